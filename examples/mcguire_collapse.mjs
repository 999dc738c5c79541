// What McGuire's article "The Half-Edge Data Structure" (2000) is for: mesh simplification collapses
// an edge into a single vertex, deletes the faces bordering the edge, and updates the faces which
// shared the vertices at its end points. All of them are found by adjacency, none by a search
// through the list of faces.
//
//   node examples/mcguire_collapse.mjs

import { HalfedgeMesh, init } from 'halfedge';
import { HE_mesh } from 'halfedge/dialects';

// An octahedron: 0 to 3 around the middle, 4 at the top, 5 at the bottom.
const positions = [1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1];
const corners = [0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 1, 0, 5, 2, 1, 5, 3, 2, 5, 0, 3, 5];

const facesThatBorder = (edge) => [edge.face.index, edge.pair.face.index];

function facesThatUse(vert) {
  const faces = [];
  let edge = vert.edge;
  do {
    faces.push(edge.face.index);
    edge = edge.pair.next;
  } while (edge !== vert.edge);
  return faces;
}

/** The mesh without the last vertex, which an edge joins to `kept`. */
function collapsed(mesh, gone, kept) {
  const he = new HE_mesh(mesh);
  const edge = he.edge(mesh.findHalfedge(gone, kept));
  const polygons = Array.from(mesh.faces(), (f) => [...mesh.faceVertices(f)]);
  for (const f of facesThatUse(he.vert(gone))) {
    polygons[f] = polygons[f].map((v) => (v === gone ? kept : v));
  }
  for (const f of facesThatBorder(edge)) polygons[f] = undefined;
  const rest = polygons.filter((polygon) => polygon !== undefined);
  return HalfedgeMesh.fromPolygons(mesh.positions.slice(0, 3 * gone), rest);
}

function print(mesh) {
  const { vertexCount, edgeCount, faceCount } = mesh;
  console.log(`${vertexCount} vertices, ${edgeCount} edges, ${faceCount} faces`);
  for (const f of mesh.faces()) console.log(`  ${[...mesh.faceVertices(f)].join(' ')}`);
  console.log(mesh.validate().length === 0 ? 'valid' : 'not valid');
}

await init();
const mesh = HalfedgeMesh.fromTriangles(positions, corners);
print(mesh);
const he = new HE_mesh(mesh);
const bordering = facesThatBorder(he.edge(mesh.findHalfedge(5, 0)));
console.log(`Edge 5-0 borders faces, which are deleted: ${bordering.join(' ')}`);
const using = facesThatUse(he.vert(5));
console.log(`Vertex 5 is used by faces, the others of which are updated: ${using.join(' ')}`);
print(collapsed(mesh, 5, 0));
