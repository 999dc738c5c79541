import * as circulator from './circulator.js';
import { type HalfedgeLike, NONE as none } from './items.js';
import type { Era, Latest, Links } from './links.js';
import * as walks from './walks.js';

// Constants of this module's own: see walks.ts.
const NONE: typeof none = none;
const { slowly } = circulator;
const { SMALL } = walks.BITS;
type Course = circulator.Course;
type Place = circulator.Place;

/** Instead of an anchor where there is none to look up: none has that number. */
const NOTHING = -2;

// All circulators, in seven classes: for what is shown (vertices, faces, halfedges and edges), along prev
// and along next, and across edges. The loops of other people in which they run are fast if V8 inlines all
// of a circulator, and keeps it in registers. So:
//
// - V8 inlines 920 bytecodes into a loop, and counts those that it has inlined into a function before. So
//   each class has a text of its own, which decides nothing, and whatever isn't as usual is a call.
// - Functions of at most 27 bytecodes are inlined in any case. The getters are that short, because they would
//   come last. What isn't as usual is a getter there, too, which takes fewer bytecodes than a call.
// - V8 keeps a circulator in memory if one of its methods has ever called something, or gone through a loop. So
//   where it begins is found before it is made, and up to two sides without a face are stepped over in line.
// - They extend nothing: to call the constructor of a base class takes twice the bytecodes.
// - What is wrong is found by looking up what isn't there, as laps do: see laps.ts. Once the era is over, there
//   is nothing at all.
// - What is shown is shown as it stands there, also where a program has written into the live views.
// - What goes around vertices turns to the opposite, what goes around faces doesn't: `turn` is 1 or 0. What shows
//   faces turns once in each step, to go on or to look, so that `side` says it all.

/** Shows the vertices that its halfedges lead to, along prev. */
export class VerticesAlongPrev {
  constructor(links: Links, course: Course, anchors: Latest, at: number) {
    this.links = links;
    this.course = course;
    this.anchors = anchors;
    this.turn = course.turn;
    this.era = links.era;
    this.at = at;
  }

  get current(): number {
    return this.era.toVertex[this.at] ?? this.currentSlowly;
  }

  get halfedge(): number {
    return this.era.toVertex[0] === undefined ? this.halfedgeSlowly : this.at;
  }

  next(): number {
    const { era, turn } = this;
    const h = ((era.prev[this.at] ?? NONE) ^ turn) & SMALL;
    const item = era.toVertex[h];
    if (item === undefined) return this.nextSlowly();
    this.at = h;
    return item;
  }

  prev(): number {
    const { era, turn } = this;
    const h = (era.next[this.at ^ turn] ?? NONE) & SMALL;
    const item = era.toVertex[h];
    if (item === undefined) return this.prevSlowly();
    this.at = h;
    return item;
  }

  moveTo(item: number, start?: HalfedgeLike): this {
    if (typeof item === 'number' && start === undefined) {
      const { era, turn } = this;
      const anchor = this.anchors.view[item] ?? NONE;
      const h = ((era.prev[anchor] ?? NONE) ^ turn) & SMALL;
      if (era.toVertex[h] !== undefined) {
        this.at = h;
        return this;
      }
    }
    return this.moveSlowly(item, start);
  }

  arrive(h: number): void {
    this.at = h;
  }
}
export interface VerticesAlongPrev extends Going {}

/** Shows the vertices that its halfedges lead to, along next. */
export class VerticesAlongNext {
  constructor(links: Links, course: Course, anchors: Latest, at: number) {
    this.links = links;
    this.course = course;
    this.anchors = anchors;
    this.turn = course.turn;
    this.era = links.era;
    this.at = at;
  }

  get current(): number {
    return this.era.toVertex[this.at] ?? this.currentSlowly;
  }

  get halfedge(): number {
    return this.era.toVertex[0] === undefined ? this.halfedgeSlowly : this.at;
  }

  next(): number {
    const { era, turn } = this;
    const h = (era.next[this.at ^ turn] ?? NONE) & SMALL;
    const item = era.toVertex[h];
    if (item === undefined) return this.nextSlowly();
    this.at = h;
    return item;
  }

  prev(): number {
    const { era, turn } = this;
    const h = ((era.prev[this.at] ?? NONE) ^ turn) & SMALL;
    const item = era.toVertex[h];
    if (item === undefined) return this.prevSlowly();
    this.at = h;
    return item;
  }

  moveTo(item: number, start?: HalfedgeLike): this {
    if (typeof item === 'number' && start === undefined) {
      const { era } = this;
      const h = (this.anchors.view[item] ?? NONE) & SMALL;
      if (era.toVertex[h] !== undefined) {
        this.at = h;
        return this;
      }
    }
    return this.moveSlowly(item, start);
  }

