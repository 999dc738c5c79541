import { newArray } from '../arguments.js';

/** Items of one kind, once each, in the order in which they came. Made to be filled again and again. */
export class ItemSet {
  readonly items: number[] = [];
  #isIn = new Uint8Array(0);

  /** Empties it, and makes room for items below `slots`. Costs what was in it. */
  begin(slots: number): void {
    for (const item of this.items) this.#isIn[item] = 0;
    this.items.length = 0;
    if (slots <= this.#isIn.length) return;
    this.#isIn = newArray('the marks of items', Uint8Array, Math.ceil(1.25 * slots));
  }

  /** Adds an item; a negative one is none. */
  add(item: number): void {
    if (!(item >= 0) || this.#isIn[item] === 1) return;
    this.#isIn[item] = 1;
    this.items.push(item);
  }
}
