import { type BufferAttribute, Matrix4 } from 'three';
import { type HalfedgeMesh, NONE } from '../api.js';
import { FaceTree, type FaceTreeOptions, type ShownFaces } from '../three/face-tree.js';
import type { PickTarget } from '../three/item-picker.js';
import { MeshChanges } from '../three/mesh-changes.js';
import { RowBuffer, roomFor } from '../three/rows.js';
import type { Triangles } from '../three/triangle-tree.js';
import { triangulateFaces } from '../three/triangulate.js';
import { type ChangedEdge, changedEdge, type FormerVertex, type SurfaceChange } from './change.js';
import { ShownTriangles } from './shown-triangles.js';
import { type Bounds, boundsOf, medianEdge } from './surface-measures.js';

/** Changes of more triangles, edges or vertices than this are not told one by one. */
const MOST_CHANGES = 4000;

/**
 * A mesh made ready for the scene: its positions moved into the unit sphere, its faces triangulated for drawing, and a
 * tree over the triangles that picks the faces they are part of. `update` takes up what an edit has changed.
 */
export class Surface implements PickTarget, ShownFaces {
  readonly mesh: HalfedgeMesh;
  /** xyz by vertex, centred, within distance 1 of the origin; the origin for deleted vertices. */
  points: Float32Array = new Float32Array(0);
  readonly triangles: ShownTriangles;
  /** Takes a position of the mesh to its place in the scene, also after edits. */
  readonly placement: Matrix4;
  readonly tree: FaceTree;
  /** Its points are in the world as they are. */
  readonly matrixWorld = new Matrix4();
  /** The boundary halfedges. */
  boundary: readonly number[] = [];
  /** A typical length of an edge. */
  readonly medianEdge: number;
  readonly #bounds: Bounds;
  readonly #position = new RowBuffer(new Float32Array(0), 3);
  readonly #changes = new MeshChanges([]);
  /** The mesh as it was at the last update: by vertex, whether it is there; by halfedge, the vertex it points to. */
  #isLive = new Uint8Array(0);
  #toVertex = new Int32Array(0);
  #vertices = 0;
  #halfedges = 0;

  constructor(mesh: HalfedgeMesh, options: FaceTreeOptions = {}) {
    this.mesh = mesh;
    this.#bounds = boundsOf(mesh.positions);
    const { centre, scale } = this.#bounds;
    this.placement = new Matrix4()
      .makeScale(scale, scale, scale)
      .multiply(new Matrix4().makeTranslation(-centre[0], -centre[1], -centre[2]));
    this.#changes.skip(mesh);
    this.#reserve();
    this.#fill();
    this.triangles = new ShownTriangles(mesh);
    this.boundary = boundaryOf(mesh);
    this.tree = new FaceTree(this, options);
    this.medianEdge = medianEdge(mesh, this.points);
  }

  /** The points, as layers share them: another attribute when there was not room enough. */
  get position(): BufferAttribute {
    return this.#position.attribute;
  }

  /** Whether there is such a vertex. */
  isLive(vertex: number): boolean {
    return this.#isLive[vertex] === 1;
  }

  /** The triangles that a face is drawn as, as vertices. */
  triangleVertices(face: number): Uint32Array {
    return this.triangles.verticesOf(face);
  }

  /** Writes xyz of the corners of a face to `out`, and returns its degree. */
  corners(face: number, out: number[]): number {
    const { next, toVertex, faceHalfedge } = this.mesh.connectivity;
    const first = faceHalfedge[face];
    let degree = 0;
    let h = first;
    do {
      const p = 3 * toVertex[h];
      out[3 * degree] = this.points[p];
      out[3 * degree + 1] = this.points[p + 1];
      out[3 * degree + 2] = this.points[p + 2];
      degree += 1;
      h = next[h];
    } while (h !== first);
    return degree;
  }

  /** Vertices whose points are others now: they are uploaded, and nothing else. */
  movePoints(vertices: Iterable<number>): void {
    for (const v of vertices) this.position.addUpdateRange(3 * v, 3);
    this.position.needsUpdate = true;
  }

  allTriangles(): Triangles {
    return { points: this.points.slice(), ...this.triangles.inOrder(this.mesh) };
  }

  /**
   * Takes up what has changed in the mesh since the last time, and returns it; null where that is too much to be told
   * one by one. Costs what has changed, and some milliseconds for a million faces to find it.
   */
  update(): SurfaceChange | null {
    const { mesh } = this;
    const changes = this.#changes;
    changes.find(mesh);
    this.#reserve();
    const vertices = this.#takeVertices(changes.vertices.items);
    const edges = this.#takeEdges(changes.edges.items);
    this.#position.mark();
    for (const v of vertices.keys()) {
      if (this.isLive(v)) for (const face of mesh.vertexFaces(v)) changes.faces.add(face);
    }
    this.boundary = boundaryOf(mesh);
    const isTooMuch = Math.max(vertices.size, edges.length) > MOST_CHANGES;
    const faces = isTooMuch ? null : this.#changedFaces(changes.faces.items, vertices);
    if (faces === null || this.triangles.isWasteful) this.triangles.fill(mesh);
    else this.triangles.place(mesh, [...faces.faces]);
    this.tree.update(faces?.faces ?? null, this);
    return faces && { ...faces, edges, vertices };
  }

