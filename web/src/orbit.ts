import { describe } from './arguments.js';
import { HalfedgeError } from './errors.js';
import { NONE as none } from './items.js';
import { corrupt, type Links } from './links.js';

/**
 * A constant of this module's own. V8 checks at each use of an imported one that it is initialised,
 * and the error that it would throw keeps the iterators of inlined loops in memory.
 */
const NONE: typeof none = none;

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
/** Without any of these a walk follows prev. */
const NOT_ALONG_PREV = FOLLOW_NEXT | FOLLOW_NOTHING;

/**
 * A lap has a *home*, for which nothing needs to be looked up: the anchor of its item, as long as nobody
 * names a start. Walks along next begin there, and show where they are before they step. The others end
 * there, and step before they show.
 */
const SHOW_THEN_STEP = FOLLOW_NEXT;

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

/** Whether a lap begins at its home, rather than ends there. */
export const beginsAtHome = (walk: number): boolean => (walk & SHOW_THEN_STEP) !== 0;

/** The walk that undoes `walk`. */
export function reverse(walk: number): number {
  if (walk === ACROSS) return ACROSS;
  return walk === LOOP_CCW || walk === LOOP_CW
    ? walk ^ FOLLOW_NEXT
    : walk ^ (ROTATE_CCW ^ ROTATE_CW);
}

/**
 * All indices of halfedges lie below: 2^30 of them would need more memory than there is. Masking
 * with it tells the JIT that a number needs no check to fit in a tagged small integer.
 */
const SMALL = 0x3fffffff;
export const SMALL_INDEX = SMALL;

/** What a step from `h` reads; undefined or negative where views are detached, or links corrupt. */
const linkFrom = (links: Links, walk: number, h: number): number => {
  if (walk >= FOLLOW_NOTHING) return h;
  return ((walk & FOLLOW_NEXT) === 0 ? links.prev : links.next)[h ^ ((walk >> 1) & 1)];
};

/** Where a step that reads `link` leads to. */
const arrival = (walk: number, link: number): number => (link ^ ((walk >> 2) & 1)) & SMALL;

/** One step from `h`, through the live views; NONE where there is no link. */
export const step = (links: Links, walk: number, h: number): number => {
  const link = linkFrom(links, walk, h);
  return link >= 0
    ? arrival(walk, link)
    : links.storesPrev
      ? NONE
      : search.stepByPrev(links, walk, h);
};

/** A step along prev where it isn't stored; NONE where the links are corrupt. */
function stepByPrev(links: Links, walk: number, h: number): number {
  if ((walk & NOT_ALONG_PREV) !== 0) return NONE;
  const link = links.findPrev(h ^ ((walk >> 1) & 1));
  return link >= 0 ? arrival(walk, link) : NONE;
}
/** A method, because V8 compiles no property access that has never happened. */
const search = { stepByPrev };

/** What `view` shows of `h`; NONE for no face, undefined or below NONE where links are corrupt. */
export const shown = (links: Links, view: number, h: number): number => {
  const side = h ^ (view & SHOW_OPPOSITE);
  if (view < SHOW_VERTEX) return side >> (view >> 1);
  return view < SHOW_FACE ? links.toVertex[side] : links.face[side];
};

/**
 * The same for those that have no time to decide: a step of any walk but ACROSS is
 * `(follow[h ^ before] ^ after) & SMALL_INDEX`, and a view shows `(h ^ side) >> shift`, or
 * `table[h ^ side]` where shift is NONE.
 */
export const recipe = (walk: number, view: number) => ({
  alongNext: (walk & FOLLOW_NEXT) !== 0,
  before: (walk >> 1) & 1,
  after: (walk >> 2) & 1,
  side: view & SHOW_OPPOSITE,
  shift: view < SHOW_VERTEX ? view >> 1 : NONE,
});

/** What `next` of an iterator returns: NONE at the end, because V8 is slow with "or undefined". */
export type Result = IteratorResult<number, typeof NONE>;

/**
 * One lap underway. A literal, not a class: V8 takes literals out of inlined loops, but not what a
 * constructor has made.
 */
interface Lap {
  next: () => Result;
  orbit: Orbit<number>;
  /** Where to go on, NONE when the lap is over; and how many steps there may be left. */
  at: number;
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
  declare readonly links: Links;
  /** @internal */
  declare readonly era: Links['era'];
  /** @internal The halfedge where a lap begins or ends (see SHOW_THEN_STEP); NONE for no lap. */
  declare readonly home: number;
  /** @internal */
  declare readonly walk: number;
  /** @internal */
  declare readonly view: number;

