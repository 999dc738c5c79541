// "The Halfedge Data Structure" of OpenMesh's documentation, in OpenMesh's names: the links (1) to
// (7), circulating by the opposite of the previous halfedge, telling the boundary by the outgoing
// halfedge of a vertex, and keeping it so after a low-level change of topology.
//
//   node examples/openmesh_structure.mjs

import { HalfedgeMesh, init } from 'halfedge';
import { HalfedgeHandle, PolyMesh, VertexHandle } from 'halfedge/dialects';

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

await init();
const box = HalfedgeMesh.fromPolygons(positions.flat(), Object.values(faces));
const mesh = new PolyMesh(box);

function nameOf(item) {
  if (item instanceof VertexHandle) return `${item.idx()}`;
  if (!(item instanceof HalfedgeHandle)) return Object.keys(faces)[item.idx()];
  return `${mesh.from_vertex_handle(item).idx()}>${mesh.to_vertex_handle(item).idx()}`;
}

const print = (title, items) => console.log(`${title}: ${items.map(nameOf).join(' ') || 'none'}`);

function printLinks(vh, fh) {
  const heh = mesh.halfedge_handle(fh);
  const next = mesh.next_halfedge_handle(heh);
  const opposite = mesh.opposite_halfedge_handle(heh);
  const previous = mesh.prev_halfedge_handle(heh);
  console.log(`(1) vertex ${nameOf(vh)} has the outgoing halfedge ${nameOf(mesh.halfedge_handle(vh))}
(2) the ${nameOf(fh)} has the halfedge ${nameOf(heh)}
(3) which points to vertex ${nameOf(mesh.to_vertex_handle(heh))},
(4) belongs to the ${nameOf(mesh.face_handle(heh))},
(5) has the next halfedge ${nameOf(next)},
(6) the opposite halfedge ${nameOf(opposite)},
(7) and the previous halfedge ${nameOf(previous)}.`);
}

/** Around a vertex: from its halfedge on to the opposite of the previous one, without a branch. */
function circulate(vh) {
  const outgoing = [];
  let heh = mesh.halfedge_handle(vh);
  do {
    outgoing.push(heh);
    heh = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(heh));
  } while (heh !== mesh.halfedge_handle(vh));
  return outgoing;
}

const boundaryVertices = () => mesh.vertices().filter((vh) => mesh.is_boundary(vh));

/** Takes a face away, and puts it into the gap to the left of a boundary halfedge. */
function moveFace(fh, gap) {
  const left = mesh.fh_range(fh);
  const filled = mesh.hl_range(gap);
  for (const heh of left) mesh.set_boundary(heh);
  for (const heh of filled) mesh.set_face_handle(heh, fh);
  mesh.set_halfedge_handle(fh, gap);
}

const vh = mesh.vertex_handle(0);
const bottom = mesh.face_handle(0);
const front = mesh.face_handle(1);

printLinks(vh, front);
print('Around the front, its vertices', mesh.fv_range(front));
print('its halfedges', mesh.fh_range(front));
print('its neighbours', mesh.ff_range(front));
print('Around vertex 0, by the opposite of the previous', circulate(vh));
print('its one-ring', mesh.vv_range(vh));
print('incoming halfedges', mesh.vih_range(vh));
print('faces', mesh.vf_range(vh));

print('On the boundary', boundaryVertices());
moveFace(bottom, mesh.find_halfedge(mesh.vertex_handle(4), mesh.vertex_handle(5)));
print('The bottom becomes the lid', mesh.fv_range(bottom));
print('On the boundary, say outgoing halfedges', boundaryVertices());
console.log(`A problem, says validate: ${box.validate()[0].code}`);
for (const vertex of mesh.vertices()) mesh.adjust_outgoing_halfedge(vertex);
print('On the boundary, when they are adjusted', boundaryVertices());
console.log(`Problems left: ${box.validate().length}`);
