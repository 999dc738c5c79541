import { type ItemKind, NONE } from './items.js';
import type { Links } from './links.js';
import { type Result, stale } from './orbit.js';

/** A walk through the slots underway; see `Lap` in orbit.ts for its form. */
interface Pass {
  next: () => Result;
  items: LiveItems<number>;
  links: Links;
  version: number;
  /** Slots of deleted items hold less than -1 here, at `item << shift`. */
  slots: Int32Array;
  shift: number;
  at: number;
  end: number;
}

/**
 * The live items of one kind in index order, as something to iterate over any number of times. Good
 * until the connectivity changes: using it after that throws.
 */
export class LiveItems<Item extends number> implements Iterable<Item> {
  /** @internal */
  readonly links: Links;
  /** @internal */
  readonly version: number;
  /** @internal */
  readonly kind: ItemKind;

  /** @internal */
  constructor(links: Links, kind: ItemKind) {
    links.revive();
    this.links = links;
    this.version = links.version;
    this.kind = kind;
  }

  [Symbol.iterator](): Iterator<Item, typeof NONE> {
    const { links, version, kind } = this;
    const shift = kind === 'edge' ? 1 : 0;
    return {
      next: nextLive,
      items: this,
      links,
      version,
      slots: slotsOf(links, kind),
      shift,
      at: 0,
      end: slotCount(links, kind) >> shift,
    } as Pass as unknown as Iterator<Item, typeof NONE>;
  }

  /** The items in a fresh array. */
  toArray(): Item[] {
    return Array.from(this);
  }
}

function nextLive(this: Pass): Result {
  const { end } = this;
  let item = this.at;
  if (this.links.version !== this.version) stale(this.links);
  if (item < end) {
    for (; item < end; item++) {
      let slot = this.slots[item << this.shift];
      if (slot === undefined) slot = readAgain(this, item);
      if (slot >= NONE) break;
    }
    this.at = item + 1;
  }
  const done = item >= end;
  return { value: done ? NONE : item, done } as Result;
}

/** Mends the view of a pass, which growth of the memory has detached. */
function readAgain(pass: Pass, item: number): number {
  const { links, items } = pass;
  links.revive();
  pass.slots = slotsOf(links, items.kind);
  return pass.slots[item << pass.shift];
}

function slotsOf(links: Links, kind: ItemKind): Int32Array {
  if (kind === 'vertex') return links.vertexHalfedge;
  return kind === 'face' ? links.faceHalfedge : links.next;
}

function slotCount(links: Links, kind: ItemKind): number {
  if (kind === 'vertex') return links.vertexSlots;
  return kind === 'face' ? links.faceSlots : links.halfedgeSlots;
}
