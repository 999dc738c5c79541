import type { HalfedgeMesh } from '../api.js';

/**
 * The halfedges of a shortest path along edges from vertex `from` to vertex `to`, without the vertices
 * of `avoided` in between; null if there is none. O(what is nearer than the end).
 */
function edgePath(
  mesh: HalfedgeMesh,
  from: number,
  to: number,
  avoided: ReadonlySet<number> = new Set(),
): number[] | null {
  if (from === to) return [];
  const arrivedBy = new Map<number, number>([[from, -1]]);
  const queue = [from];
  for (let at = 0; at < queue.length && !arrivedBy.has(to); at++) {
    for (const h of mesh.vertexOutgoingHalfedges(queue[at])) {
      const v = mesh.toVertex(h);
      if (arrivedBy.has(v) || (avoided.has(v) && v !== to)) continue;
      arrivedBy.set(v, h);
      queue.push(v);
    }
  }
  if (!arrivedBy.has(to)) return null;
  const path: number[] = [];
  for (let v = to; v !== from; ) {
    const h = arrivedBy.get(v) as number;
    path.push(h);
    v = mesh.fromVertex(h);
  }
  return path.reverse();
}

/** A path that begins with one halfedge and ends with another; both alone where nothing joins them. */
export function pathThrough(mesh: HalfedgeMesh, first: number, last: number): number[] {
  if (first === last) return [first];
  const between = edgePath(mesh, mesh.toVertex(first), mesh.fromVertex(last));
  return between ? [first, ...between, last] : [first, last];
}

/** A cycle through two halfedges that meets no vertex twice; both alone where there is none. */
export function cycleThrough(mesh: HalfedgeMesh, first: number, second: number): number[] {
  const [a, b] = [mesh.fromVertex(first), mesh.toVertex(first)];
  const [c, d] = [mesh.fromVertex(second), mesh.toVertex(second)];
  const there = edgePath(mesh, b, c, new Set([a, d]));
  if (!there) return [first, second];
  const used = new Set([a, b, c, d, ...there.map((h) => mesh.toVertex(h))]);
  const back = edgePath(mesh, d, a, used);
  return back ? [first, ...there, second, ...back] : [first, second];
}

/** Longer stretches are glued one after the other: each length is tried. */
const MOST_GLUED = 1000;

/** How many edges can be glued from two boundary halfedges on: as many as the mesh allows, at least 1. */
export function gluable(mesh: HalfedgeMesh, h: number, g: number): number {
  const longest = Math.min([...mesh.halfedgeLoop(h)].length, [...mesh.halfedgeLoop(g)].length);
  let count = Math.min(longest, MOST_GLUED);
  while (count > 1 && mesh.checkGluePath(h, g, count) !== null) count -= 1;
  return count;
}
