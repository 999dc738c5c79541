import { describe } from '../arguments.js';
import * as around from '../around.js';
import { roomIn, tooSmall } from '../buffer.js';
import { type Direction, type Halfedge, type HalfedgeLike, NONE as none } from '../items.js';
import type { Result } from '../laps.js';
import { corrupt } from '../links.js';
import * as walks from '../walks.js';
import * as directed from './links.js';

// Constants of this module's own: see walks.ts.
const NONE: typeof none = none;
const { walkAround } = around;
const { after, before, edgeOf, faceOf, staleError } = directed;
const { EDGE, FACE, ITSELF, LOOP_CCW, LOOP_CW, OPPOSITE, OPPOSITE_FACE } = walks;
const { ROTATE_CCW, ROTATE_CW, TO_VERTEX, reverse } = walks;
type Centre = around.Centre;
type DirectedLinks = directed.DirectedLinks;

// The walks and views of walks.ts over Directed Edges. They stand apart from those: V8 compiles each of
// the two for the one kind of links that it meets.

/** One step from `h`; undefined or negative where views are detached, or links corrupt. */
const step = (links: DirectedLinks, walk: number, h: number): number => {
  if (walk === ROTATE_CCW) return links.opposite[before(links, h)];
  if (walk === ROTATE_CW) return after(links, links.opposite[h]);
  if (walk === LOOP_CCW) return after(links, h);
  return walk === LOOP_CW ? before(links, h) : links.opposite[h];
};

/** What `view` shows of `h`; NONE for no face, undefined or below NONE where links are corrupt. */
const shown = (links: DirectedLinks, view: number, h: number): number => {
  if (view === TO_VERTEX) return links.toVertex[h];
  if (view === FACE) return faceOf(links, h);
  if (view === OPPOSITE_FACE) {
    const opposite = links.opposite[h];
    return opposite >= 0 ? faceOf(links, opposite) : opposite;
  }
  if (view === ITSELF) return h;
  return view === EDGE ? edgeOf(links, h) : links.opposite[h];
};

/** What a circulator goes around, and what it shows. */
export interface Kind {
  readonly centre: Centre;
  readonly view: number;
}

/** One lap underway: the halfedge that is shown next, NONE when the lap is over. */
interface Lap {
  next: () => Result;
  orbit: DirectedOrbit<number>;
  at: number;
  left: number;
}

/**
 * One lap around an item of Directed Edges: an `Orbit` in all but name.
 */
export class DirectedOrbit<Item extends number> implements Iterable<Item> {
  /** @internal */
  declare readonly links: DirectedLinks;
  /** @internal Where a lap begins and ends; NONE for no lap. */
  declare readonly first: number;
  /** @internal */
  declare readonly walk: number;
  /** @internal */
  declare readonly view: number;

  /** @internal */
  constructor(links: DirectedLinks, first: number, walk: number, view: number) {
    this.links = links;
    this.first = first;
    this.walk = walk;
    this.view = view;
  }

  [Symbol.iterator](): Iterator<Item, typeof NONE> {
    const lap: Lap = { next: nextItem, orbit: this, at: this.first, left: this.links.halfedges };
    return lap as Iterator<Item, typeof NONE>;
  }

  /** The items of the lap in a fresh array. */
  toArray(): Item[] {
    const items: Item[] = [];
    for (const item of this) items.push(item);
    return items;
  }

  /**
   * Writes the items of the lap to the beginning of `buffer`, and returns how many there are.
   *
   * @throws RangeError if they don't all fit, with the length that is needed
   */
  into(buffer: Int32Array | Uint32Array): number {
    const { links, first, walk, view } = this;
    links.revive();
    const room = roomIn(buffer);
    let count = 0;
    let h = first;
    for (let left = links.halfedges; h >= 0 && left > 0; left--) {
      const item = shown(links, view, h);
      if (item >= 0) {
        buffer[count] = item; // ignored beyond its end
        count += 1;
      } else if (item !== NONE) this.fail();
      h = step(links, walk, h);
      if (h === first) return count <= room ? count : tooSmall(room, count);
    }
    return first === NONE ? 0 : this.fail();
  }

