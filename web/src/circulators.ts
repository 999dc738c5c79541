import * as circulator from './circulator.js';
import { type HalfedgeLike, NONE as none } from './items.js';
import type { Latest, Links } from './links.js';
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
// - V8 keeps a circulator in memory if a call gets to see it, or if one of its methods has ever called something.
//   So where it begins is found before it is made, and its methods call something only where `slowly` is needed.
// - They extend nothing: to call the constructor of a base class takes twice the bytecodes.
// - What is wrong is found by looking up what isn't there, as laps do: see laps.ts. Once the era is over, there
//   is nothing at all.
// - What is shown is shown as it stands there, also where a program has written into the live views.
// - What goes around vertices turns to the opposite, what goes around faces doesn't: `turn` is 1 or 0.

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
    let h = ((era.prev[this.at] ?? NONE) ^ turn) & SMALL;
    if (era.toVertex[h] === undefined) {
      h = slowly.next(this.links, era, this.course, this.at) | 0;
    }
    this.at = h;
    return era.toVertex[h] ?? NONE;
  }

  prev(): number {
    const { era, turn } = this;
    let h = (era.next[this.at ^ turn] ?? NONE) & SMALL;
    if (era.toVertex[h] === undefined) {
      h = slowly.prev(this.links, era, this.course, this.at) | 0;
    }
    this.at = h;
    return era.toVertex[h] ?? NONE;
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
    const { links, course } = this;
    const h =
      start === undefined
        ? beginAlongPrev(links, course, this.anchors, item)
        : slowly.begin(links, course, item, start) | 0;
    this.at = h;
    this.era = links.era;
    return this;
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
    let h = (era.next[this.at ^ turn] ?? NONE) & SMALL;
    if (era.toVertex[h] === undefined) {
      h = slowly.next(this.links, era, this.course, this.at) | 0;
    }
    this.at = h;
    return era.toVertex[h] ?? NONE;
  }

  prev(): number {
    const { era, turn } = this;
    let h = ((era.prev[this.at] ?? NONE) ^ turn) & SMALL;
    if (era.toVertex[h] === undefined) {
      h = slowly.prev(this.links, era, this.course, this.at) | 0;
    }
    this.at = h;
    return era.toVertex[h] ?? NONE;
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
    const { links, course } = this;
    const h =
      start === undefined
        ? beginAlongNext(links, course, this.anchors, item)
        : slowly.begin(links, course, item, start) | 0;
    this.at = h;
    this.era = links.era;
    return this;
  }
}
export interface VerticesAlongNext extends Going {}

/** Shows faces, of its halfedges or their opposites, along prev. */
export class FacesAlongPrev {
  constructor(links: Links, course: Course, anchors: Latest, at: number) {
    this.links = links;
    this.course = course;
    this.anchors = anchors;
    this.turn = course.turn;
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
    const { era, turn } = this;
    let h = ((era.prev[this.at] ?? NONE) ^ turn) & SMALL;
    if (era.face[(era.face[h ^ this.side] ?? NONE) >> 31] === undefined) {
      h = slowly.next(this.links, era, this.course, this.at) | 0;
    }
    this.at = h;
    this.seen = h ^ this.side;
    return era.face[h ^ this.side] ?? NONE;
  }

  prev(): number {
    const { era, turn } = this;
    let h = (era.next[this.at ^ turn] ?? NONE) & SMALL;
    if (era.face[(era.face[h ^ this.side] ?? NONE) >> 31] === undefined) {
      h = slowly.prev(this.links, era, this.course, this.at) | 0;
    }
    this.at = h;
    this.seen = h ^ this.side;
    return era.face[h ^ this.side] ?? NONE;
  }

  moveTo(item: number, start?: HalfedgeLike): this {
    if (typeof item === 'number' && start === undefined) {
      const { era, turn } = this;
      const anchor = this.anchors.view[item] ?? NONE;
      const h = ((era.prev[anchor] ?? NONE) ^ turn) & SMALL;
      if (era.face[h ^ this.side] >= 0) {
        this.at = h;
        this.seen = h ^ this.side;
        return this;
      }
    }
    const { links, course } = this;
    const h =
      start === undefined
        ? beginFacesAlongPrev(links, course, this.anchors, item)
        : slowly.begin(links, course, item, start) | 0;
    this.at = h;
    this.seen = h ^ this.side;
    this.era = links.era;
    return this;
  }
}
export interface FacesAlongPrev extends Going {}

/** Shows faces, of its halfedges or their opposites, along next. */
export class FacesAlongNext {
  constructor(links: Links, course: Course, anchors: Latest, at: number) {
    this.links = links;
    this.course = course;
    this.anchors = anchors;
    this.turn = course.turn;
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
    const { era, turn } = this;
    let h = (era.next[this.at ^ turn] ?? NONE) & SMALL;
    if (era.face[(era.face[h ^ this.side] ?? NONE) >> 31] === undefined) {
      h = slowly.next(this.links, era, this.course, this.at) | 0;
    }
    this.at = h;
    this.seen = h ^ this.side;
    return era.face[h ^ this.side] ?? NONE;
  }

