import * as making from '../circulate.js';
import type { Circulator, Course } from '../circulator.js';
import { type HalfedgeLike, NONE as none } from '../items.js';
import { corrupt } from '../links.js';
import * as allWalks from '../walks.js';
import * as around from './around.js';
import type { DirectedLinks } from './links.js';
import * as walks from './walks.js';

// Constants of this module's own: see ../walks.ts.
const NONE: typeof none = none;
const { KINDS, LONGEST, courseBy } = making;
const { LOOP_CCW, ROTATE_CCW, beginsAtHome, reverse } = allWalks;
const { SMALL } = allWalks.BITS;
const { homeOf } = around;
const { after, before, shown, step } = walks;

/** A {@link Circulator} of Directed Edges. */
export type DirectedCirculator<
  Item extends number = number,
  Around extends number = number,
> = Circulator<Item, Around>;

// As ../circulators.ts, and for the reasons there; but with a class for each walk, which keeps what it shows.

/** Where a circulator begins; SMALL, which is no halfedge, if that has to be found slowly. */
const beginRotatingCcw = (links: DirectedLinks, v: number): number => {
  const anchor = typeof v === 'number' ? (links.vertexHalfedge[v] ?? NONE) : NONE;
  return (links.opposite[before(links, anchor)] ?? NONE) & SMALL;
};
const beginRotatingCw = (links: DirectedLinks, v: number): number =>
  (typeof v === 'number' ? (links.vertexHalfedge[v] ?? NONE) : NONE) & SMALL;
const beginAlongNext = (links: DirectedLinks, f: number): number =>
  typeof f === 'number' && f >>> 0 === f && 3 * f < links.sides ? 3 * f : SMALL;
const beginAlongPrev = (links: DirectedLinks, f: number): number =>
  typeof f === 'number' && f >>> 0 === f && 3 * f < links.sides ? 3 * f + 2 : SMALL;

/** Around a vertex, counter-clockwise. */
class RotatingCcw {
  constructor(links: DirectedLinks, course: Course, at: number, item: number) {
    this.links = links;
    this.course = course;
    this.view = course.view;
    this.at = at;
    this.item = item;
  }

  get current(): number {
    return this.links.opposite[0] === undefined ? this.currentSlowly : this.item;
  }

  get halfedge(): number {
    return this.links.opposite[0] === undefined ? this.halfedgeSlowly : this.at;
  }

  next(): number {
    const { links } = this;
    const h = (links.opposite[before(links, this.at)] ?? NONE) & SMALL;
    const item = shown(links, this.view, h);
    if (links.opposite[h | (item >> 31)] === undefined) return this.nextSlowly();
    this.at = h;
    this.item = item;
    return item;
  }

  prev(): number {
    const { links } = this;
    const h = (after(links, links.opposite[this.at] ?? NONE) ?? NONE) & SMALL;
    const item = shown(links, this.view, h);
    if (links.opposite[h | (item >> 31)] === undefined) return this.prevSlowly();
    this.at = h;
    this.item = item;
    return item;
  }

  moveTo(item: number, start?: HalfedgeLike): this {
    if (start === undefined) {
      const { links } = this;
      const h = beginRotatingCcw(links, item);
      const first = shown(links, this.view, h);
      if (links.opposite[h | (first >> 31)] !== undefined) {
        this.at = h;
        this.item = first;
        return this;
      }
    }
    return this.moveSlowly(item, start);
  }
}
interface RotatingCcw extends Going {}

/** Around a vertex, clockwise. */
class RotatingCw {
  constructor(links: DirectedLinks, course: Course, at: number, item: number) {
    this.links = links;
    this.course = course;
    this.view = course.view;
    this.at = at;
    this.item = item;
  }

  get current(): number {
    return this.links.opposite[0] === undefined ? this.currentSlowly : this.item;
  }

  get halfedge(): number {
    return this.links.opposite[0] === undefined ? this.halfedgeSlowly : this.at;
  }

  next(): number {
    const { links } = this;
    const h = (after(links, links.opposite[this.at] ?? NONE) ?? NONE) & SMALL;
    const item = shown(links, this.view, h);
    if (links.opposite[h | (item >> 31)] === undefined) return this.nextSlowly();
    this.at = h;
    this.item = item;
    return item;
  }

