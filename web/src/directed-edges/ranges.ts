import { NONE } from '../items.js';
import type { Result } from '../laps.js';
import type { DirectedLinks } from './links.js';

/**
 * All items of one kind in index order, as something to iterate over any number of times.
 */
export class DirectedItems<Item extends number> implements Iterable<Item> {
  readonly #links: DirectedLinks;
  readonly #count: number;
  readonly #areEdges: boolean;

  /** @internal */
  constructor(links: DirectedLinks, count: number, areEdges: boolean) {
    links.revive();
    this.#links = links;
    this.#count = count;
    this.#areEdges = areEdges;
  }

  [Symbol.iterator](): Iterator<Item, typeof NONE> {
    let at = 0;
    const next = (): Result => {
      this.#links.checkAlive();
      if (this.#areEdges) at = this.#edgeFrom(at);
      return (
        at < this.#count ? { value: at++, done: false } : { value: NONE, done: true }
      ) as Result;
    };
    return { next } as Iterator<Item, typeof NONE>;
  }

  /** The items in a fresh array. */
  toArray(): Item[] {
    const items: Item[] = [];
    for (const item of this) items.push(item);
    return items;
  }

  /** The first edge from `e` on: a halfedge that is smaller than its opposite. */
  #edgeFrom(e: number): number {
    const links = this.#links;
    if (links.opposite.length === 0) links.revive();
    const { opposite } = links;
    let at = e;
    while (at < this.#count && opposite[at] < at) at += 1;
    return at;
  }
}
