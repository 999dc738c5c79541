import { refuse } from '../checks.js';
import {
  type Edge,
  type EdgeLike,
  type Face,
  type FaceLike,
  type Halfedge,
  type HalfedgeLike,
  NONE as none,
  type Vertex,
  type VertexLike,
} from '../items.js';
import { corrupt } from '../links.js';
import type { DirectedLinks } from './links.js';
import { after, before } from './walks.js';

// A constant of this module's own: see walks.ts.
const NONE: typeof none = none;

/** Live zero-copy views of Directed Edges. Empty links are -1. */
export interface DirectedEdgesViews {
  /** By halfedge: the other halfedge of the same edge. */
  readonly opposite: Int32Array;
  /** By halfedge: the vertex it points to. The first `3 * faceCount` are the index buffer. */
  readonly toVertex: Int32Array;
  /** By vertex: one halfedge that leaves it, the anchor; -1 for an isolated vertex. */
  readonly vertexHalfedge: Int32Array;
  /** By boundary halfedge `h`, at `h - 3 * faceCount`: the one after it in its boundary loop. */
  readonly boundaryNext: Int32Array;
  /** By boundary halfedge, in the same way: the one before it. */
  readonly boundaryPrev: Int32Array;
}

/** The links of a mesh, for the modules of this package. */
export let directedLinksOf: (mesh: DirectedEdgesNavigation) => DirectedLinks;

/**
 * Counts, links and queries of Directed Edges, under the names that they have in `HalfedgeMesh`, and
 * with the same errors: a RangeError for an index that is out of range, a TypeError for something
 * that is no number, and a HalfedgeError `disposed` after `dispose()`.
 */
export abstract class DirectedEdgesNavigation {
  readonly #links: DirectedLinks;
  #views: DirectedEdgesViews | undefined;

  // Of #links once more: one indirection less, as in navigation.ts.
  #sides: number;
  #opposite: Int32Array;
  #toVertex: Int32Array;
  #vertexHalfedge: Int32Array;

  static {
    directedLinksOf = (mesh) => mesh.#links;
  }

  /** @internal */
  constructor(links: DirectedLinks) {
    this.#links = links;
    this.#sides = links.sides;
    this.#opposite = links.opposite;
    this.#toVertex = links.toVertex;
    this.#vertexHalfedge = links.vertexHalfedge;
    links.onRefresh = () => {
      this.#sides = links.sides;
      this.#opposite = links.opposite;
      this.#toVertex = links.toVertex;
      this.#vertexHalfedge = links.vertexHalfedge;
    };
  }

  /** The vertices. */
  get vertexCount(): number {
    this.#links.checkAlive();
    return this.#links.vertices;
  }
  /** The halfedges, boundary halfedges included: twice the edges. */
  get halfedgeCount(): number {
    this.#links.checkAlive();
    return this.#links.halfedges;
  }
  /** The edges. */
  get edgeCount(): number {
    return this.halfedgeCount / 2;
  }
  /** The faces. */
  get faceCount(): number {
    this.#links.checkAlive();
    return this.#links.sides / 3;
  }

  /** The range of the indices of vertices. */
  get vertexSlots(): number {
    return this.vertexCount;
  }
  /** The range of the indices of halfedges. */
  get halfedgeSlots(): number {
    return this.halfedgeCount;
  }
  /** The range of the indices of edges, which has gaps where a halfedge is not the smaller one. */
  get edgeSlots(): number {
    return 3 * this.faceCount;
  }
  /** The range of the indices of faces. */
  get faceSlots(): number {
    return this.faceCount;
  }

  /** The connectivity of Directed Edges never changes: 0. */
  get version(): number {
    this.#links.checkAlive();
    return 0;
  }

