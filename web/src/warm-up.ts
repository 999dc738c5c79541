import { aroundFace } from './around.js';
import { triangleLinks } from './build.js';
import { OPPOSITE_FACE } from './walks.js';

let isWarm = false;

/**
 * Goes around a face without neighbours, both ways, some times: once at all, when the first mesh is made.
 * V8 moves what doesn't change out of a loop only if each branch there was taken once, and the branches past
 * sides without a face aren't in most programs. It takes notes from the third time or so. See laps.ts.
 */
export function warmUp(): void {
  if (isWarm) return;
  isWarm = true;
  try {
    const links = triangleLinks([0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 2], {});
    for (let i = 0; i < 20; i++) {
      for (const direction of ['ccw', 'cw'] as const) {
        aroundFace(links, 0, direction, undefined, OPPOSITE_FACE).toArray();
      }
    }
    links.dispose();
  } catch {
    // No memory for it: loops over faces are slower, no more.
  }
}
