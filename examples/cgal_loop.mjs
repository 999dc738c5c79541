// "Halfedge Data Structures" of CGAL's manual. Its example program is printed incompletely; this one
// does what its text says: it builds a loop, consisting of two halfedges, one vertex and two faces,
// and verifies its validity.
//
//   node examples/cgal_loop.mjs

import { HalfedgeMesh, init } from 'halfedge';
import { Polyhedron } from 'halfedge/dialects';

const yes = (fact) => (fact ? 'yes' : 'no');

await init();
const mesh = new HalfedgeMesh();
const hds = new Polyhedron(mesh);
const h = hds.halfedge(mesh.makeLoop());

const sizes = [hds.size_of_halfedges(), hds.size_of_vertices(), hds.size_of_facets()];
console.log(`${sizes[0]} halfedges, ${sizes[1]} vertex, ${sizes[2]} faces`);
console.log(`next is the halfedge itself: ${yes(h.next() === h)}`);
console.log(`both ends are one vertex: ${yes(h.vertex() === h.opposite().vertex())}`);
console.log(`the two faces are two: ${yes(h.face() !== h.opposite().face())}`);
for (const level of [0, 1, 2, 3]) {
  console.log(`valid at level ${level}: ${yes(mesh.validate(level).length === 0)}`);
}
