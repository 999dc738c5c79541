import { type HalfedgeMesh, NONE } from '../api.js';
import type { Circulator, Query } from './circulators.js';
import type { Dialect } from './dialects.js';
import { stepOf } from './program.js';

/** One step of the walk, as the expression that makes it. */
function step(
  mesh: HalfedgeMesh,
  query: Query,
  dialect: Dialect,
  h: number,
): { expression: string; to: number } {
  const kind = stepOf(query);
  const to = {
    rotateCcw: () => mesh.rotateCcw(h),
    rotateCw: () => mesh.rotateCw(h),
    next: () => mesh.next(h),
    prev: () => mesh.prev(h),
    across: () => mesh.opposite(h),
  }[kind]();
  const at = cursor(mesh, query, dialect, h);
  const before = `h${mesh.prev(h)}`;
  return { expression: dialect.stepName(kind, `h${at}`, before), to };
}

/** The halfedge that the dialect is at, where ours is `h`: one that arrives, or one that leaves. */
function cursor(mesh: HalfedgeMesh, { circulator }: Query, dialect: Dialect, h: number): number {
  return dialect.arrives && circulator.walk === 'rotate' ? mesh.opposite(h) : h;
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
function walkWords(
  mesh: HalfedgeMesh,
  query: Query,
  from: number,
  to: number,
  dialect: Dialect,
): string {
  let words = '';
  let at = from;
  for (;;) {
    const { expression, to: reached } = step(mesh, query, dialect, at);
    words += `${expression} = h${cursor(mesh, query, dialect, reached)}`;
    at = reached;
    if (at === to || !showsNothing(mesh, query.circulator, at)) break;
    words += ', no face there: skipped; ';
  }
  return words + shown(mesh, query.circulator, to);
}

/** What the first visit of a lap does: where the walk begins, and why there. */
export function startWords(
  mesh: HalfedgeMesh,
  query: Query,
  first: number,
  dialect: Dialect,
): string {
  const { circulator, index, start } = query;
  const end = shown(mesh, circulator, first);
  const name = (h: number) => `h${cursor(mesh, query, dialect, h)}`;
  if (start === first) return `starts at the chosen ${name(first)}${end}`;
  if (circulator.around === 'halfedge') return `starts at ${name(first)} itself${end}`;
  const isOurs = dialect.id === 'halfedge';
  if (circulator.around === 'edge') {
    return isOurs ? `edgeHalfedge(${index}, 0) = h${first}${end}` : `starts at h${first}${end}`;
  }
  const accessor = circulator.around === 'vertex' ? 'vertexHalfedge' : 'faceHalfedge';
  const stored = start ?? mesh[accessor](index as never);
  const letter = circulator.around === 'vertex' ? 'v' : 'f';
  const anchor = isOurs
    ? `${accessor}(${index})`
    : dialect.anchor(circulator.around, letter + index).replace('.', dialect.mesh ? '.' : '->');
  if (stored === first) return `${anchor} = ${name(first)}${end}`;
  const named =
    start !== undefined ? 'chosen' : circulator.around === 'vertex' ? 'anchor' : accessor;
  return `${isOurs || start !== undefined ? named : anchor} ${name(stored)}: ${walkWords(mesh, query, stored, first, dialect)}`;
}

/** What a step did: `opposite(prev(h12)) = h31 → vertex 7`. */
export function hopWords(
  mesh: HalfedgeMesh,
  query: Query,
  from: number,
  to: number,
  dialect: Dialect,
): string {
  return walkWords(mesh, query, from, to, dialect);
}
