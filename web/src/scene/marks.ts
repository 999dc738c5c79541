import type { Vector3 } from 'three';
import type { HalfedgeMesh } from '../api.js';
import { type LinkRole, linksOf } from '../teaching/item-links.js';
import { type Item, itemName, sameItem } from '../teaching/items.js';
import type { Visit } from '../teaching/player.js';
import type { Mark } from './highlights.js';
import type { Label } from './labels.js';
import type { Palette } from './palette.js';

/** No more visited items than this are drawn, the latest ones. */
const TRAIL_CAP = 600;
const ORDINAL_CAP = 150;

/** What is to be shown of a mesh. */
export interface Shows {
  readonly mesh: HalfedgeMesh;
  readonly selected: Item | null;
  readonly hovered: Item | null;
  /** What a circulator has visited so far; its links are shown where that is nothing. */
  readonly visits: readonly Visit[];
  /** Whether the links of the selected item are shown. Default: true. */
  readonly links?: boolean;
  /** Whether they have their numbers; arrows along the links have them otherwise. Default: true. */
  readonly numbers?: boolean;
  /** What makes an operation impossible: has the picture to itself, with the selected item. */
  readonly witness: readonly Item[] | null;
  /** The item from which an operation goes that waits for its second one. */
  readonly first: Item | null;
}

/** What is drawn over the mesh in a state of the page. */
export interface Overlay {
  readonly marks: Mark[];
  readonly labels: Label[];
}

/** Where the label of an item is anchored, and to which side of the anchor it goes. */
export interface Anchors {
  point(item: Item): Vector3;
  side(item: Item): Vector3 | undefined;
  /** From corner to corner, where the item is drawn as a line. */
  line(item: Item): Vector3[] | undefined;
}

/** The colour of the palette that a link has. */
export const ROLE_COLORS: Record<LinkRole, 'next' | 'opposite' | 'vertex' | 'self'> = {
  next: 'next',
  prev: 'next',
  halfedge: 'next',
  opposite: 'opposite',
  vertex: 'vertex',
  edge: 'self',
  face: 'self',
};

/** Marks and labels for the selection, its links, the visited trail and what is under the pointer. */
export function overlayOf(shows: Shows, palette: Palette, anchors: Anchors): Overlay {
  const { marks, labels } = new OverlayDrawing(palette, anchors).add(shows);
  return { marks, labels };
}

/** An overlay while it is put together, in the colours of a palette, with labels where the anchors are. */
export class OverlayDrawing implements Overlay {
  readonly marks: Mark[] = [];
  readonly labels: Label[] = [];
  readonly #palette: Palette;
  readonly #anchors: Anchors;

  constructor(palette: Palette, anchors: Anchors) {
    this.#palette = palette;
    this.#anchors = anchors;
  }

  /** Adds all that is to be shown. */
  add({
    mesh,
    selected,
    hovered,
    visits,
    witness,
    first,
    links = true,
    numbers = true,
  }: Shows): this {
    if (selected) {
      // A witness, and the first of two, have labels of their own.
      const hasOther = [...(witness ?? []), first].some((item) => sameItem(item, selected));
      this.#addSelected(selected, !hasOther);
      if (links && visits.length === 0 && !witness && !first) {
        this.#addLinks(mesh, selected, numbers);
      }
    }
    // A refusal has the picture to itself: what its sentence names, and nothing else.
    if (visits.length > 0 && !witness) this.#addTrail(visits);
    if (witness) this.addWitness(witness);
    if (first) this.#addFirst(first);
    if (hovered && !sameItem(hovered, selected)) this.#addHovered(hovered);
    return this;
  }

  /** Adds the items that make an operation impossible, or that a walk has missed, each with its name. */
  addWitness(witness: readonly Item[]): void {
    for (const item of witness) {
      this.marks.push({ item, color: this.#palette.opposite, weight: 'strong' });
      this.labels.unshift({
        text: `✕ ${itemName(item)}`,
        look: 'witness',
        point: this.#anchors.point(item),
        side: this.#anchors.side(item),
        lift: item.kind === 'face' ? 0 : 22,
      });
    }
  }

  #addSelected(selected: Item, hasLabel: boolean): void {
    this.marks.push({ item: selected, color: this.#palette.self, weight: 'strong' });
    if (!hasLabel) return;
    this.labels.push({
      text: itemName(selected),
      look: 'self',
      point: this.#anchors.point(selected),
      side: this.#anchors.side(selected),
      line: this.#anchors.line(selected),
      lift: selected.kind === 'face' ? 0 : 22,
      yields: true,
    });
  }

  #addHovered(hovered: Item): void {
    this.marks.push({ item: hovered, color: this.#palette.ink, weight: 'faint' });
    this.labels.push({
      text: itemName(hovered),
      look: 'hover',
      point: this.#anchors.point(hovered),
      side: this.#anchors.side(hovered),
      lift: hovered.kind === 'face' ? 0 : 20,
    });
  }

  /** The item from which an operation goes that waits for its second one. */
  #addFirst(first: Item): void {
    this.marks.push({ item: first, color: this.#palette.next, weight: 'strong' });
    this.labels.unshift({
      text: `from ${itemName(first)}`,
      look: 'first',
      point: this.#anchors.point(first),
      side: this.#anchors.side(first),
      lift: 22,
    });
  }

  /** The visited items with their ordinals and the halfedges that led to them; the current strong. */
  #addTrail(visits: readonly Visit[]): void {
    const current = visits.at(-1);
    for (const visit of visits.slice(-TRAIL_CAP)) {
      const weight = visit === current ? 'strong' : 'fine';
      const carrier: Item = { kind: 'halfedge', index: visit.cursor };
      const led = visit.cursor >= 0 && !sameItem(carrier, visit.item);
      if (led) this.marks.push({ item: carrier, color: this.#palette.next, weight });
      this.marks.push({ item: visit.item, color: this.#palette.next, weight });
    }
    const numbers: Label[] = [];
    for (let i = visits.length - 1; i >= 0 && i >= visits.length - ORDINAL_CAP; i--) {
      const { item } = visits[i];
      const look = visits[i] === current ? 'current' : 'ordinal';
      numbers.push({ text: `${i + 1}`, look, point: this.#anchors.point(item), lift: 0 });
    }
    // Before the name of the selected item, which goes aside.
    this.labels.unshift(...numbers);
  }

  /** The items that the links of the selected one lead to, with their numbers. */
  #addLinks(mesh: HalfedgeMesh, selected: Item, numbers: boolean): void {
    const roomy: Label[] = [];
    for (const { number, target, role } of linksOf(mesh, selected)) {
      if (!target) continue;
      if (role === 'face') {
        this.marks.push({ item: target, color: this.#palette.self, weight: 'fine' });
      } else if (role !== 'edge' && !(role === 'vertex' && number === undefined)) {
        const color = this.#palette[ROLE_COLORS[role]];
        this.marks.push({ item: target, color, weight: 'fine', dashed: role === 'prev' });
      }
      if (numbers && number !== undefined) {
        // A face has room for its number, so it comes after those that have little.
        const group = role === 'face' ? roomy : this.labels;
        group.push({
          text: `${number}`,
          look: 'link',
          role,
          point: this.#anchors.point(target),
          line: this.#anchors.line(target),
          lift: role === 'vertex' ? 18 : 0,
          yields: true,
        });
      }
    }
    this.labels.push(...roomy);
  }
}
