import * as around from './around.js';
import { type Direction, type Halfedge, type HalfedgeLike, NONE as none } from './items.js';
import { corrupt, type Era, type Latest, type Links } from './links.js';
import type { OptionNames } from './options.js';
import * as orbit from './orbit.js';
import * as walks from './walks.js';

// Constants of this module's own: see walks.ts.
const NONE: typeof none = none;
const { lastAround, walkAround } = around;
const { staleError } = orbit;
const { reverse, shown, step } = walks;
const { SHOW_OPPOSITE, TURN } = walks.BITS;
type Centre = around.Centre;

/** Nothing to look up: what is read from it, undefined, leads to the slow path. */
const NO_ANCHORS: Latest = { view: new Int32Array(0) };

/**
 * An endless, bidirectional circulator: it has no end, and you decide when to stop. It is at one halfedge at
 * a time. After the connectivity has changed, every use except `moveTo` throws.
 */
export interface Circulator<Item extends number = number, Around extends number = number> {
  /** The current item; `NONE` if there is nothing around the centre. */
  readonly current: Item;

  /**
   * The current halfedge: around a vertex, one that leaves it; around a face, one of the face's own. `NONE`
   * if there is nothing around the centre.
   */
  readonly halfedge: Halfedge;

  /** Steps forward, and returns the new current item. */
  next(): Item;

  /** Steps back, and returns the new current item. */
  prev(): Item;

  /**
   * Moves it to another centre of the same kind, in the same direction, as if it were a new circulator, but
   * without making one.
   */
  moveTo(item: Around, start?: HalfedgeLike): this;
}

/** Which way a circulator goes, and where it begins. */
export interface CirculateOptions {
  /** Default: 'ccw'. */
  direction?: Direction | undefined;
  /**
   * A halfedge to begin at: one that leaves the vertex (`vertexIncomingHalfedges` also takes one that
   * arrives there), or one of the face. Edges and loops have none.
   */
  start?: HalfedgeLike | undefined;
}

export const CIRCULATE_OPTIONS: OptionNames<CirculateOptions> = { direction: true, start: true };

/** How one kind of circulator goes in one direction. */
export interface Course {
  readonly centre: Centre;
  readonly walk: number;
  readonly view: number;
  /** 1 if a step goes to the opposite, too: around a vertex. */
  readonly turn: number;
  /** 1 if it shows what is at the opposite. */
  readonly side: number;
  /** Halfedges and edges are shown as `(h ^ side) >> shift`. */
  readonly shift: number;
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
    return { centre, walk, view, turn: walk & TURN, side: view & SHOW_OPPOSITE, shift: view >> 1 };
  };
  return { ccw: course('ccw'), cw: course('cw') };
}

/** The view of the anchors of what a circulator goes around. */
export function anchorsOf(links: Links, centre: Centre): Latest {
  if (centre === 'vertex') return links.vertexAnchors;
  return centre === 'face' ? links.faceAnchors : NO_ANCHORS;
}

/** A circulator, as what it shows slowly sees it. */
export interface Place {
  links: Links;
  course: Course;
  era: Era;
  at: number;
}

/**
 * All that isn't as usual: an era that is over, sides without a face, a start. Methods, because V8 compiles no
 * property access that has never happened.
 */
export const slowly = {
  current({ links, course, era, at }: Place): number {
    checkEra(links, era);
    return at === NONE ? NONE : shown(links, course.view, at);
  },

  halfedge({ links, era, at }: Place): number {
    checkEra(links, era);
    return at;
  },

  /** Where it begins around `item`; NONE if there is nothing to show. */
  begin(links: Links, course: Course, item: number, start?: HalfedgeLike): number {
    const { centre, walk, view } = course;
    const last = lastAround(links, centre, item, walk, start, view);
    return slowly.walk(links, links.era, view, walk, last);
  },

  /** The next halfedge that shows something, if there is one. */
  next({ links, era, course, at }: Place): number {
    return slowly.walk(links, era, course.view, course.walk, at);
  },

  prev({ links, era, course, at }: Place): number {
    return slowly.walk(links, era, course.view, reverse(course.walk), at);
  },

  walk(links: Links, era: Era, view: number, walk: number, begin: number): number {
    checkEra(links, era);
    if (begin === NONE) return NONE;
    let h = begin;
    for (let left = links.halfedgeSlots; left > 0; left--) {
      h = step(links, walk, h);
      const item = shown(links, view, h);
      if (!(h >= 0 && item >= NONE)) break;
      if (item !== NONE) return h;
      if (h === begin) return NONE;
    }
    throw corrupt(`The orbit of halfedge ${begin} does not close`);
  },
};

/** Throws once the era is over; mends views that growth of the memory has detached. */
function checkEra(links: Links, era: Era): void {
  if (era.isOver) throw staleError(links);
  links.revive();
}
