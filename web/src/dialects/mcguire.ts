import { named } from '../inspect.js';
import type { FaceLike, HalfedgeLike, VertexLike } from '../items.js';
import type { HalfedgeMesh } from '../mesh.js';
import { Pool } from './pool.js';
import { checkReadable, type ReadableMesh } from './readable.js';

/**
 * A mesh as the structs of Max McGuire's article "The Half-Edge Data Structure" (2000). They are read
 * from the mesh when they are asked, and there is one object for each item, so that the loops of
 * the article run as they are printed:
 *
 * ```ts
 * const he = new HE_mesh(mesh);
 * const vert = he.vert(v);
 * let edge = vert.edge;
 * do {
 *   // do something with edge, edge.pair or edge.face
 *   edge = edge.pair.next;
 * } while (edge !== vert.edge);
 * ```
 *
 * For convenience, not for speed: an object for each item that is met. Make one for a mesh and keep
 * it; items of two of them are never equal.
 */
export class HE_mesh<Mesh extends ReadableMesh = HalfedgeMesh> {
  /** @internal */
  readonly edges: Pool<HE_edge>;
  /** @internal */
  readonly verts: Pool<HE_vert>;
  /** @internal */
  readonly faces: Pool<HE_face>;

  constructor(readonly mesh: Mesh) {
    checkReadable(mesh);
    this.edges = new Pool((index) => new HE_edge(this, index));
    this.verts = new Pool((index) => new HE_vert(this, index));
    this.faces = new Pool((index) => new HE_face(this, index));
  }

  /** The struct of a halfedge. */
  edge(h: HalfedgeLike): HE_edge {
    this.mesh.next(h); // throws where there is none
    return this.edges.at(h);
  }

  /** The struct of a vertex. */
  vert(v: VertexLike): HE_vert {
    this.mesh.vertexHalfedge(v);
    return this.verts.at(v);
  }

  /** The struct of a face. */
  face(f: FaceLike): HE_face {
    this.mesh.faceHalfedge(f);
    return this.faces.at(f);
  }
}

/** A halfedge, with the fields of the article's struct. */
export class HE_edge {
  readonly #of: HE_mesh<ReadableMesh>;

  /** @internal */
  constructor(
    of: HE_mesh<ReadableMesh>,
    /** The halfedge of the mesh. */
    readonly index: number,
  ) {
    this.#of = of;
  }

  /** The vertex at the end of the half-edge. */
  get vert(): HE_vert {
    return this.#of.verts.at(this.#of.mesh.toVertex(this.index));
  }
  /** The oppositely oriented adjacent half-edge. */
  get pair(): HE_edge {
    return this.#of.edges.at(this.#of.mesh.opposite(this.index));
  }
  /** The face the half-edge borders; null on the boundary, which the article excludes. */
  get face(): HE_face | null {
    return this.#of.faces.orNull(this.#of.mesh.face(this.index));
  }
  /** The next half-edge around the face, or around the boundary loop. */
  get next(): HE_edge {
    return this.#of.edges.at(this.#of.mesh.next(this.index));
  }
}

/** A vertex, with the fields of the article's struct. */
export class HE_vert {
  readonly #of: HE_mesh<ReadableMesh>;

  /** @internal */
  constructor(
    of: HE_mesh<ReadableMesh>,
    /** The vertex of the mesh. */
    readonly index: number,
  ) {
    this.#of = of;
  }

  get x(): number {
    return this.#coordinate(0);
  }
  set x(x: number) {
    this.#move(0, x);
  }
  get y(): number {
    return this.#coordinate(1);
  }
  set y(y: number) {
    this.#move(1, y);
  }
  get z(): number {
    return this.#coordinate(2);
  }
  set z(z: number) {
    this.#move(2, z);
  }

  #coordinate(axis: number): number {
    this.#of.mesh.vertexHalfedge(this.index); // throws where it is gone
    return this.#of.mesh.positions[3 * this.index + axis] as number;
  }

  #move(axis: number, to: number): void {
    this.#of.mesh.vertexHalfedge(this.index);
    this.#of.mesh.positions[3 * this.index + axis] = to;
  }

  /** One of the half-edges that emanate from the vertex; null if there is none. */
  get edge(): HE_edge | null {
    return this.#of.edges.orNull(this.#of.mesh.vertexHalfedge(this.index));
  }
}

/** A face, with the field of the article's struct. */
export class HE_face {
  readonly #of: HE_mesh<ReadableMesh>;

  /** @internal */
  constructor(
    of: HE_mesh<ReadableMesh>,
    /** The face of the mesh. */
    readonly index: number,
  ) {
    this.#of = of;
  }

  /** One of the half-edges that border the face. */
  get edge(): HE_edge {
    return this.#of.edges.at(this.#of.mesh.faceHalfedge(this.index));
  }
}

named({ HE_mesh, HE_edge, HE_vert, HE_face });