  prev(): number {
    const { era, turn } = this;
    let h = ((era.prev[this.at] ?? NONE) ^ turn) & SMALL;
    if (era.face[(era.face[h ^ this.side] ?? NONE) >> 31] === undefined) {
      h = slowly.prev(this.links, era, this.course, this.at) | 0;
    }
    this.at = h;
    this.seen = h ^ this.side;
    return era.face[h ^ this.side] ?? NONE;
  }

  moveTo(item: number, start?: HalfedgeLike): this {
    if (typeof item === 'number' && start === undefined) {
      const { era } = this;
      const h = (this.anchors.view[item] ?? NONE) & SMALL;
      if (era.face[h ^ this.side] >= 0) {
        this.at = h;
        this.seen = h ^ this.side;
        return this;
      }
    }
    const { links, course } = this;
    const h =
      start === undefined
        ? beginFacesAlongNext(links, course, this.anchors, item)
        : slowly.begin(links, course, item, start) | 0;
    this.at = h;
    this.seen = h ^ this.side;
    this.era = links.era;
    return this;
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
    let h = ((era.prev[this.at] ?? NONE) ^ turn) & SMALL;
    if (era.toVertex[h] === undefined) {
      h = slowly.next(this.links, era, this.course, this.at) | 0;
    }
    this.at = h;
    this.item = ((h ^ this.side) >> this.shift) | (h >> 31);
    return this.item;
  }

  prev(): number {
    const { era, turn } = this;
    let h = (era.next[this.at ^ turn] ?? NONE) & SMALL;
    if (era.toVertex[h] === undefined) {
      h = slowly.prev(this.links, era, this.course, this.at) | 0;
    }
    this.at = h;
    this.item = ((h ^ this.side) >> this.shift) | (h >> 31);
    return this.item;
  }

  moveTo(item: number, start?: HalfedgeLike): this {
    if (typeof item === 'number' && start === undefined) {
      const { era, turn } = this;
      const anchor = this.anchors.view[item] ?? NONE;
      const h = ((era.prev[anchor] ?? NONE) ^ turn) & SMALL;
      if (era.toVertex[h] !== undefined) {
        this.at = h;
        this.item = ((h ^ this.side) >> this.shift) | (h >> 31);
        return this;
      }
    }
    const { links, course } = this;
    const h =
      start === undefined
        ? beginAlongPrev(links, course, this.anchors, item)
        : slowly.begin(links, course, item, start) | 0;
    this.at = h;
    this.item = ((h ^ this.side) >> this.shift) | (h >> 31);
    this.era = links.era;
    return this;
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
    let h = (era.next[this.at ^ turn] ?? NONE) & SMALL;
    if (era.toVertex[h] === undefined) {
      h = slowly.next(this.links, era, this.course, this.at) | 0;
    }
    this.at = h;
    this.item = ((h ^ this.side) >> this.shift) | (h >> 31);
    return this.item;
  }

  prev(): number {
    const { era, turn } = this;
    let h = ((era.prev[this.at] ?? NONE) ^ turn) & SMALL;
    if (era.toVertex[h] === undefined) {
      h = slowly.prev(this.links, era, this.course, this.at) | 0;
    }
    this.at = h;
    this.item = ((h ^ this.side) >> this.shift) | (h >> 31);
    return this.item;
  }

  moveTo(item: number, start?: HalfedgeLike): this {
    if (typeof item === 'number' && start === undefined) {
      const { era } = this;
      const h = (this.anchors.view[item] ?? NONE) & SMALL;
      if (era.toVertex[h] !== undefined) {
        this.at = h;
        this.item = ((h ^ this.side) >> this.shift) | (h >> 31);
        return this;
      }
    }
    const { links, course } = this;
    const h =
      start === undefined
        ? beginAlongNext(links, course, this.anchors, item)
        : slowly.begin(links, course, item, start) | 0;
    this.at = h;
    this.item = ((h ^ this.side) >> this.shift) | (h >> 31);
    this.era = links.era;
    return this;
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
    this.at = slowly.next(this.links, this.era, this.course, this.at);
    return this.currentSlowly;
  }

  prev(): number {
    this.at = slowly.prev(this.links, this.era, this.course, this.at);
    return this.currentSlowly;
  }

  moveTo(item: number, start?: HalfedgeLike): this {
    const { links } = this;
    this.at = slowly.begin(links, this.course, item, start);
    this.era = links.era;
    return this;
  }
}
export interface Across extends Going {}

/** What is shown in all cases, by getters that all of them share. */
const shared: PropertyDescriptorMap = {
  currentSlowly: {
    get(this: Place): number {
      return slowly.current(this);
    },
  },
  halfedgeSlowly: {
    get(this: Place): number {
      return slowly.halfedge(this);
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
}

// Where a circulator begins around an item, NONE if there is nothing to show.

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
    const anchor = anchors.view[item] ?? NOTHING;
    if (anchor === NONE) return NONE;
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
    const anchor = anchors.view[item] ?? NOTHING;
    if (anchor === NONE) return NONE;
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
