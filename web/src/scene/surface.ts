import { BufferAttribute, DynamicDrawUsage, Matrix4, ShapeUtils, Vector2 } from 'three';
import { type HalfedgeMesh, NONE } from '../api.js';
import { FaceTree, type FaceTreeOptions, type ShownFaces } from '../three/face-tree.js';
import { newellNormal } from '../three/index.js';
import type { PickTarget } from '../three/item-picker.js';
import { roomFor } from '../three/rows.js';
import { firstOf, type Triangles } from '../three/triangle-tree.js';
import { type ChangedTriangles, changedTriangles, type Drawn } from './change.js';

/** Changes of more triangles than this are not told one by one. */
const MOST_CHANGES = 4000;

/**
 * A mesh made ready for the scene: its positions moved into the unit sphere, its faces
 * triangulated for drawing, and a tree over the triangles that picks the faces they are part of.
 */
export class Surface implements Drawn, PickTarget, ShownFaces {
  readonly mesh: HalfedgeMesh;
  /** xyz by vertex, centred, within distance 1 of the origin; the origin for deleted vertices. */
  readonly points: Float32Array;
  readonly vertexHalfedge: Int32Array;
  readonly toVertex: Int32Array;
  readonly triangles: Uint32Array;
  /** Takes a position of the mesh to its place in the scene. */
  readonly placement: Matrix4;
  /** The points, as layers share them: those of surfaces that come one from the other, while there is room. */
  readonly position: BufferAttribute;
  readonly tree: FaceTree;
  /** Its points are in the world as they are. */
  readonly matrixWorld = new Matrix4();
  /** What changed since the earlier surface; null where there is none, or all may have changed. */
  readonly change: ChangedTriangles | null;
  /** By triangle: the face it is part of. */
  readonly faceOf: Uint32Array;
  /** A typical length of an edge. */
  readonly medianEdge: number;
  readonly #bounds: Bounds;
  /** The points, and room for some more. */
  readonly #room: Float32Array;

  /** With a surface that was made from the mesh earlier, before an edit: in the same place. */
  constructor(mesh: HalfedgeMesh, earlier?: Surface, options: FaceTreeOptions = {}) {
    this.mesh = mesh;
    // What this was made from, as it was then: the mesh itself goes on to change.
    this.vertexHalfedge = mesh.connectivity.vertexHalfedge.slice();
    this.toVertex = mesh.connectivity.toVertex.slice();
    this.#bounds = earlier ? earlier.#bounds : bounds(mesh.positions);
    const { centre, scale } = this.#bounds;
    const { length } = mesh.positions;
    const known = earlier ? earlier.#room.length : 0;
    this.#room = new Float32Array(length <= known ? known : 3 * roomFor(length / 3));
    this.points = this.#room.subarray(0, length);
    this.#placePoints();
    this.placement = new Matrix4()
      .makeScale(scale, scale, scale)
      .multiply(new Matrix4().makeTranslation(-centre[0], -centre[1], -centre[2]));
    const { triangles, faceOf } = triangulate(mesh, this.points);
    this.faceOf = faceOf;
    this.triangles = triangles;
    this.change = earlier ? changedTriangles(earlier, this, MOST_CHANGES) : null;
    this.position = this.#sharedPosition(earlier);
    this.tree = earlier?.tree ?? new FaceTree(this, options);
    if (earlier) this.tree.update(this.change?.faces ?? null, this);
    this.medianEdge = earlier ? earlier.medianEdge : medianEdge(mesh, this.points);
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

  /** The triangles that a face is drawn as, as vertices. */
  facePieces(face: number): number[] {
    return triangulateFace(this.mesh, this.points, face);
  }

  /** Vertices whose points are others now: they are uploaded, and nothing else. */
  movePoints(vertices: Iterable<number>): void {
    for (const v of vertices) this.position.addUpdateRange(3 * v, 3);
    this.position.needsUpdate = true;
  }

  triangleVertices(face: number): Uint32Array {
    const from = firstOf(this.faceOf, face);
    return this.triangles.subarray(3 * from, 3 * firstOf(this.faceOf, face + 1));
  }

  allTriangles(): Triangles {
    const { points, triangles, faceOf } = this;
    return { points: points.slice(), vertices: triangles.slice(), faces: faceOf };
  }

  #placePoints(): void {
    const { centre, scale } = this.#bounds;
    const { positions } = this.mesh;
    for (let v = 0; v < this.vertexHalfedge.length; v++) {
      if (this.vertexHalfedge[v] < NONE) continue;
      for (let k = 0; k < 3; k++) {
        const x = (positions[3 * v + k] - centre[k]) * scale;
        if (Number.isFinite(x)) this.points[3 * v + k] = x;
      }
    }
  }

