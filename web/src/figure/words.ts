// The words of attributes, and the sentences about wrong ones.

import type { Direction, HalfedgeMesh } from '../api.js';
import { circulators, type Query } from '../teaching/circulators.js';
import { type Dialect, dialects } from '../teaching/dialects.js';
import { type Item, isLive, itemName, itemSlots, parseItemName } from '../teaching/items.js';

/** The dialect of that name. Throws a sentence for another. */
export function dialectNamed(name: string): Dialect {
  const found = dialects.find(({ id }) => id === name);
  if (found) return found;
  const known = dialects.map(({ id }) => id).join(', ');
  throw new Error(`dialect is “${name}”; expected one of ${known}.`);
}

/** The item that an attribute names. Throws a sentence where the mesh has none. */
export function itemNamed(mesh: HalfedgeMesh, name: string): Item {
  const found = parseItemName(name);
  if (!found) throw new Error(`select is “${name}”; expected an item such as v12, h31, e15 or f7.`);
  if (isLive(mesh, found)) return found;
  throw new Error(`select is “${name}”: ${lack(mesh, found)}.`);
}

/** `this mesh does not have e99; it has edge 0 to 11` */
export function lack(mesh: HalfedgeMesh, item: Item): string {
  const slots = itemSlots(mesh, item.kind);
  const range = slots > 0 ? `it has ${item.kind} 0 to ${slots - 1}` : `it has no ${item.kind}`;
  return `this mesh does not have ${itemName(item)}; ${range}`;
}

/**
 * What a circulator is asked, by its public name: around the selected item, or around the vertex or
 * face of the selected halfedge, from there on. Throws a sentence where that does not go together.
 */
export function queryNamed(
  mesh: HalfedgeMesh,
  name: string,
  selected: Item,
  direction: Direction,
): Query {
  const circulator = circulators.find((known) => known.name === name);
  if (!circulator) {
    const known = circulators.map((it) => it.name).join(', ');
    throw new Error(`query is “${name}”; expected one of ${known}.`);
  }
  const { around } = circulator;
  const { kind, index } = selected;
  if (kind === around) return { circulator, index, direction };
  if (kind === 'halfedge') {
    const centres = {
      vertex: () => mesh.fromVertex(index),
      face: () => mesh.face(index),
      edge: () => mesh.edge(index),
    };
    const found = around === 'halfedge' ? index : centres[around]();
    if (found < 0) throw new Error(`${name} goes around a face; ${itemName(selected)} has none.`);
    const query = { circulator, index: found, direction };
    return around === 'edge' ? query : { ...query, start: index };
  }
  throw new Error(`${name} goes around a ${around}; ${itemName(selected)} is selected.`);
}

/** The direction of that name. Throws a sentence for another. */
export function directionNamed(name: string): Direction {
  if (name === 'ccw' || name === 'cw') return name;
  throw new Error(`direction is “${name}”; expected ccw or cw.`);
}
