import { refuse } from './checks.js';
import * as circulator from './circulator.js';
import { type Direction, type HalfedgeLike, NONE as none } from './items.js';
import type { Links } from './links.js';
import { checkOptions } from './options.js';
import * as walks from './walks.js';

// Constants of this module's own: see walks.ts.
const NONE: typeof none = none;
const { CIRCULATE_OPTIONS, anchorsOf, kindOf, slowly } = circulator;
const { ACROSS, EDGE, FACE, ITSELF, OPPOSITE, OPPOSITE_FACE, TO_VERTEX, beginsAtHome } = walks;
const { SMALL } = walks.BITS;
type CirculateOptions = circulator.CirculateOptions;
type Course = circulator.Course;
type Kind = circulator.Kind;
type Place = circulator.Place;

// All circulators, in seven classes: for what is shown (vertices, faces, halfedges and edges), along prev
// and along next, and across edges. The loops of other people in which they run are fast if V8 inlines all
// of a circulator, and keeps it in registers. So:
//
// - V8 inlines 920 bytecodes into a loop, and counts those that it has inlined into a function before. So
//   each class has a text of its own, which decides nothing, and whatever isn't as usual is a call.
// - They extend nothing: to call the constructor of a base class takes twice the bytecodes.
// - What is wrong is found by looking up what isn't there, as laps do: see laps.ts. Where the era is over,
//   `at | era.first` is -1. The views of the links are always those of now, but `anchors` only those of the
//   era: growth of the mesh can move them.
// - What is shown is shown as it stands there, also where a program has written into the live views.
// - What goes around vertices turns to the opposite, what goes around faces doesn't: `turn` is 1 or 0.

/** Shows the vertices that its halfedges lead to, along prev. */
class VerticesAlongPrev {
  constructor(links: Links, course: Course, anchors: Int32Array, item: number) {
    this.links = links;
    this.course = course;
    this.anchors = anchors;
    this.turn = course.turn;
    this.era = links.era;
    this.at = NONE;
    this.moveTo(item);
  }

  get current(): number {
    return this.links.toVertex[this.at | this.era.first] ?? this.currentSlowly();
  }

  get halfedge(): number {
    return this.links.toVertex[this.era.first] === undefined ? this.halfedgeSlowly() : this.at;
  }

  next(): number {
    const { links, turn } = this;
    const h = ((links.prev[this.at | this.era.first] ?? NONE) ^ turn) & SMALL;
    const item = links.toVertex[h];
    if (item === undefined) return this.nextSlowly();
    this.at = h;
    return item;
  }

  prev(): number {
    const { links, turn } = this;
    const h = (links.next[(this.at | this.era.first) ^ turn] ?? NONE) & SMALL;
    const item = links.toVertex[h];
    if (item === undefined) return this.prevSlowly();
    this.at = h;
    return item;
  }

  moveTo(item: number, start?: HalfedgeLike): this {
    if (typeof item === 'number' && start === undefined) {
      const { links, turn } = this;
      const anchor = (this.anchors[item] ?? NONE) | this.era.first;
      const h = ((links.prev[anchor] ?? NONE) ^ turn) & SMALL;
      if (links.toVertex[h] !== undefined) {
        this.at = h;
        return this;
      }
    }
    return this.moveSlowly(item, start);
  }
}
interface VerticesAlongPrev extends Going {}

/** Shows the vertices that its halfedges lead to, along next. */
class VerticesAlongNext {
  constructor(links: Links, course: Course, anchors: Int32Array, item: number) {
    this.links = links;
    this.course = course;
    this.anchors = anchors;
    this.turn = course.turn;
    this.era = links.era;
    this.at = NONE;
    this.moveTo(item);
  }

  get current(): number {
    return this.links.toVertex[this.at | this.era.first] ?? this.currentSlowly();
  }

  get halfedge(): number {
    return this.links.toVertex[this.era.first] === undefined ? this.halfedgeSlowly() : this.at;
  }

  next(): number {
    const { links, turn } = this;
    const h = (links.next[(this.at | this.era.first) ^ turn] ?? NONE) & SMALL;
    const item = links.toVertex[h];
    if (item === undefined) return this.nextSlowly();
    this.at = h;
    return item;
  }

