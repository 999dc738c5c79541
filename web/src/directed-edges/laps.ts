import { NONE as none } from '../items.js';
import type { Result } from '../laps.js';
import * as general from '../walks.js';
import type { DirectedOrbit } from './orbit.js';
import * as walks from './walks.js';

// Constants of this module's own: see ../walks.ts.
const NONE: typeof none = none;
const { FACE, LOOP_CCW, LOOP_CW, ROTATE_CCW, ROTATE_CW } = general;
const { SMALL } = general.BITS;
const { after, before, faceOf, shown } = walks;

/** One lap underway: where to go on, NONE when it is over; and how many steps there may be after the next. */
export interface Lap {
  next: () => Result;
  orbit: DirectedOrbit<number>;
  at: number;
  left: number;
}

// As ../laps.ts, and for the reasons there.

const nextByRotationCcw = function (this: Lap): Result {
  const item = rotateCcw(this);
  return { value: item, done: item < 0 } as Result;
};
const nextByRotationCw = function (this: Lap): Result {
  const item = rotateCw(this);
  return { value: item, done: item < 0 } as Result;
};
const nextAlongNext = function (this: Lap): Result {
  const item = alongNext(this);
  return { value: item, done: item < 0 } as Result;
};
const nextAlongPrev = function (this: Lap): Result {
  const item = alongPrev(this);
  return { value: item, done: item < 0 } as Result;
};
const nextFaceCcw = function (this: Lap): Result {
  const item = faceCcw(this);
  return { value: item, done: item < 0 } as Result;
};
const nextFaceCw = function (this: Lap): Result {
  const item = faceCw(this);
  return { value: item, done: item < 0 } as Result;
};
const nextNeighbourCcw = function (this: Lap): Result {
  const item = neighbourCcw(this);
  return { value: item, done: item < 0 } as Result;
};
const nextNeighbourCw = function (this: Lap): Result {
  const item = neighbourCw(this);
  return { value: item, done: item < 0 } as Result;
};
const nextSlowly = function (this: Lap): Result {
  const item = this.orbit.advanceSlowly(this);
  return { value: item, done: item < 0 } as Result;
};

/** By `walk | (view & FACE)`, as walks and views are numbered in ../walks.ts. */
export const NEXT = Object.assign(new Array<() => Result>(16).fill(nextSlowly), {
  [ROTATE_CCW]: nextByRotationCcw,
  [ROTATE_CW]: nextByRotationCw,
  [LOOP_CCW]: nextAlongNext,
  [LOOP_CW]: nextAlongPrev,
  [ROTATE_CCW | FACE]: nextFaceCcw,
  [ROTATE_CW | FACE]: nextFaceCw,
  [LOOP_CCW | FACE]: nextNeighbourCcw,
  [LOOP_CW | FACE]: nextNeighbourCw,
});

// The next item of a lap, or NONE at its end. Vertices, halfedges and edges:

const rotateCcw = (lap: Lap): number => {
  const { orbit, at, left } = lap;
  const { links, view } = orbit;
  const { opposite } = links;
  if (opposite[0] === undefined || links.toVertex[0] === undefined) return orbit.advanceSlowly(lap);
  if (at < 0) return at;
  const h = (opposite[before(links, at)] ?? NONE) & SMALL;
  const item = shown(links, view, h);
  if (opposite[left | (item >> 31)] === undefined || opposite[h] === undefined) {
    return orbit.advanceSlowly(lap);
  }
  lap.left = left - 1;
  lap.at = h === orbit.home ? NONE : h;
  return item;
};

const rotateCw = (lap: Lap): number => {
  const { orbit, at, left } = lap;
  const { links, view } = orbit;
  const { opposite } = links;
  if (opposite[0] === undefined || links.toVertex[0] === undefined) return orbit.advanceSlowly(lap);
  if (at < 0) return at;
  const item = shown(links, view, at);
  const h = (after(links, opposite[at] ?? NONE) ?? NONE) & SMALL;
  if (opposite[left | (item >> 31)] === undefined || opposite[h] === undefined) {
    return orbit.advanceSlowly(lap);
  }
  lap.left = left - 1;
  lap.at = h === orbit.home ? NONE : h;
  return item;
};

