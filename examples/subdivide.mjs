// Smooths meshes by subdivision, made of operations: triangles by the scheme of Loop ("Smooth subdivision surfaces
// based on triangles", 1987), polygons by that of Catmull and Clark ("Recursively generated B-spline surfaces on
// arbitrary topological meshes", 1978).
//
//   node examples/subdivide.mjs                       an icosahedron, a cube, and an open pyramid by both
//   node examples/subdivide.mjs model.obj smooth.ply  twice: by Loop's scheme if all faces are triangles

import { readFile, writeFile } from 'node:fs/promises';
import { HalfedgeMesh, init } from 'halfedge';

/** The sum of weights times points; `terms` are pairs of both. */
function weighted(terms) {
  const sum = [0, 0, 0];
  for (const [weight, point] of terms)
    for (const axis of [0, 1, 2]) sum[axis] += weight * point[axis];
  return sum;
}

const mean = (points) => weighted(points.map((point) => [1 / points.length, point]));

/**
 * Of a vertex on the boundary: three quarters of itself, an eighth of either neighbour there. One without edges, which
 * counts as such, stays.
 */
function boundaryPoint(mesh, v) {
  if (mesh.isIsolatedVertex(v)) return mesh.position(v);
  const leaving = mesh.vertexHalfedge(v); // a boundary halfedge: that is what the anchor of such a vertex is
  const [before, after] = [mesh.fromVertex(mesh.prev(leaving)), mesh.toVertex(leaving)];
  return weighted([
    [3 / 4, mesh.position(v)],
    [1 / 8, mesh.position(before)],
    [1 / 8, mesh.position(after)],
  ]);
}

/** Each triangle becomes four: a vertex on each edge, and a triangle between those on its three edges. */
function loopStep(mesh) {
  const at = (v) => mesh.position(v);
  const vertices = [...mesh.vertices()];
  const edges = [...mesh.edges()];
  const isOld = (v) => v < vertices.length; // new ones come after them, since there are no gaps

  const vertexPoints = vertices.map((v) => {
    if (mesh.isBoundaryVertex(v)) return boundaryPoint(mesh, v);
    const ring = Array.from(mesh.vertexVertices(v), at);
    const n = ring.length;
    const weight = (5 / 8 - (3 / 8 + Math.cos((2 * Math.PI) / n) / 4) ** 2) / n;
    return weighted([[1 - n * weight, at(v)], ...ring.map((point) => [weight, point])]);
  });
  const edgePoints = edges.map((e) => {
    const ends = Array.from(mesh.edgeVertices(e), at);
    if (mesh.isBoundaryEdge(e)) return mean(ends);
    const opposite = Array.from(mesh.edgeHalfedges(e), (h) => at(mesh.toVertex(mesh.next(h))));
    return weighted([...ends.map((p) => [3 / 8, p]), ...opposite.map((p) => [1 / 8, p])]);
  });

  // Splitting an edge also cuts the triangles beside it, from the new vertex to the corner opposite. Where that
  // corner is an old one, the cut is turned, and joins the new vertices of the other two sides.
  const cuts = [];
  for (const [i, e] of edges.entries()) {
    const ends = [...mesh.edgeVertices(e)];
    const middle = mesh.splitEdge(e, edgePoints[i]);
    for (const h of mesh.vertexOutgoingHalfedges(middle)) {
      const corner = mesh.toVertex(h);
      if (isOld(corner) && !ends.includes(corner)) cuts.push(mesh.edge(h));
    }
  }
  for (const e of cuts) mesh.flipEdge(e);
  for (const v of vertices) mesh.setPosition(v, vertexPoints[v]);
}

/** Each face with n corners becomes n quads: a vertex in it, joined to one on each of its sides. */
function catmullClarkStep(mesh) {
  const at = (v) => mesh.position(v);
  const vertices = [...mesh.vertices()];
  const edges = [...mesh.edges()];
  const faces = [...mesh.faces()];
  const isOld = (v) => v < vertices.length;

  const facePoints = faces.map((f) => mesh.faceCentroid(f));
  const edgePoints = edges.map((e) => {
    const ends = Array.from(mesh.edgeVertices(e), at);
    if (mesh.isBoundaryEdge(e)) return mean(ends);
    return mean([...ends, ...Array.from(mesh.edgeFaces(e), (f) => facePoints[f])]);
  });
  const vertexPoints = vertices.map((v) => {
    if (mesh.isBoundaryVertex(v)) return boundaryPoint(mesh, v);
    const n = mesh.valence(v);
    const ofFaces = mean(Array.from(mesh.vertexFaces(v), (f) => facePoints[f]));
    const ofEdges = mean(Array.from(mesh.vertexEdges(v), (e) => mesh.edgeMidpoint(e)));
    return weighted([
      [1 / n, ofFaces],
      [2 / n, ofEdges],
      [(n - 3) / n, at(v)],
    ]);
  });

  for (const [i, e] of edges.entries()) mesh.insertVertexOnEdge(e, edgePoints[i]);
  for (const [i, f] of faces.entries()) {
    const centre = mesh.splitFace(f, facePoints[i]); // joined to all corners, so also to the old ones
    for (const h of [...mesh.vertexOutgoingHalfedges(centre)]) {
      if (isOld(mesh.toVertex(h))) mesh.removeEdge(mesh.edge(h));
    }
  }
  for (const v of vertices) mesh.setPosition(v, vertexPoints[v]);
  mesh.compact(); // the next step counts on it that there are no gaps
}

/** How many faces there are, and vertices of each valence: all but a few are regular. */
function describe(mesh) {
  const valences = new Map();
  for (const v of mesh.vertices()) {
    if (!mesh.isBoundaryVertex(v)) {
      const valence = mesh.valence(v);
      valences.set(valence, (valences.get(valence) ?? 0) + 1);
    }
  }
  const sorted = [...valences].sort(([a], [b]) => a - b);
  const inside = sorted.map(([valence, count]) => `${count} of valence ${valence}`).join(', ');
  const { max } = mesh.boundingBox();
  const reach = max.map((x) => x.toFixed(4)).join(' ');
  const problems = mesh.validate('geometry').length;
  const valid = problems === 0 ? 'valid' : `${problems} problems`;
  return `${mesh.faceCount} faces; inside ${inside}; up to ${reach}; ${valid}`;
}

function show(name, mesh, step) {
  console.log(`${name}: ${describe(mesh)}`);
  for (const times of ['once', 'twice']) {
    step(mesh);
    console.log(`  ${times}: ${describe(mesh)}`);
  }
  mesh.dispose();
}

await init();
const [input, output] = process.argv.slice(2);
if (input) {
  const { mesh } = HalfedgeMesh.parse(await readFile(input));
  const step = mesh.isTriangleMesh() ? loopStep : catmullClarkStep;
  for (let times = 0; times < 2; times++) step(mesh);
  console.log(describe(mesh));
  if (output) await writeFile(output, mesh.write('ply'));
  mesh.dispose();
} else {
  const pyramid = () => HalfedgeMesh.cone(4, { base: 'open' });
  show('an icosahedron, by Loop', HalfedgeMesh.icosahedron(), loopStep);
  show('an open pyramid, by Loop', pyramid(), loopStep);
  show('a cube, by Catmull and Clark', HalfedgeMesh.cube(), catmullClarkStep);
  show('an open pyramid, by Catmull and Clark', pyramid(), catmullClarkStep);
}
