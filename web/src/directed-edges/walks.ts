import { NONE as none } from '../items.js';
import * as walks from '../walks.js';
import type { DirectedLinks } from './links.js';

// Constants of this module's own: see ../walks.ts.
const NONE: typeof none = none;
const { FACE, ITSELF, LOOP_CCW, LOOP_CW, OPPOSITE, OPPOSITE_FACE } = walks;
const { ROTATE_CCW, ROTATE_CW, TO_VERTEX } = walks;
const { SMALL } = walks.BITS;

// The walks and views of ../walks.ts over Directed Edges. They stand apart from those: V8 compiles each of
// the two for the one kind of links that it meets.
//
// The links of a face are arithmetic: its sides are the halfedges 3 f, 3 f + 1 and 3 f + 2. Boundary halfedges come
// behind those of all faces, and have links of their own.

/** Instead of an item where links are corrupt, or views detached: neither an item nor NONE. */
const UNSOUND = -2;

/** The halfedge after `h` in its face loop or boundary loop; undefined for what is no halfedge. */
export const after = (links: DirectedLinks, h: number): number =>
  h >>> 0 < links.sides ? (h % 3 === 2 ? h - 2 : h + 1) : links.boundaryNext[h - links.sides];

/** The halfedge before `h`; undefined for what is no halfedge. */
export const before = (links: DirectedLinks, h: number): number =>
  h >>> 0 < links.sides ? (h % 3 === 0 ? h + 2 : h - 1) : links.boundaryPrev[h - links.sides];

/** The face of `h`, NONE for a boundary halfedge. */
export const faceOf = (links: DirectedLinks, h: number): number =>
  h >>> 0 < links.sides ? ((h & SMALL) / 3) | 0 : NONE;

/** One step from `h`; undefined or negative where views are detached, or links corrupt. */
export const step = (links: DirectedLinks, walk: number, h: number): number => {
  if (walk === ROTATE_CCW) return links.opposite[before(links, h)];
  if (walk === ROTATE_CW) return after(links, links.opposite[h]);
  if (walk === LOOP_CCW) return after(links, h);
  return walk === LOOP_CW ? before(links, h) : links.opposite[h];
};

/** What `view` shows of `h`; NONE for no face, less where links are corrupt, or views detached. */
export const shown = (links: DirectedLinks, view: number, h: number): number =>
  view === TO_VERTEX ? (links.toVertex[h] ?? UNSOUND) : otherThanVertex(links, view, h);

// Apart, because V8 inlines only what a program has come by.

const otherThanVertex = (links: DirectedLinks, view: number, h: number): number => {
  if (view === ITSELF) return h;
  return view === FACE ? faceOf(links, h) : acrossEdge(links, view, h);
};

/** The opposite, its face, or the edge: the smaller of both. */
const acrossEdge = (links: DirectedLinks, view: number, h: number): number => {
  const opposite = links.opposite[h] ?? UNSOUND;
  if (view === OPPOSITE_FACE && opposite >= 0) return faceOf(links, opposite);
  return view === OPPOSITE || opposite < h ? opposite : h;
};
