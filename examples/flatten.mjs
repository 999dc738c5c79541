// Flattens a surface: gives each vertex a place (u, v) in the plane, for textures. The boundary goes around a circle,
// and each vertex inside to the weighted mean of its neighbours. With equal weights, no triangle is turned over
// (Tutte, "How to draw a graph", 1963); with cotangent weights, angles change less (Pinkall and Polthier, "Computing
// discrete minimal surfaces and their conjugates", 1993).
//
//   node examples/flatten.mjs                     half a sphere
//   node examples/flatten.mjs face.ply flat.obj   holes are filled, all but the longest

import { readFile, writeFile } from 'node:fs/promises';
import { HalfedgeMesh, init } from 'halfedge';

function hemisphere() {
  const mesh = HalfedgeMesh.icoSphere(4);
  for (const f of mesh.faces().toArray()) if (mesh.faceCentroid(f)[2] < 0) mesh.deleteFace(f);
  mesh.compact();
  return mesh;
}

/** The halfedges of the longest boundary loop; the others are filled, each with a vertex in the middle. */
function onlyBoundary(mesh) {
  const length = (loop) => loop.reduce((sum, h) => sum + mesh.edgeLength(mesh.edge(h)), 0);
  const loops = mesh.boundaryLoops().map((h) => [...mesh.halfedgeLoop(h)]);
  const [longest, ...others] = loops.sort((a, b) => length(b) - length(a));
  for (const [h] of others) {
    const f = mesh.fillHole(h);
    mesh.splitFace(f, mesh.faceCentroid(f));
  }
  return longest;
}

/** What keeps a mesh with this boundary from being a disk, or undefined. */
function whyNoDisk(mesh, boundary) {
  if (!boundary) return 'has no boundary: cut it open first, by deleteFace or cutEdges';
  const parts = mesh.components().length;
  if (parts !== 1) return `has ${parts} components`;
  if (mesh.genus() > 0) return `has genus ${mesh.genus()}`;
  return undefined;
}

/** By vertex, x and y of those on the boundary: on the unit circle, as far apart as along the loop. */
function circle(mesh, boundary) {
  const lengths = boundary.map((h) => mesh.edgeLength(mesh.edge(h)));
  const turn = (2 * Math.PI) / lengths.reduce((sum, length) => sum + length, 0);
  const x = new Float64Array(mesh.vertexSlots);
  const y = new Float64Array(mesh.vertexSlots);
  let angle = 0;
  for (const [i, h] of boundary.entries()) {
    angle -= turn * lengths[i]; // a boundary loop runs clockwise around the surface
    x[mesh.toVertex(h)] = Math.cos(angle);
    y[mesh.toVertex(h)] = Math.sin(angle);
  }
  return [x, y];
}

/** By vertex, x and y in the plane: of those inside, the weighted means of their neighbours. */
function flattened(mesh, boundary, weights) {
  const { offsets, items: leaving } = mesh.allVertexOutgoingHalfedges();
  const { toVertex } = mesh.connectivity;
  const inside = mesh
    .vertices()
    .toArray()
    .filter((v) => !mesh.isBoundaryVertex(v));
  const total = new Float64Array(mesh.vertexSlots).fill(1); // of the weights around a vertex
  for (const v of inside) {
    total[v] = 0;
    for (let i = offsets[v]; i < offsets[v + 1]; i++) total[v] += weights[leaving[i] >> 1];
  }
  /** How much the weights draw each vertex towards its neighbours; 0 on the boundary. */
  const pull = (x, result) => {
    for (const v of inside) {
      let sum = 0;
      for (let i = offsets[v]; i < offsets[v + 1]; i++) {
        const h = leaving[i];
        sum += weights[h >> 1] * (x[toVertex[h]] - x[v]);
      }
      result[v] = sum;
    }
    return result;
  };

  /** Moves all vertices inside until nothing draws them, in one coordinate: by conjugate gradients. */
  const relax = (x) => {
    const left = pull(x, new Float64Array(x.length));
    const step = left.map((force, v) => force / total[v]);
    const change = new Float64Array(x.length);
    const error = () => left.reduce((sum, force, v) => sum + force ** 2 / total[v], 0);
    let now = error();
    const enough = 1e-20 * now;
    for (let rounds = 0; now > enough && rounds < 5000; rounds++) {
      pull(step, change);
      const size = -now / step.reduce((sum, along, v) => sum + along * change[v], 0);
      for (const v of inside) {
        x[v] += size * step[v];
        left[v] += size * change[v];
      }
      const before = now;
      now = error();
      for (const v of inside) step[v] = left[v] / total[v] + (now / before) * step[v];
    }
  };

  const places = circle(mesh, boundary);
  places.forEach(relax);
  return places;
}

/** How many triangles are turned over, and how much the angles have changed. */
function describe(mesh, [x, y]) {
  const { indices } = mesh.toTriangles();
  let turned = 0;
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = indices.subarray(i, i + 3);
    if ((x[b] - x[a]) * (y[c] - y[a]) < (x[c] - x[a]) * (y[b] - y[a])) turned++;
  }
  const before = mesh.allCornerAngles();
  const flat = mesh.clone();
  for (const v of mesh.vertices()) flat.setPosition(v, [x[v], y[v], 0]);
  const after = flat.allCornerAngles();
  flat.dispose();
  const change = before.reduce((sum, angle, h) => sum + Math.abs(after[h] - angle), 0);
  const degrees = (change / (3 * mesh.faceCount)) * (180 / Math.PI);
  return `${turned} triangles turned over; angles change by ${degrees.toFixed(1)} degrees on average`;
}

await init();
const [input, output] = process.argv.slice(2);
const mesh = input ? HalfedgeMesh.parse(await readFile(input)).mesh : hemisphere();
mesh.triangulate();
const boundary = onlyBoundary(mesh);
const problem = whyNoDisk(mesh, boundary);
if (problem) {
  console.error(`The surface can't be flattened: it ${problem}.`);
  process.exit(1);
}
console.log(`${mesh.faceCount} triangles, ${boundary.length} edges around them`);
const equal = flattened(mesh, boundary, new Float64Array(mesh.edgeSlots).fill(1));
console.log(`equal weights: ${describe(mesh, equal)}`);
const cotangent = flattened(mesh, boundary, mesh.allCotanWeights());
console.log(`cotangent weights: ${describe(mesh, cotangent)}`);
if (output) {
  const uv = mesh.attributes.add('vertex', 'uv', { components: 2 });
  for (const v of mesh.vertices()) uv.set([equal[0][v], equal[1][v]], 2 * v);
  await writeFile(output, mesh.write('obj'));
}
