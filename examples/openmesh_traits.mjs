// "Developer Documentation" of OpenMesh: the previous halfedge need not be stored, since it can be
// derived from the links to the next ones; leaving it out gains memory. And a mesh is customised:
// by what it stores, and by data for each edge, for which a face-based structure has no place.
//
//   node examples/openmesh_traits.mjs

import { HalfedgeMesh, init } from 'halfedge';
import { PolyMesh } from 'halfedge/dialects';

// A torus of triangles: 8 × 8 squares, each cut in two.
const side = 8;
const at = (x, y) => (y % side) * side + (x % side);
const positions = [];
const corners = [];
for (let y = 0; y < side; y++) {
  for (let x = 0; x < side; x++) {
    positions.push(x, y, 0);
    corners.push(at(x, y), at(x + 1, y), at(x + 1, y + 1));
    corners.push(at(x, y), at(x + 1, y + 1), at(x, y + 1));
  }
}

/** What the links take, positions left out. */
function bytesPerVertex({ connectivity, vertexCount }) {
  const links = Object.values(connectivity).filter((link) => link !== undefined);
  return links.reduce((bytes, { byteLength }) => bytes + byteLength, 0) / vertexCount;
}

/** Round the loop until the next one is where it began. */
function prevByWalking(mesh, heh) {
  let at = heh;
  while (mesh.next_halfedge_handle(at) !== heh) at = mesh.next_halfedge_handle(at);
  return at;
}

const oneRing = (mesh, vh) => mesh.vv_ccw_range(vh).map((neighbour) => neighbour.idx());

await init();
const stored = HalfedgeMesh.fromTriangles(positions, corners);
const reduced = HalfedgeMesh.fromTriangles(positions, corners, { storePrev: false });
const mesh = new PolyMesh(stored);
const withoutPrev = new PolyMesh(reduced);

console.log(`${mesh.n_vertices()} vertices, ${mesh.n_edges()} edges, ${mesh.n_faces()} faces`);
console.log(`with prev: ${bytesPerVertex(stored)} bytes a vertex`);
console.log(`without:   ${bytesPerVertex(reduced)} bytes a vertex`);

let same = 0;
for (const heh of withoutPrev.halfedges()) {
  const prev = stored.prev(heh.idx());
  const walked = prevByWalking(withoutPrev, heh).idx();
  same += walked === prev && withoutPrev.prev_halfedge_handle(heh).idx() === prev ? 1 : 0;
}
console.log(`walking finds the same prev for ${same} of ${mesh.n_halfedges()} halfedges`);
console.log(`one-ring of vertex 0, with prev: ${oneRing(mesh, mesh.vertex_handle(0)).join(' ')}`);
const ring = oneRing(withoutPrev, withoutPrev.vertex_handle(0));
console.log(`and without:                     ${ring.join(' ')}`);

// Data for each edge: an array, since items are indices. So for vertices, halfedges and faces.
const facesOfEdge = new Uint8Array(mesh.n_edges());
for (const fh of mesh.faces()) {
  for (const eh of mesh.fe_range(fh)) facesOfEdge[eh.idx()] += 1;
}
console.log(`edges with two faces: ${facesOfEdge.filter((count) => count === 2).length}`);