  prev(): number {
    const { links, turn } = this;
    const h = ((links.prev[this.at | this.era.first] ?? NONE) ^ turn) & SMALL;
    const item = links.toVertex[h];
    if (item === undefined) return this.prevSlowly();
    this.at = h;
    return item;
  }

  moveTo(item: number, start?: HalfedgeLike): this {
    if (typeof item === 'number' && start === undefined) {
      const { links } = this;
      const h = ((this.anchors[item] ?? NONE) | this.era.first) & SMALL;
      if (links.toVertex[h] !== undefined) {
        this.at = h;
        return this;
      }
    }
    return this.moveSlowly(item, start);
  }
}
interface VerticesAlongNext extends Going {}

/** Shows faces, of its halfedges or their opposites, along prev. */
class FacesAlongPrev {
  constructor(links: Links, course: Course, anchors: Int32Array, item: number) {
    this.links = links;
    this.course = course;
    this.anchors = anchors;
    this.turn = course.turn;
    this.side = course.side;
    this.era = links.era;
    this.at = NONE;
    this.moveTo(item);
  }

  get current(): number {
    return this.links.face[(this.at | this.era.first) ^ this.side] ?? this.currentSlowly();
  }

  get halfedge(): number {
    return this.links.face[this.era.first] === undefined ? this.halfedgeSlowly() : this.at;
  }

  next(): number {
    const { links, turn } = this;
    const { face } = links;
    const h = ((links.prev[this.at | this.era.first] ?? NONE) ^ turn) & SMALL;
    const item = face[h ^ this.side] ?? NONE;
    if (face[item >> 31] === undefined) return this.nextSlowly();
    this.at = h;
    return item;
  }

  prev(): number {
    const { links, turn } = this;
    const { face } = links;
    const h = (links.next[(this.at | this.era.first) ^ turn] ?? NONE) & SMALL;
    const item = face[h ^ this.side] ?? NONE;
    if (face[item >> 31] === undefined) return this.prevSlowly();
    this.at = h;
    return item;
  }

  moveTo(item: number, start?: HalfedgeLike): this {
    if (typeof item === 'number' && start === undefined) {
      const { links, turn } = this;
      const anchor = (this.anchors[item] ?? NONE) | this.era.first;
      const h = ((links.prev[anchor] ?? NONE) ^ turn) & SMALL;
      if (links.face[h ^ this.side] >= 0) {
        this.at = h;
        return this;
      }
    }
    return this.moveSlowly(item, start);
  }
}
interface FacesAlongPrev extends Going {}

/** Shows faces, of its halfedges or their opposites, along next. */
class FacesAlongNext {
  constructor(links: Links, course: Course, anchors: Int32Array, item: number) {
    this.links = links;
    this.course = course;
    this.anchors = anchors;
    this.turn = course.turn;
    this.side = course.side;
    this.era = links.era;
    this.at = NONE;
    this.moveTo(item);
  }

  get current(): number {
    return this.links.face[(this.at | this.era.first) ^ this.side] ?? this.currentSlowly();
  }

  get halfedge(): number {
    return this.links.face[this.era.first] === undefined ? this.halfedgeSlowly() : this.at;
  }

  next(): number {
    const { links, turn } = this;
    const { face } = links;
    const h = (links.next[(this.at | this.era.first) ^ turn] ?? NONE) & SMALL;
    const item = face[h ^ this.side] ?? NONE;
    if (face[item >> 31] === undefined) return this.nextSlowly();
    this.at = h;
    return item;
  }

  prev(): number {
    const { links, turn } = this;
    const { face } = links;
    const h = ((links.prev[this.at | this.era.first] ?? NONE) ^ turn) & SMALL;
    const item = face[h ^ this.side] ?? NONE;
    if (face[item >> 31] === undefined) return this.prevSlowly();
    this.at = h;
    return item;
  }

