// The item with the index 0, which counts as false in JavaScript, and is easily taken for none.

import type { Item } from '../../teaching/items.js';
import { namesOf } from './finding.js';
import type { Read } from './outcome.js';

/** What kind of item each question is answered with. */
const KINDS: Readonly<Record<string, Item['kind']>> = {
  toVertex: 'vertex',
  fromVertex: 'vertex',
  face: 'face',
  edge: 'edge',
  next: 'halfedge',
  prev: 'halfedge',
  opposite: 'halfedge',
  vertexHalfedge: 'halfedge',
  faceHalfedge: 'halfedge',
};

/** Whether a question of the program was answered with this item. */
export function wasGiven(kind: Item['kind'], index: number, reads: readonly Read[]): boolean {
  return reads.some(({ name, gave }) => KINDS[name] === kind && gave === index);
}

/**
 * What to say where a program stops at an item with the index 0: that was the last that it was given. `doubt` is asked
 * before.
 */
export function zeroHint(reads: readonly Read[], doubt = ''): string | null {
  const last = reads.at(-1);
  const kind = last?.gave === 0 ? KINDS[last.name] : undefined;
  if (!last || !kind) return null;
  const name = namesOf(kind, [0]);
  return `${doubt} ${last.name} gave ${name}. ${zeroIsFalse(name)}`.trim();
}

/** `f0` is an item. */
export function zeroIsFalse(name: string): string {
  return `${name} is one like any other, but 0 counts as false: compare with NONE.`;
}