  prev(): number {
    const { links } = this;
    const h = (links.opposite[before(links, this.at)] ?? NONE) & SMALL;
    const item = shown(links, this.view, h);
    if (links.opposite[h | (item >> 31)] === undefined) return this.prevSlowly();
    this.at = h;
    this.item = item;
    return item;
  }

  moveTo(item: number, start?: HalfedgeLike): this {
    if (start === undefined) {
      const { links } = this;
      const h = beginRotatingCw(links, item);
      const first = shown(links, this.view, h);
      if (links.opposite[h | (first >> 31)] !== undefined) {
        this.at = h;
        this.item = first;
        return this;
      }
    }
    return this.moveSlowly(item, start);
  }
}
interface RotatingCw extends Going {}

/** Around a face, counter-clockwise. */
class AlongNext {
  constructor(links: DirectedLinks, course: Course, at: number, item: number) {
    this.links = links;
    this.course = course;
    this.view = course.view;
    this.at = at;
    this.item = item;
  }

  get current(): number {
    return this.links.opposite[0] === undefined ? this.currentSlowly : this.item;
  }

  get halfedge(): number {
    return this.links.opposite[0] === undefined ? this.halfedgeSlowly : this.at;
  }

  next(): number {
    const { links } = this;
    const h = (after(links, this.at) ?? NONE) & SMALL;
    const item = shown(links, this.view, h);
    if (links.opposite[h | (item >> 31)] === undefined) return this.nextSlowly();
    this.at = h;
    this.item = item;
    return item;
  }

  prev(): number {
    const { links } = this;
    const h = (before(links, this.at) ?? NONE) & SMALL;
    const item = shown(links, this.view, h);
    if (links.opposite[h | (item >> 31)] === undefined) return this.prevSlowly();
    this.at = h;
    this.item = item;
    return item;
  }

  moveTo(item: number, start?: HalfedgeLike): this {
    if (start === undefined) {
      const { links } = this;
      const h = beginAlongNext(links, item);
      const first = shown(links, this.view, h);
      if (links.opposite[h | (first >> 31)] !== undefined) {
        this.at = h;
        this.item = first;
        return this;
      }
    }
    return this.moveSlowly(item, start);
  }
}
interface AlongNext extends Going {}

/** Around a face, clockwise. */
class AlongPrev {
  constructor(links: DirectedLinks, course: Course, at: number, item: number) {
    this.links = links;
    this.course = course;
    this.view = course.view;
    this.at = at;
    this.item = item;
  }

  get current(): number {
    return this.links.opposite[0] === undefined ? this.currentSlowly : this.item;
  }

  get halfedge(): number {
    return this.links.opposite[0] === undefined ? this.halfedgeSlowly : this.at;
  }

  next(): number {
    const { links } = this;
    const h = (before(links, this.at) ?? NONE) & SMALL;
    const item = shown(links, this.view, h);
    if (links.opposite[h | (item >> 31)] === undefined) return this.nextSlowly();
    this.at = h;
    this.item = item;
    return item;
  }

  prev(): number {
    const { links } = this;
    const h = (after(links, this.at) ?? NONE) & SMALL;
    const item = shown(links, this.view, h);
    if (links.opposite[h | (item >> 31)] === undefined) return this.prevSlowly();
    this.at = h;
    this.item = item;
    return item;
  }

  moveTo(item: number, start?: HalfedgeLike): this {
    if (start === undefined) {
      const { links } = this;
      const h = beginAlongPrev(links, item);
      const first = shown(links, this.view, h);
      if (links.opposite[h | (first >> 31)] !== undefined) {
        this.at = h;
        this.item = first;
        return this;
      }
    }
    return this.moveSlowly(item, start);
  }
}
interface AlongPrev extends Going {}

/** Across an edge, or along a loop, which may be one of boundary halfedges. */
class Elsewhere {
  constructor(links: DirectedLinks, course: Course, at: number, item: number) {
    this.links = links;
    this.course = course;
    this.view = course.view;
    this.at = at;
    this.item = item;
  }

  get current(): number {
    return this.links.opposite[0] === undefined ? this.currentSlowly : this.item;
  }

