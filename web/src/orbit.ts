import { describe, typedArrayName } from './arguments.js';
import { HalfedgeError } from './errors.js';
import { NONE } from './items.js';
import { corrupt, type Links } from './links.js';

// An orbit has a *walk* (how to step from halfedge to halfedge) and a *view* (what to show of each).
// All circulators are combinations of five walks and six views. Both are small integers, so that one
// hidden class serves every circulator, and the JIT folds them away where it inlines.
//
//              to(h)
//               ^ |            rotate cw:  next(opposite(h))     both leave from(h)
//             h | | opposite   rotate ccw: opposite(prev(h))
//               | v
//             from(h)          face(h) lies to the left of h

const FOLLOW_NEXT = 1;
const OPPOSITE_BEFORE = 2;
const OPPOSITE_AFTER = 4;
const FOLLOW_NOTHING = 8;

/** Outgoing halfedges of a vertex. */
export const ROTATE_CCW = OPPOSITE_AFTER;
export const ROTATE_CW = FOLLOW_NEXT | OPPOSITE_BEFORE;
/** Halfedges of a face or of a boundary loop. */
export const LOOP_CCW = FOLLOW_NEXT;
export const LOOP_CW = 0;
/** The two halfedges of an edge. */
export const ACROSS = FOLLOW_NOTHING | OPPOSITE_AFTER;

const SHOW_OPPOSITE = 1;
const SHOW_EDGE = 2;
const SHOW_VERTEX = 4;
const SHOW_FACE = 8;

export const ITSELF = 0;
export const OPPOSITE = SHOW_OPPOSITE;
export const EDGE = SHOW_EDGE;
export const TO_VERTEX = SHOW_VERTEX;
export const FACE = SHOW_FACE;
export const OPPOSITE_FACE = SHOW_FACE | SHOW_OPPOSITE;

/** The walk that undoes `walk`. */
export function reverse(walk: number): number {
  if (walk === ACROSS) return ACROSS;
  return walk === LOOP_CCW || walk === LOOP_CW
    ? walk ^ FOLLOW_NEXT
    : walk ^ (ROTATE_CCW ^ ROTATE_CW);
}

/** One step from `h`, through the live views; undefined or negative where the links are corrupt. */
export function step(links: Links, walk: number, h: number): number {
  const before = h ^ ((walk >> 1) & 1);
  const after = (walk >> 2) & 1;
  if (walk >= FOLLOW_NOTHING) return h ^ 1;
  const n = (walk & FOLLOW_NEXT) === 0 ? links.prev[before] : links.next[before];
  return n >= 0 ? n ^ after : n;
}

/** What `view` shows of `h`; NONE for no face, undefined or below NONE where links are corrupt. */
export function shown(links: Links, view: number, h: number): number {
  const side = h ^ (view & SHOW_OPPOSITE);
  if (view < SHOW_VERTEX) return side >> (view >> 1);
  return view < SHOW_FACE ? links.toVertex[side] : links.face[side];
}

/**
 * All indices of halfedges lie below: 2^30 of them would need more memory than there is. Masking
 * with it tells the JIT that a number needs no check to fit in a tagged small integer.
 */
const SMALL = 0x3fffffff;

/** One lap underway. Without methods but `next`, so that the JIT may keep it in registers. */
interface Lap {
  next: () => IteratorResult<number, typeof NONE>;
  orbit: Orbit<number>;
  links: Links;
  version: number;
  /** The links that the walk follows, and whether it takes the opposite before and after that. */
  follow: Int32Array;
  before: number;
  after: number;
  /** The links that the view looks up, if any, and of which side. */
  table: Int32Array;
  view: number;
  side: number;
  /** The halfedge shown last, NONE when the lap is over; where it ends; how many steps are left. */
  at: number;
  last: number;
  left: number;
}

/**
 * One lap around an item, as something to iterate over any number of times. Each `for...of` makes a
 * lap of its own, so loops may be nested and left early.
 *
 * A range is good until the connectivity changes: using it after that throws, as does the next step
 * of a lap underway.
 */
export class Orbit<Item extends number> implements Iterable<Item> {
  /** @internal */
  readonly links: Links;
  /** @internal */
  readonly version: number;
  /** @internal Steps from here to the first halfedge, and ends here; NONE for no lap. */
  readonly last: number;
  /** @internal */
  readonly walk: number;
  /** @internal */
  readonly view: number;

  /** @internal */
  constructor(links: Links, last: number, walk: number, view: number) {
    this.links = links;
    this.version = links.version;
    this.last = last;
    this.walk = walk;
    this.view = view;
  }

