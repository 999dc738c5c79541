import { type HalfedgeMesh, NONE } from '../api.js';
import type { Circulator, Query } from './circulators.js';
import type { Dialect } from './dialects.js';
import { arrives, stepOf, stepsFirst } from './program.js';

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
function cursor(mesh: HalfedgeMesh, query: Query, dialect: Dialect, h: number): number {
  return arrives(query, dialect) ? mesh.opposite(h) : h;
}

/** What the circulator shows of halfedge `h`: ` → vertex 7`, or nothing for the halfedge itself. */
function shown(mesh: HalfedgeMesh, query: Query, dialect: Dialect, h: number): string {
  const isAcross = arrives(query, dialect);
  switch (query.circulator.view) {
    case 'itself':
      return isAcross ? ` → its opposite h${h}` : '';
    case 'opposite':
      return isAcross ? '' : ` → its opposite h${mesh.opposite(h)}`;
    case 'toVertex':
      return ` → ${isAcross ? 'its start, ' : ''}vertex ${mesh.toVertex(h)}`;
    case 'edge':
      return ` → edge ${mesh.edge(h)}`;
    case 'face':
      return ` → ${isAcross ? 'across it, ' : ''}face ${mesh.face(h)}`;
    case 'faceAcross':
      return ` → across it, face ${mesh.face(mesh.opposite(h))}`;
  }
}

function showsNothing(mesh: HalfedgeMesh, { view }: Circulator, h: number): boolean {
  if (view === 'face') return mesh.face(h) === NONE;
  if (view === 'faceAcross') return mesh.face(mesh.opposite(h)) === NONE;
  return false;
}

/** What is said of a halfedge that shows nothing. */
function noFace(query: Query, dialect: Dialect): string {
  const isAcross = query.circulator.view === 'faceAcross' || arrives(query, dialect);
  return `no face ${isAcross ? 'across it' : 'there'}`;
}

/**
 * What a step did, from one halfedge to another that the walk reaches: `opposite(prev(h12)) = h31 → vertex 7`. Those
 * that are skipped on the way are told, too.
 */
export function hopWords(
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
    words += `, ${noFace(query, dialect)}: skipped; `;
  }
  return words + shown(mesh, query, dialect, to);
}

/** What the first visit of a lap does: where the walk begins, and how it gets from there to what it shows. */
export function startWords(
  mesh: HalfedgeMesh,
  query: Query,
  first: number,
  dialect: Dialect,
): string {
  const begin = anchorOf(mesh, query);
  const name = `h${cursor(mesh, query, dialect, begin)}`;
  const walk = () => hopWords(mesh, query, begin, first, dialect);
  if (stepsFirst(query)) return `${anchorName(query, dialect, name)}: ${walk()}`;
  const words = beginWords(query, dialect, name);
  if (begin === first) return words + shown(mesh, query, dialect, first);
  return `${words}, ${noFace(query, dialect)}: skipped; ${walk()}`;
}

/** The halfedge where the cursor is before the first step. */
function anchorOf(mesh: HalfedgeMesh, { circulator: { around }, index, start }: Query): number {
  if (start !== undefined) return start;
  switch (around) {
    case 'vertex':
      return mesh.vertexHalfedge(index);
    case 'face':
      return mesh.faceHalfedge(index);
    case 'edge':
      return mesh.edgeHalfedge(index);
    case 'halfedge':
      return index;
  }
}

/** The halfedge where a walk begins by a step: `anchor h12`, `v3->halfedge() = h12`. */
function anchorName(query: Query, dialect: Dialect, name: string): string {
  if (dialect.id !== 'halfedge') return beginWords(query, dialect, name);
  return `${query.circulator.around === 'vertex' ? 'anchor' : 'faceHalfedge'} ${name}`;
}

/** Where a walk begins: `vertexHalfedge(3) = h12`. */
function beginWords(query: Query, dialect: Dialect, name: string): string {
  const { circulator, index, start } = query;
  const { around } = circulator;
  if (start !== undefined) {
    if (arrives(query, dialect)) return `chosen h${start}->opposite() = ${name}`;
    return `starts at the chosen ${name}`;
  }
  if (around === 'halfedge') return `starts at ${name} itself`;
  if (dialect.id === 'halfedge') {
    if (around === 'edge') return `edgeHalfedge(${index}, 0) = ${name}`;
    return `${around}Halfedge(${index}) = ${name}`;
  }
  if (around === 'edge') return `starts at ${name}`;
  const anchor = dialect.anchor(around, around[0] + index);
  return `${anchor.replace('.', dialect.mesh ? '.' : '->')} = ${name}`;
}