  arrive(h: number): void {
    this.at = h;
  }
}
export interface VerticesAlongNext extends Going {}

// What a step looks up, in functions of at most 27 bytecodes; NONE, or no halfedge at all, where nothing is there.

const prevOf = (era: Era, h: number): number => era.prev[h] ?? NONE;
const nextOf = (era: Era, h: number): number => (era.next[h] ?? NONE) & SMALL;
const faceOf = (era: Era, h: number): number => era.face[h] ?? NONE;

/** Shows faces, of its halfedges or their opposites, along prev. */
export class FacesAlongPrev {
  constructor(links: Links, course: Course, anchors: Latest, at: number) {
    this.links = links;
    this.course = course;
    this.anchors = anchors;
    this.side = course.side;
    this.era = links.era;
    this.at = at;
    this.seen = at ^ this.side;
  }

  get current(): number {
    return this.era.face[this.seen] ?? this.currentSlowly;
  }

  get halfedge(): number {
    return this.era.face[0] === undefined ? this.halfedgeSlowly : this.at;
  }

  next(): number {
    const { era, side } = this;
    let seen = (prevOf(era, this.seen ^ side) ^ 1) & SMALL;
    let item = faceOf(era, seen);
    if (era.face[item >> 31] === undefined) {
      seen = (prevOf(era, seen ^ side) ^ 1) & SMALL;
      item = faceOf(era, seen);
      if (item < 0) {
        seen = (prevOf(era, seen ^ side) ^ 1) & SMALL;
        item = faceOf(era, seen);
      }
      if (item < 0) return this.nextSlowly();
    }
    this.at = seen ^ side;
    this.seen = seen;
    return item;
  }

  prev(): number {
    const { era, side } = this;
    let seen = nextOf(era, this.seen ^ 1) ^ side;
    let item = faceOf(era, seen);
    if (era.face[item >> 31] === undefined) {
      seen = nextOf(era, seen ^ 1) ^ side;
      item = faceOf(era, seen);
      if (item < 0) {
        seen = nextOf(era, seen ^ 1) ^ side;
        item = faceOf(era, seen);
      }
      if (item < 0) return this.prevSlowly();
    }
    this.at = seen ^ side;
    this.seen = seen;
    return item;
  }

  moveTo(item: number, start?: HalfedgeLike): this {
    if (typeof item === 'number' && start === undefined) {
      const { era, side } = this;
      const anchor = this.anchors.view[item] ?? NONE;
      let seen = (prevOf(era, anchor) ^ 1) & SMALL;
      if (faceOf(era, seen) < 0) seen = (prevOf(era, seen ^ side) ^ 1) & SMALL;
      if (faceOf(era, seen) < 0) seen = (prevOf(era, seen ^ side) ^ 1) & SMALL;
      if (faceOf(era, seen) >= 0) {
        this.at = seen ^ side;
        this.seen = seen;
        return this;
      }
    }
    return this.moveSlowly(item, start);
  }

  arrive(h: number): void {
    this.at = h;
    this.seen = h ^ this.side;
  }
}
export interface FacesAlongPrev extends Going {}

/** Shows faces, of its halfedges or their opposites, along next. */
export class FacesAlongNext {
  constructor(links: Links, course: Course, anchors: Latest, at: number) {
    this.links = links;
    this.course = course;
    this.anchors = anchors;
    this.side = course.side;
    this.era = links.era;
    this.at = at;
    this.seen = at ^ this.side;
  }

  get current(): number {
    return this.era.face[this.seen] ?? this.currentSlowly;
  }

  get halfedge(): number {
    return this.era.face[0] === undefined ? this.halfedgeSlowly : this.at;
  }

  next(): number {
    const { era, side } = this;
    let seen = nextOf(era, this.seen ^ 1) ^ side;
    let item = faceOf(era, seen);
    if (era.face[item >> 31] === undefined) {
      seen = nextOf(era, seen ^ 1) ^ side;
      item = faceOf(era, seen);
      if (item < 0) {
        seen = nextOf(era, seen ^ 1) ^ side;
        item = faceOf(era, seen);
      }
      if (item < 0) return this.nextSlowly();
    }
    this.at = seen ^ side;
    this.seen = seen;
    return item;
  }

  prev(): number {
    const { era, side } = this;
    let seen = (prevOf(era, this.seen ^ side) ^ 1) & SMALL;
    let item = faceOf(era, seen);
    if (era.face[item >> 31] === undefined) {
      seen = (prevOf(era, seen ^ side) ^ 1) & SMALL;
      item = faceOf(era, seen);
      if (item < 0) {
        seen = (prevOf(era, seen ^ side) ^ 1) & SMALL;
        item = faceOf(era, seen);
      }
      if (item < 0) return this.prevSlowly();
    }
    this.at = seen ^ side;
    this.seen = seen;
    return item;
  }

