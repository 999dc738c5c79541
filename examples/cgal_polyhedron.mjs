// "Halfedge of a Polyhedral Surface" of CGAL's reference manual, in CGAL's names: the access
// functions of a halfedge, both circulators, border halfedges, and prev() with and without storage.
//
//   node examples/cgal_polyhedron.mjs

import { HalfedgeMesh, init } from 'halfedge';
import { Polyhedron } from 'halfedge/dialects';

// A box without its lid 4-5-6-7.
//
//      7───────6
//     ╱│      ╱│        z y
//    4───────5 │        │╱
//    │ 3─────│─2        └─ x
//    │╱      │╱
//    0───────1
const positions = [
  [0, 0, 0],
  [1, 0, 0],
  [1, 1, 0],
  [0, 1, 0],
  [0, 0, 1],
  [1, 0, 1],
  [1, 1, 1],
  [0, 1, 1],
];
const faces = {
  bottom: [0, 3, 2, 1],
  front: [0, 1, 5, 4],
  right: [1, 2, 6, 5],
  back: [2, 3, 7, 6],
  left: [3, 0, 4, 7],
};

const nameOf = (h) => `${h.opposite().vertex().index}>${h.vertex().index}`;
const nameOfFacet = (f) => (f === null ? 'none' : Object.keys(faces)[f.index]);

/** Each is equal to what stands in brackets in the manual. */
function printAccessFunctions(h) {
  console.log(`halfedge ${nameOf(h)}
  opposite ${nameOf(h.opposite())}
  next ${nameOf(h.next())}
  prev ${nameOf(h.prev())}
  vertex ${h.vertex().index}
  facet ${nameOfFacet(h.facet())}
  next_on_vertex ${nameOf(h.next_on_vertex())} = ${nameOf(h.next().opposite())}
  prev_on_vertex ${nameOf(h.prev_on_vertex())} = ${nameOf(h.opposite().prev())}
  is_border ${h.is_border()}
  is_border_edge ${h.is_border_edge()}`);
}

function printForwards(title, c) {
  const names = [];
  const begin = c.halfedge;
  do names.push(nameOf(c.halfedge));
  while (c.next() !== begin);
  console.log(`${title}: ${names.join(' ')}`);
}

/** A circulator has no end: this one goes back two laps. */
function printBackwards(title, c) {
  const names = [];
  const begin = c.halfedge;
  for (let laps = 0; laps < 2; laps += c.halfedge === begin ? 1 : 0) names.push(nameOf(c.prev()));
  console.log(`${title}: ${names.join(' ')}`);
}

await init();
const box = HalfedgeMesh.fromPolygons(positions.flat(), Object.values(faces));
const polyhedron = new Polyhedron(box);
const frontTo5 = box.findHalfedge(1, 5);
const h = polyhedron.halfedge(frontTo5);
printAccessFunctions(h);
printForwards('clockwise around vertex 5', h.vertex_begin());
printBackwards('and back', h.vertex_begin());
printForwards('counterclockwise around the front', h.facet_begin());
printBackwards('and back', h.facet_begin());

const border = h.next().opposite();
printAccessFunctions(border);
printForwards('along the hole', border.facet_begin());

const withoutPrev = HalfedgeMesh.fromPolygons(positions.flat(), Object.values(faces), {
  storePrev: false,
});
const searched = new Polyhedron(withoutPrev).halfedge(frontTo5);
const prev = nameOf(searched.prev());
const prevOnVertex = nameOf(searched.prev_on_vertex());
console.log(
  `where prev is not stored, a search finds prev ${prev} and prev_on_vertex ${prevOnVertex}`,
);
