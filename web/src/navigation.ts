import { refuse } from './checks.js';
import type { HalfedgeError } from './errors.js';
import {
  type Edge,
  type EdgeLike,
  type Face,
  type FaceLike,
  type Halfedge,
  type HalfedgeLike,
  type ItemKind,
  NONE as none,
  type Vertex,
  type VertexLike,
} from './items.js';
import {
  type ConnectivityViews,
  checkIndex,
  corrupt,
  isLive,
  type Links,
  slotCount,
} from './links.js';

// A constant of this module's own: see walks.ts.
const NONE: typeof none = none;

/** The links of a mesh, for the modules of this package. */
export let linksOf: (mesh: Navigation) => Links;

/**
 * Counts, links and queries of a mesh: everything that is read in place, without crossing into WebAssembly.
 * Accessors take an index and cost about as much as reading a typed array.
 *
 * Every accessor throws a RangeError for an index that is out of range or deleted, a TypeError for anything
 * that isn't a number, and a HalfedgeError `disposed` after `dispose()`.
 */
export abstract class Navigation {
  readonly #links: Links;

  // The views of #links once more: one indirection less takes a tenth off each accessor. Not #private:
  // Firefox inlines no accessor that has to look at three of those. Not enumerable either, so that
  // whoever copies or prints the properties of a mesh gets no arrays.
  /** @internal */
  declare nextView: Int32Array;
  /** @internal */
  declare prevView: Int32Array;
  /** @internal */
  declare toVertexView: Int32Array;
  /** @internal */
  declare faceView: Int32Array;
  /** @internal */
  declare vertexHalfedgeView: Int32Array;
  /** @internal */
  declare faceHalfedgeView: Int32Array;

  static {
    linksOf = (mesh) => mesh.#links;
  }

  /** @internal */
  constructor(links: Links) {
    this.#links = links;
    const views = () => ({
      nextView: links.next,
      prevView: links.prev,
      toVertexView: links.toVertex,
      faceView: links.face,
      vertexHalfedgeView: links.vertexHalfedge,
      faceHalfedgeView: links.faceHalfedge,
    });
    for (const [name, value] of Object.entries(views())) {
      Object.defineProperty(this, name, { value, writable: true });
    }
    links.onRefresh = () => Object.assign(this, views());
  }

  /** Live vertices. */
  get vertexCount(): number {
    this.#links.checkAlive();
    return this.#links.vertexCount;
  }
  /** Live halfedges, boundary halfedges included: twice the edges. */
  get halfedgeCount(): number {
    return 2 * this.edgeCount;
  }
  /** Live edges. */
  get edgeCount(): number {
    this.#links.checkAlive();
    return this.#links.edgeCount;
  }
  /** Live faces. */
  get faceCount(): number {
    this.#links.checkAlive();
    return this.#links.faceCount;
  }

  /** Live and deleted vertices: the range of their indices. */
  get vertexSlots(): number {
    this.#links.checkAlive();
    return this.#links.vertexSlots;
  }
  /** Live and deleted halfedges: the range of their indices. */
  get halfedgeSlots(): number {
    this.#links.checkAlive();
    return this.#links.halfedgeSlots;
  }
  /** Live and deleted edges: the range of their indices. */
  get edgeSlots(): number {
    return this.halfedgeSlots / 2;
  }
  /** Live and deleted faces: the range of their indices. */
  get faceSlots(): number {
    this.#links.checkAlive();
    return this.#links.faceSlots;
  }

  /**
   * Changes with every change of connectivity, and with each undo and redo. Moving vertices doesn't change
   * it, but undoing a move does.
   */
  get version(): number {
    this.#links.checkAlive();
    return this.#links.version;
  }

  /**
   * The links themselves, zero-copy. A loop over these arrays is the fastest way to read a mesh.
   *
   * Views that you keep go on showing the mesh through edits, until the number of slots changes, room is made
   * for more of them (by `reserve`, or by an edit that might have needed it), the WebAssembly memory grows
   * (making any mesh can cause that; their length is then 0), or the mesh is disposed of. They are good exactly
   * as long as `mesh.connectivity === kept`. Keeping a view keeps the memory of a mesh alive that is otherwise
   * unreachable; keeping a `subarray` of it doesn't.
   *
   * Writing to them is at your own risk. Queries never crash or hang, whatever is written, and `validate()`
   * tells whether the mesh is still sound. Operations, and modules that draw a mesh (`halfedge/three`,
   * `halfedge/gltf`), rely on a sound mesh. On any other, they may do anything to it and to other meshes, or
   * not return.
   */
  get connectivity(): ConnectivityViews {
    return this.#links.exactViews;
  }

