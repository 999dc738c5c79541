// Exercises that walk around something, and give back what they meet.

import type { Direction, HalfedgeMesh } from '../../api.js';
import type { Item } from '../../teaching/items.js';
import { type Argument, type ExerciseTask, indexOf } from './task.js';

const LINKS = ['next', 'prev', 'opposite', 'toVertex', 'fromVertex', 'face'];
const AROUND_VERTEX = ['vertexHalfedge', ...LINKS];

export function* everyVertex(mesh: HalfedgeMesh): Generator<[Item]> {
  for (const index of mesh.vertices()) yield [{ kind: 'vertex', index }];
}

function* everyFace(mesh: HalfedgeMesh): Generator<[Item]> {
  for (const index of mesh.faces()) yield [{ kind: 'face', index }];
}

function* everyHalfedge(mesh: HalfedgeMesh): Generator<[Item]> {
  for (const index of mesh.halfedges()) yield [{ kind: 'halfedge', index }];
}

function* bothWaysAroundEveryVertex(mesh: HalfedgeMesh): Generator<[Item, Direction]> {
  for (const [vertex] of everyVertex(mesh)) {
    for (const direction of ['ccw', 'cw'] as const) yield [vertex, direction];
  }
}

/** The halfedges that leave a vertex, from its anchor on. */
function spokes(mesh: HalfedgeMesh, vertex: Argument, direction: Direction = 'ccw'): number[] {
  const v = indexOf(vertex);
  if (mesh.isIsolatedVertex(v)) return [];
  return [...mesh.vertexOutgoingHalfedges(v, direction, mesh.vertexHalfedge(v))];
}

export const vertexVertices: ExerciseTask = {
  name: 'vertex-vertices',
  title: 'The vertices around a vertex',
  statement:
    'Give back the neighbours of the vertex `v`, each once, in the order in which they lie around it. Either way round will do, and any of them may be the first.',
  call: 'vertexVertices',
  starter: `function vertexVertices(mesh, v) {
  const ring = [];
  const first = mesh.vertexHalfedge(v); // leaves v
  let h = first;
  do {
    // Take the vertex that h leads to,
    // then turn h around v.
  } while (h !== first);
  return ring;
}
`,
  solution: `function vertexVertices(mesh, v) {
  const ring = [];
  const first = mesh.vertexHalfedge(v);
  if (first === NONE) return ring;
  let h = first;
  do {
    ring.push(mesh.toVertex(h));
    h = mesh.opposite(mesh.prev(h));
  } while (h !== first);
  return ring;
}
`,
  gets: 'mesh',
  uses: AROUND_VERTEX,
  asks: everyVertex,
  answer: { kind: 'cycle', of: 'vertex', eitherWay: true, anyStart: true },
  reference: (mesh, v) => spokes(mesh, v).map((h) => mesh.toVertex(h)),
};

export const oneRing: ExerciseTask = {
  name: 'one-ring',
  title: 'Counter-clockwise, or clockwise',
  statement:
    "Give back the neighbours of the vertex `v` counter-clockwise where `direction` is `'ccw'`, clockwise where it is `'cw'`. The first is the one that `vertexHalfedge(v)` leads to, either way round.",
  call: 'oneRing',
  starter: `function oneRing(mesh, v, direction) {
  const ring = [];
  const first = mesh.vertexHalfedge(v);
  if (first === NONE) return ring; // isolated
  let h = first;
  do {
    ring.push(mesh.toVertex(h));
    h = mesh.next(mesh.opposite(h)); // Which way round is that?
  } while (h !== first);
  return ring;
}
`,
  solution: `function oneRing(mesh, v, direction) {
  const ring = [];
  const first = mesh.vertexHalfedge(v);
  if (first === NONE) return ring;
  let h = first;
  do {
    ring.push(mesh.toVertex(h));
    h = direction === 'ccw' ? mesh.opposite(mesh.prev(h)) : mesh.next(mesh.opposite(h));
  } while (h !== first);
  return ring;
}
`,
  gets: 'mesh',
  uses: AROUND_VERTEX,
  asks: bothWaysAroundEveryVertex,
  answer: { kind: 'cycle', of: 'vertex' },
  reference: (mesh, v, direction) =>
    spokes(mesh, v, direction as Direction).map((h) => mesh.toVertex(h)),
};