  moveTo(item: number, start?: HalfedgeLike): this {
    if (typeof item === 'number' && start === undefined) {
      const { era, side } = this;
      const anchor = this.anchors.view[item] ?? NONE;
      let seen = (anchor & SMALL) ^ side;
      if (faceOf(era, seen) < 0) seen = nextOf(era, seen ^ 1) ^ side;
      if (faceOf(era, seen) < 0) seen = nextOf(era, seen ^ 1) ^ side;
      if (faceOf(era, seen) >= 0) {
        this.at = seen ^ side;
        this.seen = seen;
        return this;
      }
    }
    return this.moveSlowly(item, start);
  }

  arrive(h: number): void {
    this.at = h;
    this.seen = h ^ this.side;
  }
}
export interface FacesAlongNext extends Going {}

/** Shows halfedges or edges, which takes no look-up, along prev. */
export class IndicesAlongPrev {
  constructor(links: Links, course: Course, anchors: Latest, at: number) {
    this.links = links;
    this.course = course;
    this.anchors = anchors;
    this.turn = course.turn;
    this.side = course.side;
    this.shift = course.shift;
    this.era = links.era;
    this.at = at;
    this.item = ((at ^ this.side) >> this.shift) | (at >> 31);
  }

  get current(): number {
    return this.era.toVertex[0] === undefined ? this.currentSlowly : this.item;
  }

  get halfedge(): number {
    return this.era.toVertex[0] === undefined ? this.halfedgeSlowly : this.at;
  }

  next(): number {
    const { era, turn } = this;
    const h = ((era.prev[this.at] ?? NONE) ^ turn) & SMALL;
    if (era.toVertex[h] === undefined) return this.nextSlowly();
    this.at = h;
    this.item = (h ^ this.side) >> this.shift;
    return this.item;
  }

  prev(): number {
    const { era, turn } = this;
    const h = (era.next[this.at ^ turn] ?? NONE) & SMALL;
    if (era.toVertex[h] === undefined) return this.prevSlowly();
    this.at = h;
    this.item = (h ^ this.side) >> this.shift;
    return this.item;
  }

  moveTo(item: number, start?: HalfedgeLike): this {
    if (typeof item === 'number' && start === undefined) {
      const { era, turn } = this;
      const anchor = this.anchors.view[item] ?? NONE;
      const h = ((era.prev[anchor] ?? NONE) ^ turn) & SMALL;
      if (era.toVertex[h] !== undefined) {
        this.at = h;
        this.item = (h ^ this.side) >> this.shift;
        return this;
      }
    }
    return this.moveSlowly(item, start);
  }

  arrive(h: number): void {
    this.at = h;
    this.item = h < 0 ? NONE : (h ^ this.side) >> this.shift;
  }
}
export interface IndicesAlongPrev extends Going {}

/** Shows halfedges or edges, which takes no look-up, along next. */
export class IndicesAlongNext {
  constructor(links: Links, course: Course, anchors: Latest, at: number) {
    this.links = links;
    this.course = course;
    this.anchors = anchors;
    this.turn = course.turn;
    this.side = course.side;
    this.shift = course.shift;
    this.era = links.era;
    this.at = at;
    this.item = ((at ^ this.side) >> this.shift) | (at >> 31);
  }

  get current(): number {
    return this.era.toVertex[0] === undefined ? this.currentSlowly : this.item;
  }

  get halfedge(): number {
    return this.era.toVertex[0] === undefined ? this.halfedgeSlowly : this.at;
  }

  next(): number {
    const { era, turn } = this;
    const h = (era.next[this.at ^ turn] ?? NONE) & SMALL;
    if (era.toVertex[h] === undefined) return this.nextSlowly();
    this.at = h;
    this.item = (h ^ this.side) >> this.shift;
    return this.item;
  }

  prev(): number {
    const { era, turn } = this;
    const h = ((era.prev[this.at] ?? NONE) ^ turn) & SMALL;
    if (era.toVertex[h] === undefined) return this.prevSlowly();
    this.at = h;
    this.item = (h ^ this.side) >> this.shift;
    return this.item;
  }

  moveTo(item: number, start?: HalfedgeLike): this {
    if (typeof item === 'number' && start === undefined) {
      const { era } = this;
      const h = (this.anchors.view[item] ?? NONE) & SMALL;
      if (era.toVertex[h] !== undefined) {
        this.at = h;
        this.item = (h ^ this.side) >> this.shift;
        return this;
      }
    }
    return this.moveSlowly(item, start);
  }

