import { Attributes } from './attributes.js';
import { Generations } from './generations.js';
import { History } from './history.js';
import { Mending } from './mending.js';
import { linksOf } from './navigation.js';

/** All operations of a mesh, and what goes along with them: history, attributes, generations. */
export abstract class Editing extends Mending {
  #history: History | undefined;
  #attributes: Attributes | undefined;
  #generations: Generations | undefined;

  /** Undo and redo. Off by default. */
  get history(): History {
    const links = linksOf(this);
    links.checkAlive();
    this.#history ??= new History(links);
    return this.#history;
  }

  /** Named columns of numbers by item, which follow every edit. */
  get attributes(): Attributes {
    const links = linksOf(this);
    links.checkAlive();
    this.#attributes ??= new Attributes(links);
    return this.#attributes;
  }

  /** Stamps that tell an item from a later one in the same slot. Off by default. */
  get generations(): Generations {
    const links = linksOf(this);
    links.checkAlive();
    this.#generations ??= new Generations(links);
    return this.#generations;
  }
}
