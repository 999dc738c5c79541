import { type HalfedgeMesh, NONE } from '../api.js';
import { refuse } from '../checks.js';
import { type Item, isLive, item, itemName, parseItemName } from './items.js';
import type { Operands, Operation } from './operation.js';
import { operations } from './operations.js';

/** An operation on certain items, as one word and their names tell it: `insertEdge h3 h9`. */
export interface Deed {
  readonly operation: Operation;
  readonly first: Item | null;
  readonly second: Item | null;
}

/**
 * Reads `flipEdge e3`, or for short `flip e3`: the method of `HalfedgeMesh`, with or without the
 * kind of item in its name. Throws a sentence for what is none.
 */
export function parseDeed(text: string): Deed {
  if (typeof text !== 'string') refuse('text', text, 'an operation such as "flip e3"');
  const [name = '', ...names] = text.trim().split(/\s+/);
  const [first = null, second = null, ...others] = names.map(itemOf);
  const on = first?.kind ?? 'mesh';
  const named = operations.filter((it) => [name, `${name}${capitalised(it.on)}`].includes(it.stem));
  const operation = named.find((it) => it.on === on);
  if (!operation) {
    if (!first && named.length > 0) {
      const kinds = named.map((it) => withArticle(it.on)).join(' or ');
      const example = `${name} ${itemName(item(named[0].on as Item['kind'], 0))}`;
      throw new Error(`“${text}” is done to ${kinds}: expected such as “${example}”.`);
    }
    const known = operations.filter((it) => it.on === on).map(({ stem }) => stem);
    throw new Error(
      `“${text}” is no operation on ${withArticle(on)}: expected one of ${known.join(', ')}, and what it is done to.`,
    );
  }
  const wanted = operation.second?.kind;
  if (second?.kind !== wanted || others.length > 0) {
    const expected = wanted ? `a ${on} and a second ${wanted}` : `one ${on}`;
    throw new Error(
      `“${text}” has other items than ${operation.stem} takes: expected ${expected}.`,
    );
  }
  return { operation, first, second };
}

const capitalised = (word: string) => `${word[0].toUpperCase()}${word.slice(1)}`;
const withArticle = (kind: string) => `${kind === 'edge' ? 'an' : 'a'} ${kind}`;

function itemOf(name: string): Item {
  const found = parseItemName(name);
  if (!found) throw new Error(`“${name}” is no item: expected such as v12, h31, e15 or f7.`);
  return found;
}

/** The deed as `parseDeed` reads it. */
export function deedName({ operation: { stem, on }, first, second }: Deed): string {
  const items = on === 'mesh' ? [] : [first, second].filter((it) => it !== null);
  return [stem, ...items.map(itemName)].join(' ');
}

/** `flip e12`, `insert edge h3, h9`, `reverse`. */
export function deedTitle({ operation: { label, on }, first, second }: Deed): string {
  const name = label.toLowerCase();
  if (on === 'mesh') return name;
  return [`${name} ${itemName(first)}`, ...(second ? [itemName(second)] : [])].join(', ');
}

/** What an operation is applied to. */
export function operandsOf(mesh: HalfedgeMesh, { first, second }: Deed): Operands {
  return { mesh, item: first ?? { kind: 'face', index: NONE }, second };
}

/** What the operation returned, if it is an item; else the first of `candidates` that is left. */
export function selectionAfter(
  { returns, renumbers }: Operation,
  result: unknown,
  mesh: HalfedgeMesh,
  candidates: readonly (Item | null)[],
): Item | null {
  const [selected] = candidates;
  if (renumbers && selected) return item(selected.kind, renumbers(result, selected));
  const returned = returns && typeof result === 'number' ? item(returns, result) : null;
  const found = [returned, ...candidates].find((it) => it && isLive(mesh, it));
  return found ?? null;
}