  moveTo(item: number, start?: HalfedgeLike): this {
    if (typeof item === 'number' && start === undefined) {
      const { links } = this;
      const h = ((this.anchors[item] ?? NONE) | this.era.first) & SMALL;
      if (links.face[h ^ this.side] >= 0) {
        this.at = h;
        return this;
      }
    }
    return this.moveSlowly(item, start);
  }
}
interface FacesAlongNext extends Going {}

/** Shows halfedges or edges, which takes no look-up, along prev. */
class IndicesAlongPrev {
  constructor(links: Links, course: Course, anchors: Int32Array, item: number) {
    this.links = links;
    this.course = course;
    this.anchors = anchors;
    this.turn = course.turn;
    this.side = course.side;
    this.shift = course.shift;
    this.era = links.era;
    this.at = NONE;
    this.moveTo(item);
  }

  get current(): number {
    const at = this.at | this.era.first;
    return this.links.toVertex[at] === undefined
      ? this.currentSlowly()
      : (at ^ this.side) >> this.shift;
  }

  get halfedge(): number {
    return this.links.toVertex[this.era.first] === undefined ? this.halfedgeSlowly() : this.at;
  }

  next(): number {
    const { links, turn } = this;
    const h = ((links.prev[this.at | this.era.first] ?? NONE) ^ turn) & SMALL;
    if (links.toVertex[h] === undefined) return this.nextSlowly();
    this.at = h;
    return (h ^ this.side) >> this.shift;
  }

  prev(): number {
    const { links, turn } = this;
    const h = (links.next[(this.at | this.era.first) ^ turn] ?? NONE) & SMALL;
    if (links.toVertex[h] === undefined) return this.prevSlowly();
    this.at = h;
    return (h ^ this.side) >> this.shift;
  }

  moveTo(item: number, start?: HalfedgeLike): this {
    if (typeof item === 'number' && start === undefined) {
      const { links, turn } = this;
      const anchor = (this.anchors[item] ?? NONE) | this.era.first;
      const h = ((links.prev[anchor] ?? NONE) ^ turn) & SMALL;
      if (links.toVertex[h] !== undefined) {
        this.at = h;
        return this;
      }
    }
    return this.moveSlowly(item, start);
  }
}
interface IndicesAlongPrev extends Going {}

/** Shows halfedges or edges, which takes no look-up, along next. */
class IndicesAlongNext {
  constructor(links: Links, course: Course, anchors: Int32Array, item: number) {
    this.links = links;
    this.course = course;
    this.anchors = anchors;
    this.turn = course.turn;
    this.side = course.side;
    this.shift = course.shift;
    this.era = links.era;
    this.at = NONE;
    this.moveTo(item);
  }

  get current(): number {
    const at = this.at | this.era.first;
    return this.links.toVertex[at] === undefined
      ? this.currentSlowly()
      : (at ^ this.side) >> this.shift;
  }

  get halfedge(): number {
    return this.links.toVertex[this.era.first] === undefined ? this.halfedgeSlowly() : this.at;
  }

  next(): number {
    const { links, turn } = this;
    const h = (links.next[(this.at | this.era.first) ^ turn] ?? NONE) & SMALL;
    if (links.toVertex[h] === undefined) return this.nextSlowly();
    this.at = h;
    return (h ^ this.side) >> this.shift;
  }

  prev(): number {
    const { links, turn } = this;
    const h = ((links.prev[this.at | this.era.first] ?? NONE) ^ turn) & SMALL;
    if (links.toVertex[h] === undefined) return this.prevSlowly();
    this.at = h;
    return (h ^ this.side) >> this.shift;
  }

  moveTo(item: number, start?: HalfedgeLike): this {
    if (typeof item === 'number' && start === undefined) {
      const { links } = this;
      const h = ((this.anchors[item] ?? NONE) | this.era.first) & SMALL;
      if (links.toVertex[h] !== undefined) {
        this.at = h;
        return this;
      }
    }
    return this.moveSlowly(item, start);
  }
}
interface IndicesAlongNext extends Going {}

/** Goes across an edge, from one of its halfedges to the other. */
class Across {
  constructor(links: Links, course: Course, anchors: Int32Array, item: number) {
    this.links = links;
    this.course = course;
    this.anchors = anchors;
    this.era = links.era;
    this.at = NONE;
    this.moveTo(item);
  }

