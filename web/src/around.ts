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
// for the JIT to inline; the rest is in functions of its own.

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
  if (!(ccw && start === undefined && last >= NONE)) {
    last = lastAroundVertex(links, v, direction, start, view);
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
  let last = typeof f === 'number' ? links.prev[links.faceHalfedge[f]] : NONE;
  const ccw = direction === 'ccw';
  if (!(ccw && start === undefined && last >= 0)) {
    last = lastAroundFace(links, f, direction, start);
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
  const [walk, back] = directionIndex(direction) === 1 ? [LOOP_CW, LOOP_CCW] : [LOOP_CCW, LOOP_CW];
  return new Orbit(links, stepBack(links, back, h), walk, view);
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

function lastAroundVertex(
  links: Links,
  v: number,
  direction: unknown,
  start: number | undefined,
  view: number,
): number {
  links.checkVertex(v);
  const clockwise = directionIndex(direction) === 1;
  const back = clockwise ? ROTATE_CCW : ROTATE_CW;
  if (start !== undefined) return stepBack(links, back, outgoing(links, v, start, view));
  const anchor = links.vertexHalfedge[v];
  return clockwise && anchor !== NONE ? stepBack(links, back, anchor) : anchor;
}

function lastAroundFace(
  links: Links,
  f: number,
  direction: unknown,
  start: number | undefined,
): number {
  links.checkFace(f);
  const clockwise = directionIndex(direction) === 1;
  const back = clockwise ? LOOP_CCW : LOOP_CW;
  if (start !== undefined) return stepBack(links, back, inFace(links, f, start));
  const first = links.faceHalfedge[f];
  return clockwise ? first : stepBack(links, back, first);
}

/** `start` as a halfedge that leaves `v`. Circulators that show incoming ones take those as well. */
function outgoing(links: Links, v: number, start: number, view: number): number {
  links.checkHalfedge(start, 'start');
  const { toVertex } = links;
  if (view === OPPOSITE && toVertex[start] === v) return start ^ 1;
  if (toVertex[start ^ 1] === v) return start;
  const from = toVertex[start ^ 1];
  const [is, expected] =
    view === OPPOSITE
      ? [`goes from vertex ${from} to ${toVertex[start]}`, 'arrives at']
      : [`leaves vertex ${from}`, 'leaves'];
  throw new RangeError(
    `start is halfedge ${describe(start)}, which ${is}; expected one that ${expected} vertex ${v}.`,
  );
}

/** `start`, if it is a halfedge of `f`. */
function inFace(links: Links, f: number, start: number): number {
  links.checkHalfedge(start, 'start');
  const face = links.face[start];
  if (face === f) return start;
  const where = face === NONE ? 'no face' : `face ${face}`;
  throw new RangeError(
    `start is halfedge ${describe(start)}, which lies in ${where}; expected one that lies in face ${f}.`,
  );
}

function stepBack(links: Links, back: number, h: number): number {
  const before = step(links, back, h);
  if (before >= 0) return before;
  throw corrupt(`Halfedge ${h} has no sound neighbours`);
}