  /**
   * The links themselves, zero-copy. They become stale when the WebAssembly memory grows (making any
   * mesh can do that; their length is 0 then), and when the mesh is disposed of: they are good
   * exactly as long as `mesh.connectivity === kept`. Writing to them is at your own risk, but can't
   * crash anything: `validate()` tells whether the mesh is still sound.
   */
  get connectivity(): DirectedEdgesViews {
    const links = this.#links;
    links.revive();
    if (
      this.#views?.opposite !== links.opposite ||
      this.#views.vertexHalfedge !== links.vertexHalfedge
    ) {
      const { opposite, toVertex, vertexHalfedge, boundaryNext, boundaryPrev } = links;
      this.#views = Object.freeze({
        opposite,
        toVertex,
        vertexHalfedge,
        boundaryNext,
        boundaryPrev,
      });
    }
    return this.#views as DirectedEdgesViews;
  }

  /**
   * The index buffer of the faces, zero-copy: the corners of face f are at 3 f, 3 f + 1, 3 f + 2, as in
   * the input. It can be drawn as it is. A new view at each call; stale as {@link connectivity} is.
   */
  get indices(): Uint32Array {
    this.#links.revive();
    return this.#links.indices();
  }

  /** The positions, zero-copy: x, y, z of each vertex. Write to it to move vertices. */
  get positions(): Float32Array {
    const { positions } = this.#links;
    if (positions.length !== 0) return positions;
    this.#links.revive();
    return this.#links.positions;
  }

  /** A copy of the position of `v`: x, y, z. */
  position(v: VertexLike): [x: number, y: number, z: number] {
    this.#links.checkVertex(v);
    const { positions } = this.#links;
    return [positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]];
  }

  // Each accessor does what it does most often first, and checks its argument where that fails.

  /** The halfedge after `h` in its face loop or boundary loop: arithmetic within a face. */
  next(h: HalfedgeLike): Halfedge {
    if (isInteger(h) && h >= 0 && h < this.#sides) {
      return (h % 3 === 2 ? h - 2 : h + 1) as Halfedge;
    }
    return this.#onBoundary(h, 'boundaryNext') as Halfedge;
  }

  /** The halfedge before `h` in its face loop or boundary loop: arithmetic within a face. */
  prev(h: HalfedgeLike): Halfedge {
    if (isInteger(h) && h >= 0 && h < this.#sides) {
      return (h % 3 === 0 ? h + 2 : h - 1) as Halfedge;
    }
    return this.#onBoundary(h, 'boundaryPrev') as Halfedge;
  }

  /** The other halfedge of the same edge. */
  opposite(h: HalfedgeLike): Halfedge {
    const r = typeof h === 'number' ? this.#opposite[h] : -1;
    return (r >= 0 ? r : this.#read(h, 'opposite')) as Halfedge;
  }

  /** The edge of `h`: the smaller of its two halfedges. */
  edge(h: HalfedgeLike): Edge {
    const opposite: number = this.opposite(h);
    return (opposite < h ? opposite : h) as Edge;
  }

  /** The face on the left of `h`, or `NONE` for a boundary halfedge: arithmetic. */
  face(h: HalfedgeLike): Face {
    if (isInteger(h) && h >= 0 && h < this.#sides) return ((h / 3) | 0) as Face;
    this.#links.checkHalfedge(h);
    return NONE as unknown as Face;
  }

  /** The vertex that `h` points to. */
  toVertex(h: HalfedgeLike): Vertex {
    const r = typeof h === 'number' ? this.#toVertex[h] : -1;
    return (r >= 0 ? r : this.#read(h, 'toVertex')) as Vertex;
  }

  /** The vertex that `h` leaves. */
  fromVertex(h: HalfedgeLike): Vertex {
    return this.toVertex(this.prev(h));
  }

  /** The next halfedge that leaves the same vertex, counter-clockwise: `opposite(prev(h))`. */
  rotateCcw(h: HalfedgeLike): Halfedge {
    return this.opposite(this.prev(h));
  }

  /** The next halfedge that leaves the same vertex, clockwise: `next(opposite(h))`. */
  rotateCw(h: HalfedgeLike): Halfedge {
    return this.next(this.opposite(h));
  }

  /** The next halfedge that arrives at the same vertex, clockwise: `opposite(next(h))`. */
  nextOnVertex(h: HalfedgeLike): Halfedge {
    return this.opposite(this.next(h));
  }

  /** The next halfedge that arrives at the same vertex, counter-clockwise: `prev(opposite(h))`. */
  prevOnVertex(h: HalfedgeLike): Halfedge {
    return this.prev(this.opposite(h));
  }

  /** One halfedge that leaves `v`, its anchor: a boundary halfedge on the boundary; or `NONE`. */
  vertexHalfedge(v: VertexLike): Halfedge {
    const r = typeof v === 'number' ? this.#vertexHalfedge[v] : -2;
    if (r >= NONE) return r as Halfedge;
    this.#links.checkVertex(v);
    return sound(this.#links.vertexHalfedge[v], NONE, 'vertexHalfedge', v) as Halfedge;
  }

  /** The halfedge of `f` that leads to the first vertex of the input face: `3 * f`. */
  faceHalfedge(f: FaceLike): Halfedge {
    if (!(isInteger(f) && f >= 0 && 3 * f < this.#sides)) this.#links.checkFace(f);
    return (3 * f) as Halfedge;
  }

  /** The halfedge on `side` 0 or 1 of `e`; side 0 has the index of the edge, and a face. */
  edgeHalfedge(e: EdgeLike, side: 0 | 1 = 0): Halfedge {
    if (side !== 0 && side !== 1) refuse('side', side, '0 or 1', 'number');
    this.#links.checkEdge(e);
    return (side === 0 ? e : this.opposite(e as number)) as Halfedge;
  }

  /** The halfedge from `a` to `b`, or `NONE`. O(valence of a). */
  findHalfedge(a: VertexLike, b: VertexLike): Halfedge | typeof NONE {
    this.#links.checkVertex(a, 'a');
    this.#links.checkVertex(b, 'b');
    const { toVertex } = this.#links;
    let found: number = NONE;
    this.#rotate(a, (h) => {
      if (toVertex[h] === b) found = h;
      return found === NONE;
    });
    return found as Halfedge;
  }

  /** The edge between `a` and `b`, or `NONE`. O(valence of a). */
  findEdge(a: VertexLike, b: VertexLike): Edge | typeof NONE {
    const h = this.findHalfedge(a, b);
    return h === NONE ? NONE : this.edge(h);
  }

  /** Whether a boundary halfedge leaves `v`; true of an isolated vertex. O(1). */
  isBoundaryVertex(v: VertexLike): boolean {
    const anchor: number = this.vertexHalfedge(v);
    return anchor < 0 || anchor >= this.#sides;
  }

  /** Whether `h` has no face on its left. O(1). */
  isBoundaryHalfedge(h: HalfedgeLike): boolean {
    return this.face(h) === NONE;
  }

  /** Whether one side of `e` has no face. O(1). */
  isBoundaryEdge(e: EdgeLike): boolean {
    return this.edgeHalfedge(e, 1) >= this.#sides;
  }

  /** Whether one of the edges of `f` is a boundary edge. O(1). */
  isBoundaryFace(f: FaceLike): boolean {
    const h: number = this.faceHalfedge(f);
    const sides = this.#sides;
    return (
      this.opposite(h) >= sides || this.opposite(h + 1) >= sides || this.opposite(h + 2) >= sides
    );
  }

  /** Whether no edge meets `v`. O(1). */
  isIsolatedVertex(v: VertexLike): boolean {
    return this.vertexHalfedge(v) === NONE;
  }

  /** Whether the faces at `v` form at most one fan; false of a pinched vertex. O(valence). */
  isManifoldVertex(v: VertexLike): boolean {
    this.#links.checkVertex(v);
    const { sides } = this.#links;
    let gaps = 0;
    this.#rotate(v, (h) => {
      if (h >= sides) gaps += 1;
      return true;
    });
    return gaps <= 1;
  }

  /** The number of edges at `v`. O(valence). */
  valence(v: VertexLike): number {
    this.#links.checkVertex(v);
    let count = 0;
    this.#rotate(v, () => {
      count += 1;
      return true;
    });
    return count;
  }

  /** The number of corners of `f`: three. */
  degree(f: FaceLike): number {
    this.#links.checkFace(f);
    return 3;
  }

  /** Calls `visit` with the halfedges that leave `v`, clockwise, until it returns false. */
  #rotate(v: number, visit: (h: number) => boolean): void {
    const links = this.#links;
    const anchor = links.vertexHalfedge[v];
    if (anchor === NONE) return;
    let h = anchor;
    for (let left = links.halfedges; left > 0; left--) {
      if (!visit(h)) return;
      h = after(links, links.opposite[h]);
      if (h === anchor) return;
      if (!(h >= 0)) break;
    }
    throw corrupt(`The halfedges of vertex ${v} form no closed orbit`);
  }

  // The slow paths: mend the views or throw, and read again.

  #onBoundary(h: number, link: 'boundaryNext' | 'boundaryPrev'): number {
    const links = this.#links;
    links.checkHalfedge(h);
    const r = link === 'boundaryNext' ? after(links, h) : before(links, h);
    return sound(r, 0, link, h - links.sides);
  }

  #read(h: number, link: 'opposite' | 'toVertex'): number {
    this.#links.checkHalfedge(h);
    return sound(this.#links[link][h], 0, link, h);
  }
}

/** Whether `index` is a 32-bit integer. */
function isInteger(index: number): boolean {
  return typeof index === 'number' && (index | 0) === index;
}

/** `value`, if a link can have it. */
function sound(value: number, least: number, link: string, of: number): number {
  if (value >= least) return value;
  throw corrupt(`${link}[${of}] is ${value}`);
}