  /** @internal */
  constructor(links: Links, home: number, walk: number, view: number) {
    this.links = links;
    this.era = links.era;
    this.home = home;
    this.walk = walk;
    this.view = view;
  }

  [Symbol.iterator](): Iterator<Item, typeof NONE> {
    const lap: Lap = {
      next: this.view < SHOW_FACE ? nextItem : nextFace,
      orbit: this,
      at: this.home,
      left: this.links.halfedgeSlots,
    };
    return lap as Iterator<Item, typeof NONE>;
  }

  /** The items of the lap in a fresh array. */
  toArray(): Item[] {
    const items: Item[] = [];
    for (const item of this) items.push(item); // several times as fast as Array.from
    return items;
  }

  /**
   * Writes the items of the lap to the beginning of `buffer`, and returns how many there are: the form
   * that allocates nothing.
   *
   * @throws RangeError if they don't all fit, with the length that is needed
   */
  into(buffer: Int32Array | Uint32Array): number {
    const { links, home, walk, view } = this;
    if (this.era.over) this.refuse();
    const room = roomIn(buffer);
    if (home < 0) return 0;
    if (links.next.length === 0) links.revive();
    // This loop decides as little as it can, and stops at whatever is not as usual.
    const follow = (walk & FOLLOW_NEXT) === 0 ? links.prev : links.next;
    const before = (walk >> 1) & 1;
    const after = (walk >> 2) & 1;
    const side = view & SHOW_OPPOSITE;
    const table = view < SHOW_FACE ? links.toVertex : links.face;
    const end = walk < FOLLOW_NOTHING ? room : 0;
    const stepFirst = (walk & SHOW_THEN_STEP) === 0;
    let at = home;
    let gaps = 0;
    for (let count = 0; count < end; ) {
      const link = follow[at ^ before];
      if (!(link >= 0)) break;
      const h = (link ^ after) & SMALL;
      const seen = (stepFirst ? h : at) ^ side;
      const item = view < SHOW_VERTEX ? seen >> (view >> 1) : table[seen];
      at = h;
      if (item >= 0) {
        buffer[count] = item;
        count += 1;
      } else {
        gaps += 1;
        if (item !== NONE || gaps > end) break;
      }
      if (h === home) return count;
    }
    return this.intoSlowly(buffer);
  }

  /** `into` in all cases. */
  private intoSlowly(buffer: Int32Array | Uint32Array): number {
    const room = buffer.length;
    let count = 0;
    for (const item of this) {
      if (count < room) buffer[count] = item;
      count += 1;
    }
    return count <= room ? count : tooSmall(room, count);
  }

  /**
   * The next step of `lap` in all cases: views that growth of the memory had detached, links that must be
   * searched, many sides without a face in a row.
   * @internal
   */
  advanceSlowly(lap: Lap): number {
    this.links.revive();
    const { links, home, walk, view } = this;
    let { at } = lap;
    for (let { left } = lap; left > 0; left--) {
      const h = step(links, walk, at);
      const item = shown(links, view, beginsAtHome(walk) ? at : h);
      at = h === home ? NONE : h;
      if (!(h >= 0 && item >= NONE)) break;
      if (item === NONE && at !== NONE) continue;
      lap.left = left - 1;
      lap.at = at;
      return item;
    }
    return this.fail();
  }

  /** @internal */
  refuse(): never {
    throw staleError(this.links);
  }

  /** @internal */
  fail(): never {
    throw corrupt(`The orbit of halfedge ${this.home} does not close`);
  }
}

/** One lap across an edge. */
export class EdgeOrbit<Item extends number> extends Orbit<Item> {
  /** @internal */
  constructor(links: Links, home: number, view: number) {
    super(links, home, ACROSS, view);
  }

  override [Symbol.iterator](): Iterator<Item, typeof NONE> {
    const lap: Lap = { next: nextOfEdge, orbit: this, at: this.home, left: 2 };
    return lap as Iterator<Item, typeof NONE>;
  }
}

// These run inside of other people's loops. V8 inlines them, if the loop has little else, and keeps the
// lap in registers as long as nothing could see it, and nothing in the loop can throw. So they are short
// and have next to no loops, and whatever hands the lap on or throws is a method: V8 compiles no property
// access that has never happened. They are constants, because a declared function is compared at each
// call with what it was when the loop was compiled.

