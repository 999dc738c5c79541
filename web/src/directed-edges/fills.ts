import { NONE as none } from '../items.js';
import * as general from '../walks.js';
import type { DirectedOrbit } from './orbit.js';
import * as walks from './walks.js';

// Constants of this module's own: see ../walks.ts.
const NONE: typeof none = none;
const { beginsAtHome } = general;
const { SMALL } = general.BITS;
const { shown, step } = walks;

/** Instead of a count where anything isn't as usual: see ../fills.ts. */
export const UNSURE = -1;

/** How `into` writes a lap. Room in the buffer ends a lap that doesn't close. */
export const fill = (orbit: DirectedOrbit<number>, buffer: Int32Array | Uint32Array): number => {
  const { links, home, view, walk } = orbit;
  const { opposite } = links;
  const showsFirst = beginsAtHome(walk);
  let at = home;
  let count = 0;
  do {
    const h = (step(links, walk, at) ?? NONE) & SMALL;
    const item = shown(links, view, showsFirst ? at : h);
    at = h;
    if (item < NONE || buffer[count] === undefined) return UNSURE;
    if (item >= 0) {
      buffer[count] = item;
      count += 1;
    }
    if (opposite[at] === undefined) return UNSURE;
  } while (at !== home);
  return count;
};
