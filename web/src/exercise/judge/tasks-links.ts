// Exercises on the raw arrays: operations, link by link.

import { type HalfedgeMesh, NONE } from '../../api.js';
import type { Item } from '../../teaching/items.js';
import { type ExerciseTask, indexOf } from './task.js';

export const flipEdge: ExerciseTask = {
  name: 'flip-edge',
  title: 'Flip an edge, link by link',
  statement:
    'Two triangles share the edge `e`. Turn it, so that it joins the other two corners: `links` has the arrays `next`, `prev`, `toVertex`, `face`, `vertexHalfedge` and `faceHalfedge`, to be changed in place. Keep the halfedges `2 * e` and `2 * e + 1`, and the two faces. Nothing is to be given back.',
  call: 'flipEdge',
  starter: `function flipEdge(links, e) {
  const { next, prev, toVertex, face, vertexHalfedge, faceHalfedge } = links;
  const h = 2 * e;           //        c
  const o = h ^ 1;           //      / ^ \\
  const hn = next[h];        //     /  |  \\
  const hp = prev[h];        //    d  h|o  b
  const on = next[o];        //     \\  |  /
  const op = prev[o];        //      \\ | /
                             //        a
  // Before: h goes from a to c, o from c to a.
  // After: h goes from b to d, o from d to b.
}
`,
  solution: `function flipEdge(links, e) {
  const { next, prev, toVertex, face, vertexHalfedge, faceHalfedge } = links;
  const h = 2 * e;
  const o = h ^ 1;
  const hn = next[h];
  const hp = prev[h];
  const on = next[o];
  const op = prev[o];
  const [a, b, c, d] = [toVertex[o], toVertex[on], toVertex[h], toVertex[hn]];
  const triangle = (f, x, y, z) => {
    next[x] = y;
    next[y] = z;
    next[z] = x;
    prev[y] = x;
    prev[z] = y;
    prev[x] = z;
    face[x] = face[y] = face[z] = f;
    faceHalfedge[f] = x;
  };
  triangle(face[h], h, hp, on);
  triangle(face[o], o, op, hn);
  toVertex[h] = d;
  toVertex[o] = b;
  if (vertexHalfedge[a] === h) vertexHalfedge[a] = on;
  if (vertexHalfedge[c] === o) vertexHalfedge[c] = hn;
}
`,
  gets: 'links',
  uses: [],
  meshes: ['cone', 'ring', 'bow-tie', 'lonely'],
  asks: flippable,
  answer: { kind: 'links' },
  reference: (mesh, edge) => {
    mesh.flipEdge(indexOf(edge));
    return null;
  },
};

/** The edges between two triangles whose other corners no edge joins yet. */
function* flippable(mesh: HalfedgeMesh): Generator<[Item]> {
  for (const e of mesh.edges()) {
    const sides = [mesh.edgeHalfedge(e, 0), mesh.edgeHalfedge(e, 1)];
    const faces = sides.map((h) => mesh.face(h));
    if (!faces.every((f) => f !== NONE && mesh.degree(f) === 3)) continue;
    const [b, d] = sides.map((h) => mesh.toVertex(mesh.next(h)));
    if (mesh.findEdge(b, d) === NONE) yield [{ kind: 'edge', index: e }];
  }
}