  /** Which of some faces are drawn otherwise than before, and how; null for too many. */
  #changedFaces(
    candidates: readonly number[],
    moved: ReadonlyMap<number, unknown>,
  ): Pick<SurfaceChange, 'faces' | 'before' | 'after'> | null {
    const { mesh, triangles } = this;
    const faces = new Set<number>();
    const before: number[] = [];
    const after: number[] = [];
    const found = triangulateFaces(mesh, candidates); // which can detach views
    const { toVertex } = mesh.connectivity;
    let at = 0;
    for (const face of candidates) {
      const was = triangles.verticesOf(face);
      const first = at;
      while (found.faces[at] === face) at += 1;
      let isSame = was.length === 3 * (at - first);
      for (let i = 0; isSame && i < was.length; i++) {
        const v = toVertex[found.halfedges[3 * first + i]];
        isSame = v === was[i] && !moved.has(v);
      }
      if (isSame) continue;
      faces.add(face);
      before.push(...was);
      for (let i = 3 * first; i < 3 * at; i++) after.push(toVertex[found.halfedges[i]]);
      if (before.length + after.length > 3 * MOST_CHANGES) return null;
    }
    // Those whose slots are no more, after undo.
    for (let face = mesh.faceSlots; face < triangles.faces; face++) {
      const was = triangles.verticesOf(face);
      if (was.length === 0) continue;
      faces.add(face);
      before.push(...was);
    }
    return before.length + after.length > 3 * MOST_CHANGES ? null : { faces, before, after };
  }

  /** Takes over where vertices are now. Returns how those were that are otherwise. */
  #takeVertices(candidates: readonly number[]): Map<number, FormerVertex> {
    const { vertexHalfedge } = this.mesh.connectivity;
    const { positions } = this.mesh;
    const changed = new Map<number, FormerVertex>();
    const points = this.#position.array;
    const take = (v: number) => {
      const isLive = v < vertexHalfedge.length && vertexHalfedge[v] >= NONE;
      const place = [points[3 * v], points[3 * v + 1], points[3 * v + 2]] as const;
      const wasLive = this.#isLive[v] === 1;
      this.#readPlace(positions, isLive ? v : -1);
      const hasMoved = this.#position.write(v, read, 0);
      if (hasMoved || wasLive !== isLive) changed.set(v, { place, isLive: wasLive });
      this.#isLive[v] = Number(isLive);
    };
    for (const v of candidates) take(v);
    for (let v = vertexHalfedge.length; v < this.#vertices; v++) take(v);
    this.#vertices = vertexHalfedge.length;
    this.points = this.#pointsOf(vertexHalfedge.length);
    return changed;
  }

  /** Takes over the ends of edges. Returns those that are others. */
  #takeEdges(candidates: readonly number[]): ChangedEdge[] {
    const { toVertex } = this.mesh.connectivity;
    const known = this.#toVertex;
    const changed: ChangedEdge[] = [];
    const take = (e: number) => {
      const ends = [toVertex[2 * e] ?? NONE, toVertex[2 * e + 1] ?? NONE] as const;
      const found = changedEdge(e, [known[2 * e], known[2 * e + 1]], ends);
      if (found) changed.push(found);
      known[2 * e] = ends[0];
      known[2 * e + 1] = ends[1];
    };
    for (const e of candidates) take(e);
    for (let h = toVertex.length; h < this.#halfedges; h += 2) take(h >> 1);
    this.#halfedges = toVertex.length;
    return changed;
  }

  /** Takes over all vertices and ends of edges, after `#reserve`. */
  #fill(): void {
    const { toVertex, vertexHalfedge } = this.mesh.connectivity;
    const { positions } = this.mesh;
    this.#toVertex.set(toVertex);
    const points = this.#position.array;
    for (let v = 0; v < vertexHalfedge.length; v++) {
      if (vertexHalfedge[v] < NONE) continue;
      this.#isLive[v] = 1;
      this.#readPlace(positions, v);
      points[3 * v] = read[0];
      points[3 * v + 1] = read[1];
      points[3 * v + 2] = read[2];
    }
    this.#vertices = vertexHalfedge.length;
    this.#halfedges = toVertex.length;
    this.points = this.#pointsOf(this.#vertices);
  }

  /** Reads where a vertex is in the scene; a negative one, and one that is nowhere, is in the middle. */
  #readPlace(positions: Float32Array, v: number): void {
    const { centre, scale } = this.#bounds;
    for (let k = 0; k < 3; k++) {
      const x = v < 0 ? 0 : (positions[3 * v + k] - centre[k]) * scale;
      read[k] = Number.isFinite(x) ? x : 0;
    }
  }

  #pointsOf(vertices: number): Float32Array<ArrayBuffer> {
    return (this.#position.array as Float32Array<ArrayBuffer>).subarray(0, 3 * vertices);
  }

  /** Makes room for what the mesh has now, and some more. */
  #reserve(): void {
    const { vertexSlots, halfedgeSlots } = this.mesh;
    if (vertexSlots > this.#isLive.length) {
      const room = roomFor(vertexSlots);
      const isLive = new Uint8Array(room);
      isLive.set(this.#isLive);
      this.#isLive = isLive;
      this.#position.reserve(room);
    }
    if (halfedgeSlots > this.#toVertex.length) {
      const toVertex = new Int32Array(roomFor(halfedgeSlots)).fill(NONE);
      toVertex.set(this.#toVertex);
      this.#toVertex = toVertex;
    }
  }
}

/** xyz of a vertex. */
const read = new Float32Array(3);

function boundaryOf({ connectivity: { face, next } }: HalfedgeMesh): number[] {
  const found: number[] = [];
  for (let h = 0; h < face.length; h++) if (face[h] === NONE && next[h] >= 0) found.push(h);
  return found;
}
