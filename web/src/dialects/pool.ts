/**
 * One object for each index, made when it is first asked for: so that items are compared by `===`,
 * and a walk makes no object twice.
 */
export class Pool<Item> {
  readonly #items: Item[] = [];
  readonly #make: (index: number) => Item;

  constructor(make: (index: number) => Item) {
    this.#make = make;
  }

  at(index: number): Item {
    const item = this.#items[index];
    if (item !== undefined) return item;
    const made = this.#make(index);
    this.#items[index] = made;
    return made;
  }

  /** The empty link, -1, is null. */
  orNull(index: number): Item | null {
    return index < 0 ? null : this.at(index);
  }
}
