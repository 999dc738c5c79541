import { named } from '../inspect.js';
import type { FaceLike, HalfedgeLike, VertexLike } from '../items.js';
import type { HalfedgeMesh } from '../mesh.js';
import { Pool } from './pool.js';
import { checkReadable, type ReadableMesh } from './readable.js';

/**
 * A mesh under the names of CGAL's Polyhedron_3, for programs and people that come from there. Items
 * are objects, one for each item of the mesh, so that `===` compares them; an empty handle is null.
 *
 * ```ts
 * const c = polyhedron.halfedge(h).vertex_begin();
 * const begin = c.halfedge;
 * do use(c.halfedge.opposite().vertex());
 * while (c.next() !== begin);
 * ```
 *
 * A halfedge is incident to the vertex it points to: around a vertex circulators visit the halfedges
 * that arrive there, clockwise; around a facet they go counter-clockwise.
 *
 * For convenience, not for speed: an object for each item that is met. Make one for a mesh and keep
 * it; items of two of them are never equal.
 */
export class Polyhedron<Mesh extends ReadableMesh = HalfedgeMesh> {
  readonly #vertices: Pool<PolyhedronVertex>;
  readonly #halfedges: Pool<PolyhedronHalfedge>;
  readonly #facets: Pool<PolyhedronFacet>;

  constructor(readonly mesh: Mesh) {
    checkReadable(mesh);
    this.#vertices = new Pool((index) => new PolyhedronVertex(this, index));
    this.#halfedges = new Pool((index) => new PolyhedronHalfedge(this, index));
    this.#facets = new Pool((index) => new PolyhedronFacet(this, index));
  }

  /** A vertex of the mesh under these names. */
  vertex(v: VertexLike): PolyhedronVertex {
    this.mesh.vertexHalfedge(v); // throws where there is none
    return this.#vertices.at(v);
  }
  /** A halfedge of the mesh under these names. */
  halfedge(h: HalfedgeLike): PolyhedronHalfedge {
    this.mesh.next(h);
    return this.#halfedges.at(h);
  }
  /** A face of the mesh under these names. */
  facet(f: FaceLike): PolyhedronFacet {
    this.mesh.faceHalfedge(f);
    return this.#facets.at(f);
  }

  size_of_vertices(): number {
    return this.mesh.vertexCount;
  }
  size_of_halfedges(): number {
    return this.mesh.halfedgeCount;
  }
  size_of_facets(): number {
    return this.mesh.faceCount;
  }
  /** O(halfedges); there is no need for normalize_border(). */
  size_of_border_halfedges(): number {
    let count = 0;
    for (const h of this.mesh.halfedges()) count += this.mesh.isBoundaryHalfedge(h) ? 1 : 0;
    return count;
  }
  /** An edge has a facet on at least one side. */
  size_of_border_edges(): number {
    return this.size_of_border_halfedges();
  }
  is_closed(): boolean {
    return this.size_of_border_halfedges() === 0;
  }
  is_pure_triangle(): boolean {
    return this.facets().every((f) => f.is_triangle());
  }
  is_pure_quad(): boolean {
    return this.facets().every((f) => f.is_quad());
  }