  get halfedge(): number {
    return this.links.opposite[0] === undefined ? this.halfedgeSlowly : this.at;
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
}
interface Elsewhere extends Going {}

/** What all of them are. */
interface Going {
  links: DirectedLinks;
  course: Course;
  view: number;
  at: number;
  /** What is shown there. */
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
}

/** All classes of circulators. */
export const CLASSES = [RotatingCcw, RotatingCw, AlongNext, AlongPrev, Elsewhere];

/** The class of circulators that go that way. */
function classOf({ centre, walk }: Course): (typeof CLASSES)[number] {
  if (centre === 'vertex') return walk === ROTATE_CCW ? RotatingCcw : RotatingCw;
  if (centre === 'face') return walk === LOOP_CCW ? AlongNext : AlongPrev;
  return Elsewhere;
}

/** What is done in all cases, by getters and methods that all of them share. */
const shared = {
  currentSlowly: {
    get(this: Going): number {
      this.links.revive();
      return this.item;
    },
  },
  halfedgeSlowly: {
    get(this: Going): number {
      this.links.revive();
      return this.at;
    },
  },
  nextSlowly: {
    value(this: Going): number {
      return slowly.arrive(this, slowly.walk(this.links, this.course, this.course.walk, this.at));
    },
  },
  prevSlowly: {
    value(this: Going): number {
      const { walk } = this.course;
      return slowly.arrive(this, slowly.walk(this.links, this.course, reverse(walk), this.at));
    },
  },
  moveSlowly: {
    value(this: Going, item: number, start: HalfedgeLike | undefined): Going {
      slowly.arrive(this, slowly.begin(this.links, this.course, item, start));
      return this;
    },
  },
};
for (const { prototype } of CLASSES) Object.defineProperties(prototype, shared);

/** All that isn't as usual. Methods, because V8 compiles no property access that has never happened. */
const slowly = {
  make(links: DirectedLinks, course: Course, item: number, start?: HalfedgeLike): Going {
    const at = slowly.begin(links, course, item, start);
    return new (classOf(course))(links, course, at, slowly.shown(links, course, at));
  },

  /** Where it begins around `item`; NONE if there is nothing to show. */
  begin(links: DirectedLinks, course: Course, item: number, start?: HalfedgeLike): number {
    const { centre, walk, view } = course;
    const home = homeOf(links, centre, item, walk, start, view);
    if (home === NONE) return NONE;
    const last = beginsAtHome(walk) ? step(links, reverse(walk), home) : home;
    if (last >= 0) return slowly.walk(links, course, walk, last);
    throw corrupt(`The halfedges of ${centre} ${item} form no closed orbit`);
  },

  /** The next halfedge after `begin` that shows something, if there is one. */
  walk(links: DirectedLinks, { view }: Course, walk: number, begin: number): number {
    links.revive();
    if (begin === NONE) return NONE;
    let h = begin;
    for (let left = links.halfedges; left > 0; left--) {
      h = step(links, walk, h);
      const item = shown(links, view, h);
      if (links.opposite[h] === undefined || !(item >= NONE)) break;
      if (item !== NONE) return h;
      if (h === begin) return NONE;
    }
    throw corrupt(`The orbit of halfedge ${begin} does not close`);
  },

  /** What it shows at `h`, or at NONE. */
  shown: (links: DirectedLinks, { view }: Course, h: number): number =>
    h === NONE ? NONE : shown(links, view, h),

  /** Stands on `h`, or on NONE. */
  arrive(circulator: Going, h: number): number {
    circulator.at = h;
    circulator.item = slowly.shown(circulator.links, circulator.course, h);
    return circulator.item;
  },
};

type Way = making.Way;

/** Makes a circulator of the kind of that name. */
type Maker = (links: DirectedLinks, kind: string, item: number, way: Way) => Going;

const {
  vertexVertices: VERTEX_VERTICES,
  vertexOutgoingHalfedges: VERTEX_OUTGOING_HALFEDGES,
  vertexIncomingHalfedges: VERTEX_INCOMING_HALFEDGES,
  vertexEdges: VERTEX_EDGES,
  vertexFaces: VERTEX_FACES,
  faceVertices: FACE_VERTICES,
  faceHalfedges: FACE_HALFEDGES,
  faceEdges: FACE_EDGES,
  faceFaces: FACE_FACES,
} = KINDS;

const makeRotatingCcw = (links: DirectedLinks, course: Course, item: number): Going => {
  const at = beginRotatingCcw(links, item);
  const first = shown(links, course.view, at);
  if (links.opposite[at | (first >> 31)] === undefined) return slowly.make(links, course, item);
  return new RotatingCcw(links, course, at, first);
};

const makeRotatingCw = (links: DirectedLinks, course: Course, item: number): Going => {
  const at = beginRotatingCw(links, item);
  const first = shown(links, course.view, at);
  if (links.opposite[at | (first >> 31)] === undefined) return slowly.make(links, course, item);
  return new RotatingCw(links, course, at, first);
};

const makeAlongNext = (links: DirectedLinks, course: Course, item: number): Going => {
  const at = beginAlongNext(links, item);
  const first = shown(links, course.view, at);
  if (links.opposite[at | (first >> 31)] === undefined) return slowly.make(links, course, item);
  return new AlongNext(links, course, at, first);
};

const makeAlongPrev = (links: DirectedLinks, course: Course, item: number): Going => {
  const at = beginAlongPrev(links, item);
  const first = shown(links, course.view, at);
  if (links.opposite[at | (first >> 31)] === undefined) return slowly.make(links, course, item);
  return new AlongPrev(links, course, at, first);
};

/** By options, of a rare kind, or of none. */
const circulateSlowly: Maker = (links, kind, item, way) => {
  const { course, start } = courseBy(kind, way);
  return slowly.make(links, course, item, start);
};

/** By the length of the name: see ../circulate.ts. */
export const MAKERS: readonly Maker[] = Object.freeze(
  Object.assign(new Array<Maker>(LONGEST + 1).fill(circulateSlowly), {
    9: (links, kind, item, way) => {
      if (kind === 'faceFaces') {
        if (way === 'ccw') return makeAlongNext(links, FACE_FACES.ccw, item);
        if (way === 'cw') return makeAlongPrev(links, FACE_FACES.cw, item);
      }
      if (kind === 'faceEdges') {
        if (way === 'ccw') return makeAlongNext(links, FACE_EDGES.ccw, item);
        if (way === 'cw') return makeAlongPrev(links, FACE_EDGES.cw, item);
      }
      return circulateSlowly(links, kind, item, way);
    },
    11: (links, kind, item, way) => {
      if (kind === 'vertexFaces') {
        if (way === 'ccw') return makeRotatingCcw(links, VERTEX_FACES.ccw, item);
        if (way === 'cw') return makeRotatingCw(links, VERTEX_FACES.cw, item);
      }
      if (kind === 'vertexEdges') {
        if (way === 'ccw') return makeRotatingCcw(links, VERTEX_EDGES.ccw, item);
        if (way === 'cw') return makeRotatingCw(links, VERTEX_EDGES.cw, item);
      }
      return circulateSlowly(links, kind, item, way);
    },
    12: (links, kind, item, way) => {
      if (kind === 'faceVertices') {
        if (way === 'ccw') return makeAlongNext(links, FACE_VERTICES.ccw, item);
        if (way === 'cw') return makeAlongPrev(links, FACE_VERTICES.cw, item);
      }
      return circulateSlowly(links, kind, item, way);
    },
    13: (links, kind, item, way) => {
      if (kind === 'faceHalfedges') {
        if (way === 'ccw') return makeAlongNext(links, FACE_HALFEDGES.ccw, item);
        if (way === 'cw') return makeAlongPrev(links, FACE_HALFEDGES.cw, item);
      }
      return circulateSlowly(links, kind, item, way);
    },
    14: (links, kind, item, way) => {
      if (kind === 'vertexVertices') {
        if (way === 'ccw') return makeRotatingCcw(links, VERTEX_VERTICES.ccw, item);
        if (way === 'cw') return makeRotatingCw(links, VERTEX_VERTICES.cw, item);
      }
      return circulateSlowly(links, kind, item, way);
    },
    23: (links, kind, item, way) => {
      if (kind === 'vertexOutgoingHalfedges') {
        if (way === 'ccw') return makeRotatingCcw(links, VERTEX_OUTGOING_HALFEDGES.ccw, item);
        if (way === 'cw') return makeRotatingCw(links, VERTEX_OUTGOING_HALFEDGES.cw, item);
      }
      if (kind === 'vertexIncomingHalfedges') {
        if (way === 'ccw') return makeRotatingCcw(links, VERTEX_INCOMING_HALFEDGES.ccw, item);
        if (way === 'cw') return makeRotatingCw(links, VERTEX_INCOMING_HALFEDGES.cw, item);
      }
      return circulateSlowly(links, kind, item, way);
    },
  } satisfies Record<number, Maker>),
);