  /**
   * The same step of `lap` again with fresh views, if growth of the memory had detached them.
   * @internal
   */
  advanceAgain(lap: Lap): number {
    if (!this.links.detached) this.fail();
    this.links.revive();
    return advance(lap);
  }

  /** @internal */
  refuse(): never {
    throw staleError(this.links);
  }

  /** @internal */
  fail(): never {
    throw corrupt(`The orbit of halfedge ${this.first} does not close`);
  }
}

const nextItem = function (this: Lap): Result {
  const item = advance(this);
  return { value: item, done: item < 0 } as Result;
};

/** The next item, or NONE at the end. */
const advance = (lap: Lap): number => {
  const { orbit } = lap;
  const { links, walk, view, first } = orbit;
  if (links.era.over) orbit.refuse();
  let h = lap.at;
  while (h >= 0) {
    const item = shown(links, view, h);
    const next = step(links, walk, h);
    if (!(next >= 0 && item >= NONE) || lap.left <= 0) return orbit.advanceAgain(lap);
    h = next === first ? NONE : next;
    lap.left -= 1;
    lap.at = h;
    if (item >= 0) return item;
  }
  return NONE;
};

/**
 * Where a lap around an item begins. Throws a sentence for wrong arguments. Circulators that show
 * incoming halfedges take one of those as their start, too.
 */
function firstAround(
  links: DirectedLinks,
  { centre, view }: Kind,
  item: number,
  direction: Direction,
  start: number | undefined,
): number {
  const walk = walkAround(centre, direction);
  if (start !== undefined && (centre === 'edge' || centre === 'loop')) {
    const first =
      centre === 'edge' ? 'an edge begins with its side 0' : 'a loop begins at its halfedge';
    throw new RangeError(`start is ${describe(start)}; expected none, because ${first}.`);
  }
  if (centre === 'vertex') links.checkVertex(item);
  else if (centre === 'face') links.checkFace(item);
  else if (centre === 'edge') links.checkEdge(item);
  else links.checkHalfedge(item);
  if (start !== undefined) return checkStart(links, { centre, view }, item, start);
  if (centre === 'edge' || centre === 'loop') return item;
  const anchor = centre === 'vertex' ? links.vertexHalfedge[item] : 3 * item;
  // The reverse of a lap that begins at the anchor ends there.
  if (anchor === NONE || walk === ROTATE_CW || walk === LOOP_CCW) return anchor;
  const first = step(links, walk, anchor);
  if (first >= 0) return first;
  throw corrupt(`The halfedges of ${centre} ${item} form no closed orbit`);
}

function checkStart(
  links: DirectedLinks,
  { centre, view }: Kind,
  item: number,
  start: number,
): number {
  const refuse = (where: string, expected: string): never => {
    throw new RangeError(
      `start is halfedge ${describe(start)}, which ${where}; expected one that ${expected}.`,
    );
  };
  links.checkHalfedge(start, 'start');
  const [from, to] = [links.toVertex[before(links, start)], links.toVertex[start]];
  const face = faceOf(links, start);
  const incoming = centre === 'vertex' && view === OPPOSITE;
  if (incoming && to === item) return links.opposite[start];
  if (incoming && from !== item) {
    refuse(`goes from vertex ${from} to ${to}`, `arrives at vertex ${item}`);
  }
  if (centre === 'vertex' && from !== item) {
    refuse(`leaves vertex ${from}`, `leaves vertex ${item}`);
  }
  if (centre === 'face' && face !== item) {
    refuse(`lies in ${face === NONE ? 'no face' : `face ${face}`}`, `lies in face ${item}`);
  }
  return start;
}

/** The lap around an item. */
export function lapAround<Item extends number>(
  links: DirectedLinks,
  kind: Kind,
  item: number,
  direction: Direction,
  start: number | undefined,
): DirectedOrbit<Item> {
  const first = firstAround(links, kind, item, direction, start);
  return new DirectedOrbit(links, first, walkAround(kind.centre, direction), kind.view);
}

