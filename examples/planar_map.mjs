// A planar map: connectivity alone, without any geometry. A street block with two plots and a pond in
// one of them; every halfedge has a face, the unbounded one included. See planar_map.cpp.
//
//     3 ------------- 2        faces: south (0 1 2), with the pond 4 5 6 as a hole in it,
//     |           .   |               north (0 2 3), the pond, and outside
//     | north  .  4   |
//     |     .    / \  |
//     |  .      5---6 |
//     0 ------------- 1

import { HalfedgeMesh, init } from 'halfedge';

await init();

const [SOUTH, OUTSIDE, SHORE] = [0, 3, 4];
const map = HalfedgeMesh.fromFaces([
  [0, 1, 2],
  [0, 2, 3],
  [4, 5, 6],
  [3, 2, 1, 0],
  [6, 5, 4], // the shore: a loop of its own, which the map below gives to south
]);
/** The face that a loop is a hole of. */
const holeOf = new Map([[SHORE, SOUTH]]);
const faceOf = (loop) => holeOf.get(loop) ?? loop;
const faces = map
  .faces()
  .toArray()
  .filter((f) => !holeOf.has(f));

for (const f of faces) {
  let line = `face ${f}: ${map.faceVertices(f).toArray().join(' ')}`;
  for (const [loop, face] of holeOf) {
    if (face === f) line += `, around a hole: ${map.faceVertices(loop).toArray().join(' ')}`;
  }
  console.log(f === OUTSIDE ? `${line}, unbounded` : line);
}

function neighbours(loop) {
  return map.faceFaces(loop).toArray().map(faceOf);
}

// Two connected parts in the plane: V - E + F = 1 + 2.
console.log(`V - E + F = ${map.vertexCount - map.edgeCount + faces.length}`);
console.log(`neighbours of face ${SOUTH}: ${neighbours(SOUTH).join(' ')}`);
console.log(`across its hole: ${neighbours(SHORE).join(' ')}`);

// The dual: a vertex for each face, a face for each vertex, clockwise around it.
for (const v of map.vertices()) {
  const around = map.vertexFaces(v, 'cw').toArray().map(faceOf);
  const least = around.indexOf(Math.min(...around));
  const corners = [...around.slice(least), ...around.slice(0, least)];
  console.log(`dual of vertex ${v}: faces ${corners.join(' ')}`);
}

map.dispose();
