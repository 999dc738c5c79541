import * as around from './around.js';
import { refuse } from './checks.js';
import { type Direction, type Halfedge, type HalfedgeLike, NONE as none } from './items.js';
import { corrupt, type Links } from './links.js';
import * as orbit from './orbit.js';
import * as walks from './walks.js';

// Constants of this module's own: see walks.ts.
const NONE: typeof none = none;
const { lastAround, walkAround } = around;
const { staleError } = orbit;
const { ACROSS, TO_VERTEX, beginsAtHome, recipe, reverse, shown, step } = walks;
const { SMALL } = walks.BITS;
type Centre = around.Centre;

/** Nothing to look up: what is read from it, undefined, leads to the slow path. */
const NOTHING = new Int32Array(0);

/**
 * How one kind of circulator goes in one direction. A step is two look-ups and three exclusive ors, the
 * same for all kinds that show a vertex or a face: `h = follow[h ^ before] ^ after` and
 * `item = table[h ^ side]`. To decide at each step what to do would cost twice the time.
 */
export interface Course {
  readonly centre: Centre;
  readonly walk: number;
  readonly view: number;
  /** Whether it follows next, rather than prev. */
  readonly alongNext: boolean;
  readonly before: number;
  readonly after: number;
  readonly side: number;
  /** What it shows where that needs no table is `(h ^ side) >> shift`; else NONE. */
  readonly shift: number;
  /** Whether it begins at the anchor of its item, rather than one step after it. */
  readonly beginsAtAnchor: boolean;
}

/** The courses of one kind of circulator. */
export interface Kind {
  readonly ccw: Course;
  readonly cw: Course;
}

/** What a circulator goes around, and what it shows of each halfedge. */
export function kindOf(centre: Centre, view: number): Kind {
  const course = (direction: Direction): Course => {
    const walk = walkAround(centre, direction);
    const { alongNext, before, after, side, shift } = recipe(walk, view);
    return {
      centre,
      walk,
      view,
      alongNext,
      before,
      after,
      side,
      shift,
      beginsAtAnchor: beginsAtHome(walk),
    };
  };
  return { ccw: course('ccw'), cw: course('cw') };
}

/**
 * An endless, bidirectional circulator: it has no end, and you decide when to stop. It is at one halfedge at
 * a time. After the connectivity has changed, every use except `moveTo` throws.
 */
export class Circulator<Item extends number = number, Around extends number = number> {
  // Not #private: a loop that makes a circulator for each vertex would take twice as long.
  /** @internal */
  declare readonly links: Links;
  /** @internal */
  declare readonly course: Course;
  /** @internal Copies of the course: where `circulate` is inlined, V8 takes these for constants. */
  declare readonly before: number;
  /** @internal */
  declare readonly after: number;
  /** @internal */
  declare readonly side: number;
  /** @internal */
  declare readonly shift: number;
  /** @internal The views to look things up in: empty once detached, stale once the era is over. */
  declare anchors: Int32Array;
  /** @internal */
  declare follow: Int32Array;
  /** @internal */
  declare table: Int32Array;
  /** @internal */
  declare era: Links['era'];
  /** @internal */
  declare at: number;
  /** @internal */
  declare item: number;

  /** @internal */
  constructor(links: Links, { ccw, cw }: Kind, direction: Direction) {
    const course = direction === 'ccw' ? ccw : direction === 'cw' ? cw : wrong.direction(direction);
    const { centre, view } = course;
    this.links = links;
    this.course = course;
    this.before = course.before;
    this.after = course.after;
    this.side = course.side;
    this.shift = course.shift;
    this.anchors = anchorsOf(links, centre);
    this.follow = followedBy(links, course);
    this.table = view === TO_VERTEX ? links.toVertex : links.face;
    this.era = links.era;
    this.at = NONE;
    this.item = NONE;
  }

  /** The current item; `NONE` if there is nothing around the centre. */
  get current(): Item {
    if (this.era.first < 0) this.refuse();
    return this.item as Item;
  }

  /**
   * The current halfedge: around a vertex, one that leaves it; around a face, one of the face's own. `NONE`
   * if there is nothing around the centre.
   */
  get halfedge(): Halfedge {
    if (this.era.first < 0) this.refuse();
    return this.at as Halfedge;
  }

