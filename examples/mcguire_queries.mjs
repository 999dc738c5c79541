// The five adjacency queries of Max McGuire's article "The Half-Edge Data Structure" (2000), on a
// cube. Each takes constant time for every item that it yields.
//
//   node examples/mcguire_queries.mjs

import { HalfedgeMesh, init } from 'halfedge';

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

const nameOfFace = (f) => Object.keys(faces)[f];
const nameOfEdge = (e) => [...mesh.edgeVertices(e)].sort((a, b) => a - b).join('-');
const print = (question, names) => console.log(`${question}  ${names.join(' ')}`);

const vertex = 6;
const edge = mesh.findEdge(5, 6);
const face = Object.keys(faces).indexOf('top');

print('Which faces use vertex 6?', Array.from(mesh.vertexFaces(vertex), nameOfFace));
print('Which edges use vertex 6?', Array.from(mesh.vertexEdges(vertex), nameOfEdge));
print('Which faces border edge 5-6?', Array.from(mesh.edgeFaces(edge), nameOfFace));
print('Which edges border the top?', Array.from(mesh.faceEdges(face), nameOfEdge));
print('Which faces are adjacent to the top?', Array.from(mesh.faceFaces(face), nameOfFace));