const alongNext = (lap: Lap): number => {
  const { orbit, at, left } = lap;
  const { links, view } = orbit;
  const { opposite } = links;
  if (opposite[0] === undefined || links.toVertex[0] === undefined) return orbit.advanceSlowly(lap);
  if (at < 0) return at;
  const item = shown(links, view, at);
  const h = (after(links, at) ?? NONE) & SMALL;
  if (opposite[left | (item >> 31)] === undefined || opposite[h] === undefined) {
    return orbit.advanceSlowly(lap);
  }
  lap.left = left - 1;
  lap.at = h === orbit.home ? NONE : h;
  return item;
};

const alongPrev = (lap: Lap): number => {
  const { orbit, at, left } = lap;
  const { links, view } = orbit;
  const { opposite } = links;
  if (opposite[0] === undefined || links.toVertex[0] === undefined) return orbit.advanceSlowly(lap);
  if (at < 0) return at;
  const h = (before(links, at) ?? NONE) & SMALL;
  const item = shown(links, view, h);
  if (opposite[left | (item >> 31)] === undefined || opposite[h] === undefined) {
    return orbit.advanceSlowly(lap);
  }
  lap.left = left - 1;
  lap.at = h === orbit.home ? NONE : h;
  return item;
};

// Faces at a vertex: only its anchor has none, which is its home, unless it is pinched.

const faceCcw = (lap: Lap): number => {
  const { orbit, at, left } = lap;
  const { links, home } = orbit;
  const { opposite } = links;
  if (opposite[0] === undefined) return orbit.advanceSlowly(lap);
  if (at < 0) return at;
  const h = (opposite[before(links, at)] ?? NONE) & SMALL;
  const item = faceOf(links, h);
  const least = h === home ? NONE : 0;
  if (opposite[left | ((item - least) >> 31)] === undefined) return orbit.advanceSlowly(lap);
  lap.left = left - 1;
  lap.at = h === home ? NONE : h;
  return item;
};

const faceCw = (lap: Lap): number => {
  const { orbit, at, left } = lap;
  const { links, home } = orbit;
  const { opposite } = links;
  if (opposite[0] === undefined) return orbit.advanceSlowly(lap);
  if (at < 0) return at;
  let item = faceOf(links, at);
  let h = (after(links, opposite[at] ?? NONE) ?? NONE) & SMALL;
  if (item < 0 && h !== home) {
    item = faceOf(links, h);
    h = (after(links, opposite[h] ?? NONE) ?? NONE) & SMALL;
  }
  const least = h === home ? NONE : 0;
  if (opposite[left | ((item - least) >> 31)] === undefined || opposite[h] === undefined) {
    return orbit.advanceSlowly(lap);
  }
  lap.left = left - 1;
  lap.at = h === home ? NONE : h;
  return item;
};

// Neighbours of a face, past sides without one.

const neighbourCcw = (lap: Lap): number => {
  const { orbit, at, left } = lap;
  const { links, home } = orbit;
  const { opposite } = links;
  if (opposite[0] === undefined) return orbit.advanceSlowly(lap);
  if (at < 0) return at;
  let item = faceOf(links, opposite[at] ?? NONE);
  let h = after(links, at) & SMALL;
  if (item < 0 && h !== home) {
    item = faceOf(links, opposite[h] ?? NONE);
    h = after(links, h) & SMALL;
    if (item < 0 && h !== home) {
      item = faceOf(links, opposite[h] ?? NONE);
      h = after(links, h) & SMALL;
    }
  }
  const least = h === home ? NONE : 0;
  if (opposite[left | ((item - least) >> 31)] === undefined) return orbit.advanceSlowly(lap);
  lap.left = left - 1;
  lap.at = h === home ? NONE : h;
  return item;
};

const neighbourCw = (lap: Lap): number => {
  const { orbit, at, left } = lap;
  const { links, home } = orbit;
  const { opposite } = links;
  if (opposite[0] === undefined) return orbit.advanceSlowly(lap);
  if (at < 0) return at;
  let h = before(links, at) & SMALL;
  let item = faceOf(links, opposite[h] ?? NONE);
  if (item < 0 && h !== home) {
    h = before(links, h) & SMALL;
    item = faceOf(links, opposite[h] ?? NONE);
    if (item < 0 && h !== home) {
      h = before(links, h) & SMALL;
      item = faceOf(links, opposite[h] ?? NONE);
    }
  }
  const least = h === home ? NONE : 0;
  if (opposite[left | ((item - least) >> 31)] === undefined) return orbit.advanceSlowly(lap);
  lap.left = left - 1;
  lap.at = h === home ? NONE : h;
  return item;
};