  vertices(): PolyhedronVertex[] {
    return Array.from(this.mesh.vertices(), (v) => this.#vertices.at(v));
  }
  halfedges(): PolyhedronHalfedge[] {
    return Array.from(this.mesh.halfedges(), (h) => this.#halfedges.at(h));
  }
  /** One halfedge of each edge, as `Edge_iterator`. */
  edges(): PolyhedronHalfedge[] {
    return this.halfedges().filter((h) => h.index < h.opposite().index);
  }
  facets(): PolyhedronFacet[] {
    return Array.from(this.mesh.faces(), (f) => this.#facets.at(f));
  }
}

/** A halfedge, as a `Halfedge_handle` points to it. */
export class PolyhedronHalfedge {
  readonly #of: Polyhedron<ReadableMesh>;

  /** @internal */
  constructor(
    of: Polyhedron<ReadableMesh>,
    /** The halfedge of the mesh. */
    readonly index: number,
  ) {
    this.#of = of;
  }

  next(): PolyhedronHalfedge {
    return this.#of.halfedge(this.#of.mesh.next(this.index));
  }
  prev(): PolyhedronHalfedge {
    return this.#of.halfedge(this.#of.mesh.prev(this.index));
  }
  opposite(): PolyhedronHalfedge {
    return this.#of.halfedge(this.#of.mesh.opposite(this.index));
  }
  /** The vertex it points to. */
  vertex(): PolyhedronVertex {
    return this.#of.vertex(this.#of.mesh.toVertex(this.index));
  }
  /** Null for a border halfedge. */
  facet(): PolyhedronFacet | null {
    const f = this.#of.mesh.face(this.index);
    return f < 0 ? null : this.#of.facet(f);
  }
  /** As {@link facet}, the name in HalfedgeDS. */
  face(): PolyhedronFacet | null {
    return this.facet();
  }

  /** Clockwise: `next().opposite()`. */
  next_on_vertex(): PolyhedronHalfedge {
    return this.#of.halfedge(this.#of.mesh.nextOnVertex(this.index));
  }
  /** Counter-clockwise: `opposite().prev()`. */
  prev_on_vertex(): PolyhedronHalfedge {
    return this.#of.halfedge(this.#of.mesh.prevOnVertex(this.index));
  }
  /** Of the halfedges that arrive at `vertex()`, clockwise. */
  vertex_begin(): HalfedgeAroundVertexCirculator {
    return new HalfedgeAroundVertexCirculator(this);
  }
  /** Of the halfedges of `facet()`, or of the hole, counter-clockwise. */
  facet_begin(): HalfedgeAroundFacetCirculator {
    return new HalfedgeAroundFacetCirculator(this);
  }

  is_border(): boolean {
    return this.#of.mesh.isBoundaryHalfedge(this.index);
  }
  is_border_edge(): boolean {
    return this.is_border() || this.opposite().is_border();
  }
  vertex_degree(): number {
    return this.#of.mesh.valence(this.#of.mesh.toVertex(this.index));
  }
  facet_degree(): number {
    return stepsAround(this.facet_begin());
  }
  is_bivalent(): boolean {
    return this.vertex_degree() === 2;
  }
  is_trivalent(): boolean {
    return this.vertex_degree() === 3;
  }
  /** Of the facet, or of the hole. */
  is_triangle(): boolean {
    return this.facet_degree() === 3;
  }
  is_quad(): boolean {
    return this.facet_degree() === 4;
  }
}

/** A vertex, as a `Vertex_handle` points to it. */
export class PolyhedronVertex {
  readonly #of: Polyhedron<ReadableMesh>;

  /** @internal */
  constructor(
    of: Polyhedron<ReadableMesh>,
    /** The vertex of the mesh. */
    readonly index: number,
  ) {
    this.#of = of;
  }

  /** One that arrives here; null for an isolated vertex, which CGAL doesn't have. */
  halfedge(): PolyhedronHalfedge | null {
    const anchor = this.#of.mesh.vertexHalfedge(this.index);
    return anchor < 0 ? null : this.#of.halfedge(this.#of.mesh.opposite(anchor));
  }
  /** Null for an isolated vertex. */
  vertex_begin(): HalfedgeAroundVertexCirculator | null {
    return this.halfedge()?.vertex_begin() ?? null;
  }
  vertex_degree(): number {
    return this.#of.mesh.valence(this.index);
  }
  degree(): number {
    return this.vertex_degree();
  }
  is_bivalent(): boolean {
    return this.vertex_degree() === 2;
  }
  is_trivalent(): boolean {
    return this.vertex_degree() === 3;
  }
  /** A copy: to move a vertex write to `mesh.positions`. */
  point(): [x: number, y: number, z: number] {
    this.#of.mesh.vertexHalfedge(this.index); // throws where it is gone
    const { positions } = this.#of.mesh;
    const at = 3 * this.index;
    return [positions[at] as number, positions[at + 1] as number, positions[at + 2] as number];
  }
}

/** A facet, as a `Facet_handle` points to it. */
export class PolyhedronFacet {
  readonly #of: Polyhedron<ReadableMesh>;

  /** @internal */
  constructor(
    of: Polyhedron<ReadableMesh>,
    /** The face of the mesh. */
    readonly index: number,
  ) {
    this.#of = of;
  }

  halfedge(): PolyhedronHalfedge {
    return this.#of.halfedge(this.#of.mesh.faceHalfedge(this.index));
  }
  facet_begin(): HalfedgeAroundFacetCirculator {
    return this.halfedge().facet_begin();
  }
  facet_degree(): number {
    return this.#of.mesh.degree(this.index);
  }
  is_triangle(): boolean {
    return this.facet_degree() === 3;
  }
  is_quad(): boolean {
    return this.facet_degree() === 4;
  }
}

/** Endless and bidirectional: `next()` is `++c`, `prev()` is `--c`; both return where it then stands. */
abstract class HalfedgeCirculator {
  #halfedge: PolyhedronHalfedge;

  /** @internal */
  constructor(start: PolyhedronHalfedge) {
    this.#halfedge = start;
  }

  /** Where it stands. */
  get halfedge(): PolyhedronHalfedge {
    return this.#halfedge;
  }
  next(): PolyhedronHalfedge {
    this.#halfedge = this.after(this.#halfedge);
    return this.#halfedge;
  }
  prev(): PolyhedronHalfedge {
    this.#halfedge = this.before(this.#halfedge);
    return this.#halfedge;
  }

  protected abstract after(h: PolyhedronHalfedge): PolyhedronHalfedge;
  protected abstract before(h: PolyhedronHalfedge): PolyhedronHalfedge;
}

/** The halfedges that lead to a vertex, clockwise, along `next_on_vertex()`. */
export class HalfedgeAroundVertexCirculator extends HalfedgeCirculator {
  protected after(h: PolyhedronHalfedge): PolyhedronHalfedge {
    return h.next_on_vertex();
  }
  protected before(h: PolyhedronHalfedge): PolyhedronHalfedge {
    return h.prev_on_vertex();
  }
}

/** The halfedges around a facet, along `next()`. */
export class HalfedgeAroundFacetCirculator extends HalfedgeCirculator {
  protected after(h: PolyhedronHalfedge): PolyhedronHalfedge {
    return h.next();
  }
  protected before(h: PolyhedronHalfedge): PolyhedronHalfedge {
    return h.prev();
  }
}

function stepsAround(circulator: HalfedgeCirculator): number {
  const begin = circulator.halfedge;
  let steps = 0;
  do steps += 1;
  while (circulator.next() !== begin);
  return steps;
}

named({
  Polyhedron,
  PolyhedronHalfedge,
  PolyhedronVertex,
  PolyhedronFacet,
  HalfedgeAroundVertexCirculator,
  HalfedgeAroundFacetCirculator,
});
