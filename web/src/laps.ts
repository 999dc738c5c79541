import { NONE as none } from './items.js';
import type { Orbit } from './orbit.js';
import * as walks from './walks.js';

// Constants of this module's own: see walks.ts.
const NONE: typeof none = none;
const { shown } = walks;
const { SHOW_OPPOSITE, SMALL, TURN } = walks.BITS;
/** Instead of an item where there is nothing at all to look up. */
const UNSOUND = -2;

/** What `next` of an iterator returns: NONE at the end, because V8 is slow with "or undefined". */
export type Result = IteratorResult<number, typeof NONE>;

/**
 * One lap underway. A literal, not a class: V8 takes literals out of inlined loops, but not what a
 * constructor has made.
 */
export interface Lap {
  next: () => Result;
  orbit: Orbit<number>;
  /** Where to go on, NONE when the lap is over; and how many steps there may be after the next. */
  at: number;
  left: number;
}

// These run inside of other people's loops, in which V8 inlines them if the loop has little else (920
// bytecodes in all). It keeps the lap in registers as long as nothing could see it, and nothing in the
// loop can throw. And it moves out of the loop what doesn't change, such as where the views lie, if
// it comes by there before the first branch, and no branch of the loop was never taken: that would be a
// way out that V8 copies no loop around. So:
//
// - They are many and short, rather than few that decide. They have no loops.
// - What is wrong is found by looking up what isn't there: element 0 of the views of an era that is over, and
//   element -1 for a link that can't be. V8 makes a comparison of that, without a branch, and without the
//   look-up, since it knows that what is there is a number.
// - Branches that most programs never take are taken once by `warmUp`.
// - Whatever hands the lap on is a method: V8 compiles no property access that has never happened.
// - They are constants, because a declared function is compared at each call with what it was when the
//   loop was compiled.

const nextIndexAlongPrev = function (this: Lap): Result {
  const item = indexAlongPrev(this);
  return { value: item, done: item < 0 } as Result;
};
const nextIndexAlongNext = function (this: Lap): Result {
  const item = indexAlongNext(this);
  return { value: item, done: item < 0 } as Result;
};
const nextVertexAlongPrev = function (this: Lap): Result {
  const item = vertexAlongPrev(this);
  return { value: item, done: item < 0 } as Result;
};
const nextVertexAlongNext = function (this: Lap): Result {
  const item = vertexAlongNext(this);
  return { value: item, done: item < 0 } as Result;
};
const nextFaceAlongPrev = function (this: Lap): Result {
  const item = faceAlongPrev(this);
  return { value: item, done: item < 0 } as Result;
};
const nextFaceAlongNext = function (this: Lap): Result {
  const item = faceAlongNext(this);
  return { value: item, done: item < 0 } as Result;
};

/** By what is shown (an index, a vertex, a face), and whether along next. */
export const NEXT = [
  nextIndexAlongPrev,
  nextIndexAlongNext,
  nextVertexAlongPrev,
  nextVertexAlongNext,
  nextFaceAlongPrev,
  nextFaceAlongNext,
];

// The next item of a lap, or NONE at its end. Halfedges and edges:

const indexAlongPrev = (lap: Lap): number => {
  const { orbit, at, left } = lap;
  const { walk, view } = orbit;
  const { prev } = orbit.era;
  if (prev[0] === undefined) return orbit.advanceSlowly(lap);
  if (at < 0) return at;
  const h = ((prev[at] ?? NONE) ^ (walk & TURN)) & SMALL;
  if (prev[left] === undefined || prev[h] === undefined) return orbit.advanceSlowly(lap);
  lap.left = left - 1;
  lap.at = h === orbit.home ? NONE : h;
  return (h ^ (view & SHOW_OPPOSITE)) >> (view >> 1);
};

const indexAlongNext = (lap: Lap): number => {
  const { orbit, at, left } = lap;
  const { walk, view } = orbit;
  const { next } = orbit.era;
  if (next[0] === undefined) return orbit.advanceSlowly(lap);
  if (at < 0) return at;
  const h = (next[at ^ (walk & TURN)] ?? NONE) & SMALL;
  if (next[left] === undefined || next[h] === undefined) return orbit.advanceSlowly(lap);
  lap.left = left - 1;
  lap.at = h === orbit.home ? NONE : h;
  return (at ^ (view & SHOW_OPPOSITE)) >> (view >> 1);
};

