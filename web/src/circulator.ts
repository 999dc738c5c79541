import { type Halfedge, NONE } from './items.js';
import { corrupt, type Links } from './links.js';
import { type Orbit, reverse, shown, stale, step } from './orbit.js';

/**
 * Endless and bidirectional: it has no end, it stops when you say so. It stands on one halfedge at a
 * time. Every use throws after the connectivity has changed under it.
 */
export class Circulator<Item extends number = number> {
  readonly #links: Links;
  readonly #version: number;
  readonly #walk: number;
  readonly #back: number;
  readonly #view: number;
  #halfedge: number;
  #current: number;

  /** @internal Stands where the lap of `orbit` begins. */
  constructor({ links, version, last, walk, view }: Orbit<Item>) {
    this.#links = links;
    this.#version = version;
    this.#walk = walk;
    this.#back = reverse(walk);
    this.#view = view;
    this.#halfedge = last;
    this.#current = NONE;
    if (last !== NONE) this.#step(walk);
  }

  /** What it shows where it stands; `NONE` if there is nothing around the item. */
  get current(): Item {
    if (this.#links.version !== this.#version) stale(this.#links);
    return this.#current as Item;
  }

  /**
   * The halfedge where it stands: around a vertex one that leaves it, around a face one of its own;
   * `NONE` if there is nothing around the item.
   */
  get halfedge(): Halfedge {
    if (this.#links.version !== this.#version) stale(this.#links);
    return this.#halfedge as Halfedge;
  }

  /** Steps on, and returns what it shows there. */
  next(): Item {
    return this.#step(this.#walk);
  }

  /** Steps back, and returns what it shows there. */
  prev(): Item {
    return this.#step(this.#back);
  }

  #step(walk: number): Item {
    const links = this.#links;
    if (links.version !== this.#version) stale(links);
    const h = step(links, walk, this.#halfedge);
    if (h >= 0) {
      const item = shown(links, this.#view, h);
      if (item >= 0) {
        this.#halfedge = h;
        this.#current = item;
        return item as Item;
      }
    }
    return this.#search(walk);
  }

  /** Steps to the next halfedge that shows something, if there is one; mends detached views first. */
  #search(walk: number): Item {
    if (this.#halfedge === NONE) return NONE as Item;
    const links = this.#links;
    links.revive();
    const begin = this.#halfedge;
    let h = begin;
    for (let left = links.halfedgeSlots; left > 0; left--) {
      h = step(links, walk, h);
      const item = shown(links, this.#view, h);
      if (!(h >= 0 && item >= NONE)) break;
      if (item !== NONE || h === begin) {
        this.#halfedge = item === NONE ? NONE : h;
        this.#current = item;
        return item as Item;
      }
    }
    throw corrupt(`The orbit of halfedge ${begin} does not close`);
  }
}
