import { describe } from './arguments.js';
import { type Direction, NONE as none } from './items.js';
import { corrupt, type Links } from './links.js';
import * as orbit from './orbit.js';
import { directionIndex } from './rings.js';

// Constants of this module's own: see orbit.ts.
const NONE: typeof none = none;
const { ACROSS, LOOP_CCW, LOOP_CW, OPPOSITE, Orbit, ROTATE_CCW, ROTATE_CW, step } = orbit;

// Where the lap around an item begins, and all checks of what a caller passes. An orbit is told where
// it *ends*, one step before its first halfedge: around a vertex that is the anchor for the default
// direction, so that nothing needs to be looked up. The common case of each function is small enough
// for the JIT to inline; the rest is `lastOf`.

/** The halfedges that leave `v`. */
export function aroundVertex<Item extends number>(
  links: Links,
  v: number,
  direction: Direction,
  start: number | undefined,
  view: number,
): orbit.Orbit<Item> {
  let last = typeof v === 'number' ? links.vertexHalfedge[v] : -2;
  const ccw = direction === 'ccw';
  if (!ccw && last >= 0) {
    const before = links.prev[last];
    last = direction === 'cw' && before >= 0 ? before ^ 1 : -2;
  }
  if (start !== undefined || !(last >= NONE)) {
    last = rest.lastOf(links, 'vertex', v, direction, start, view === OPPOSITE);
  }
  return new Orbit(links, last, ccw ? ROTATE_CCW : ROTATE_CW, view);
}

/** The halfedges of `f`. */
export function aroundFace<Item extends number>(
  links: Links,
  f: number,
  direction: Direction,
  start: number | undefined,
  view: number,
): orbit.Orbit<Item> {
  let last = typeof f === 'number' ? links.faceHalfedge[f] : NONE;
  const ccw = direction === 'ccw';
  if (ccw && last >= 0) last = links.prev[last];
  if (start !== undefined || !(last >= 0 && (ccw || direction === 'cw'))) {
    last = rest.lastOf(links, 'face', f, direction, start, false);
  }
  return new Orbit(links, last, ccw ? LOOP_CCW : LOOP_CW, view);
}

/** The loop through `h`, from `h` on. */
export function aroundLoop<Item extends number>(
  links: Links,
  h: number,
  direction: Direction,
  view: number,
): orbit.Orbit<Item> {
  links.checkHalfedge(h);
  const clockwise = directionIndex(direction) === 1;
  const last = step(links, clockwise ? LOOP_CCW : LOOP_CW, h);
  if (!(last >= 0)) throw corrupt(`The loop of halfedge ${h} does not close`);
  return new Orbit(links, last, clockwise ? LOOP_CW : LOOP_CCW, view);
}

/** The two halfedges of `e`, side 0 first. */
export function aroundEdge<Item extends number>(
  links: Links,
  e: number,
  view: number,
): orbit.Orbit<Item> {
  if (!(typeof e === 'number' && (e | 0) === e && links.next[2 * e] >= 0)) links.checkEdge(e);
  return new Orbit(links, 2 * e + 1, ACROSS, view);
}

/**
 * Where the lap around a vertex or a face ends, in all cases: the views are detached, there is a start,
 * an argument is wrong. Circulators that show incoming halfedges take one of those as their start, too.
 *
 * One function on purpose: V8 inlines none that is so long, and so the loops of programs that use it
 * have room left for what they need inlined.
 */
function lastOf(
  links: Links,
  centre: 'vertex' | 'face',
  item: number,
  direction: unknown,
  start: number | undefined,
  incoming: boolean,
): number {
  const clockwise = directionIndex(direction) === 1;
  if (centre === 'vertex') links.checkVertex(item);
  else links.checkFace(item);

  const anchor = centre === 'vertex' ? links.vertexHalfedge[item] : links.faceHalfedge[item];
  let first = anchor;
  if (start !== undefined) {
    links.checkHalfedge(start, 'start');
    const [from, to, face] = [links.toVertex[start ^ 1], links.toVertex[start], links.face[start]];
    first = incoming && to === item ? start ^ 1 : start;
    if (incoming && to !== item && from !== item) {
      throw new RangeError(
        `start is halfedge ${describe(start)}, which goes from vertex ${from} to ${to}; expected one that arrives at vertex ${item}.`,
      );
    }
    if (centre === 'vertex' && !incoming && from !== item) {
      throw new RangeError(
        `start is halfedge ${describe(start)}, which leaves vertex ${from}; expected one that leaves vertex ${item}.`,
      );
    }
    if (centre === 'face' && face !== item) {
      throw new RangeError(
        `start is halfedge ${describe(start)}, which lies in ${face === NONE ? 'no face' : `face ${face}`}; expected one that lies in face ${item}.`,
      );
    }
  } else if (first === NONE && centre === 'vertex') {
    return NONE;
  } else if (clockwise === (centre === 'face')) {
    return first; // these directions end at the anchor
  }
  let back = clockwise ? ROTATE_CCW : ROTATE_CW;
  if (centre === 'face') back = clockwise ? LOOP_CCW : LOOP_CW;
  const last = step(links, back, first);
  if (last >= 0) return last;
  throw corrupt(`The halfedges of ${centre} ${item} form no closed orbit`);
}

/** A method, because V8 compiles no property access that has never happened: see orbit.ts. */
const rest = { lastOf };
