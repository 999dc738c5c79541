import { checkFlag, refuse } from './checks.js';
import { kindIndex } from './edit.js';
import { HalfedgeError } from './errors.js';
import { printed } from './inspect.js';
import type { ItemKind, ItemLike, ItemOf } from './items.js';
import { checkIndex, checkItem, isLive, type Links, slotCount } from './links.js';
import { unwrap } from './reports.js';

/** An item at the time when the reference was made: its index, and the stamp that its slot then had. */
export interface Reference<Item extends number = number> {
  readonly kind: ItemKind;
  readonly index: Item;
  readonly generation: number;
}

/**
 * Tells an item from a later one in the same slot. The index of a deleted item is refused only until a new
 * item takes its slot. To keep hold of items across edits, keep references instead of indices. Off by
 * default; takes 4 bytes per vertex, edge and face.
 *
 * ```ts
 * mesh.generations.enabled = true;
 * const reference = mesh.generations.reference('vertex', v);
 * // ... edits ...
 * if (mesh.generations.isCurrent(reference)) use(reference.index);
 * ```
 *
 * `compact()` and `reorder()` end all generations if they move items. Undo restores the stamps.
 */
export class Generations {
  readonly #links: Links;
  #enabled: boolean | undefined;

  /** @internal */
  constructor(links: Links) {
    this.#links = links;
  }

  /** Whether items are stamped. Switching it off ends all references; switching it on forgets all steps of history. */
  get enabled(): boolean {
    const { core, address } = this.#links;
    this.#enabled ??= core._has_generations(address) !== 0; // a clone has those of its original
    return this.#enabled;
  }

  set enabled(enabled: boolean) {
    checkFlag('enabled', enabled);
    if (enabled === this.enabled) return;
    const { core, address } = this.#links;
    if (enabled) unwrap(core.enableGenerations(address));
    else core.disableGenerations(address);
    this.#enabled = enabled;
  }

  /**
   * A reference to a live item.
   *
   * @throws HalfedgeError `no-generations` if they are not enabled
   */
  reference<Kind extends ItemKind>(kind: Kind, item: ItemLike<Kind>): Reference<ItemOf<Kind>> {
    const i = this.#checkKind(kind);
    checkItem(this.#links, kind, item);
    const { core, address } = this.#links;
    const generation = core._generation(address, i, item) >>> 0;
    return Object.freeze({ kind, index: item as ItemOf<Kind>, generation });
  }

  /**
   * Whether the item of the reference is still alive, and not another one in its slot.
   *
   * @throws HalfedgeError `no-generations` if they are not enabled
   */
  isCurrent(reference: Reference): boolean {
    if (typeof reference !== 'object' || reference === null) {
      refuse('reference', reference, 'one that reference() has made');
    }
    const { kind, index, generation } = reference;
    const i = this.#checkKind(kind, 'reference.kind');
    if (typeof generation !== 'number') {
      refuse('reference.generation', generation, 'the number that reference() has given it');
    }
    const links = this.#links;
    if (typeof index === 'number' && index >= slotCount(links, kind)) return false; // there were more of them: undo, compact() ...
    checkIndex(kind, slotCount(links, kind), index, 'reference.index');
    const { core, address } = links;
    return core._generation(address, i, index) >>> 0 === generation && isLive(links, kind, index);
  }

  #checkKind(kind: unknown, argument = 'kind'): number {
    const i = kindIndex(kind, argument);
    if (this.enabled) return i;
    throw new HalfedgeError(
      'no-generations',
      'This mesh stamps no items; expected `mesh.generations.enabled = true` before references are made.',
    );
  }
}

printed('Generations', Generations, ({ enabled }) => ({ enabled }));