export const vertexFaces: ExerciseTask = {
  name: 'vertex-faces',
  title: 'The faces around a vertex',
  statement:
    'Give back the faces around the vertex `v`, each once, in their order. Either way round will do, and any may be the first. At the boundary there is a gap where no face is: it does not count, and what lies behind it does.',
  call: 'vertexFaces',
  starter: `function vertexFaces(mesh, v) {
  const faces = [];
  const first = mesh.vertexHalfedge(v);
  if (first === NONE) return faces; // isolated
  let h = first;
  do {
    faces.push(mesh.face(h));
    h = mesh.opposite(mesh.prev(h));
  } while (h !== first);
  return faces;
}
`,
  solution: `function vertexFaces(mesh, v) {
  const faces = [];
  const first = mesh.vertexHalfedge(v);
  if (first === NONE) return faces;
  let h = first;
  do {
    if (mesh.face(h) !== NONE) faces.push(mesh.face(h));
    h = mesh.opposite(mesh.prev(h));
  } while (h !== first);
  return faces;
}
`,
  gets: 'mesh',
  uses: AROUND_VERTEX,
  asks: everyVertex,
  answer: { kind: 'cycle', of: 'face', eitherWay: true, anyStart: true },
  reference: (mesh, v) =>
    spokes(mesh, v)
      .map((h) => mesh.face(h))
      .filter((f) => f >= 0),
};

export const faceVertices: ExerciseTask = {
  name: 'face-vertices',
  title: 'The vertices of a face',
  statement:
    'Give back the vertices of the face `f`, each once, counter-clockwise: in the order of `next`. Any of them may be the first.',
  call: 'faceVertices',
  starter: `function faceVertices(mesh, f) {
  const corners = [];
  let h = mesh.faceHalfedge(f);
  // Walk around f, and take a vertex of each halfedge.
  return corners;
}
`,
  solution: `function faceVertices(mesh, f) {
  const corners = [];
  const first = mesh.faceHalfedge(f);
  let h = first;
  do {
    corners.push(mesh.toVertex(h));
    h = mesh.next(h);
  } while (h !== first);
  return corners;
}
`,
  gets: 'mesh',
  uses: ['faceHalfedge', ...LINKS],
  asks: everyFace,
  answer: { kind: 'cycle', of: 'vertex', anyStart: true },
  reference: (mesh, f) => {
    const face = indexOf(f);
    return [...mesh.faceVertices(face, 'ccw', mesh.faceHalfedge(face))];
  },
};

export const boundaryLoop: ExerciseTask = {
  name: 'boundary-loop',
  title: 'Once around a boundary loop',
  statement:
    'The halfedge `h` has no face. Give back the halfedges of its boundary loop in the order of `next`, from `h` on.',
  call: 'boundaryLoop',
  starter: `function boundaryLoop(mesh, h) {
  const loop = [];
  return loop;
}
`,
  solution: `function boundaryLoop(mesh, h) {
  const loop = [];
  let at = h;
  do {
    loop.push(at);
    at = mesh.next(at);
  } while (at !== h);
  return loop;
}
`,
  gets: 'mesh',
  uses: LINKS,
  meshes: ['sheet', 'ring', 'bow-tie', 'lonely'],
  *asks(mesh) {
    for (const [halfedge] of everyHalfedge(mesh)) {
      if (mesh.isBoundaryHalfedge(halfedge.index)) yield [halfedge];
    }
  },
  answer: { kind: 'cycle', of: 'halfedge' },
  reference: (mesh, h) => [...mesh.halfedgeLoop(indexOf(h))],
};

export const previous: ExerciseTask = {
  name: 'previous',
  title: 'The previous halfedge, by walking',
  statement:
    'Many structures do not store `prev`. Give back the halfedge before `h` in its loop, with the other links alone.',
  call: 'previous',
  starter: `function previous(mesh, h) {
  let before = h;
  return before;
}
`,
  solution: `function previous(mesh, h) {
  let before = h;
  while (mesh.next(before) !== h) before = mesh.next(before);
  return before;
}
`,
  gets: 'mesh',
  uses: ['next', 'opposite', 'toVertex', 'face'],
  asks: everyHalfedge,
  answer: { kind: 'item', of: 'halfedge' },
  reference: (mesh, h) => mesh.prev(indexOf(h)),
};
