import { type HalfedgeMesh, NONE } from 'halfedge';
import type { Circulator, Query } from './circulators.js';

/** One step of the walk, as the expression that makes it. */
function step(mesh: HalfedgeMesh, query: Query, h: number): { expression: string; to: number } {
  const { walk } = query.circulator;
  const ccw = query.direction === 'ccw';
  if (walk === 'rotate') {
    return ccw
      ? { expression: `opposite(prev(h${h}))`, to: mesh.rotateCcw(h) }
      : { expression: `next(opposite(h${h}))`, to: mesh.rotateCw(h) };
  }
  if (walk === 'loop') {
    return ccw
      ? { expression: `next(h${h})`, to: mesh.next(h) }
      : { expression: `prev(h${h})`, to: mesh.prev(h) };
  }
  return { expression: `opposite(h${h})`, to: mesh.opposite(h) };
}

/** What the circulator shows of halfedge `h`: ` → vertex 7`, or nothing for the halfedge itself. */
function shown(mesh: HalfedgeMesh, { view }: Circulator, h: number): string {
  switch (view) {
    case 'itself':
      return '';
    case 'opposite':
      return ` → its opposite h${mesh.opposite(h)}`;
    case 'toVertex':
      return ` → vertex ${mesh.toVertex(h)}`;
    case 'edge':
      return ` → edge ${mesh.edge(h)}`;
    case 'face':
      return ` → face ${mesh.face(h)}`;
    case 'faceAcross':
      return ` → across it, face ${mesh.face(mesh.opposite(h))}`;
  }
}

function showsNothing(mesh: HalfedgeMesh, { view }: Circulator, h: number): boolean {
  if (view === 'face') return mesh.face(h) === NONE;
  if (view === 'faceAcross') return mesh.face(mesh.opposite(h)) === NONE;
  return false;
}

/** The walk in words from one halfedge to another that it reaches, skipped ones included. */
function walkWords(mesh: HalfedgeMesh, query: Query, from: number, to: number): string {
  let words = '';
  let at = from;
  for (;;) {
    const { expression, to: reached } = step(mesh, query, at);
    words += `${expression} = h${reached}`;
    at = reached;
    if (at === to || !showsNothing(mesh, query.circulator, at)) break;
    words += ', no face there: skipped; ';
  }
  return words + shown(mesh, query.circulator, to);
}

/** What the first visit of a lap does: where the walk begins, and why there. */
export function startWords(mesh: HalfedgeMesh, query: Query, first: number): string {
  const { circulator, index, start } = query;
  const end = shown(mesh, circulator, first);
  if (start === first) return `starts at the chosen h${first}${end}`;
  if (circulator.around === 'halfedge') return `starts at h${first} itself${end}`;
  if (circulator.around === 'edge') return `edgeHalfedge(${index}, 0) = h${first}${end}`;
  const accessor = circulator.around === 'vertex' ? 'vertexHalfedge' : 'faceHalfedge';
  const stored = start ?? mesh[accessor](index as never);
  if (stored === first) return `${accessor}(${index}) = h${first}${end}`;
  const named =
    start !== undefined ? 'chosen' : circulator.around === 'vertex' ? 'anchor' : accessor;
  return `${named} h${stored}: ${walkWords(mesh, query, stored, first)}`;
}

/** What a step did: `opposite(prev(h12)) = h31 → vertex 7`. */
export function hopWords(mesh: HalfedgeMesh, query: Query, from: number, to: number): string {
  return walkWords(mesh, query, from, to);
}