/** Endless and bidirectional, as `Circulator` is for a full mesh. */
export class DirectedCirculator<Item extends number = number, Around extends number = number> {
  /** @internal */
  declare readonly links: DirectedLinks;
  /** @internal */
  declare readonly kind: Kind;
  /** @internal */
  declare readonly direction: Direction;
  /** @internal */
  declare readonly walk: number;
  /** @internal */
  declare at: number;
  /** @internal */
  declare item: number;

  /** @internal */
  constructor(links: DirectedLinks, kind: Kind, direction: Direction) {
    this.links = links;
    this.kind = kind;
    this.direction = direction;
    this.walk = walkAround(kind.centre, direction);
    this.at = NONE;
    this.item = NONE;
  }

  /** What it shows where it stands; `NONE` if there is nothing around the item. */
  get current(): Item {
    if (this.links.era.over) throw staleError(this.links);
    return this.item as Item;
  }

  /** The halfedge where it stands; `NONE` if there is nothing around the item. */
  get halfedge(): Halfedge {
    if (this.links.era.over) throw staleError(this.links);
    return this.at as Halfedge;
  }

  /** Steps on, and returns what it shows there. */
  next(): Item {
    return this.step(this.walk);
  }

  /** Steps back, and returns what it shows there. */
  prev(): Item {
    return this.step(reverse(this.walk));
  }

  /** Goes around another item of the same kind and in the same direction. */
  moveTo(item: Around, start?: HalfedgeLike): this {
    this.at = firstAround(this.links, this.kind, item, this.direction, start);
    this.item = NONE;
    if (this.at < 0) return this;
    this.item = shown(this.links, this.kind.view, this.at);
    if (!(this.item >= 0)) this.step(this.walk); // a side without a face
    return this;
  }

  /** @internal */
  step(walk: number): Item {
    const { links, at: begin } = this;
    if (links.era.over) throw staleError(links);
    if (begin < 0) return NONE as Item;
    links.revive();
    let h = begin;
    for (let left = links.halfedges; left > 0; left--) {
      h = step(links, walk, h);
      const item = h >= 0 ? shown(links, this.kind.view, h) : h;
      if (!(item >= NONE) || !(h >= 0)) break;
      if (item === NONE && h !== begin) continue;
      this.at = item === NONE ? NONE : h;
      this.item = item;
      return item as Item;
    }
    throw corrupt(`The orbit of halfedge ${begin} does not close`);
  }
}

/**
 * All items of one kind in index order, as something to iterate over any number of times.
 */
export class DirectedItems<Item extends number> implements Iterable<Item> {
  readonly #links: DirectedLinks;
  readonly #count: number;
  readonly #areEdges: boolean;

  /** @internal */
  constructor(links: DirectedLinks, count: number, areEdges: boolean) {
    links.revive();
    this.#links = links;
    this.#count = count;
    this.#areEdges = areEdges;
  }

  [Symbol.iterator](): Iterator<Item, typeof NONE> {
    let at = 0;
    const next = (): Result => {
      if (this.#links.era.over) throw staleError(this.#links);
      if (this.#areEdges) at = this.#edgeFrom(at);
      return (
        at < this.#count ? { value: at++, done: false } : { value: NONE, done: true }
      ) as Result;
    };
    return { next } as Iterator<Item, typeof NONE>;
  }

  /** The items in a fresh array. */
  toArray(): Item[] {
    const items: Item[] = [];
    for (const item of this) items.push(item);
    return items;
  }

  /** The first edge from `e` on: a halfedge that is smaller than its opposite. */
  #edgeFrom(e: number): number {
    const links = this.#links;
    if (links.opposite.length === 0) links.revive();
    const { opposite } = links;
    let at = e;
    while (at < this.#count && opposite[at] < at) at += 1;
    return at;
  }
}
