// The five adjacency queries of Max McGuire's article "The Half-Edge Data Structure" (2000), on a
// cube, with the article's own structs and loops. Each takes constant time for every item that it
// yields. The same queries in our own words are the circulators: mesh.vertexFaces(v) and so on.
//
//   node examples/mcguire_queries.mjs

import { HalfedgeMesh, init } from 'halfedge';
import { HE_mesh } from 'halfedge/dialects';

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
  top: [4, 5, 6, 7],
  front: [0, 1, 5, 4],
  right: [1, 2, 6, 5],
  back: [2, 3, 7, 6],
  left: [3, 0, 4, 7],
};

await init();
const mesh = HalfedgeMesh.fromPolygons(positions.flat(), Object.values(faces));
const he = new HE_mesh(mesh);

function edgesThatUse(vert) {
  const edges = [];
  let edge = vert.edge;
  do {
    edges.push(edge);
    edge = edge.pair.next;
  } while (edge !== vert.edge);
  return edges;
}

function edgesThatBorder(face) {
  const edges = [];
  let edge = face.edge;
  do {
    edges.push(edge);
    edge = edge.next;
  } while (edge !== face.edge);
  return edges;
}

const nameOfFace = (face) => Object.keys(faces)[face.index];
const nameOfEdge = (edge) =>
  [edge.pair.vert.index, edge.vert.index].sort((a, b) => a - b).join('-');
const print = (question, names) => console.log(`${question}  ${names.join(' ')}`);

const vert = he.vert(6);
const edge = he.edge(mesh.findHalfedge(5, 6));
const top = he.face(Object.keys(faces).indexOf('top'));

const faceOf = (edge) => nameOfFace(edge.face);
print('Which faces use vertex 6?', edgesThatUse(vert).map(faceOf));
print('Which edges use vertex 6?', edgesThatUse(vert).map(nameOfEdge));
print('Which faces border edge 5-6?', [edge.face, edge.pair.face].map(nameOfFace));
print('Which edges border the top?', edgesThatBorder(top).map(nameOfEdge));
const acrossOf = (edge) => nameOfFace(edge.pair.face);
print('Which faces are adjacent to the top?', edgesThatBorder(top).map(acrossOf));