  [Symbol.iterator](): Iterator<Item, typeof NONE> {
    // A literal, not a class: V8 removes it from an inlined loop, which it doesn't do for objects
    // made by a constructor (bench/README.md).
    const { links, version, last, walk, view } = this;
    if (links.version !== version) stale(links);
    return {
      next: view < SHOW_FACE ? nextItem : nextFace,
      orbit: this,
      links,
      version,
      follow: (walk & FOLLOW_NEXT) === 0 ? links.prev : links.next,
      before: walk >= FOLLOW_NOTHING ? -1 : (walk >> 1) & 1,
      after: (walk >> 2) & 1,
      table: view < SHOW_FACE ? links.toVertex : links.face,
      view,
      side: view & SHOW_OPPOSITE,
      at: last,
      last,
      left: links.halfedgeSlots,
    } as Lap as unknown as Iterator<Item, typeof NONE>;
  }

  /** The items of the lap in a fresh array. */
  toArray(): Item[] {
    const lap = this[Symbol.iterator]() as unknown as Lap;
    const items: number[] = [];
    for (;;) {
      const item = this.view < SHOW_FACE ? advance(lap) : advanceToFace(lap);
      if (item < 0) return items as Item[];
      items.push(item);
    }
  }

  /**
   * Writes the items of the lap to the beginning of `buffer`, and returns how many there are. The
   * form to use where not a byte may be allocated.
   *
   * @throws RangeError if they don't all fit, with the length that is needed
   */
  into(buffer: Int32Array | Uint32Array): number {
    const lap = this[Symbol.iterator]() as unknown as Lap;
    const room = roomIn(buffer);
    for (let count = 0; ; count++) {
      const item = this.view < SHOW_FACE ? advance(lap) : advanceToFace(lap);
      if (item < 0) return count <= room ? count : tooSmall(room, count);
      if (count < room) buffer[count] = item;
    }
  }
}

function nextItem(this: Lap): IteratorResult<number, typeof NONE> {
  const item = advance(this);
  return { value: item, done: item < 0 } as IteratorResult<number, typeof NONE>;
}

function nextFace(this: Lap): IteratorResult<number, typeof NONE> {
  const item = advanceToFace(this);
  return { value: item, done: item < 0 } as IteratorResult<number, typeof NONE>;
}

// These run inside of other people's loops. They are written so that the JIT can inline them and then
// drop the lap altogether: the lap is passed on only to functions that are as small, or to those that
// fail, and what fails is a call, not a `throw`, because V8 compiles no calls that never happened.

/** The next item, or NONE at the end. */
function advance(lap: Lap): number {
  const at = lap.at;
  if (at < 0) return NONE;
  if (lap.links.version !== lap.version) stale(lap.links);
  const h = stepOn(lap, at);
  const { view } = lap;
  const item = view < SHOW_VERTEX ? (h ^ lap.side) >> (view >> 1) : lap.table[h ^ lap.side];
  if (!(item >= 0)) failed(lap.orbit);
  lap.at = h === lap.last ? NONE : h;
  return item;
}

/** As `advance`, stepping over sides without a face. */
function advanceToFace(lap: Lap): number {
  let h = lap.at;
  if (h < 0) return NONE;
  if (lap.links.version !== lap.version) stale(lap.links);
  const { last } = lap;
  let item: number;
  do {
    h = stepOn(lap, h);
    item = lap.table[h ^ lap.side];
    if (!(item >= NONE)) failed(lap.orbit);
  } while (item < 0 && h !== last);
  lap.at = h === last ? NONE : h;
  return item;
}

function stepOn(lap: Lap, h: number): number {
  const { left, before } = lap;
  if (left === 0) failed(lap.orbit);
  lap.left = (left - 1) & SMALL;
  if (before < 0) return h ^ 1;
  let n = lap.follow[h ^ before];
  if (!(n >= 0)) n = followAgain(lap, h);
  return (n ^ lap.after) & SMALL;
}

/** Mends the views of a lap, which growth of the memory has detached. */
function followAgain(lap: Lap, h: number): number {
  const { orbit, links } = lap;
  links.revive();
  lap.follow = (orbit.walk & FOLLOW_NEXT) === 0 ? links.prev : links.next;
  lap.table = orbit.view < SHOW_FACE ? links.toVertex : links.face;
  const n = lap.follow[h ^ lap.before];
  return n >= 0 ? n : failed(orbit);
}

export function stale(links: Links): never {
  links.checkAlive();
  throw new HalfedgeError(
    'stale-circulator',
    'This circulator was used after the connectivity changed under it; expected a new one.',
  );
}

export function failed(orbit: Orbit<number>): never {
  throw corrupt(`The orbit of halfedge ${orbit.last} does not close`);
}

function roomIn(buffer: unknown): number {
  if (buffer instanceof Int32Array || buffer instanceof Uint32Array) return buffer.length;
  const name = typedArrayName(buffer); // of another realm
  if (name === 'Int32Array' || name === 'Uint32Array') return (buffer as Int32Array).length;
  throw new TypeError(`buffer is ${describe(buffer)}; expected an Int32Array or a Uint32Array.`);
}

function tooSmall(room: number, count: number): never {
  throw new RangeError(`buffer has length ${room}; expected at least ${count}.`);
}