  get current(): number {
    return this.currentSlowly();
  }

  get halfedge(): number {
    return this.halfedgeSlowly();
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
interface Across extends Going {}

/** The methods that all of them share. */
const shared = {
  currentSlowly(this: Place): number {
    return slowly.current(this);
  },
  halfedgeSlowly(this: Place): number {
    return slowly.halfedge(this);
  },
  nextSlowly(this: Place): number {
    return slowly.next(this);
  },
  prevSlowly(this: Place): number {
    return slowly.prev(this);
  },
  moveSlowly<It extends Place>(this: It, item: number, start: HalfedgeLike | undefined): It {
    slowly.moveTo(this, item, start);
    return this;
  },
};

/** What all of them have. */
interface Going extends Place {
  turn: number;
  side: number;
  shift: number;
  currentSlowly(): number;
  halfedgeSlowly(): number;
  nextSlowly(): number;
  prevSlowly(): number;
  moveSlowly(item: number, start: HalfedgeLike | undefined): this;
}

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
for (const { prototype } of CLASSES) {
  for (const [name, value] of Object.entries(shared)) {
    Object.defineProperty(prototype, name, { value });
  }
}

/** How `circulate` makes one: by a direction alone, or by options. */
type Way = Direction | CirculateOptions;

const VERTEX_VERTICES = kindOf('vertex', TO_VERTEX);
const VERTEX_OUTGOING_HALFEDGES = kindOf('vertex', ITSELF);
const VERTEX_INCOMING_HALFEDGES = kindOf('vertex', OPPOSITE);
const VERTEX_EDGES = kindOf('vertex', EDGE);
const VERTEX_FACES = kindOf('vertex', FACE);
const FACE_VERTICES = kindOf('face', TO_VERTEX);
const FACE_HALFEDGES = kindOf('face', ITSELF);
const FACE_EDGES = kindOf('face', EDGE);
const FACE_FACES = kindOf('face', OPPOSITE_FACE);

/** All kinds, by their names. */
export const KINDS = {
  vertexVertices: VERTEX_VERTICES,
  vertexOutgoingHalfedges: VERTEX_OUTGOING_HALFEDGES,
  vertexIncomingHalfedges: VERTEX_INCOMING_HALFEDGES,
  vertexEdges: VERTEX_EDGES,
  vertexFaces: VERTEX_FACES,
  faceVertices: FACE_VERTICES,
  faceHalfedges: FACE_HALFEDGES,
  faceEdges: FACE_EDGES,
  faceFaces: FACE_FACES,
  edgeVertices: kindOf('edge', TO_VERTEX),
  edgeHalfedges: kindOf('edge', ITSELF),
  edgeFaces: kindOf('edge', FACE),
  halfedgeLoop: kindOf('loop', ITSELF),
};
Object.setPrototypeOf(KINDS, null); // `constructor` is no kind

/**
 * What makes the circulators of a mesh, a method for each kind. If one method made all, V8 would inline into
 * each loop whatever the program needs of it anywhere.
 */
export class Circulators {
  readonly links: Links;

  constructor(links: Links) {
    this.links = links;
  }

  vertexVertices(item: number, way: Way) {
    const { links } = this;
    const anchors = links.vertexHalfedge;
    if (way === 'ccw') return new VerticesAlongPrev(links, VERTEX_VERTICES.ccw, anchors, item);
    if (way === 'cw') return new VerticesAlongNext(links, VERTEX_VERTICES.cw, anchors, item);
    return circulateBy(links, VERTEX_VERTICES, item, way);
  }

  vertexOutgoingHalfedges(item: number, way: Way) {
    const { links } = this;
    const anchors = links.vertexHalfedge;
    if (way === 'ccw')
      return new IndicesAlongPrev(links, VERTEX_OUTGOING_HALFEDGES.ccw, anchors, item);
    if (way === 'cw')
      return new IndicesAlongNext(links, VERTEX_OUTGOING_HALFEDGES.cw, anchors, item);
    return circulateBy(links, VERTEX_OUTGOING_HALFEDGES, item, way);
  }

  vertexIncomingHalfedges(item: number, way: Way) {
    const { links } = this;
    const anchors = links.vertexHalfedge;
    if (way === 'ccw')
      return new IndicesAlongPrev(links, VERTEX_INCOMING_HALFEDGES.ccw, anchors, item);
    if (way === 'cw')
      return new IndicesAlongNext(links, VERTEX_INCOMING_HALFEDGES.cw, anchors, item);
    return circulateBy(links, VERTEX_INCOMING_HALFEDGES, item, way);
  }

  vertexEdges(item: number, way: Way) {
    const { links } = this;
    const anchors = links.vertexHalfedge;
    if (way === 'ccw') return new IndicesAlongPrev(links, VERTEX_EDGES.ccw, anchors, item);
    if (way === 'cw') return new IndicesAlongNext(links, VERTEX_EDGES.cw, anchors, item);
    return circulateBy(links, VERTEX_EDGES, item, way);
  }

  vertexFaces(item: number, way: Way) {
    const { links } = this;
    const anchors = links.vertexHalfedge;
    if (way === 'ccw') return new FacesAlongPrev(links, VERTEX_FACES.ccw, anchors, item);
    if (way === 'cw') return new FacesAlongNext(links, VERTEX_FACES.cw, anchors, item);
    return circulateBy(links, VERTEX_FACES, item, way);
  }

  faceVertices(item: number, way: Way) {
    const { links } = this;
    const anchors = links.faceHalfedge;
    if (way === 'ccw') return new VerticesAlongNext(links, FACE_VERTICES.ccw, anchors, item);
    if (way === 'cw') return new VerticesAlongPrev(links, FACE_VERTICES.cw, anchors, item);
    return circulateBy(links, FACE_VERTICES, item, way);
  }

  faceHalfedges(item: number, way: Way) {
    const { links } = this;
    const anchors = links.faceHalfedge;
    if (way === 'ccw') return new IndicesAlongNext(links, FACE_HALFEDGES.ccw, anchors, item);
    if (way === 'cw') return new IndicesAlongPrev(links, FACE_HALFEDGES.cw, anchors, item);
    return circulateBy(links, FACE_HALFEDGES, item, way);
  }

  faceEdges(item: number, way: Way) {
    const { links } = this;
    const anchors = links.faceHalfedge;
    if (way === 'ccw') return new IndicesAlongNext(links, FACE_EDGES.ccw, anchors, item);
    if (way === 'cw') return new IndicesAlongPrev(links, FACE_EDGES.cw, anchors, item);
    return circulateBy(links, FACE_EDGES, item, way);
  }
  faceFaces(item: number, way: Way) {
    const { links } = this;
    const anchors = links.faceHalfedge;
    if (way === 'ccw') return new FacesAlongNext(links, FACE_FACES.ccw, anchors, item);
    if (way === 'cw') return new FacesAlongPrev(links, FACE_FACES.cw, anchors, item);
    return circulateBy(links, FACE_FACES, item, way);
  }
}

/** A circulator of any kind, by options or with a direction that is none. */
export function circulateBy(links: Links, kind: Kind, item: number, way: Way) {
  const { direction = 'ccw', start } =
    typeof way === 'string' ? { direction: way } : checkOptions(way, CIRCULATE_OPTIONS);
  if (direction !== 'ccw' && direction !== 'cw') {
    return refuse('direction', direction, "'ccw' or 'cw'", 'string');
  }
  const course = kind[direction];
  const { centre, walk, view } = course;
  const [prevClass, nextClass] =
    view === TO_VERTEX
      ? [VerticesAlongPrev, VerticesAlongNext]
      : view < TO_VERTEX
        ? [IndicesAlongPrev, IndicesAlongNext]
        : [FacesAlongPrev, FacesAlongNext];
  const Class = walk === ACROSS ? Across : beginsAtHome(walk) ? nextClass : prevClass;
  const made = new Class(links, course, anchorsOf(links, centre), item);
  return start === undefined ? made : made.moveTo(item, start);
}
