import * as buffers from '../buffer.js';
import { NONE as none } from '../items.js';
import { corrupt } from '../links.js';
import * as general from '../walks.js';
import * as fills from './fills.js';
import * as laps from './laps.js';
import type { DirectedLinks } from './links.js';
import * as walks from './walks.js';

// Constants of this module's own: see ../walks.ts.
const NONE: typeof none = none;
const { intoSlowly, roomIn } = buffers;
const { fill } = fills;
const { NEXT } = laps;
const { FACE, beginsAtHome } = general;
const { shown, step } = walks;
type Lap = laps.Lap;

/**
 * One lap around an item of Directed Edges: an `Orbit` in all but name.
 */
export class DirectedOrbit<Item extends number> implements Iterable<Item> {
  /** @internal */
  declare readonly links: DirectedLinks;
  /** @internal The halfedge where a lap begins or ends (see SHOW_THEN_STEP); NONE for no lap. */
  declare readonly home: number;
  /** @internal */
  declare readonly walk: number;
  /** @internal */
  declare readonly view: number;

  /** @internal */
  constructor(links: DirectedLinks, home: number, walk: number, view: number) {
    this.links = links;
    this.home = home;
    this.walk = walk;
    this.view = view;
  }

  [Symbol.iterator](): Iterator<Item, typeof NONE> {
    const lap: Lap = {
      next: NEXT[this.walk | (this.view & FACE)],
      orbit: this,
      at: this.home,
      left: this.links.halfedges - 1,
    };
    return lap as Iterator<Item, typeof NONE>;
  }

  /** The items of the lap in a fresh array. */
  toArray(): Item[] {
    const items: Item[] = [];
    for (const item of this) items.push(item);
    return items;
  }

  /**
   * Writes the items of the lap to the beginning of `buffer`, and returns how many there are.
   *
   * @throws RangeError if they don't all fit, with the length that is needed
   */
  into(buffer: Int32Array | Uint32Array): number {
    const { links, home } = this;
    if (links.opposite[0] === undefined) links.revive();
    roomIn(buffer); // refuses what is no buffer
    if (home < 0) return 0;
    const count = fill(this, buffer);
    if (count >= 0) return count;
    return intoSlowly(this, buffer);
  }

  /**
   * The next step of `lap` in all cases: with views that growth of the memory had detached, across an edge,
   * past sides without a face.
   * @internal
   */
  advanceSlowly(lap: Lap): number {
    const { links, home, walk, view } = this;
    links.revive();
    let { at } = lap;
    if (at < 0) return at;
    for (let { left } = lap; left >= 0; left--) {
      const h = step(links, walk, at);
      const item = shown(links, view, beginsAtHome(walk) ? at : h);
      at = h === home ? NONE : h;
      if (links.opposite[h] === undefined || !(item >= NONE)) break;
      if (item === NONE && at !== NONE) continue;
      lap.left = left - 1;
      lap.at = at;
      return item;
    }
    return this.fail();
  }

  /** @internal */
  fail(): never {
    throw corrupt(`The orbit of halfedge ${this.home} does not close`);
  }
}
