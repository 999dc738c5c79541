import * as buffers from './buffer.js';
import { HalfedgeError } from './errors.js';
import * as fills from './fills.js';
import { NONE as none } from './items.js';
import * as laps from './laps.js';
import { corrupt, type Era, type Links } from './links.js';
import * as walks from './walks.js';

// Constants of this module's own: see walks.ts.
const NONE: typeof none = none;
const { intoSlowly, roomIn } = buffers;
const { NEXT } = laps;
const { FILL } = fills;
const { beginsAtHome, shown, step } = walks;
type Lap = laps.Lap;

/**
 * One lap around an item. You can iterate over it any number of times. Each `for...of` makes a lap of its
 * own, so loops may be nested and left early.
 *
 * A range is good until the connectivity changes: using it after that throws, as does the next step of a lap
 * underway.
 */
export class Orbit<Item extends number> implements Iterable<Item> {
  /** @internal */
  declare readonly links: Links;
  /** @internal */
  declare readonly era: Era;
  /** @internal The halfedge where a lap begins or ends (see SHOW_THEN_STEP); NONE for no lap. */
  declare readonly home: number;
  /** @internal */
  declare readonly walk: number;
  /** @internal */
  declare readonly view: number;

  /** @internal */
  constructor(links: Links, home: number, walk: number, view: number) {
    this.links = links;
    this.era = links.era;
    this.home = home;
    this.walk = walk;
    this.view = view;
  }

  [Symbol.iterator](): Iterator<Item, typeof NONE> {
    const lap: Lap = {
      next: NEXT[((this.view >> 1) & ~1) | (this.walk >> 1)],
      orbit: this,
      at: this.home,
      left: this.links.halfedgeSlots - 1,
    };
    return lap as Iterator<Item, typeof NONE>;
  }

  /** The items of the lap in a fresh array. */
  toArray(): Item[] {
    const items: Item[] = [];
    for (const item of this) items.push(item); // several times as fast as Array.from
    return items;
  }

  /**
   * Writes the items of the lap to the beginning of `buffer`, and returns how many there are. This form
   * allocates nothing.
   *
   * @throws RangeError if they don't all fit, naming the length that is needed
   */
  into(buffer: Int32Array | Uint32Array): number {
    const { home, walk, view } = this;
    if (this.era.next[0] === undefined) this.revive();
    roomIn(buffer); // refuses what is no buffer
    if (home < 0) return 0;
    const count = FILL[((view >> 1) & ~1) | (walk >> 1)](this, buffer);
    return count >= 0 ? count : intoSlowly(this, buffer);
  }

  /**
   * The next step of `lap` in all cases: after a change, with views that growth of the memory had detached,
   * where links must be searched, past many sides without a face in a row.
   * @internal
   */
  advanceSlowly(lap: Lap): number {
    this.revive();
    let { at } = lap;
    if (at < 0) return at;
    const { links, home, walk, view } = this;
    for (let { left } = lap; left >= 0; left--) {
      const h = step(links, walk, at);
      const item = shown(links, view, beginsAtHome(walk) ? at : h);
      at = h === home ? NONE : h;
      if (links.next[h] === undefined || !(item >= NONE)) break;
      if (item === NONE && at !== NONE) continue;
      lap.left = left - 1;
      lap.at = at;
      return item;
    }
    return this.fail();
  }

  /** @internal Mends views that growth of the memory had detached. Throws after a change. */
  revive(): void {
    if (this.era.isOver) this.refuse();
    this.links.revive();
  }

  /** @internal */
  refuse(): never {
    throw staleError(this.links);
  }

  /** @internal */
  fail(): never {
    throw corrupt(`The orbit of halfedge ${this.home} does not close`);
  }
}

/** The error for use after a change of connectivity. */
export function staleError(links: Links): HalfedgeError {
  links.checkAlive();
  return new HalfedgeError(
    'stale-circulator',
    'This circulator was used after the connectivity changed under it; expected a new one.',
  );
}