  /** Steps forward, and returns the new current item. */
  next(): Item {
    if (this.era.first < 0) this.refuse();
    const link = this.follow[this.at ^ this.before];
    if (link >= 0) {
      const h = (link ^ this.after) & SMALL;
      const side = h ^ this.side;
      const item = this.shift < 0 ? this.table[side] : side >> this.shift;
      if (item >= 0) {
        this.at = h;
        this.item = item;
        return item as Item;
      }
    }
    return this.search(this.course.walk);
  }

  /** Steps back, and returns the new current item. */
  prev(): Item {
    if (this.era.first < 0) this.refuse();
    const { links, course } = this;
    const walk = reverse(course.walk);
    const h = step(links, walk, this.at);
    const item = shown(links, course.view, h);
    if (!(item >= 0)) return this.search(walk);
    this.at = h;
    this.item = item;
    return item as Item;
  }

  /**
   * Moves it to another centre of the same kind, in the same direction, as if it were a new circulator, but
   * without making one.
   */
  moveTo(item: Around, start?: HalfedgeLike): this {
    // One way out for all that isn't as usual: V8 inlines so many bytecodes into a loop, and then no more.
    if (typeof item === 'number' && start === undefined && this.era.first >= 0) {
      const anchor = this.anchors[item];
      if (anchor >= 0) {
        const stays = this.course.beginsAtAnchor; // and `after` is 0 then: it follows next
        const link = stays ? anchor : this.follow[anchor ^ this.before];
        const h = (link ^ this.after) & SMALL;
        if (link >= 0 && h < this.follow.length) {
          const side = h ^ this.side;
          const first = this.shift < 0 ? this.table[side] : side >> this.shift;
          if (first >= 0) {
            this.at = h;
            this.item = first;
            return this;
          }
        }
      }
    }
    return this.moveSlowly(item, start);
  }

  /**
   * `moveTo` in all cases: an isolated vertex, a start, a first side without a face, views that are
   * detached or stale, an argument that is wrong.
   * @internal
   */
  moveSlowly(item: number, start: HalfedgeLike | undefined): this {
    const { links, course } = this;
    const { centre, walk, view } = course;
    const last = lastAround(links, centre, item, walk, start, view);
    this.era = links.era;
    this.at = last;
    this.item = NONE;
    this.search(walk);
    return this;
  }

  /**
   * Steps to the next halfedge that shows something, if there is one; mends detached views first.
   * @internal
   */
  search(walk: number): Item {
    const { links } = this;
    const { view } = this.course;
    links.revive();
    this.lookAgain();
    if (this.at === NONE) return NONE as Item;
    const begin = this.at;
    let h = begin;
    for (let left = links.halfedgeSlots; left > 0; left--) {
      h = step(links, walk, h);
      const item = shown(links, view, h);
      if (!(h >= 0 && item >= NONE)) break;
      if (item !== NONE || h === begin) {
        this.at = item === NONE ? NONE : h;
        this.item = item;
        return item as Item;
      }
    }
    throw corrupt(`The orbit of halfedge ${begin} does not close`);
  }

  /** @internal Takes the views as they are now. */
  lookAgain(): void {
    const { links } = this;
    const { course } = this;
    const { centre, view } = course;
    this.anchors = anchorsOf(links, centre);
    this.follow = followedBy(links, course);
    this.table = view === TO_VERTEX ? links.toVertex : links.face;
  }

  /** @internal */
  refuse(): never {
    throw staleError(this.links);
  }
}

/** A method, because V8 compiles no property access that has never happened. */
const wrong = { direction: (way: unknown) => refuse('direction', way, "'ccw' or 'cw'", 'string') };

/** By item, the halfedge where it begins or one step before; edges and loops have no such view. */
function anchorsOf(links: Links, centre: Centre): Int32Array {
  if (centre === 'vertex') return links.vertexHalfedge;
  return centre === 'face' ? links.faceHalfedge : NOTHING;
}

function followedBy(links: Links, { walk, alongNext }: Course): Int32Array {
  if (walk === ACROSS) return NOTHING;
  return alongNext === true ? links.next : links.prev;
}