const nextItem = function (this: Lap): Result {
  const item = advance(this);
  return { value: item, done: item < 0 } as Result;
};

const nextFace = function (this: Lap): Result {
  const item = advanceToFace(this);
  return { value: item, done: item < 0 } as Result;
};

/** The next item, or NONE at the end. */
const advance = (lap: Lap): number => {
  const { orbit, at, left } = lap;
  const { links, walk, view } = orbit;
  if (orbit.era.over) orbit.refuse();
  if (at < 0) return at;
  const follow = (walk & FOLLOW_NEXT) === 0 ? links.prev : links.next;
  const link = follow[at ^ ((walk >> 1) & 1)];
  if (!(link >= 0) || left <= 0) return orbit.advanceSlowly(lap);
  const h = (link ^ ((walk >> 2) & 1)) & SMALL;
  const side = ((walk & SHOW_THEN_STEP) === 0 ? h : at) ^ (view & SHOW_OPPOSITE);
  const item = view < SHOW_VERTEX ? side >> (view >> 1) : links.toVertex[side];
  if (!(item >= 0)) orbit.fail();
  lap.left = left - 1;
  lap.at = h === orbit.home ? NONE : h;
  return item;
};

/**
 * As `advance`, past sides without a face: as many as a triangle has. A loop would go past any number of
 * them, but around loops and calls V8 keeps the lap in memory.
 */
const advanceToFace = (lap: Lap): number => {
  const { orbit, at, left } = lap;
  const { links, walk, home } = orbit;
  if (orbit.era.over) orbit.refuse();
  if (at < 0) return at;
  const { face } = links;
  const follow = (walk & FOLLOW_NEXT) === 0 ? links.prev : links.next;
  const before = (walk >> 1) & 1;
  const after = (walk >> 2) & 1;
  const opposite = orbit.view & SHOW_OPPOSITE;
  const stepFirst = (walk & SHOW_THEN_STEP) === 0;
  let link = follow[at ^ before];
  if (!(link >= 0) || left <= 0) return orbit.advanceSlowly(lap);
  let from = at;
  let h = (link ^ after) & SMALL;
  let item = face[(stepFirst ? h : from) ^ opposite];
  if (item < 0 && h !== home) {
    from = h;
    link = follow[from ^ before];
    h = (link ^ after) & SMALL;
    item = face[(stepFirst ? h : from) ^ opposite];
    if (item < 0 && h !== home) {
      from = h;
      link = follow[from ^ before];
      h = (link ^ after) & SMALL;
      item = face[(stepFirst ? h : from) ^ opposite];
    }
  }
  if (!(link >= 0 && item >= (h === home ? NONE : 0))) return orbit.advanceSlowly(lap);
  lap.left = left - 1;
  lap.at = h === home ? NONE : h;
  return item;
};

const nextOfEdge = function (this: Lap): Result {
  const item = advanceAcross(this);
  return { value: item, done: item < 0 } as Result;
};

/** The same across an edge: of its two halfedges one may have no face. */
const advanceAcross = (lap: Lap): number => {
  const { orbit, at } = lap;
  const { links, view, home } = orbit;
  if (orbit.era.over) orbit.refuse();
  if (at < 0) return at;
  let h = at ^ 1;
  let item = shown(links, view, h);
  if (item === NONE && h !== home) {
    h = home;
    item = shown(links, view, h);
  }
  if (!(item >= (h === home ? NONE : 0))) return orbit.advanceSlowly(lap);
  lap.at = h === home ? NONE : h;
  return item;
};

/** The error for use after a change of connectivity. */
export function staleError(links: Links): HalfedgeError {
  links.checkAlive();
  return new HalfedgeError(
    'stale-circulator',
    'This circulator was used after the connectivity changed under it; expected a new one.',
  );
}

function roomIn(buffer: Int32Array | Uint32Array): number {
  // Unlike `instanceof` this knows the arrays of other realms, and V8 makes one comparison of it.
  const name = buffer?.[Symbol.toStringTag];
  if (name === 'Int32Array' || name === 'Uint32Array') return buffer.length;
  throw new TypeError(`buffer is ${describe(buffer)}; expected an Int32Array or a Uint32Array.`);
}

function tooSmall(room: number, count: number): never {
  throw new RangeError(`buffer has length ${room}; expected at least ${count}.`);
}