  /** That of the surface before with these points, if they fit: what has not changed is not uploaded again. */
  #sharedPosition(earlier?: Surface): BufferAttribute {
    if (!earlier || earlier.#room.length !== this.#room.length) {
      return new BufferAttribute(this.#room, 3).setUsage(DynamicDrawUsage);
    }
    const { position } = earlier;
    position.array = this.#room;
    position.needsUpdate = true;
    if (this.change === null) {
      position.clearUpdateRanges(); // all of it, then
      return position;
    }
    const changed = new Set(this.change.after.flatMap((t) => [...this.#cornersOf(t)]));
    for (const v of changed) position.addUpdateRange(3 * v, 3);
    return position;
  }

  #cornersOf(triangle: number): Uint32Array {
    return this.triangles.subarray(3 * triangle, 3 * triangle + 3);
  }
}

interface Bounds {
  readonly centre: readonly number[];
  readonly scale: number;
}

/** The middle of the bounding box, and the scale that makes everything fit into the unit sphere. */
function bounds(positions: Float32Array): Bounds {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i += 3) {
    for (let k = 0; k < 3; k++) {
      const x = positions[i + k];
      if (!Number.isFinite(x)) continue;
      if (x < low[k]) low[k] = x;
      if (x > high[k]) high[k] = x;
    }
  }
  const centre = low.map((x, k) => (Number.isFinite(x) ? (x + high[k]) / 2 : 0));
  const [cx, cy, cz] = centre;
  let squared = 0;
  for (let i = 0; i < positions.length; i += 3) {
    const [x, y, z] = [positions[i] - cx, positions[i + 1] - cy, positions[i + 2] - cz];
    const r = x * x + y * y + z * z;
    if (r > squared && Number.isFinite(r)) squared = r;
  }
  return { centre, scale: squared > 0 ? 1 / Math.sqrt(squared) : 1 };
}

function triangulate(
  mesh: HalfedgeMesh,
  points: Float32Array,
): { triangles: Uint32Array; faceOf: Uint32Array } {
  const { next, toVertex, faceHalfedge } = mesh.connectivity;
  // A face of degree n is n - 2 triangles, and the degrees add up to at most the halfedges.
  const most = Math.max(0, mesh.halfedgeCount - 2 * mesh.faceCount);
  const triangles = new Uint32Array(3 * most);
  const faceOf = new Uint32Array(most);
  let count = 0;
  for (const f of mesh.faces()) {
    const a = faceHalfedge[f];
    const b = next[a];
    const c = next[b];
    if (next[c] === a) {
      triangles[3 * count] = toVertex[a];
      triangles[3 * count + 1] = toVertex[b];
      triangles[3 * count + 2] = toVertex[c];
      faceOf[count++] = f;
      continue;
    }
    const pieces = triangulateFace(mesh, points, f);
    triangles.set(pieces, 3 * count);
    faceOf.fill(f, count, count + pieces.length / 3);
    count += pieces.length / 3;
  }
  return { triangles: triangles.slice(0, 3 * count), faceOf: faceOf.slice(0, count) };
}

function triangulateFace(mesh: HalfedgeMesh, points: Float32Array, face: number): number[] {
  return triangulateRing([...mesh.faceVertices(face)], points);
}

/** The triangles of a polygon: ear clipping in its plane; a fan where it has no area. */
export function triangulateRing(ring: number[], points: Float32Array): number[] {
  if (ring.length === 3) return ring;
  const corners = ring.flatMap((v) => [points[3 * v], points[3 * v + 1], points[3 * v + 2]]);
  const normal = newellNormal(corners, ring.length, new Float64Array(3));
  const flat = flatten(corners, normal);
  const pieces = ShapeUtils.triangulateShape(flat, []);
  if (pieces.length === ring.length - 2) return pieces.flat().map((i) => ring[i]);
  return ring.slice(2).flatMap((v, i) => [ring[0], ring[i + 1], v]);
}

/** The points seen along the normal, counter-clockwise where the face is. */
function flatten(corners: readonly number[], normal: Float64Array): Vector2[] {
  const [x, y, z] = normal;
  // A unit vector across the normal (Duff et al., "Building an Orthonormal Basis, Revisited").
  const sign = z >= 0 ? 1 : -1;
  const a = -1 / (sign + z);
  const b = x * y * a;
  const u = [1 + sign * x * x * a, sign * b, -sign * x];
  const v = [b, sign + y * y * a, -y];
  const flat: Vector2[] = [];
  for (let i = 0; i < corners.length; i += 3) {
    const dot = (w: readonly number[]) =>
      w[0] * corners[i] + w[1] * corners[i + 1] + w[2] * corners[i + 2];
    flat.push(new Vector2(dot(u), dot(v)));
  }
  return flat;
}

/** The median over a sample of the edges: enough to tell what is worth drawing. */
function medianEdge(mesh: HalfedgeMesh, points: Float32Array): number {
  const { toVertex } = mesh.connectivity;
  const lengths: number[] = [];
  const stride = 2 * Math.max(1, Math.floor(toVertex.length / 2 / 1000));
  for (let h = 0; h + 1 < toVertex.length; h += stride) {
    const [a, b] = [3 * toVertex[h], 3 * toVertex[h + 1]];
    if (a < 0 || b < 0) continue;
    lengths.push(
      Math.hypot(
        points[a] - points[b],
        points[a + 1] - points[b + 1],
        points[a + 2] - points[b + 2],
      ),
    );
  }
  lengths.sort((p, q) => p - q);
  return lengths[lengths.length >> 1] ?? 0;
}