  /**
   * The positions, zero-copy: x, y, z of each vertex slot, 3 * vertexSlots floats. Write to it to move
   * vertices. It becomes stale in the same way as {@link connectivity}, and is good as long as
   * `mesh.positions === kept`.
   */
  get positions(): Float32Array {
    return this.#links.positions;
  }

  // Each accessor reads first and looks whether what it got is the number of an item: see Links. The checks
  // of types before that keep strings from naming properties and fractions out of the arithmetic; V8
  // drops them where it knows that h is an integer.

  /** The halfedge after `h` in its face loop or boundary loop. */
  next(h: HalfedgeLike): Halfedge {
    const r = typeof h === 'number' ? this.nextView[h] : -1;
    return (this.nextView[r] !== undefined ? r : readNext(this, h)) as Halfedge;
  }

  /**
   * The halfedge before `h` in its face loop or boundary loop. Without `storePrev` it is searched for, in
   * O(min(degree, valence)).
   */
  prev(h: HalfedgeLike): Halfedge {
    const r = typeof h === 'number' ? this.prevView[h] : -1;
    return (this.prevView[r] !== undefined ? r : readPrev(this, h)) as Halfedge;
  }

  /** The other halfedge of the same edge: `h ^ 1`. */
  opposite(h: HalfedgeLike): Halfedge {
    const r = typeof h === 'number' ? this.nextView[h] : -1;
    return ((this.nextView[r] !== undefined ? h : checked(this, h)) ^ 1) as Halfedge;
  }

  /** The edge of `h`: `h >> 1`. */
  edge(h: HalfedgeLike): Edge {
    const r = typeof h === 'number' ? this.nextView[h] : -1;
    return ((this.nextView[r] !== undefined ? h : checked(this, h)) >> 1) as Edge;
  }

  /** The face on the left of `h`, or `NONE` for a boundary halfedge. */
  face(h: HalfedgeLike): Face {
    const r = typeof h === 'number' ? this.faceView[h] : -2;
    return (this.faceView[r + 1] !== undefined ? r : readFace(this, h)) as Face;
  }

  /** The vertex that `h` points to. */
  toVertex(h: HalfedgeLike): Vertex {
    const r = typeof h === 'number' ? this.toVertexView[h] : -1;
    return (this.vertexHalfedgeView[r] !== undefined ? r : readToVertex(this, h)) as Vertex;
  }

  /** The vertex that `h` leaves. */
  fromVertex(h: HalfedgeLike): Vertex {
    const r = isInteger(h) ? this.toVertexView[h ^ 1] : -1;
    return (this.vertexHalfedgeView[r] !== undefined ? r : readToVertex(this, h, 1)) as Vertex;
  }

  /** The next halfedge that leaves the same vertex, counter-clockwise: `opposite(prev(h))`. */
  rotateCcw(h: HalfedgeLike): Halfedge {
    const r = typeof h === 'number' ? this.prevView[h] : -1;
    return ((this.prevView[r] !== undefined ? r : readPrev(this, h)) ^ 1) as Halfedge;
  }

  /** The next halfedge that leaves the same vertex, clockwise: `next(opposite(h))`. */
  rotateCw(h: HalfedgeLike): Halfedge {
    const r = isInteger(h) ? this.nextView[h ^ 1] : -1;
    return (this.nextView[r] !== undefined ? r : readNext(this, h, 1)) as Halfedge;
  }

  /** The next halfedge that arrives at the same vertex, clockwise: `opposite(next(h))`. */
  nextOnVertex(h: HalfedgeLike): Halfedge {
    const r = typeof h === 'number' ? this.nextView[h] : -1;
    return ((this.nextView[r] !== undefined ? r : readNext(this, h)) ^ 1) as Halfedge;
  }

  /** The next halfedge that arrives at the same vertex, counter-clockwise: `prev(opposite(h))`. */
  prevOnVertex(h: HalfedgeLike): Halfedge {
    const r = isInteger(h) ? this.prevView[h ^ 1] : -1;
    return (this.prevView[r] !== undefined ? r : readPrev(this, h, 1)) as Halfedge;
  }

