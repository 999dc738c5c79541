// What glTF allows of numbers is less than what a mesh holds.

import { describe } from '../arguments.js';
import { counted } from '../counted.js';
import { HalfedgeError, NO_WITNESS } from '../errors.js';
import type { HalfedgeMesh } from '../mesh.js';
import { type Buffers, buffersOf, type CornerValues, columnsOf, type Note } from './corners.js';

/** Throws if a vertex is at no place that can be written. */
export function checkPositions(mesh: HalfedgeMesh): void {
  const { positions } = mesh;
  for (const v of mesh.vertices()) {
    const [x, y, z] = [positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]];
    if (Number.isFinite(x + y + z)) continue;
    throw new HalfedgeError(
      'non-finite-position',
      `Vertex ${v} has the position ${x}, ${y}, ${z}, expected finite numbers in glTF.`,
      { witness: { ...NO_WITNESS, vertices: [v] } },
    );
  }
}

/** The buffers of a mesh, as `buffersOf` makes them, with such triangles and attributes as glTF allows. */
export function writableBuffers(mesh: HalfedgeMesh, note: Note, halfedges?: Uint32Array): Buffers {
  const columns = columnsOf(mesh, note);
  const buffers = withThreeVertices(buffersOf(mesh, columns, halfedges), note);
  columns.forEach(({ kind, name }, i) => {
    const { values } = buffers.attributes[i];
    const title = `the ${kind} attribute ${describe(name)}`;
    if (name === 'normal') {
      if (bringToLengthOne(values, buffers.indices)) {
        note(`Wrote ${title} brought to length 1: glTF has no other normals.`);
      }
      return;
    }
    if (clearNonFinite(values)) {
      note(`Wrote 0 where ${title} is no finite number: glTF has no others.`);
    }
    if (name === 'color' && values instanceof Float32Array && clamp(values)) {
      note(`Wrote ${title} brought between 0 and 1: glTF has no other colours.`);
    }
  });
  return buffers;
}

/** Without triangles of fewer vertices, into which the faces of degenerate complexes are cut; in place. */
function withThreeVertices(buffers: Buffers, note: Note): Buffers {
  const { indices, vertexOf } = buffers;
  let size = 0;
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [vertexOf[indices[i]], vertexOf[indices[i + 1]], vertexOf[indices[i + 2]]];
    if (a === b || b === c || c === a) continue;
    if (size < i) indices.copyWithin(size, i, i + 3);
    size += 3;
  }
  if (size === indices.length) return buffers;
  note(
    `Left out ${counted((indices.length - size) / 3, 'triangle')} with a vertex at two corners.`,
  );
  return { ...buffers, indices: indices.subarray(0, size) };
}

/** How far from 1 the validator of glTF allows the length of a normal to be. */
const TOLERANCE = 0.0005;

/**
 * Before three.js does it, which tells the console. Returns whether the normal of a corner has changed:
 * isolated vertices may have none.
 */
function bringToLengthOne(normals: CornerValues, indices: Uint32Array): boolean {
  const changed = new Set<number>();
  for (let i = 0; i < normals.length; i += 3) {
    const length = Math.hypot(normals[i], normals[i + 1], normals[i + 2]);
    if (Math.abs(length - 1) <= TOLERANCE) continue;
    const isDirection = length > 0 && Number.isFinite(length);
    const normal = normals.subarray(i, i + 3);
    normal.set(isDirection ? normal.map((x) => x / length) : [1, 0, 0]); // as three.js
    changed.add(i / 3);
  }
  return changed.size > 0 && indices.some((row) => changed.has(row));
}

/** Returns whether a number has changed. */
function clamp(values: Float32Array): boolean {
  let changed = false;
  for (let i = 0; i < values.length; i++) {
    if (values[i] >= 0 && values[i] <= 1) continue;
    values[i] = values[i] < 0 ? 0 : 1;
    changed = true;
  }
  return changed;
}

/** Returns whether there was one that isn't. */
function clearNonFinite(values: CornerValues): boolean {
  let found = false;
  for (let i = 0; i < values.length; i++) {
    if (Number.isFinite(values[i])) continue;
    values[i] = 0;
    found = true;
  }
  return found;
}
