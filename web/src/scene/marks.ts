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

/** Marks and labels for the selection, its links, the visited trail and what is under the pointer. */
export function overlayOf(shows: Shows, palette: Palette, anchors: Anchors): Overlay {
  const overlay: Overlay = { marks: [], labels: [] };
  const { mesh, selected, hovered, visits, witness, first, links = true, numbers = true } = shows;
  if (selected) {
    // A witness, and the first of two, have labels of their own.
    const hasOther = [...(witness ?? []), first].some((item) => sameItem(item, selected));
    addSelected(overlay, palette, anchors, selected, !hasOther);
    if (links && visits.length === 0 && !witness && !first) {
      addLinks(overlay, mesh, palette, anchors, selected, numbers);
    }
  }
  // A refusal has the picture to itself: what its sentence names, and nothing else.
  if (visits.length > 0 && !witness) addTrail(overlay, visits, palette, anchors);
  if (witness) addWitness(overlay, witness, palette, anchors);
  if (first) addFirst(overlay, first, palette, anchors);
  if (hovered && !sameItem(hovered, selected)) {
    overlay.marks.push({ item: hovered, color: palette.ink, weight: 'faint' });
    overlay.labels.push({
      text: itemName(hovered),
      look: 'hover',
      point: anchors.point(hovered),
      side: anchors.side(hovered),
      lift: hovered.kind === 'face' ? 0 : 20,
    });
  }
  return overlay;
}

function addSelected(
  { marks, labels }: Overlay,
  palette: Palette,
  anchors: Anchors,
  selected: Item,
  hasLabel: boolean,
): void {
  marks.push({ item: selected, color: palette.self, weight: 'strong' });
  if (!hasLabel) return;
  labels.push({
    text: itemName(selected),
    look: 'self',
    point: anchors.point(selected),
    side: anchors.side(selected),
    line: anchors.line(selected),
    lift: selected.kind === 'face' ? 0 : 22,
    yields: true,
  });
}

/** The items that make an operation impossible, or that a walk has missed, each with its name. */
export function addWitness(
  { marks, labels }: Overlay,
  witness: readonly Item[],
  palette: Palette,
  anchors: Anchors,
): void {
  for (const item of witness) {
    marks.push({ item, color: palette.opposite, weight: 'strong' });
    labels.unshift({
      text: `✕ ${itemName(item)}`,
      look: 'witness',
      point: anchors.point(item),
      side: anchors.side(item),
      lift: item.kind === 'face' ? 0 : 22,
    });
  }
}

/** The item from which an operation goes that waits for its second one. */
function addFirst(
  { marks, labels }: Overlay,
  first: Item,
  palette: Palette,
  anchors: Anchors,
): void {
  marks.push({ item: first, color: palette.next, weight: 'strong' });
  labels.unshift({
    text: `from ${itemName(first)}`,
    look: 'first',
    point: anchors.point(first),
    side: anchors.side(first),
    lift: 22,
  });
}

/** The visited items with their ordinals and the halfedges that led to them; the current strong. */
function addTrail(
  { marks, labels }: Overlay,
  visits: readonly Visit[],
  palette: Palette,
  anchors: Anchors,
): void {
  const current = visits.at(-1);
  if (!current) return;
  for (const visit of visits.slice(-TRAIL_CAP)) {
    const weight = visit === current ? 'strong' : 'fine';
    const carrier: Item = { kind: 'halfedge', index: visit.cursor };
    const led = visit.cursor >= 0 && !sameItem(carrier, visit.item);
    if (led) marks.push({ item: carrier, color: palette.next, weight });
    marks.push({ item: visit.item, color: palette.next, weight });
  }
  const numbers: Label[] = [];
  for (let i = visits.length - 1; i >= 0 && i >= visits.length - ORDINAL_CAP; i--) {
    const { item } = visits[i];
    const look = visits[i] === current ? 'current' : 'ordinal';
    numbers.push({ text: `${i + 1}`, look, point: anchors.point(item), lift: 0 });
  }
  // Before the name of the selected item, which goes aside.
  labels.unshift(...numbers);
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

/** The items that the links of the selected one lead to, with their numbers. */
function addLinks(
  { marks, labels }: Overlay,
  mesh: HalfedgeMesh,
  palette: Palette,
  anchors: Anchors,
  selected: Item,
  numbers: boolean,
): void {
  const roomy: Label[] = [];
  for (const { number, target, role } of linksOf(mesh, selected)) {
    if (!target) continue;
    if (role === 'face') {
      marks.push({ item: target, color: palette.self, weight: 'fine' });
    } else if (role !== 'edge' && !(role === 'vertex' && number === undefined)) {
      const color = palette[ROLE_COLORS[role]];
      marks.push({ item: target, color, weight: 'fine', dashed: role === 'prev' });
    }
    if (numbers && number !== undefined) {
      // A face has room for its number, so it comes after those that have little.
      const group = role === 'face' ? roomy : labels;
      group.push({
        text: `${number}`,
        look: 'link',
        role,
        point: anchors.point(target),
        line: anchors.line(target),
        lift: role === 'vertex' ? 18 : 0,
        yields: true,
      });
    }
  }
  labels.push(...roomy);
}
