// Exercises whose answer is a number, or yes or no.

import type { HalfedgeMesh } from '../../api.js';
import { type Argument, type ExerciseTask, indexOf } from './task.js';
import { everyVertex } from './tasks-around.js';

export const valence: ExerciseTask = {
  name: 'valence',
  title: 'The valence of a vertex',
  statement: 'Give back how many edges meet the vertex `v`.',
  call: 'valence',
  starter: `function valence(mesh, v) {
  let count = 0;
  return count;
}
`,
  solution: `function valence(mesh, v) {
  const first = mesh.vertexHalfedge(v);
  if (first === NONE) return 0;
  let count = 0;
  let h = first;
  do {
    count += 1;
    h = mesh.next(mesh.opposite(h));
  } while (h !== first);
  return count;
}
`,
  gets: 'mesh',
  uses: ['vertexHalfedge', 'next', 'prev', 'opposite', 'toVertex', 'fromVertex', 'face'],
  asks: everyVertex,
  answer: { kind: 'number' },
  reference: (mesh, v) => mesh.valence(indexOf(v)),
  mistakes: [
    {
      code: 'counts-faces',
      answer: (mesh, v) => [...mesh.vertexFaces(indexOf(v))].length,
      says: 'That is the number of faces around it.',
      hint: 'At the boundary a vertex has one edge more than faces for each gap: count every halfedge that leaves it, also one without a face.',
    },
    {
      code: 'walks-face',
      answer: (mesh, v) => {
        const first = mesh.vertexHalfedge(indexOf(v));
        return first < 0 ? 0 : [...mesh.halfedgeLoop(first)].length;
      },
      says: 'That is the number of halfedges around a face.',
      hint: '`next` stays in a face. To turn around the vertex, go `next(opposite(h))` or `opposite(prev(h))`.',
    },
  ],
};

export const isBoundaryVertex: ExerciseTask = {
  name: 'is-boundary-vertex',
  title: 'Is it at the boundary?',
  statement:
    'Give back `true` where the vertex `v` is at the boundary: where a halfedge leaves it that has no face. A vertex that nothing meets counts as one at the boundary, too.',
  call: 'isBoundaryVertex',
  starter: `function isBoundaryVertex(mesh, v) {
  return false;
}
`,
  solution: `function isBoundaryVertex(mesh, v) {
  const first = mesh.vertexHalfedge(v);
  if (first === NONE) return true;
  let h = first;
  do {
    if (mesh.face(h) === NONE) return true;
    h = mesh.opposite(mesh.prev(h));
  } while (h !== first);
  return false;
}
`,
  gets: 'mesh',
  uses: ['vertexHalfedge', 'next', 'prev', 'opposite', 'toVertex', 'fromVertex', 'face'],
  asks: everyVertex,
  answer: { kind: 'boolean' },
  reference: (mesh, v) => mesh.isBoundaryVertex(indexOf(v)),
};

export const countBoundaryLoops: ExerciseTask = {
  name: 'count-boundary-loops',
  title: 'How many boundary loops?',
  statement:
    'Give back how many boundary loops the mesh has. `mesh.halfedges()` lists its halfedges; those of a loop have no face, and `next` leads along it.',
  call: 'countBoundaryLoops',
  starter: `function countBoundaryLoops(mesh) {
  let loops = 0;
  for (const h of mesh.halfedges()) {
    if (mesh.face(h) === NONE) loops += 1; // one for each?
  }
  return loops;
}
`,
  solution: `function countBoundaryLoops(mesh) {
  const seen = new Set();
  let loops = 0;
  for (const h of mesh.halfedges()) {
    if (mesh.face(h) !== NONE || seen.has(h)) continue;
    loops += 1;
    for (let at = h; !seen.has(at); at = mesh.next(at)) seen.add(at);
  }
  return loops;
}
`,
  gets: 'mesh',
  uses: ['halfedges', 'halfedgeCount', 'next', 'prev', 'opposite', 'toVertex', 'face'],
  asks: () => [[]],
  answer: { kind: 'number' },
  reference: (mesh) => mesh.boundaryLoops().length,
  mistakes: [
    {
      code: 'counts-halfedges',
      answer: (mesh) => boundaryHalfedges(mesh).length,
      says: 'That is the number of boundary halfedges.',
      hint: 'All halfedges of a loop together count one: remember those that you have been at.',
    },
    {
      code: 'yes-or-no',
      answer: (mesh) => (boundaryHalfedges(mesh).length > 0 ? 1 : 0),
      says: 'It has more than one.',
      hint: 'Having gone around one loop, look for a boundary halfedge that was not in it.',
    },
  ],
};

export const eulerCharacteristic: ExerciseTask = {
  name: 'euler-characteristic',
  title: 'The Euler characteristic',
  statement:
    'Give back the vertices less the edges plus the faces. The mesh tells `vertexCount`, `halfedgeCount` and `faceCount`.',
  call: 'eulerCharacteristic',
  starter: `function eulerCharacteristic(mesh) {
  return mesh.vertexCount - mesh.halfedgeCount + mesh.faceCount;
}
`,
  solution: `function eulerCharacteristic(mesh) {
  return mesh.vertexCount - mesh.halfedgeCount / 2 + mesh.faceCount;
}
`,
  gets: 'mesh',
  uses: ['vertexCount', 'halfedgeCount', 'faceCount'],
  asks: () => [[]],
  answer: { kind: 'number' },
  reference: (mesh) => mesh.eulerCharacteristic(),
  mistakes: [
    counted(
      'counts-halfedges',
      ({ vertexCount, halfedgeCount, faceCount }) => vertexCount - halfedgeCount + faceCount,
      'It takes each halfedge for an edge; an edge has two of them.',
    ),
    counted(
      'adds-edges',
      ({ vertexCount, edgeCount, faceCount }) => vertexCount + edgeCount + faceCount,
      'It adds the edges; they are to be taken away.',
    ),
    counted(
      'two',
      () => 2,
      'It is 2 for a sphere only: boundary loops, handles and further parts change it.',
    ),
  ],
};

function counted(code: string, answer: (mesh: HalfedgeMesh) => number, says: string) {
  return { code, answer: (mesh: HalfedgeMesh, ..._: Argument[]) => answer(mesh), says };
}

function boundaryHalfedges(mesh: HalfedgeMesh): number[] {
  return [...mesh.halfedges()].filter((h) => mesh.isBoundaryHalfedge(h));
}
