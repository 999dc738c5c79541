import * as buffers from './buffer.js';
import type { NONE } from './items.js';
import * as laps from './laps.js';
import type { Era, Links } from './links.js';
import { Orbit } from './orbit.js';
import * as walks from './walks.js';

// Constants of this module's own: see walks.ts.
const { intoSlowly, roomIn } = buffers;
const { nextOfEdge } = laps;
const { ACROSS, shown } = walks;
type Lap = laps.Lap;

/**
 * One lap across an edge: an `Orbit` in all but its constructor, which calls no other one. If it did, V8 would make an
 * object for each lap of a loop, and there are only two items to it.
 */
export class EdgeOrbit<Item extends number> {
  /** @internal */
  declare readonly links: Links;
  /** @internal */
  declare readonly era: Era;
  /** @internal */
  declare readonly home: number;
  /** @internal */
  declare readonly walk: number;
  /** @internal */
  declare readonly view: number;

  /** @internal */
  constructor(links: Links, home: number, view: number) {
    this.links = links;
    this.era = links.era;
    this.home = home;
    this.walk = ACROSS;
    this.view = view;
  }

  [Symbol.iterator](): Iterator<Item, typeof NONE> {
    const lap: Lap = { next: nextOfEdge, orbit: this, at: this.home, left: 2 };
    return lap as Iterator<Item, typeof NONE>;
  }

  into(buffer: Int32Array | Uint32Array): number {
    const { links, home, view } = this;
    if (this.era.next[0] === undefined) this.revive();
    const room = roomIn(buffer); // refuses what is no buffer
    const first = shown(links, view, home ^ 1);
    const second = shown(links, view, home);
    if (room < 2 || !(first >= 0 && second >= 0)) return intoSlowly(this, buffer);
    buffer[0] = first;
    buffer[1] = second;
    return 2;
  }
}
export interface EdgeOrbit<Item extends number> extends Orbit<Item> {}
Object.setPrototypeOf(EdgeOrbit.prototype, Orbit.prototype);
