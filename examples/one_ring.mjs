// Five lines to a one-ring: a pyramid without a base, and the vertices around its apex.
//
//   node examples/one_ring.mjs

import { HalfedgeMesh, init } from 'halfedge';

await init();
const positions = [0, 0, 1, 1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0];
const mesh = HalfedgeMesh.fromTriangles(positions, [0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1]);
for (const v of mesh.vertexVertices(0)) console.log(`vertex ${v}`);
