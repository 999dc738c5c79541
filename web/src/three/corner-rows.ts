import { newArray } from '../arguments.js';
import { type Surface, writeFaceNormal, writeVertexNormal } from '../measures.js';
import {
  eachOutgoing,
  GeometryRows,
  isMoreThanAll,
  isMost,
  type ShownColumn,
  type ShownRows,
} from './geometry-rows.js';
import { ItemSet } from './item-set.js';
import { surfaceOf } from './normals.js';
import { roomFor } from './rows.js';
import type { Placement, TriangleIndex } from './triangle-index.js';
import type { FaceTriangles } from './triangulate.js';

/** Rows that are corners of triangles, three for each: where normals or attributes have seams. */
export class CornerRows extends GeometryRows {
  /** By vertex, where its rows say that it is. */
  #points = new Float32Array(0);
  readonly #isFlat: boolean;
  readonly #stale = new ItemSet();

  constructor(shown: ShownRows, triangles: TriangleIndex, isFlat: boolean) {
    super(shown, triangles);
    this.#isFlat = isFlat;
  }

  override get points(): Float32Array {
    return this.#points;
  }

  override fill({ halfedges, faces }: FaceTriangles): void {
    this.#reserveVertices();
    this.#points.set(this.mesh.positions);
    this.reserve(3 * this.triangles.capacity);
    const surface = surfaceOf(this.mesh);
    const { toVertex, positions } = surface;
    const position = this.position.array;
    const smooth = this.normal && !this.#isFlat ? this.mesh.allVertexNormals() : undefined;
    const normals = this.normal?.array;
    position.fill(0, 3 * halfedges.length); // as in the index: no triangle that has an area
    for (let row = 0; row < halfedges.length; row++) {
      const from = 3 * toVertex[halfedges[row]];
      const to = 3 * row;
      position[to] = positions[from];
      position[to + 1] = positions[from + 1];
      position[to + 2] = positions[from + 2];
      if (normals === undefined) continue;
      if (smooth === undefined && row % 3 === 0 && faces[row / 3] !== faces[row / 3 - 1])
        this.#faceNormal(surface, faces, row / 3);
      const source = smooth ?? normal;
      const at = smooth ? from : 0;
      normals[to] = source[at];
      normals[to + 1] = source[at + 1];
      normals[to + 2] = source[at + 2];
    }
    for (const column of this.columns()) fillColumn(column, halfedges, toVertex);
  }

  override writeVertices(vertices: readonly number[], faces: ItemSet): number[] {
    this.#reserveVertices();
    const { next, face, vertexHalfedge } = this.mesh.connectivity;
    const { positions } = this.mesh;
    const points = this.#points;
    const moved: number[] = [];
    for (const v of vertices) {
      let hasMoved = false;
      for (let k = 3 * v; k < 3 * v + 3; k++) {
        if (Object.is(points[k], positions[k])) continue;
        points[k] = positions[k];
        hasMoved = true;
      }
      if (hasMoved && vertexHalfedge[v] >= -1) moved.push(v);
    }
    if (isMost(vertices, this.mesh)) {
      // All, in the order in which they lie: that is several times as fast.
      for (let f = 0; f < this.mesh.faceSlots; f++) faces.add(f);
    } else {
      for (const v of vertices) eachOutgoing(next, vertexHalfedge[v], (h) => faces.add(face[h]));
    }
    return moved;
  }

  override writeTriangles(
    faces: readonly number[],
    { halfedges, faces: faceOf }: FaceTriangles,
    { vertices, freed }: Placement,
    moved: readonly number[],
  ): void {
    this.reserve(3 * this.triangles.capacity);
    for (const { first, count } of freed) {
      for (let row = 3 * first; row < 3 * (first + count); row++)
        this.position.write(row, NOWHERE, 0);
    }
    const surface = surfaceOf(this.mesh);
    const { toVertex, positions } = surface;
    const columns = this.columns();
    const { slots } = this.triangles;
    let at = 0;
    for (const face of faces) {
      const first = 3 * slots.first(face);
      const rows = 3 * slots.count(face);
      if (rows > 0 && this.#isFlat) this.#faceNormal(surface, faceOf, at / 3);
      for (let row = first; row < first + rows; row++, at++) {
        const h = halfedges[at];
        this.position.write(row, positions, 3 * toVertex[h]);
        for (const { buffer, isOfVertices, values } of columns)
          buffer.write(row, values, buffer.components * (isOfVertices ? toVertex[h] : h));
        if (this.#isFlat) this.normal?.write(row, normal, 0);
      }
    }
    if (!this.#isFlat) this.#writeSmoothNormals(vertices, moved);
  }

  #writeSmoothNormals(vertices: readonly number[], moved: readonly number[]): void {
    if (this.normal === undefined) return;
    const { items } = this.#stale;
    const surface = isMost(moved, this.mesh) ? null : this.findStale(vertices, moved, this.#stale);
    if (surface === null || isMoreThanAll(items, surface)) {
      const normals = this.allNormals();
      const { slots, buffer } = this.triangles;
      for (let row = 0; row < 3 * slots.end; row++) {
        if (slots.faceOf[Math.floor(row / 3)] >= 0)
          this.normal.write(row, normals, 3 * buffer.array[row]);
      }
      return;
    }
    const { next, face, vertexHalfedge } = surface;
    for (const v of items) {
      writeVertexNormal(surface, v, normal, 0);
      eachOutgoing(next, vertexHalfedge[v], (h) => this.#writeNormalAt(v, face[h]));
    }
  }

  /** Writes the normal into those corners of a face that are at a vertex. */
  #writeNormalAt(v: number, face: number): void {
    if (face < 0) return;
    const { slots, buffer } = this.triangles;
    const first = 3 * slots.first(face);
    const end = first + 3 * slots.count(face);
    for (let row = first; row < end; row++) {
      if (buffer.array[row] === v) this.normal?.write(row, normal, 0);
    }
  }

  /** Puts the normal of the face of a triangle into `normal`. */
  #faceNormal(surface: Surface, faceOf: Uint32Array, triangle: number): void {
    writeFaceNormal(surface, faceOf[triangle], normal, 0);
  }

  #reserveVertices(): void {
    const known = this.#points.length;
    if (3 * this.mesh.vertexSlots <= known) return;
    const grown = newArray('the vertices', Float32Array, 3 * roomFor(this.mesh.vertexSlots));
    grown.fill(Number.NaN, known).set(this.#points);
    this.#points = grown;
  }
}

const NOWHERE = [0, 0, 0];
const normal = new Float32Array(3);

function fillColumn(
  { buffer: { array, components }, isOfVertices, values }: ShownColumn,
  halfedges: Uint32Array,
  toVertex: Int32Array,
): void {
  for (let row = 0; row < halfedges.length; row++) {
    const h = halfedges[row];
    const from = components * (isOfVertices ? toVertex[h] : h);
    for (let k = 0; k < components; k++) array[row * components + k] = values[from + k];
  }
}
