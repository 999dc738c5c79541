import { NONE as none } from '../items.js';
import * as general from '../walks.js';
import type { DirectedOrbit } from './orbit.js';
import * as walks from './walks.js';

// Constants of this module's own: see ../walks.ts.
const NONE: typeof none = none;
const { LOOP_CCW, LOOP_CW, ROTATE_CCW, ROTATE_CW } = general;
const { SMALL } = general.BITS;
const { after, before, shown } = walks;

/** Instead of a count where anything isn't as usual: see ../fills.ts. */
const UNSURE = -1;

type Buffer = Int32Array | Uint32Array;
type Fill = (orbit: DirectedOrbit<number>, buffer: Buffer) => number;

// How `into` writes a lap: a function for each walk. Room in the buffer ends a lap that doesn't close.

const fillByRotationCcw = (orbit: DirectedOrbit<number>, buffer: Buffer): number => {
  const { links, home, view } = orbit;
  const { opposite } = links;
  let at = home;
  let count = 0;
  do {
    at = (opposite[before(links, at)] ?? NONE) & SMALL;
    const item = shown(links, view, at);
    if (item < NONE || buffer[count] === undefined) return UNSURE;
    if (item >= 0) {
      buffer[count] = item;
      count += 1;
    }
    if (opposite[at] === undefined) return UNSURE;
  } while (at !== home);
  return count;
};

const fillByRotationCw = (orbit: DirectedOrbit<number>, buffer: Buffer): number => {
  const { links, home, view } = orbit;
  const { opposite } = links;
  let at = home;
  let count = 0;
  do {
    const item = shown(links, view, at);
    if (item < NONE || buffer[count] === undefined) return UNSURE;
    if (item >= 0) {
      buffer[count] = item;
      count += 1;
    }
    at = (after(links, opposite[at] ?? NONE) ?? NONE) & SMALL;
    if (opposite[at] === undefined) return UNSURE;
  } while (at !== home);
  return count;
};

const fillAlongNext = (orbit: DirectedOrbit<number>, buffer: Buffer): number => {
  const { links, home, view } = orbit;
  const { opposite } = links;
  let at = home;
  let count = 0;
  do {
    const item = shown(links, view, at);
    if (item < NONE || buffer[count] === undefined) return UNSURE;
    if (item >= 0) {
      buffer[count] = item;
      count += 1;
    }
    at = (after(links, at) ?? NONE) & SMALL;
    if (opposite[at] === undefined) return UNSURE;
  } while (at !== home);
  return count;
};

const fillAlongPrev = (orbit: DirectedOrbit<number>, buffer: Buffer): number => {
  const { links, home, view } = orbit;
  const { opposite } = links;
  let at = home;
  let count = 0;
  do {
    at = (before(links, at) ?? NONE) & SMALL;
    const item = shown(links, view, at);
    if (item < NONE || buffer[count] === undefined) return UNSURE;
    if (item >= 0) {
      buffer[count] = item;
      count += 1;
    }
    if (opposite[at] === undefined) return UNSURE;
  } while (at !== home);
  return count;
};

/** By walk. */
export const FILL = Object.assign([] as Fill[], {
  [ROTATE_CCW]: fillByRotationCcw,
  [ROTATE_CW]: fillByRotationCw,
  [LOOP_CCW]: fillAlongNext,
  [LOOP_CW]: fillAlongPrev,
});