// Vertices; one index finds fault with both the number of steps and the vertex.

const vertexAlongPrev = (lap: Lap): number => {
  const { orbit, at, left } = lap;
  const { prev, toVertex } = orbit.era;
  if (prev[0] === undefined || toVertex[0] === undefined) {
    return orbit.advanceSlowly(lap);
  }
  if (at < 0) return at;
  const h = ((prev[at] ?? NONE) ^ (orbit.walk & TURN)) & SMALL;
  const item = toVertex[h] ?? UNSOUND;
  if (prev[left | (item >> 31)] === undefined) return orbit.advanceSlowly(lap);
  lap.left = left - 1;
  lap.at = h === orbit.home ? NONE : h;
  return item;
};

const vertexAlongNext = (lap: Lap): number => {
  const { orbit, at, left } = lap;
  const { next, toVertex } = orbit.era;
  if (next[0] === undefined || toVertex[0] === undefined) {
    return orbit.advanceSlowly(lap);
  }
  if (at < 0) return at;
  const h = (next[at ^ (orbit.walk & TURN)] ?? NONE) & SMALL;
  const item = toVertex[at] ?? UNSOUND;
  if (next[left | (item >> 31)] === undefined) return orbit.advanceSlowly(lap);
  lap.left = left - 1;
  lap.at = h === orbit.home ? NONE : h;
  return item;
};

// Faces, past sides without one: as many as a triangle has. A loop would go past any number of them, but
// around loops and calls V8 keeps the lap in memory. The last side of a lap may have none.

const faceAlongPrev = (lap: Lap): number => {
  const { orbit, at, left } = lap;
  const { walk, home } = orbit;
  const { prev, face } = orbit.era;
  if (prev[0] === undefined || face[0] === undefined) {
    return orbit.advanceSlowly(lap);
  }
  if (at < 0) return at;
  const turn = walk & TURN;
  const side = orbit.view & SHOW_OPPOSITE;
  let h = ((prev[at] ?? NONE) ^ turn) & SMALL;
  let item = face[h ^ side];
  if (item < 0 && h !== home) {
    h = (prev[h] ^ turn) & SMALL;
    item = face[h ^ side];
    if (item < 0 && h !== home) {
      h = (prev[h] ^ turn) & SMALL;
      item = face[h ^ side];
    }
  }
  const least = h === home ? NONE : 0;
  if (prev[left | (((item ?? UNSOUND) - least) >> 31)] === undefined) {
    return orbit.advanceSlowly(lap);
  }
  lap.left = left - 1;
  lap.at = h === home ? NONE : h;
  return item;
};

const faceAlongNext = (lap: Lap): number => {
  const { orbit, at, left } = lap;
  const { walk, home } = orbit;
  const { next, face } = orbit.era;
  if (next[0] === undefined || face[0] === undefined) {
    return orbit.advanceSlowly(lap);
  }
  if (at < 0) return at;
  const turn = walk & TURN;
  const side = orbit.view & SHOW_OPPOSITE;
  let item = face[at ^ side];
  let h = (next[at ^ turn] ?? NONE) & SMALL;
  if (item < 0 && h !== home) {
    item = face[h ^ side];
    h = next[h ^ turn] & SMALL;
    if (item < 0 && h !== home) {
      item = face[h ^ side];
      h = next[h ^ turn] & SMALL;
    }
  }
  const least = h === home ? NONE : 0;
  if (next[left | (((item ?? UNSOUND) - least) >> 31)] === undefined) {
    return orbit.advanceSlowly(lap);
  }
  lap.left = left - 1;
  lap.at = h === home ? NONE : h;
  return item;
};

export const nextOfEdge = function (this: Lap): Result {
  const item = advanceAcross(this);
  return { value: item, done: item < 0 } as Result;
};

/** The same across an edge: of its two halfedges one may have no face. */
const advanceAcross = (lap: Lap): number => {
  const { orbit, at } = lap;
  const { links, view, home } = orbit;
  if (orbit.era.isOver) orbit.refuse();
  if (at < 0) return at;
  let h = at ^ 1;
  let item = shown(links, view, h);
  if (item === NONE && h !== home) {
    h = home;
    item = shown(links, view, h);
  }
  if (!(item >= (h === home ? NONE : 0))) return orbit.advanceSlowly(lap);
  lap.at = h === home ? NONE : h;
  return item;
};