  /**
   * One halfedge that leaves `v`, its anchor: a boundary halfedge where `v` is on the boundary.
   * `NONE` for an isolated vertex.
   */
  vertexHalfedge(v: VertexLike): Halfedge {
    const r = typeof v === 'number' ? this.vertexHalfedgeView[v] : -1;
    return (this.nextView[r] !== undefined ? r : readVertexHalfedge(this, v)) as Halfedge;
  }

  /** One halfedge of `f`: the one that leads to the first vertex of the input face. */
  faceHalfedge(f: FaceLike): Halfedge {
    const r = typeof f === 'number' ? this.faceHalfedgeView[f] : -1;
    return (this.nextView[r] !== undefined ? r : readFaceHalfedge(this, f)) as Halfedge;
  }

  /** The halfedge on `side` 0 or 1 of `e`: `2 * e + side`. */
  edgeHalfedge(e: EdgeLike, side: 0 | 1 = 0): Halfedge {
    if (side !== 0 && side !== 1) {
      refuse('side', side, '0 or 1', 'number');
    }
    const r = isInteger(e) ? this.nextView[2 * e] : -1;
    if (this.nextView[r] === undefined) this.#links.checkEdge(e);
    return (2 * e + side) as Halfedge;
  }

  /** The halfedge from `a` to `b`, or `NONE`. O(the smaller valence). */
  findHalfedge(a: VertexLike, b: VertexLike): Halfedge | typeof NONE {
    this.#links.checkVertex(a, 'a');
    this.#links.checkVertex(b, 'b');
    const { next, toVertex, vertexHalfedge } = this.#links;
    const fromA = vertexHalfedge[a];
    const fromB = vertexHalfedge[b];
    if (fromA === NONE || fromB === NONE) return NONE;
    // Around both in step, so that a vertex of high valence costs no more than the other one.
    let atA = fromA;
    let atB = fromB;
    for (let laps = next.length; laps > 0; laps--) {
      if (toVertex[atA] === b) return atA as Halfedge;
      if (toVertex[atB] === a) return (atB ^ 1) as Halfedge;
      atA = next[atA ^ 1];
      atB = next[atB ^ 1];
      if (atA === fromA || atB === fromB) return NONE;
      if (!(atA >= 0 && atB >= 0)) break;
    }
    throw openOrbit('vertex', atA >= 0 ? b : a);
  }

  /** The edge between `a` and `b`, or `NONE`. O(the smaller valence). */
  findEdge(a: VertexLike, b: VertexLike): Edge | typeof NONE {
    const h = this.findHalfedge(a, b);
    return h === NONE ? NONE : ((h >> 1) as Edge);
  }

  /**
   * Whether the vertex `v` exists, since edits may have deleted it. False for anything that has never been a
   * vertex, such as `NONE`. A new vertex may have taken the slot of a deleted one: see `generations`.
   */
  isLiveVertex(v: VertexLike): boolean {
    return isThere(this, 'vertex', v, 'v');
  }

  /** Whether the halfedge `h` exists; like {@link isLiveVertex}. */
  isLiveHalfedge(h: HalfedgeLike): boolean {
    return isThere(this, 'halfedge', h, 'h');
  }

  /** Whether the edge `e` exists; like {@link isLiveVertex}. */
  isLiveEdge(e: EdgeLike): boolean {
    return isThere(this, 'edge', e, 'e');
  }

  /** Whether the face `f` exists; like {@link isLiveVertex}. */
  isLiveFace(f: FaceLike): boolean {
    return isThere(this, 'face', f, 'f');
  }

