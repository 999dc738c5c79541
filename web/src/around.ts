import { describe } from './arguments.js';
import * as edgeOrbit from './edge-orbit.js';
import { type Direction, NONE as none } from './items.js';
import { corrupt, type Links } from './links.js';
import * as orbit from './orbit.js';
import { directionIndex } from './rings.js';
import * as walks from './walks.js';

// Constants of this module's own: see walks.ts.
const NONE: typeof none = none;
const { EdgeOrbit } = edgeOrbit;
const { Orbit } = orbit;
const { ACROSS, ITSELF, LOOP_CCW, LOOP_CW, OPPOSITE } = walks;
const { ROTATE_CCW, ROTATE_CW, beginsAtHome, reverse, step } = walks;

// Where the lap around an item begins or ends, its home (see walks.ts), and all checks of what a caller
// passes. The common case of each function is small enough for the JIT to inline; the rest is `homeOf`.

/** What a lap goes around; a loop is the one through a halfedge. */
export type Centre = 'vertex' | 'face' | 'edge' | 'loop';

/** How to go around it. Throws a sentence for what is no direction. */
export const walkAround = (centre: Centre, direction: Direction): number => {
  const ccw = direction === 'ccw' || directionIndex(direction) === 0;
  if (centre === 'vertex') return ccw ? ROTATE_CCW : ROTATE_CW;
  if (centre === 'edge') return ACROSS;
  return ccw ? LOOP_CCW : LOOP_CW;
};

/** The halfedge where the lap ends, NONE around an isolated vertex. */
export const lastAround = (
  links: Links,
  centre: Centre,
  item: number,
  walk: number,
  start: number | undefined,
  view: number,
): number => {
  const home = homeOf(links, centre, item, walk, start, view);
  return home !== NONE && beginsAtHome(walk) ? before(links, centre, item, walk, home) : home;
};

/** The halfedge one step before `h` on the walk around an item. */
const before = (links: Links, centre: Centre, item: number, walk: number, h: number): number => {
  const previous = step(links, reverse(walk), h);
  if (previous >= 0) return previous;
  if (centre === 'loop') throw corrupt(`The loop of halfedge ${item} does not close`);
  throw corrupt(`The halfedges of ${centre} ${item} form no closed orbit`);
};

const homeAtVertex = (
  links: Links,
  v: number,
  walk: number,
  start: number | undefined,
  view: number,
): number => {
  const home = typeof v === 'number' && start === undefined ? links.vertexHalfedge[v] : -2;
  return home >= NONE ? home : rest.homeOf(links, 'vertex', v, walk, start, view);
};

const homeAtFace = (links: Links, f: number, walk: number, start: number | undefined): number => {
  const home = typeof f === 'number' && start === undefined ? links.faceHalfedge[f] : NONE;
  return home >= 0 ? home : rest.homeOf(links, 'face', f, walk, start, ITSELF);
};

/** The halfedges that leave `v`. */
export const aroundVertex = <Item extends number>(
  links: Links,
  v: number,
  direction: Direction,
  start: number | undefined,
  view: number,
): orbit.Orbit<Item> => {
  const walk =
    direction === 'ccw'
      ? ROTATE_CCW
      : direction === 'cw'
        ? ROTATE_CW
        : rest.walkAround('vertex', direction);
  return new Orbit(links, homeAtVertex(links, v, walk, start, view), walk, view);
};

/** The halfedges of `f`. */
export const aroundFace = <Item extends number>(
  links: Links,
  f: number,
  direction: Direction,
  start: number | undefined,
  view: number,
): orbit.Orbit<Item> => {
  const walk =
    direction === 'ccw'
      ? LOOP_CCW
      : direction === 'cw'
        ? LOOP_CW
        : rest.walkAround('face', direction);
  return new Orbit(links, homeAtFace(links, f, walk, start), walk, view);
};

/** The loop through `h`, from `h` on. */
export const aroundLoop = <Item extends number>(
  links: Links,
  h: number,
  direction: Direction,
  view: number,
): orbit.Orbit<Item> => {
  const walk = walkAround('loop', direction);
  return new Orbit(links, rest.homeOf(links, 'loop', h, walk, undefined, view), walk, view);
};

/** The two halfedges of `e`, side 0 first. */
export const aroundEdge = <Item extends number>(
  links: Links,
  e: number,
  view: number,
): orbit.Orbit<Item> => {
  links.checkEdge(e);
  return new EdgeOrbit(links, 2 * e + 1, view);
};

/**
 * The home of the lap around an item, in all cases: the views are detached, there is a start, an argument
 * is wrong. Circulators that show incoming halfedges take one of those as their start, too.
 *
 * One function on purpose: V8 inlines none that is so long, and so the loops of programs that use it
 * have room left for what they need inlined.
 */
const homeOf = (
  links: Links,
  centre: Centre,
  item: number,
  walk: number,
  start: number | undefined,
  view: number,
): number => {
  if (start !== undefined && (centre === 'edge' || centre === 'loop')) {
    const first =
      centre === 'edge' ? 'an edge begins with its side 0' : 'a loop begins at its halfedge';
    throw new RangeError(`start is ${describe(start)}; expected none, because ${first}.`);
  }
  if (centre === 'vertex') links.checkVertex(item);
  else if (centre === 'face') links.checkFace(item);
  else if (centre === 'edge') links.checkEdge(item);
  else links.checkHalfedge(item);
  if (centre === 'edge') return 2 * item + 1;

  let anchor = item;
  if (centre === 'vertex') anchor = links.vertexHalfedge[item];
  else if (centre === 'face') anchor = links.faceHalfedge[item];
  let first = anchor;
  if (start !== undefined) {
    links.checkHalfedge(start, 'start');
    const [from, to, face] = [links.toVertex[start ^ 1], links.toVertex[start], links.face[start]];
    const incoming = centre === 'vertex' && view === OPPOSITE;
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
  } else if (centre !== 'loop') {
    return first;
  }
  return beginsAtHome(walk) ? first : before(links, centre, item, walk, first);
};

/** Methods, because V8 compiles no property access that has never happened: see laps.ts. */
const rest = { homeOf, walkAround };
