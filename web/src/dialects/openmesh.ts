import { refuse } from '../checks.js';
import { checkGivenPosition, type Position } from '../edit.js';
import { named, printed } from '../inspect.js';
import type { Direction, ItemKind } from '../items.js';
import type { HalfedgeMesh } from '../mesh.js';
import { Pool } from './pool.js';
import { checkReadable } from './readable.js';

abstract class Handle {
  readonly #idx: number;

  /** @internal */
  constructor(idx = -1) {
    this.#idx = idx;
  }

  /** The index of the item in the mesh, -1 if there is none. */
  idx(): number {
    return this.#idx;
  }
  is_valid(): boolean {
    return this.#idx >= 0;
  }
}

// The names tell them apart for TypeScript.
/** Which vertex: its index, or none. */
export class VertexHandle extends Handle {
  readonly kind = 'vertex';
}
/** Which halfedge: its index, or none. */
export class HalfedgeHandle extends Handle {
  readonly kind = 'halfedge';
}
/** Which edge: its index, or none. */
export class EdgeHandle extends Handle {
  readonly kind = 'edge';
}
/** Which face: its index, or none. */
export class FaceHandle extends Handle {
  readonly kind = 'face';
}

for (const [name, type] of Object.entries({
  VertexHandle,
  HalfedgeHandle,
  EdgeHandle,
  FaceHandle,
})) {
  printed<Handle>(name, type, (handle) => ({ idx: handle.idx() }));
}

const VERTEX_OR_FACE = 'a VertexHandle or a FaceHandle';

/** The index of a handle of the kind that is asked for. Throws a sentence for anything else. */
const ofVertex = (v: VertexHandle, argument = 'v') =>
  indexOf(v, 'vertex', argument, 'a VertexHandle');
const ofHalfedge = (h: HalfedgeHandle, argument = 'h') =>
  indexOf(h, 'halfedge', argument, 'a HalfedgeHandle');
const ofFace = (f: FaceHandle, argument = 'f', expected = 'a FaceHandle') =>
  indexOf(f, 'face', argument, expected);

function indexOf(
  handle: VertexHandle | HalfedgeHandle | FaceHandle,
  kind: ItemKind,
  argument: string,
  expected: string,
): number {
  if (handle instanceof Handle && handle.kind === kind) return handle.idx();
  refuse(argument, handle, expected);
}

/**
 * A mesh under OpenMesh's names, for programs and people that come from there:
 *
 * ```ts
 * const om = new PolyMesh(mesh);
 * for (const vh of om.vv_range(om.vertex_handle(0))) console.log(vh.idx(), om.is_boundary(vh));
 * ```
 *
 * Orders, starts and default directions are OpenMesh's: around a vertex clockwise, around a face
 * counter-clockwise. Ranges are arrays. There is one handle for each item, so that `===` compares
 * them; the empty one has the index -1.
 *
 * For convenience, not for speed: an object for each item that is met. Make one for a mesh and keep
 * it; handles of two of them are never equal.
 */
export class PolyMesh {
  static readonly InvalidVertexHandle: VertexHandle = new VertexHandle(-1);
  static readonly InvalidHalfedgeHandle: HalfedgeHandle = new HalfedgeHandle(-1);
  static readonly InvalidEdgeHandle: EdgeHandle = new EdgeHandle(-1);
  static readonly InvalidFaceHandle: FaceHandle = new FaceHandle(-1);

  readonly #vertices = new Pool((idx) => new VertexHandle(idx));
  readonly #halfedges = new Pool((idx) => new HalfedgeHandle(idx));
  readonly #edges = new Pool((idx) => new EdgeHandle(idx));
  readonly #faces = new Pool((idx) => new FaceHandle(idx));

  constructor(readonly mesh: HalfedgeMesh) {
    checkReadable(mesh, 'a HalfedgeMesh');
    if (!('isLiveVertex' in mesh)) refuse('mesh', mesh, 'a HalfedgeMesh'); // links can be set
  }