  /** Whether a boundary halfedge leaves `v`; true for an isolated vertex. O(1). */
  isBoundaryVertex(v: VertexLike): boolean {
    const anchor = this.vertexHalfedge(v);
    return anchor === NONE || sound(this.#links.face[anchor], -1, 'face', anchor) === NONE;
  }

  /** Whether `h` has no face on its left. O(1). */
  isBoundaryHalfedge(h: HalfedgeLike): boolean {
    return this.face(h) === NONE;
  }

  /** Whether one side of `e` has no face. O(1). */
  isBoundaryEdge(e: EdgeLike): boolean {
    const h = this.edgeHalfedge(e);
    return this.face(h) === NONE || this.face(h ^ 1) === NONE;
  }

  /** Whether one of the edges of `f` is a boundary edge. O(degree). */
  isBoundaryFace(f: FaceLike): boolean {
    const first = this.faceHalfedge(f);
    const { next, face } = this.#links;
    let h: number = first;
    for (let laps = next.length; laps > 0; laps--) {
      if (face[h ^ 1] === NONE) return true;
      h = next[h];
      if (h === first) return false;
      if (!(h >= 0)) break;
    }
    throw openOrbit('face', f);
  }

  /** Whether `v` has no edges. O(1). */
  isIsolatedVertex(v: VertexLike): boolean {
    return this.vertexHalfedge(v) === NONE;
  }

  /** Whether the faces at `v` form at most one fan; false of a pinched vertex. O(valence). */
  isManifoldVertex(v: VertexLike): boolean {
    const anchor: number = this.vertexHalfedge(v);
    if (anchor === NONE) return true;
    const { next, face } = this.#links;
    let h = anchor;
    let gaps = 0;
    for (let laps = next.length; laps > 0; laps--) {
      if (face[h] === NONE) gaps += 1;
      h = next[h ^ 1];
      if (h === anchor) return gaps <= 1;
      if (!(h >= 0)) break;
    }
    throw openOrbit('vertex', v);
  }

  /** The number of edges at `v`. O(valence). */
  valence(v: VertexLike): number {
    const anchor: number = this.vertexHalfedge(v);
    if (anchor === NONE) return 0;
    const { next } = this.#links;
    let h = anchor;
    for (let count = 1; count <= next.length; count++) {
      h = next[h ^ 1];
      if (h === anchor) return count;
      if (!(h >= 0)) break;
    }
    throw openOrbit('vertex', v);
  }

  /** The number of corners of `f`. O(degree). */
  degree(f: FaceLike): number {
    const first: number = this.faceHalfedge(f);
    const { next } = this.#links;
    let h = first;
    for (let count = 1; count <= next.length; count++) {
      h = next[h];
      if (h === first) return count;
      if (!(h >= 0)) break;
    }
    throw openOrbit('face', f);
  }
}

// The slow paths: mend the views or throw, and read again, `side` 1 meaning the opposite. Functions, since
// Firefox takes a call of a #private method for so long that it inlines no accessor.

function readNext(mesh: Navigation, h: number, side = 0): number {
  const links = linksOf(mesh);
  links.checkHalfedge(h);
  return sound(links.next[h ^ side], 0, 'next', h ^ side);
}
function readPrev(mesh: Navigation, h: number, side = 0): number {
  const links = linksOf(mesh);
  links.checkHalfedge(h);
  const { storesPrev, prev } = links;
  const before = storesPrev ? prev[h ^ side] : links.findPrev(h ^ side);
  return sound(before, 0, 'prev', h ^ side);
}
function readToVertex(mesh: Navigation, h: number, side = 0): number {
  const links = linksOf(mesh);
  links.checkHalfedge(h);
  return sound(links.toVertex[h ^ side], 0, 'toVertex', h ^ side);
}
function readFace(mesh: Navigation, h: number): number {
  const links = linksOf(mesh);
  links.checkHalfedge(h);
  return sound(links.face[h], NONE, 'face', h);
}
function readVertexHalfedge(mesh: Navigation, v: number): number {
  const links = linksOf(mesh);
  links.checkVertex(v);
  return sound(links.vertexHalfedge[v], NONE, 'vertexHalfedge', v);
}
function readFaceHalfedge(mesh: Navigation, f: number): number {
  const links = linksOf(mesh);
  links.checkFace(f);
  return sound(links.faceHalfedge[f], 0, 'faceHalfedge', f);
}
/** `h` itself, if it is a live halfedge. */
function checked(mesh: Navigation, h: number): number {
  linksOf(mesh).checkHalfedge(h);
  return h;
}

/** Whether an item is alive. Throws a sentence for what is no number. */
function isThere(mesh: Navigation, kind: ItemKind, index: number, argument: string): boolean {
  const links = linksOf(mesh);
  links.checkAlive();
  if (typeof index !== 'number') checkIndex(kind, slotCount(links, kind), index, argument);
  return isLive(links, kind, index);
}

/** Whether `index` is a 32-bit integer. */
function isInteger(index: number): boolean {
  return typeof index === 'number' && (index | 0) === index;
}

/** `value`, if a link of a live item can have it. */
function sound(value: number, least: number, link: string, of: number): number {
  if (value >= least) return value;
  throw corrupt(`${link}[${of}] is ${value}`);
}

function openOrbit(kind: 'vertex' | 'face', index: number): HalfedgeError {
  return corrupt(`The halfedges of ${kind} ${index} form no closed orbit`);
}
