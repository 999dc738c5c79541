import { type HalfedgeMesh, NONE } from '../../api.js';
import { permutation, type Random } from './random.js';

/**
 * Gives every vertex, halfedge, edge and face of a mesh another index, and every vertex and face another
 * anchor. The surface stays as it is; a program that calculates with indices, or relies on where a walk
 * begins, does not survive it. The mesh must have no deleted items.
 */
export function shuffle(mesh: HalfedgeMesh, random: Random): void {
  const { next, prev, toVertex, face, vertexHalfedge, faceHalfedge } = mesh.connectivity;
  const vertices = permutation(mesh.vertexSlots, random);
  const faces = permutation(mesh.faceSlots, random);
  const edges = permutation(mesh.edgeSlots, random);
  const sides = edges.map(() => random(2));
  const halfedge = (h: number) =>
    h === NONE ? NONE : 2 * edges[h >> 1] + ((h & 1) ^ sides[h >> 1]);
  const halfedges = Array.from(next, (_, h) => halfedge(h));

  renumber(next, halfedges, halfedge);
  renumber(prev, halfedges, halfedge);
  renumber(toVertex, halfedges, (v) => vertices[v]);
  renumber(face, halfedges, (f) => (f === NONE ? NONE : faces[f]));
  renumber(vertexHalfedge, vertices, halfedge);
  renumber(faceHalfedge, faces, halfedge);
  const points = mesh.positions.slice();
  vertices.forEach((to, v) => {
    mesh.positions.set(points.subarray(3 * v, 3 * v + 3), 3 * to);
  });
  moveAnchors(mesh, random);
}

/** Moves what lies at `i` to `places[i]`, each value changed by `value`. */
function renumber(
  links: Int32Array,
  places: readonly number[],
  value: (old: number) => number,
): void {
  const old = links.slice();
  places.forEach((to, i) => {
    links[to] = value(old[i]);
  });
}

/** At the boundary the anchor of a vertex stays a boundary halfedge: the library promises that. */
function moveAnchors(mesh: HalfedgeMesh, random: Random): void {
  const { vertexHalfedge, faceHalfedge } = mesh.connectivity;
  for (const v of mesh.vertices()) {
    const all = [...mesh.vertexOutgoingHalfedges(v)];
    const atBoundary = all.filter((h) => mesh.isBoundaryHalfedge(h));
    const choices = atBoundary.length > 0 ? atBoundary : all;
    if (choices.length > 0) vertexHalfedge[v] = choices[random(choices.length)];
  }
  for (const f of mesh.faces()) {
    const all = [...mesh.faceHalfedges(f)];
    faceHalfedge[f] = all[random(all.length)];
  }
}