  arrive(h: number): void {
    this.at = h;
    this.item = h < 0 ? NONE : (h ^ this.side) >> this.shift;
  }
}
export interface IndicesAlongNext extends Going {}

/** Goes across an edge, from one of its halfedges to the other. */
export class Across {
  constructor(links: Links, course: Course, anchors: Latest, at: number) {
    this.links = links;
    this.course = course;
    this.anchors = anchors;
    this.era = links.era;
    this.at = at;
  }

  get current(): number {
    return this.currentSlowly;
  }

  get halfedge(): number {
    return this.halfedgeSlowly;
  }

  next(): number {
    return this.nextSlowly();
  }

  prev(): number {
    return this.prevSlowly();
  }

  moveTo(item: number, start?: HalfedgeLike): this {
    return this.moveSlowly(item, start);
  }

  arrive(h: number): void {
    this.at = h;
  }
}
export interface Across extends Going {}

/** What is done in all cases, by getters and methods that all of them share. */
const shared = {
  currentSlowly: {
    get(this: Going): number {
      return slowly.current(this);
    },
  },
  halfedgeSlowly: {
    get(this: Going): number {
      return slowly.halfedge(this);
    },
  },
  nextSlowly: {
    value(this: Going): number {
      this.arrive(slowly.next(this));
      return this.current;
    },
  },
  prevSlowly: {
    value(this: Going): number {
      this.arrive(slowly.prev(this));
      return this.current;
    },
  },
  moveSlowly: {
    value(this: Going, item: number, start: HalfedgeLike | undefined): Going {
      this.arrive(slowly.begin(this.links, this.course, item, start));
      this.era = this.links.era;
      return this;
    },
  },
};

/** What all of them are; `seen` and `item` only what shows from there. */
export interface Going extends Place {
  anchors: Latest;
  turn: number;
  side: number;
  shift: number;
  /** The halfedge whose face is shown. */
  seen: number;
  /** What is shown, where that takes no look-up. */
  item: number;

  readonly current: number;
  readonly halfedge: number;
  next(): number;
  prev(): number;
  moveTo(item: number, start?: HalfedgeLike): this;

  readonly currentSlowly: number;
  readonly halfedgeSlowly: number;
  nextSlowly(): number;
  prevSlowly(): number;
  moveSlowly(item: number, start: HalfedgeLike | undefined): this;
  /** Stands on a halfedge, or on NONE. */
  arrive(h: number): void;
}

// Where a circulator begins around an item, NONE if there is nothing to show. `| 0` tells V8 that it is a number.

export const beginAlongPrev = (
  links: Links,
  course: Course,
  anchors: Latest,
  item: number,
): number => {
  if (typeof item === 'number') {
    const { era } = links;
    const anchor = anchors.view[item] ?? NOTHING;
    if (anchor === NONE) return NONE;
    const h = ((era.prev[anchor] ?? NONE) ^ course.turn) & SMALL;
    if (era.toVertex[h] !== undefined) return h;
  }
  return slowly.begin(links, course, item) | 0;
};

export const beginAlongNext = (
  links: Links,
  course: Course,
  anchors: Latest,
  item: number,
): number => {
  if (typeof item === 'number') {
    const { era } = links;
    const anchor = anchors.view[item] ?? NOTHING;
    if (anchor === NONE) return NONE;
    const h = anchor & SMALL;
    if (era.toVertex[h] !== undefined) return h;
  }
  return slowly.begin(links, course, item) | 0;
};

export const beginFacesAlongPrev = (
  links: Links,
  course: Course,
  anchors: Latest,
  item: number,
): number => {
  if (typeof item === 'number') {
    const { era } = links;
    const anchor = anchors.view[item] ?? NONE;
    const h = ((era.prev[anchor] ?? NONE) ^ course.turn) & SMALL;
    if (era.face[h ^ course.side] >= 0) return h;
  }
  return slowly.begin(links, course, item) | 0;
};

export const beginFacesAlongNext = (
  links: Links,
  course: Course,
  anchors: Latest,
  item: number,
): number => {
  if (typeof item === 'number') {
    const { era } = links;
    const anchor = anchors.view[item] ?? NONE;
    const h = anchor & SMALL;
    if (era.face[h ^ course.side] >= 0) return h;
  }
  return slowly.begin(links, course, item) | 0;
};

/** All classes of circulators. */
export const CLASSES = [
  VerticesAlongPrev,
  VerticesAlongNext,
  FacesAlongPrev,
  FacesAlongNext,
  IndicesAlongPrev,
  IndicesAlongNext,
  Across,
];
for (const { prototype } of CLASSES) Object.defineProperties(prototype, shared);
