import { NONE as none } from './items.js';
import type { Orbit } from './orbit.js';
import * as walks from './walks.js';

// Constants of this module's own: see walks.ts.
const NONE: typeof none = none;
const { SHOW_OPPOSITE, SMALL, TURN } = walks.BITS;

/** Instead of a count where anything isn't as usual: detached views, links that can't be, no room. */
const UNSURE = -1;

/** Instead of a face where there is nothing at all to look up. */
const UNSOUND = -2;

type Buffer = Int32Array | Uint32Array;

// How `into` writes a lap: a function for what is shown and which links are followed, as laps.ts has them,
// and for the same reasons. Room in the buffer ends a lap that doesn't close. What is shown is looked at
// when all is written: negative vertices leave a bit.

const fillVerticesAlongPrev = (orbit: Orbit<number>, buffer: Buffer): number => {
  const { home, walk } = orbit;
  const { prev, toVertex } = orbit.links;
  const turn = walk & TURN;
  let at = home;
  let count = 0;
  let bits = 0;
  do {
    at = ((prev[at] ?? NONE) ^ turn) & SMALL;
    const item = toVertex[at];
    if (item === undefined || buffer[count] === undefined) return UNSURE;
    buffer[count] = item;
    bits |= item;
    count += 1;
  } while (at !== home);
  return bits < 0 ? UNSURE : count;
};

const fillVerticesAlongNext = (orbit: Orbit<number>, buffer: Buffer): number => {
  const { home, walk } = orbit;
  const { next, toVertex } = orbit.links;
  const turn = walk & TURN;
  let at = home;
  let count = 0;
  let bits = 0;
  do {
    const item = toVertex[at];
    if (item === undefined || buffer[count] === undefined) return UNSURE;
    buffer[count] = item;
    bits |= item;
    count += 1;
    at = (next[at ^ turn] ?? NONE) & SMALL;
  } while (at !== home);
  return bits < 0 ? UNSURE : count;
};

const fillIndicesAlongPrev = (orbit: Orbit<number>, buffer: Buffer): number => {
  const { home, walk, view } = orbit;
  const { prev } = orbit.links;
  const turn = walk & TURN;
  const side = view & SHOW_OPPOSITE;
  const shift = view >> 1;
  let at = home;
  let count = 0;
  do {
    at = ((prev[at] ?? NONE) ^ turn) & SMALL;
    if (prev[at] === undefined || buffer[count] === undefined) return UNSURE;
    buffer[count] = (at ^ side) >> shift;
    count += 1;
  } while (at !== home);
  return count;
};

const fillIndicesAlongNext = (orbit: Orbit<number>, buffer: Buffer): number => {
  const { home, walk, view } = orbit;
  const { next } = orbit.links;
  const turn = walk & TURN;
  const side = view & SHOW_OPPOSITE;
  const shift = view >> 1;
  let at = home;
  let count = 0;
  do {
    if (next[at] === undefined || buffer[count] === undefined) return UNSURE;
    buffer[count] = (at ^ side) >> shift;
    count += 1;
    at = (next[at ^ turn] ?? NONE) & SMALL;
  } while (at !== home);
  return count;
};

// Past sides without a face, as many steps as there are halfedges.

const fillFacesAlongPrev = (orbit: Orbit<number>, buffer: Buffer): number => {
  const { home, walk, view } = orbit;
  const { prev, face } = orbit.links;
  const turn = walk & TURN;
  const side = view & SHOW_OPPOSITE;
  let at = home;
  let count = 0;
  let steps = 0;
  do {
    at = ((prev[at] ?? NONE) ^ turn) & SMALL;
    const item = face[at ^ side] ?? UNSOUND;
    if (face[steps | ((item + 1) >> 31)] === undefined) return UNSURE;
    steps += 1;
    if (item >= 0) {
      if (buffer[count] === undefined) return UNSURE;
      buffer[count] = item;
      count += 1;
    }
  } while (at !== home);
  return count;
};

const fillFacesAlongNext = (orbit: Orbit<number>, buffer: Buffer): number => {
  const { home, walk, view } = orbit;
  const { next, face } = orbit.links;
  const turn = walk & TURN;
  const side = view & SHOW_OPPOSITE;
  let at = home;
  let count = 0;
  let steps = 0;
  do {
    const item = face[at ^ side] ?? UNSOUND;
    if (face[steps | ((item + 1) >> 31)] === undefined) return UNSURE;
    steps += 1;
    if (item >= 0) {
      if (buffer[count] === undefined) return UNSURE;
      buffer[count] = item;
      count += 1;
    }
    at = (next[at ^ turn] ?? NONE) & SMALL;
  } while (at !== home);
  return count;
};

/** By what is shown (an index, a vertex, a face), and whether along next. */
export const FILL = [
  fillIndicesAlongPrev,
  fillIndicesAlongNext,
  fillVerticesAlongPrev,
  fillVerticesAlongNext,
  fillFacesAlongPrev,
  fillFacesAlongNext,
];
