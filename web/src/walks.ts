import { NONE as none } from './items.js';
import type { Links } from './links.js';

/**
 * A constant of this module's own. V8 checks at each use of one that is imported, or exported, whether it
 * is initialised, and the error that it would throw keeps the iterators of inlined loops in memory.
 */
const NONE: typeof none = none;

// An orbit has a *walk* (how to step from halfedge to halfedge) and a *view* (what to show of each).
// All circulators are combinations of five walks and six views. Both are small integers, so that one
// hidden class serves every circulator, and the JIT folds them away where it inlines.
//
//              to(h)
//               ^ |            rotate cw:  next(opposite(h))     both leave from(h)
//             h | | opposite   rotate ccw: opposite(prev(h))
//               | v
//             from(h)          face(h) lies to the left of h

/** To the opposite as well: after prev, before next. */
const TURN = 1;
/** Along next; without that and STAY a walk goes along prev. */
const ALONG_NEXT = 2;
/** Nowhere. */
const STAY = 4;

/**
 * A lap has a *home*, for which nothing needs to be looked up: the anchor of its item, as long as nobody
 * names a start. Walks along next begin there, and show where they are before they step. The others end
 * there, and step before they show.
 */
const SHOW_THEN_STEP = ALONG_NEXT;

/** Outgoing halfedges of a vertex. */
export const ROTATE_CCW = TURN;
export const ROTATE_CW = ALONG_NEXT | TURN;
/** Halfedges of a face or of a boundary loop. */
export const LOOP_CCW = ALONG_NEXT;
export const LOOP_CW = 0;
/** The two halfedges of an edge. */
export const ACROSS = STAY | TURN;

const SHOW_OPPOSITE = 1;
const SHOW_EDGE = 2;
const SHOW_VERTEX = 4;
const SHOW_FACE = 8;

export const ITSELF = 0;
export const OPPOSITE = SHOW_OPPOSITE;
export const EDGE = SHOW_EDGE;
export const TO_VERTEX = SHOW_VERTEX;
export const FACE = SHOW_FACE;
export const OPPOSITE_FACE = SHOW_FACE | SHOW_OPPOSITE;

/** Whether a lap begins at its home, rather than ends there. */
export const beginsAtHome = (walk: number): boolean => (walk & SHOW_THEN_STEP) !== 0;

/** The walk that undoes `walk`. */
export function reverse(walk: number): number {
  return walk === ACROSS ? ACROSS : walk ^ ALONG_NEXT;
}

/** What a walk exchanges for the opposite: 1 for yes, before it looks the next halfedge up or after. */
const turnBefore = (walk: number): number => (walk >> 1) & walk & TURN;
const turnAfter = (walk: number): number => ~(walk >> 1) & walk & TURN;

/**
 * All indices of halfedges lie below: 2^30 of them would need more memory than there is. Masking
 * with it tells the JIT that a number needs no check to fit in a tagged small integer.
 */
const SMALL = 0x3fffffff;

/** What a step from `h` reads; undefined or negative where views are detached, or links corrupt. */
const linkFrom = (links: Links, walk: number, h: number): number => {
  if (walk >= STAY) return h;
  return ((walk & ALONG_NEXT) === 0 ? links.prev : links.next)[h ^ turnBefore(walk)];
};

/** Where a step that reads `link` leads to. */
const arrival = (walk: number, link: number): number => (link ^ turnAfter(walk)) & SMALL;

/** One step from `h`, through the live views; NONE where there is no link. */
export const step = (links: Links, walk: number, h: number): number => {
  const link = linkFrom(links, walk, h);
  return link >= 0
    ? arrival(walk, link)
    : links.storesPrev
      ? NONE
      : search.stepByPrev(links, walk, h);
};

/** A step along prev where it isn't stored; NONE where the links are corrupt. */
function stepByPrev(links: Links, walk: number, h: number): number {
  if ((walk & (ALONG_NEXT | STAY)) !== 0) return NONE;
  const link = links.findPrev(h);
  return link >= 0 ? arrival(walk, link) : NONE;
}
/** A method, because V8 compiles no property access that has never happened. */
const search = { stepByPrev };

/** What `view` shows of `h`; NONE for no face, undefined or below NONE where links are corrupt. */
export const shown = (links: Links, view: number, h: number): number => {
  const side = h ^ (view & SHOW_OPPOSITE);
  if (view < SHOW_VERTEX) return side >> (view >> 1);
  return view < SHOW_FACE ? links.toVertex[side] : links.face[side];
};

/** The constants of this module, for others to make their own of. */
export const BITS = { TURN, SHOW_OPPOSITE, SMALL } as const;
