import { writeVertexNormal } from '../measures.js';
import { eachOutgoing, GeometryRows, isMoreThanAll, isMost } from './geometry-rows.js';
import { ItemSet } from './item-set.js';
import { roomFor } from './rows.js';
import type { Placement } from './triangle-index.js';
import type { FaceTriangles } from './triangulate.js';

/** Rows that are the vertices of the mesh, slot by slot: for an indexed geometry. */
export class VertexRows extends GeometryRows {
  readonly #stale = new ItemSet();

  override get points(): Float32Array {
    return this.position.array as Float32Array;
  }

  override fill(): void {
    const { mesh } = this;
    this.#reserveVertices();
    this.points.set(mesh.positions);
    if (this.normal) mesh.allVertexNormals(this.normal.array as Float32Array);
    for (const { buffer, values } of this.columns()) buffer.array.set(values);
  }

  override writeVertices(vertices: readonly number[], faces: ItemSet): number[] {
    this.#reserveVertices();
    const { next, face, vertexHalfedge } = this.mesh.connectivity;
    const { positions } = this.mesh;
    const columns = this.columns();
    const moved: number[] = [];
    for (const v of vertices) {
      for (const { buffer, values } of columns) buffer.write(v, values, v * buffer.components);
      if (!this.position.write(v, positions, 3 * v)) continue;
      if (vertexHalfedge[v] >= -1) moved.push(v);
      // Polygons may have to be cut in another way now; triangles stay as they are.
      eachOutgoing(next, vertexHalfedge[v], (h) => {
        if (next[next[next[h]]] !== h) faces.add(face[h]);
      });
    }
    return moved;
  }

  override writeTriangles(
    _faces: readonly number[],
    _triangles: FaceTriangles,
    { vertices }: Placement,
    moved: readonly number[],
  ): void {
    if (this.normal === undefined) return;
    const { items } = this.#stale;
    const surface = isMost(moved, this.mesh) ? null : this.findStale(vertices, moved, this.#stale);
    if (surface === null || isMoreThanAll(items, surface)) {
      const normals = this.allNormals();
      for (const v of this.mesh.vertices()) this.normal.write(v, normals, 3 * v);
      return;
    }
    for (const v of items) {
      writeVertexNormal(surface, v, normal, 0);
      this.normal.write(v, normal, 0);
    }
  }

  #reserveVertices(): void {
    const { vertexSlots } = this.mesh;
    if (3 * vertexSlots > this.points.length) this.reserve(roomFor(vertexSlots));
  }
}

const normal = new Float32Array(3);