  /** Deleted ones included, as in OpenMesh before garbage_collection(). */
  n_vertices(): number {
    return this.mesh.vertexSlots;
  }
  n_halfedges(): number {
    return this.mesh.halfedgeSlots;
  }
  n_edges(): number {
    return this.mesh.edgeSlots;
  }
  n_faces(): number {
    return this.mesh.faceSlots;
  }

  vertices(): VertexHandle[] {
    return Array.from(this.mesh.vertices(), this.#vertex);
  }
  halfedges(): HalfedgeHandle[] {
    return Array.from(this.mesh.halfedges(), this.#halfedge);
  }
  edges(): EdgeHandle[] {
    return Array.from(this.mesh.edges(), this.#edge);
  }
  faces(): FaceHandle[] {
    return Array.from(this.mesh.faces(), this.#face);
  }

  // ---- links (1)-(7) ------------------------------------------------------------------------------

  vertex_handle(i: number): VertexHandle {
    this.mesh.vertexHalfedge(i); // throws where there is none
    return this.#vertex(i);
  }
  /** By its index; of a vertex an outgoing one; of a face one of its own; of an edge one `side`. */
  halfedge_handle(of: number | VertexHandle | FaceHandle): HalfedgeHandle;
  halfedge_handle(of: EdgeHandle, side: 0 | 1): HalfedgeHandle;
  halfedge_handle(
    of: number | VertexHandle | FaceHandle | EdgeHandle,
    side: 0 | 1 = 0,
  ): HalfedgeHandle {
    if (of instanceof VertexHandle) return this.#halfedge(this.mesh.vertexHalfedge(of.idx()));
    if (of instanceof FaceHandle) return this.#halfedge(this.mesh.faceHalfedge(of.idx()));
    if (of instanceof EdgeHandle) return this.#halfedge(this.mesh.edgeHalfedge(of.idx(), side));
    this.mesh.next(of);
    return this.#halfedge(of);
  }
  /** By its index, or of a halfedge. */
  edge_handle(of: number | HalfedgeHandle): EdgeHandle {
    if (typeof of !== 'number') return this.#edge(this.mesh.edge(ofHalfedge(of, 'of')));
    this.mesh.edgeHalfedge(of);
    return this.#edge(of);
  }
  /** By its index, or of a halfedge; invalid for a boundary halfedge. */
  face_handle(of: number | HalfedgeHandle): FaceHandle {
    if (typeof of !== 'number') return this.#face(this.mesh.face(ofHalfedge(of, 'of')));
    this.mesh.faceHalfedge(of);
    return this.#face(of);
  }
  opposite_face_handle(h: HalfedgeHandle): FaceHandle {
    return this.face_handle(this.opposite_halfedge_handle(h));
  }
  to_vertex_handle(h: HalfedgeHandle): VertexHandle {
    return this.#vertex(this.mesh.toVertex(ofHalfedge(h)));
  }
  from_vertex_handle(h: HalfedgeHandle): VertexHandle {
    return this.#vertex(this.mesh.fromVertex(ofHalfedge(h)));
  }
  next_halfedge_handle(h: HalfedgeHandle): HalfedgeHandle {
    return this.#halfedge(this.mesh.next(ofHalfedge(h)));
  }
  prev_halfedge_handle(h: HalfedgeHandle): HalfedgeHandle {
    return this.#halfedge(this.mesh.prev(ofHalfedge(h)));
  }
  opposite_halfedge_handle(h: HalfedgeHandle): HalfedgeHandle {
    return this.#halfedge(this.mesh.opposite(ofHalfedge(h)));
  }
  cw_rotated_halfedge_handle(h: HalfedgeHandle): HalfedgeHandle {
    return this.#halfedge(this.mesh.rotateCw(ofHalfedge(h)));
  }
  ccw_rotated_halfedge_handle(h: HalfedgeHandle): HalfedgeHandle {
    return this.#halfedge(this.mesh.rotateCcw(ofHalfedge(h)));
  }

  // ---- queries ------------------------------------------------------------------------------------

  /** With `check_vertex` a face that touches the boundary with a corner counts as well. */
  is_boundary(
    item: VertexHandle | HalfedgeHandle | EdgeHandle | FaceHandle,
    check_vertex = false,
  ): boolean {
    if (item instanceof VertexHandle) return this.mesh.isBoundaryVertex(item.idx());
    if (item instanceof HalfedgeHandle) return this.mesh.isBoundaryHalfedge(item.idx());
    if (item instanceof EdgeHandle) return this.mesh.isBoundaryEdge(item.idx());
    const f = ofFace(item, 'item', 'a handle');
    if (this.mesh.isBoundaryFace(f)) return true;
    return (
      check_vertex && [...this.mesh.faceVertices(f)].some((v) => this.mesh.isBoundaryVertex(v))
    );
  }
  is_isolated(v: VertexHandle): boolean {
    return this.mesh.isIsolatedVertex(ofVertex(v));
  }
  is_manifold(v: VertexHandle): boolean {
    return this.mesh.isManifoldVertex(ofVertex(v));
  }
  valence(item: VertexHandle | FaceHandle): number {
    return item instanceof VertexHandle
      ? this.mesh.valence(item.idx())
      : this.mesh.degree(ofFace(item, 'item', VERTEX_OR_FACE));
  }
  find_halfedge(a: VertexHandle, b: VertexHandle): HalfedgeHandle {
    return this.#halfedge(this.mesh.findHalfedge(ofVertex(a, 'a'), ofVertex(b, 'b')));
  }
  /** A copy. */
  point(v: VertexHandle): [x: number, y: number, z: number] {
    this.mesh.vertexHalfedge(ofVertex(v));
    const { positions } = this.mesh;
    const at = 3 * ofVertex(v);
    return [positions[at] as number, positions[at + 1] as number, positions[at + 2] as number];
  }
  set_point(v: VertexHandle, point: Position): void {
    const at = ofVertex(v);
    this.mesh.vertexHalfedge(at);
    this.mesh.setPosition(at, checkGivenPosition(point, 'point')); // so that history records it
  }

  // ---- circulators --------------------------------------------------------------------------------
  // Those of a vertex `voh` and `vih` also begin at a halfedge that leaves it, or arrives there.

  vv_range(v: VertexHandle): VertexHandle[] {
    return Array.from(this.mesh.vertexVertices(ofVertex(v), 'cw'), this.#vertex);
  }
  vv_cw_range(v: VertexHandle): VertexHandle[] {
    return Array.from(this.mesh.vertexVertices(ofVertex(v), 'cw'), this.#vertex);
  }
  vv_ccw_range(v: VertexHandle): VertexHandle[] {
    return Array.from(this.mesh.vertexVertices(ofVertex(v), 'ccw'), this.#vertex);
  }
  voh_range(at: VertexHandle | HalfedgeHandle): HalfedgeHandle[] {
    return this.#leaving(at, 'cw');
  }
  voh_cw_range(at: VertexHandle | HalfedgeHandle): HalfedgeHandle[] {
    return this.#leaving(at, 'cw');
  }
  voh_ccw_range(at: VertexHandle | HalfedgeHandle): HalfedgeHandle[] {
    return this.#leaving(at, 'ccw');
  }
  vih_range(at: VertexHandle | HalfedgeHandle): HalfedgeHandle[] {
    return this.#arriving(at, 'cw');
  }
  vih_cw_range(at: VertexHandle | HalfedgeHandle): HalfedgeHandle[] {
    return this.#arriving(at, 'cw');
  }
  vih_ccw_range(at: VertexHandle | HalfedgeHandle): HalfedgeHandle[] {
    return this.#arriving(at, 'ccw');
  }
  ve_range(v: VertexHandle): EdgeHandle[] {
    return Array.from(this.mesh.vertexEdges(ofVertex(v), 'cw'), this.#edge);
  }
  ve_cw_range(v: VertexHandle): EdgeHandle[] {
    return Array.from(this.mesh.vertexEdges(ofVertex(v), 'cw'), this.#edge);
  }
  ve_ccw_range(v: VertexHandle): EdgeHandle[] {
    return Array.from(this.mesh.vertexEdges(ofVertex(v), 'ccw'), this.#edge);
  }
  vf_range(v: VertexHandle): FaceHandle[] {
    return Array.from(this.mesh.vertexFaces(ofVertex(v), 'cw'), this.#face);
  }
  vf_cw_range(v: VertexHandle): FaceHandle[] {
    return Array.from(this.mesh.vertexFaces(ofVertex(v), 'cw'), this.#face);
  }
  vf_ccw_range(v: VertexHandle): FaceHandle[] {
    return Array.from(this.mesh.vertexFaces(ofVertex(v), 'ccw'), this.#face);
  }
  fv_range(f: FaceHandle): VertexHandle[] {
    return Array.from(this.mesh.faceVertices(ofFace(f), 'ccw'), this.#vertex);
  }
  fv_cw_range(f: FaceHandle): VertexHandle[] {
    return Array.from(this.mesh.faceVertices(ofFace(f), 'cw'), this.#vertex);
  }
  fv_ccw_range(f: FaceHandle): VertexHandle[] {
    return Array.from(this.mesh.faceVertices(ofFace(f), 'ccw'), this.#vertex);
  }
  fh_range(f: FaceHandle): HalfedgeHandle[] {
    return Array.from(this.mesh.faceHalfedges(ofFace(f), 'ccw'), this.#halfedge);
  }
  fh_cw_range(f: FaceHandle): HalfedgeHandle[] {
    return Array.from(this.mesh.faceHalfedges(ofFace(f), 'cw'), this.#halfedge);
  }
  fh_ccw_range(f: FaceHandle): HalfedgeHandle[] {
    return Array.from(this.mesh.faceHalfedges(ofFace(f), 'ccw'), this.#halfedge);
  }
  fe_range(f: FaceHandle): EdgeHandle[] {
    return Array.from(this.mesh.faceEdges(ofFace(f), 'ccw'), this.#edge);
  }
  fe_cw_range(f: FaceHandle): EdgeHandle[] {
    return Array.from(this.mesh.faceEdges(ofFace(f), 'cw'), this.#edge);
  }
  fe_ccw_range(f: FaceHandle): EdgeHandle[] {
    return Array.from(this.mesh.faceEdges(ofFace(f), 'ccw'), this.#edge);
  }
  ff_range(f: FaceHandle): FaceHandle[] {
    return Array.from(this.mesh.faceFaces(ofFace(f), 'ccw'), this.#face);
  }
  ff_cw_range(f: FaceHandle): FaceHandle[] {
    return Array.from(this.mesh.faceFaces(ofFace(f), 'cw'), this.#face);
  }
  ff_ccw_range(f: FaceHandle): FaceHandle[] {
    return Array.from(this.mesh.faceFaces(ofFace(f), 'ccw'), this.#face);
  }
  hl_range(h: HalfedgeHandle): HalfedgeHandle[] {
    return Array.from(this.mesh.halfedgeLoop(ofHalfedge(h), 'ccw'), this.#halfedge);
  }
  hl_cw_range(h: HalfedgeHandle): HalfedgeHandle[] {
    return Array.from(this.mesh.halfedgeLoop(ofHalfedge(h), 'cw'), this.#halfedge);
  }
  hl_ccw_range(h: HalfedgeHandle): HalfedgeHandle[] {
    return Array.from(this.mesh.halfedgeLoop(ofHalfedge(h), 'ccw'), this.#halfedge);
  }

  // ---- low-level changes ----------------------------------------------------------------------------
  // They write into `mesh.connectivity`, and keep no invariant by themselves: `mesh.validate()` tells
  // whether the result does. Circulators that are under way don't notice.

  /** The outgoing halfedge of a vertex, or the halfedge of a face. */
  set_halfedge_handle(of: VertexHandle | FaceHandle, h: HalfedgeHandle): void {
    const { vertexHalfedge, faceHalfedge } = this.mesh.connectivity;
    const [at, halfedge] = [
      of instanceof VertexHandle ? of.idx() : ofFace(of, 'of', VERTEX_OR_FACE),
      ofHalfedge(h),
    ];
    this.#check(of, h);
    if (of instanceof VertexHandle) vertexHalfedge[at] = halfedge;
    else faceHalfedge[at] = halfedge;
  }
  /** The vertex that `h` points to. */
  set_vertex_handle(h: HalfedgeHandle, v: VertexHandle): void {
    const [at, vertex] = [ofHalfedge(h), ofVertex(v)];
    this.#check(h, v);
    this.mesh.connectivity.toVertex[at] = vertex;
  }
  set_face_handle(h: HalfedgeHandle, f: FaceHandle): void {
    const [at, face] = [ofHalfedge(h), ofFace(f)];
    this.#check(h, f);
    this.mesh.connectivity.face[at] = face;
  }
  set_boundary(h: HalfedgeHandle): void {
    const at = ofHalfedge(h);
    this.#check(h);
    this.mesh.connectivity.face[at] = -1;
  }
  set_isolated(v: VertexHandle): void {
    const at = ofVertex(v);
    this.#check(v);
    this.mesh.connectivity.vertexHalfedge[at] = -1;
  }
  /** Sets the link back as well. */
  set_next_halfedge_handle(h: HalfedgeHandle, next: HalfedgeHandle): void {
    const [before, after] = [ofHalfedge(h), ofHalfedge(next, 'next')];
    this.#check(h, next);
    const links = this.mesh.connectivity;
    links.next[before] = after;
    links.prev[after] = before;
  }
  /** The outgoing halfedge of a boundary vertex becomes a boundary halfedge. */
  adjust_outgoing_halfedge(v: VertexHandle): void {
    const boundary = this.voh_range(v).find((h) => this.is_boundary(h));
    if (boundary !== undefined) this.set_halfedge_handle(v, boundary);
  }

  // ---- indices to handles ---------------------------------------------------------------------------

  readonly #vertex = (idx: number): VertexHandle => this.#vertices.at(idx);
  readonly #halfedge = (idx: number): HalfedgeHandle =>
    idx < 0 ? PolyMesh.InvalidHalfedgeHandle : this.#halfedges.at(idx);
  readonly #edge = (idx: number): EdgeHandle => this.#edges.at(idx);
  readonly #face = (idx: number): FaceHandle =>
    idx < 0 ? PolyMesh.InvalidFaceHandle : this.#faces.at(idx);

  #leaving(at: VertexHandle | HalfedgeHandle, direction: Direction): HalfedgeHandle[] {
    const [v, start] =
      at instanceof VertexHandle
        ? [at.idx(), undefined]
        : [this.from_vertex_handle(at).idx(), at.idx()];
    return Array.from(this.mesh.vertexOutgoingHalfedges(v, direction, start), this.#halfedge);
  }
  #arriving(at: VertexHandle | HalfedgeHandle, direction: Direction): HalfedgeHandle[] {
    const start = at instanceof VertexHandle ? at : this.opposite_halfedge_handle(at);
    return this.#leaving(start, direction).map((h) => this.opposite_halfedge_handle(h));
  }

  /** Throws for the handle of an item that isn't there. */
  #check(...handles: (VertexHandle | HalfedgeHandle | FaceHandle)[]): void {
    for (const handle of handles) {
      if (handle instanceof VertexHandle) this.mesh.vertexHalfedge(handle.idx());
      else if (handle instanceof HalfedgeHandle) this.mesh.next(handle.idx());
      else this.mesh.faceHalfedge(handle.idx());
    }
  }
}

named({ PolyMesh });
