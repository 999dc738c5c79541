// An operation of your own, made of those of the library: inserts an edge loop, as modelling programs do. It
// cuts a strip of quads lengthwise, and is one step of history.
//
//   node examples/edge_loop.mjs

import { HalfedgeMesh, init } from 'halfedge';

/**
 * One halfedge of each edge across the strip of quads that `e` lies in, in order. Each has a quad of the strip on
 * its left, but for the last one of a strip that is no ring.
 */
function stripThrough(mesh, e) {
  const isQuad = (h) => !mesh.isBoundaryHalfedge(h) && mesh.degree(mesh.face(h)) === 4;
  const start = mesh.edgeHalfedge(e);
  let h = start;
  while (isQuad(mesh.opposite(h))) {
    h = mesh.next(mesh.next(mesh.opposite(h))); // back, to the beginning of the strip
    if (h === start) break;
  }
  const strip = [h];
  while (isQuad(h)) {
    h = mesh.opposite(mesh.next(mesh.next(h)));
    if (h === strip[0]) return { strip, isRing: true };
    strip.push(h);
  }
  return { strip, isRing: false };
}

/** Cuts the edges of the strip in the middle, and joins the new vertices. Returns the new edges. */
function insertEdgeLoop(mesh, e) {
  const { strip, isRing } = stripThrough(mesh, e);
  const quads = (isRing ? strip : strip.slice(0, -1)).map((h) => mesh.face(h));
  if (new Set(quads).size < quads.length)
    throw new RangeError(`The strip of e${e} crosses itself.`);
  return mesh.history.group(() => {
    // What leads to each new vertex in the quad on the left of the edge that was cut, and in the one on its right.
    const left = strip.map((h) => {
      const v = mesh.insertVertexOnEdge(mesh.edge(h));
      return mesh.toVertex(h) === v ? h : mesh.prev(h); // `h` may have become the other half
    });
    const right = left.map((h) => mesh.nextOnVertex(h));
    return quads.map((_, i) => mesh.insertEdge(left[i], right[(i + 1) % strip.length]));
  });
}

await init();
const mesh = HalfedgeMesh.cube();
mesh.history.enabled = true;
const tell = (what) => {
  const { vertexCount, edgeCount, faceCount } = mesh;
  console.log(`${what}: ${vertexCount} vertices, ${edgeCount} edges, ${faceCount} faces`);
};
tell('a cube');
const loop = insertEdgeLoop(mesh, 0);
tell(`with a loop of ${loop.length} edges`);
tell(`with another of ${insertEdgeLoop(mesh, loop[0]).length}`); // across the first
console.log(`all quads: ${mesh.isQuadMesh()}, problems: ${mesh.validate('geometry').length}`);
mesh.history.undo();
tell('the second taken back');
