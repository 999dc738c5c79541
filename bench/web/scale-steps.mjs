// What is done with a mesh of ten million triangles, the same in Node and in a browser.

import { oneRingsByAccessors, oneRingsForOf } from './contenders.mjs';
import { torus } from './meshes.mjs';

/**
 * Times the steps: `{ faces, steps: [{ title, ms, bytes }] }`, where `bytes` is the size that WebAssembly
 * memory has after the step. It never shrinks: that is the most that was needed so far.
 */
export function runSteps({ HalfedgeMesh, core }, side) {
  const { positions, triangles } = torus(side);
  const steps = [];
  const step = (title, run) => {
    const begin = performance.now();
    const result = run();
    const ms = performance.now() - begin;
    steps.push({ title, ms, bytes: core().memory.buffer.byteLength });
    return result;
  };

  const mesh = step('build', () => HalfedgeMesh.fromTriangles(positions, triangles));
  step('one-rings of all vertices: accessors', () => oneRingsByAccessors(mesh));
  step('one-rings of all vertices: `for…of`', () => oneRingsForOf(mesh));
  step('one-rings of all vertices: `allVertexVertices()`', () => mesh.allVertexVertices());
  expectValid(step('validate', () => mesh.validate()));
  const faces = mesh.faceCount;
  step('delete every tenth face, one by one', () => {
    for (let f = 0; f < faces; f += 10) mesh.deleteFace(f);
  });
  step('compact', () => mesh.compact());
  expectValid(mesh.validate());
  if (mesh.faceSlots !== faces - Math.ceil(faces / 10)) throw new Error('compact() left gaps.');
  mesh.dispose();
  return { faces, steps };
}

/**
 * Copies a mesh until there is no room for the next copy, and asks for a single one that is too large:
 * `{ copies, bytes, another, larger }`, the last two being the sentences. The mesh is valid afterwards.
 */
export function runIntoTheLimit({ HalfedgeMesh, core }, side, largerSide) {
  const mesh = fromTorus(HalfedgeMesh, side);
  const copies = [];
  const another = sentenceOf(() => {
    for (;;) copies.push(mesh.clone());
  });
  const bytes = core().memory.buffer.byteLength;
  expectValid(copies.at(-1).validate());
  for (const copy of copies) copy.dispose();
  const larger = sentenceOf(() => fromTorus(HalfedgeMesh, largerSide));
  expectValid(mesh.validate());
  mesh.dispose();
  return { copies: copies.length, bytes, another, larger };
}

function fromTorus(HalfedgeMesh, side) {
  const { positions, triangles } = torus(side);
  return HalfedgeMesh.fromTriangles(positions, triangles);
}

/** What is told to who asks for too much. */
function sentenceOf(ask) {
  try {
    ask();
  } catch (error) {
    return String(error);
  }
  throw new Error('There was room for it.');
}

function expectValid(problems) {
  const errors = problems.filter(({ severity }) => severity === 'error');
  if (errors.length > 0) throw new Error(`The mesh is broken: ${errors[0].message}`);
}
