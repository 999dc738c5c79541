import * as around from './around.js';
import { type Direction, type Halfedge, type HalfedgeLike, NONE as none } from './items.js';
import { corrupt, type Links } from './links.js';
import * as orbit from './orbit.js';

// Constants of this module's own: see orbit.ts.
const NONE: typeof none = none;
const { lastAround, walkAround } = around;
const { reverse, shown, staleError, step } = orbit;
type Centre = around.Centre;

/** What a circulator goes around, and what it shows of each halfedge. */
export interface Kind {
  readonly centre: Centre;
  readonly view: number;
}

/**
 * Endless and bidirectional: it has no end, it stops when you say so. It stands on one halfedge at a
 * time. Every use but `moveTo` throws after the connectivity has changed under it.
 */
export class Circulator<Item extends number = number> {
  // Not #private: a loop that makes a circulator for each vertex would take twice as long.
  /** @internal */
  declare readonly links: Links;
  /** @internal */
  declare readonly centre: Centre;
  /** @internal */
  declare readonly walk: number;
  /** @internal */
  declare readonly view: number;
  /** @internal */
  declare era: Links['era'];
  /** @internal */
  declare at: number;
  /** @internal */
  declare item: number;

  /** @internal */
  constructor(links: Links, { centre, view }: Kind, direction: Direction) {
    this.links = links;
    this.centre = centre;
    this.walk = walkAround(centre, direction);
    this.view = view;
    this.era = links.era;
    this.at = NONE;
    this.item = NONE;
  }

  /** What it shows where it stands; `NONE` if there is nothing around the item. */
  get current(): Item {
    if (this.era.over) this.refuse();
    return this.item as Item;
  }

  /**
   * The halfedge where it stands: around a vertex one that leaves it, around a face one of its own;
   * `NONE` if there is nothing around the item.
   */
  get halfedge(): Halfedge {
    if (this.era.over) this.refuse();
    return this.at as Halfedge;
  }

  /** Steps on, and returns what it shows there. */
  next(): Item {
    return this.step(this.walk);
  }

  /** Steps back, and returns what it shows there. */
  prev(): Item {
    return this.step(reverse(this.walk));
  }

  /**
   * Goes around another item of the same kind and in the same direction, as a new circulator would, but
   * without making one.
   */
  moveTo(item: number, start?: HalfedgeLike): this {
    const { links, walk, view } = this;
    const last = lastAround(links, this.centre, item, walk, start, view);
    this.era = links.era;
    this.at = last;
    this.item = NONE;
    if (last >= 0) this.step(walk);
    return this;
  }

  /** @internal */
  step(walk: number): Item {
    const { links } = this;
    if (this.era.over) this.refuse();
    const h = step(links, walk, this.at);
    const item = shown(links, this.view, h);
    if (!(item >= 0)) return this.search(walk);
    this.at = h;
    this.item = item;
    return item as Item;
  }

  /**
   * Steps to the next halfedge that shows something, if there is one; mends detached views first.
   * @internal
   */
  search(walk: number): Item {
    if (this.at === NONE) return NONE as Item;
    const { links } = this;
    links.revive();
    const begin = this.at;
    let h = begin;
    for (let left = links.halfedgeSlots; left > 0; left--) {
      h = step(links, walk, h);
      const item = shown(links, this.view, h);
      if (!(h >= 0 && item >= NONE)) break;
      if (item !== NONE || h === begin) {
        this.at = item === NONE ? NONE : h;
        this.item = item;
        return item as Item;
      }
    }
    throw corrupt(`The orbit of halfedge ${begin} does not close`);
  }

  /** @internal */
  refuse(): never {
    throw staleError(this.links);
  }
}
