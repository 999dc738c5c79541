import { describe, lengthOfArrayLike, listFrom, newArray } from './arguments.js';
import { indexOfChoice, refuse } from './checks.js';
import { HalfedgeError, type Witness } from './errors.js';
import { type ItemKind, type ItemList, PLURALS } from './items.js';
import { checkItem, type Links } from './links.js';
import { outOfMemory, withInputs } from './memory.js';
import { takeRefusal } from './refusal.js';

// How an operation crosses into the core, and back. The functions of the core are plain exports:
// numbers in, a number out.

/** Why an operation can't be done. */
export interface Refusal {
  /** A stable name for programs, in kebab-case. */
  readonly code: string;
  /** One sentence that names the items, what they are and what was expected. */
  readonly message: string;
  /** The items that make it impossible. */
  readonly witness: Witness;
}

/** The bits of a mode, as in wasm/operation_bindings.h. */
export const CHECK_ONLY = 1;
const KEEP_STEP_OPEN = 2;
const AT = 4;
export const OPTION = 8;

/** What the core returns for a refusal; and if there is no memory even for its sentence. */
const REFUSED = -2;
const NO_ROOM = -3;

/** In the order of the enum ItemKind in C++. */
export const KINDS: readonly ItemKind[] = ['vertex', 'halfedge', 'edge', 'face'];

/** The value of `kind` in C++. Throws a sentence for what is no kind. */
export function kindIndex(kind: unknown, argument = 'kind'): number {
  return indexOfChoice(argument, kind, KINDS);
}

/** A place for a vertex: x, y, z, as an array, or as what can be iterated over, such as a Vector3 of three.js. */
export type Position = ArrayLike<number> | Iterable<number>;

/** The mode of an edit: whether it ends a step of history. */
export function modeOf(links: Links): number {
  return links.groups === 0 ? 0 : KEEP_STEP_OPEN;
}

/** The mode of an edit or a check, if a position is given. */
export function withPosition(mode: number, position: Position | undefined): number {
  return position === undefined ? mode : mode | AT;
}

/** What an edit returned, after which the links are those of the changed mesh. Throws if refused. */
export function done(links: Links, result: number): number {
  if (result === NO_ROOM) throw noRoom();
  links.update();
  if (result !== REFUSED) return result;
  const { code, message, witness } = takeRefusal(links.core);
  throw new HalfedgeError(code, message, { witness });
}

/** What a check returned: null if the operation can be done, else why not. */
export function answer(links: Links, result: number): Refusal | null {
  if (result === NO_ROOM) throw noRoom();
  return result === REFUSED ? takeRefusal(links.core) : null;
}

const noRoom = () => outOfMemory('the change');

/** A copy of the position, or the origin if none is given. Throws a sentence for what is none. */
export function checkPosition(
  position: Position | undefined,
  argument = 'position',
): [x: number, y: number, z: number] {
  return position === undefined ? [0, 0, 0] : checkGivenPosition(position, argument);
}

/** A copy of the position. Throws a sentence for what is none. */
export function checkGivenPosition(
  position: Position,
  argument = 'position',
): [x: number, y: number, z: number] {
  const expected = 'three numbers, x, y and z';
  const list = listFrom(position) as ArrayLike<number>;
  if (lengthOfArrayLike(argument, list, expected) !== 3) {
    throw new RangeError(`${argument} is ${describe(list)}; expected ${expected}.`);
  }
  return [
    coordinate(list, 0, argument),
    coordinate(list, 1, argument),
    coordinate(list, 2, argument),
  ];
}

function coordinate(position: ArrayLike<number>, i: number, argument: string): number {
  const value: unknown = position[i];
  if (typeof value === 'number' && Number.isFinite(Math.fround(value))) return value;
  refuse(`${argument}[${i}]`, value, 'a finite number that fits a 32-bit float', 'number');
}

/** What lists for the core are of. */
type ListedKind = 'vertex' | 'halfedge' | 'edge';

/** The room for a list in the core, in place: most are short. */
let shortList = new Uint32Array(0);
const SHORT = 64;
/** The same here, while a list is read. */
let shortItems: Uint32Array | undefined;

/**
 * Calls `use` with a list of items where the core can read it. Throws a sentence for what is no list, or
 * has something in it that is no live item.
 */
export function withList(
  links: Links,
  argument: string,
  source: ItemList<number>,
  kind: ListedKind,
  use: (address: number, count: number) => number,
): number {
  const list = listFrom(source) as ArrayLike<number>;
  links.revive();
  const { core } = links;
  const count = lengthOfArrayLike(argument, list, `an array of ${PLURALS[kind]}`);
  // Each is read once and by index: getters may answer otherwise later, or let the memory grow, and an iterator
  // of the list's own may give fewer.
  if (count > SHORT) {
    const items: number[] = [];
    for (let i = 0; i < count; i++) items.push(checkListed(links, argument, list[i], kind, i));
    const copy = newArray(argument, Uint32Array, count);
    copy.set(items);
    return withInputs(core, (inputs) => use(inputs.indices(argument, copy).address, count));
  }
  const items = shortItems ?? new Uint32Array(SHORT);
  shortItems = undefined; // until they are in the core: a getter may come here with a list of its own
  for (let i = 0; i < count; i++) items[i] = checkListed(links, argument, list[i], kind, i);
  if (shortList.length === 0 || shortList.buffer !== core.memory.buffer) {
    shortList = new Uint32Array(core.memory.buffer, core._short_list() >>> 0, SHORT);
  }
  for (let i = 0; i < count; i++) shortList[i] = items[i];
  shortItems = items;
  return use(shortList.byteOffset, count);
}

function checkListed(
  links: Links,
  argument: string,
  item: number,
  kind: ListedKind,
  i: number,
): number {
  const link = typeof item === 'number' ? linkOf(links, kind, item) : undefined;
  if (link !== undefined && link >= -1) return item;
  checkItem(links, kind, item, `${argument}[${i}]`);
  return item;
}

/** A link of the item, which only a live one has. */
function linkOf(links: Links, kind: ListedKind, item: number): number | undefined {
  if (kind === 'vertex') return links.vertexHalfedge[item];
  if (kind === 'halfedge') return links.next[item];
  return Number.isInteger(item) ? links.next[2 * item] : undefined;
}
