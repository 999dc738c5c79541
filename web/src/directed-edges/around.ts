import { describe } from '../arguments.js';
import * as around from '../around.js';
import { type Direction, NONE as none } from '../items.js';
import { corrupt } from '../links.js';
import * as general from '../walks.js';
import type { DirectedLinks } from './links.js';
import * as orbit from './orbit.js';
import * as walks from './walks.js';

// Constants of this module's own: see ../walks.ts.
const NONE: typeof none = none;
const { DirectedOrbit } = orbit;
const { walkAround } = around;
const { ITSELF, LOOP_CCW, LOOP_CW, OPPOSITE } = general;
const { ROTATE_CCW, ROTATE_CW, beginsAtHome, reverse } = general;
const { before, faceOf, step } = walks;
type Centre = around.Centre;

// As ../around.ts, over Directed Edges.

/** The halfedges that leave `v`. */
export const aroundVertex = <Item extends number>(
  links: DirectedLinks,
  v: number,
  direction: Direction,
  start: number | undefined,
  view: number,
): orbit.DirectedOrbit<Item> => {
  const walk =
    direction === 'ccw'
      ? ROTATE_CCW
      : direction === 'cw'
        ? ROTATE_CW
        : rest.walkAround('vertex', direction);
  const anchor = typeof v === 'number' && start === undefined ? links.vertexHalfedge[v] : -2;
  const home = anchor >= NONE ? anchor : rest.homeOf(links, 'vertex', v, walk, start, view);
  return new DirectedOrbit(links, home, walk, view);
};

/** The halfedges of `f`. */
export const aroundFace = <Item extends number>(
  links: DirectedLinks,
  f: number,
  direction: Direction,
  start: number | undefined,
  view: number,
): orbit.DirectedOrbit<Item> => {
  const walk =
    direction === 'ccw'
      ? LOOP_CCW
      : direction === 'cw'
        ? LOOP_CW
        : rest.walkAround('face', direction);
  const isUsual = typeof f === 'number' && f >>> 0 === f && start === undefined;
  const home =
    isUsual && 3 * f < links.sides ? 3 * f : rest.homeOf(links, 'face', f, walk, start, ITSELF);
  return new DirectedOrbit(links, home, walk, view);
};

/** The loop through `h`, from `h` on. */
export const aroundLoop = <Item extends number>(
  links: DirectedLinks,
  h: number,
  direction: Direction,
  view: number,
): orbit.DirectedOrbit<Item> => {
  const walk = walkAround('loop', direction);
  return new DirectedOrbit(links, homeOf(links, 'loop', h, walk, undefined, view), walk, view);
};

/** The two halfedges of `e`, side 0 first. */
export const aroundEdge = <Item extends number>(
  links: DirectedLinks,
  e: number,
  view: number,
): orbit.DirectedOrbit<Item> => {
  const walk = walkAround('edge', 'ccw');
  return new DirectedOrbit(links, homeOf(links, 'edge', e, walk, undefined, view), walk, view);
};

/**
 * The home of the lap around an item, in all cases: the views are detached, there is a start, an argument
 * is wrong. Circulators that show incoming halfedges take one of those as their start, too.
 *
 * One function on purpose, as there: too long for V8 to inline.
 */
export const homeOf = (
  links: DirectedLinks,
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
  if (centre === 'edge') return links.opposite[item];

  let first = item;
  if (start !== undefined) {
    links.checkHalfedge(start, 'start');
    const [from, to] = [links.toVertex[before(links, start)], links.toVertex[start]];
    const face = faceOf(links, start);
    const incoming = centre === 'vertex' && view === OPPOSITE;
    first = incoming && to === item ? links.opposite[start] : start;
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
  } else if (centre === 'vertex') {
    return links.vertexHalfedge[item];
  } else if (centre === 'face') {
    return 3 * item;
  }
  if (beginsAtHome(walk)) return first;
  const home = step(links, reverse(walk), first);
  if (home >= 0) return home;
  if (centre === 'loop') throw corrupt(`The loop of halfedge ${item} does not close`);
  throw corrupt(`The halfedges of ${centre} ${item} form no closed orbit`);
};

/** Methods, because V8 compiles no property access that has never happened: see ../laps.ts. */
const rest = { homeOf, walkAround };
