import { describe } from './arguments.js';
import { type Direction, NONE } from './items.js';
import { corrupt, type Links } from './links.js';
import {
  ACROSS,
  LOOP_CCW,
  LOOP_CW,
  OPPOSITE,
  Orbit,
  ROTATE_CCW,
  ROTATE_CW,
  step,
} from './orbit.js';
import { directionIndex } from './rings.js';

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
): Orbit<Item> {
  let last = typeof v === 'number' ? links.vertexHalfedge[v] : -2;
  if (!(last >= NONE)) last = anchorOf(links, v);
  const ccw = direction === 'ccw';
  if (!ccw || start !== undefined) last = lastAroundVertex(links, v, direction, start, view);
  return new Orbit(links, last, ccw ? ROTATE_CCW : ROTATE_CW, view);
}

/** The halfedges of `f`. */
export function aroundFace<Item extends number>(
  links: Links,
  f: number,
  direction: Direction,
  start: number | undefined,
  view: number,
): Orbit<Item> {
  const first = typeof f === 'number' ? links.faceHalfedge[f] : -2;
  const ccw = direction === 'ccw';
  let last = ccw ? links.prev[first] : first;
  if (!(last >= 0) || !ccw || start !== undefined) {
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
): Orbit<Item> {
  links.checkHalfedge(h);
  const [walk, back] = directionIndex(direction) === 1 ? [LOOP_CW, LOOP_CCW] : [LOOP_CCW, LOOP_CW];
  return new Orbit(links, stepBack(links, back, h), walk, view);
}

/** The two halfedges of `e`, side 0 first. */
export function aroundEdge<Item extends number>(
  links: Links,
  e: number,
  view: number,
): Orbit<Item> {
  if (!(typeof e === 'number' && (e | 0) === e && links.next[2 * e] >= 0)) links.checkEdge(e);
  return new Orbit(links, 2 * e + 1, ACROSS, view);
}

/** The anchor of `v`, with fresh views; throws a sentence unless `v` is a live vertex. */
function anchorOf(links: Links, v: number): number {
  links.checkVertex(v);
  const anchor = links.vertexHalfedge[v];
  if (anchor >= NONE) return anchor;
  throw corrupt(`vertexHalfedge[${v}] is ${anchor}`);
}

function lastAroundVertex(
  links: Links,
  v: number,
  direction: unknown,
  start: number | undefined,
  view: number,
): number {
  const clockwise = directionIndex(direction) === 1;
  const back = clockwise ? ROTATE_CCW : ROTATE_CW;
  if (start !== undefined) return stepBack(links, back, outgoing(links, v, start, view));
  const anchor = anchorOf(links, v);
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
  if (!(first >= 0)) throw corrupt(`faceHalfedge[${f}] is ${first}`);
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
