import { Box3, BufferGeometry, Sphere, Vector3 } from 'three';
import { checkOptions, newArray } from '../arguments.js';
import type { AttributeInfo, AttributeView } from '../attributes.js';
import type { HalfedgeMesh } from '../mesh.js';
import { linksOf } from '../navigation.js';
import {
  checkMesh,
  checkNormals,
  type GeometryOptions,
  isNormalized,
  shownAttributes,
  valuesOf,
} from './columns.js';
import { Digest } from './digest.js';
import {
  type Shape,
  shapeOf,
  vertexNormals,
  writeFaceNormal,
  writeVertexNormal,
} from './normals.js';
import { RowBuffer } from './rows.js';
import { TriangleSlots } from './slots.js';
import { type FaceTriangles, triangulateFaces } from './triangulate.js';

/** What an update has found. */
export interface GeometryUpdate {
  /** Faces that have other corners than before, came or went. */
  readonly faces: number;
  /** Bytes that three.js will upload because of it. */
  readonly bytes: number;
}

/** Room for so much more than there is, so that few edits need new buffers. */
const SLACK = 1.125;

/** An attribute of the mesh that is shown, and where. */
interface Shown {
  readonly info: AttributeInfo;
  readonly buffer: RowBuffer;
  readonly digest: Digest;
}

/** An attribute as it lies in memory, until something allocates. */
interface ShownColumn {
  readonly buffer: RowBuffer;
  readonly isOfVertices: boolean;
  readonly values: AttributeView;
}

/** Items found to be changed, once each. */
class Found {
  readonly items: number[] = [];
  #isIn: Uint8Array;

  constructor(slots: number) {
    this.#isIn = new Uint8Array(slots);
  }

  add(item: number): void {
    if (!(item >= 0) || this.#isIn[item] === 1) return;
    this.#isIn[item] = 1;
    this.items.push(item);
  }
}

/**
 * A geometry of three.js that stays in step with a mesh. After any edits, undo and redo, `compact()`, or
 * writing into `mesh.positions` or an attribute that it shows, call `update()`: only what has changed is
 * written, and marked for upload.
 *
 * ```ts
 * const geometry = new MeshGeometry(mesh);
 * scene.add(new Mesh(geometry, material));
 * mesh.flipEdge(e);
 * geometry.update(); // { faces: 2, bytes: 84 }
 * ```
 *
 * Without attributes of halfedges and with smooth normals it is indexed, and vertex v of it is vertex v of the
 * mesh. Otherwise each triangle has three vertices of its own. Its buffers are longer than what they hold, so
 * that they can grow: the draw range tells how far they are used. Triangles that show nothing have no area.
 * Groups and morph targets are not shown: see `toBufferGeometry`. The attributes are those that the mesh had
 * when the geometry was made.
 *
 * To find what has changed, `update` makes a digest of the links, positions and attributes shown: of a
 * million triangles that alone takes some 5 ms. It keeps no copy of the links.
 */
export class MeshGeometry extends BufferGeometry {
  override readonly type = 'MeshGeometry' as 'BufferGeometry';
  readonly mesh: HalfedgeMesh;
  readonly #options: GeometryOptions;
  readonly #isIndexed: boolean;
  readonly #digests = {
    next: new Digest(),
    toVertex: new Digest(),
    faceHalfedge: new Digest(),
    positions: new Digest(),
  };
  readonly #shown: Shown[];
  #slots = new TriangleSlots(0);
  /** The index, with three vertices for each triangle; not drawn from unless it is indexed. */
  #index = new RowBuffer(new Uint32Array(0), 3, false, 1);
  #position = new RowBuffer(new Float32Array(0), 3);
  #normal: RowBuffer | undefined;
  /** By vertex: computed normals, where they are smooth and the mesh has none. */
  #smooth: Float32Array | undefined;
  /** By vertex, where they are: what their rows are compared with. */
  #points = new Float32Array(0);
  #resized = false;

  /**
   * @throws TypeError or RangeError for wrong options; HalfedgeError `out-of-memory`
   */
  constructor(mesh: HalfedgeMesh, options: GeometryOptions = {}) {
    super();
    checkOptions(options);
    this.mesh = checkMesh(mesh);
    const normals = checkNormals(options.normals);
    this.#options = { ...options };
    const infos = shownAttributes(mesh, options);
    const hasNormals = infos.some(({ name }) => name === 'normal');
    const isFlat = normals === 'flat';
    this.#isIndexed = !isFlat && infos.every(({ kind }) => kind === 'vertex');
    this.#shown = infos.map((info) => {
      const Kind = valuesOf(mesh, info).constructor as Float32ArrayConstructor;
      const buffer = new RowBuffer(new Kind(0), info.components, isNormalized(info));
      return { info, buffer, digest: new Digest() };
    });
    if (normals !== 'none' && !hasNormals) {
      this.#normal = new RowBuffer(new Float32Array(0), 3);
      if (!isFlat) this.#smooth = new Float32Array(0);
    }
    this.#rebuild();
  }

  /** The face that a triangle shows, such as the `faceIndex` of an intersection; -1 for one that shows none. */
  face(triangle: number): number {
    return this.#slots.faceOf[triangle] ?? -1;
  }

  /** The triangles that show a face: the first of them, and how many. None is 0. */
  triangles(face: number): { first: number; count: number } {
    return { first: this.#slots.first(face), count: this.#slots.count(face) };
  }

  /**
   * Takes up what has changed in the mesh since the last time.
   *
   * @throws HalfedgeError `disposed`, `out-of-memory`
   */
  update(): GeometryUpdate {
    const mesh = checkMesh(this.mesh);
    const { faces, vertices } = this.#find(mesh);
    if (faces.items.length === 0 && vertices.items.length === 0 && !this.#hasLostFaces)
      return { faces: 0, bytes: 0 };
    this.#reserveVertices(mesh.vertexSlots);
    const moved = this.#move(mesh, vertices, faces);
    const triangles = triangulateFaces(mesh, faces.items); // which can detach views
    const written = this.#place(faces.items, triangles);
    this.#recompute(moved, written.corners);
    this.#writeRows(triangles, faces.items);
    if (this.#slots.isWasteful) {
      this.#rebuild();
      return { faces: written.faces, bytes: this.#size() };
    }
    this.setDrawRange(0, 3 * this.#slots.end);
    if (this.#resized) {
      this.#attach();
      return { faces: written.faces, bytes: this.#size() };
    }
    let bytes = 0;
    for (const buffer of this.#buffers()) bytes += buffer.mark();
    return { faces: written.faces, bytes };
  }

  /** The bounds of the live vertices: the buffers hold others, too. */
  override computeBoundingBox(): void {
    this.boundingBox ??= new Box3();
    const box = this.boundingBox;
    box.makeEmpty();
    this.#eachPoint((at) => box.expandByPoint(at));
  }

  /** A sphere around the live vertices. */
  override computeBoundingSphere(): void {
    this.boundingSphere ??= new Sphere();
    const sphere = this.boundingSphere;
    const box = new Box3();
    this.#eachPoint((at) => box.expandByPoint(at));
    sphere.makeEmpty();
    if (box.isEmpty()) return;
    box.getCenter(sphere.center);
    let squared = 0;
    this.#eachPoint((at) => {
      squared = Math.max(squared, sphere.center.distanceToSquared(at));
    });
    sphere.radius = Math.sqrt(squared);
  }

  /** A geometry of its own for the same mesh. */
  override clone(): this {
    return new MeshGeometry(this.mesh, this.#options) as this;
  }

  #eachPoint(use: (at: Vector3) => void): void {
    const { positions } = this.mesh;
    const { vertexHalfedge } = this.mesh.connectivity;
    for (let v = 0; v < vertexHalfedge.length; v++) {
      if (vertexHalfedge[v] < -1) continue;
      point.fromArray(positions, 3 * v);
      if (Number.isFinite(point.x + point.y + point.z)) use(point);
    }
  }

  /** Those that are drawn. */
  #buffers(): RowBuffer[] {
    const buffers = [this.#position, ...this.#shown.map(({ buffer }) => buffer)];
    if (this.#normal) buffers.push(this.#normal);
    if (this.#isIndexed) buffers.push(this.#index);
    return buffers;
  }

  #size(): number {
    return this.#buffers().reduce((sum, { array }) => sum + array.byteLength, 0);
  }

  /** Gives three.js the buffers that are there now, to be uploaded whole; it frees those that it had. */
  #attach(): void {
    this.dispose();
    for (const buffer of this.#buffers()) buffer.forget();
    this.setAttribute('position', this.#position.attribute);
    if (this.#normal) this.setAttribute('normal', this.#normal.attribute);
    for (const { info, buffer } of this.#shown) this.setAttribute(info.name, buffer.attribute);
    if (this.#isIndexed) this.setIndex(this.#index.attribute);
    this.#resized = false;
  }

  /** Everything anew, without gaps. */
  #rebuild(): void {
    const { mesh } = this;
    this.#find(mesh); // so that all is known as it is now
    const triangles = triangulateFaces(mesh, mesh.faces());
    this.#slots = new TriangleSlots(Math.ceil(SLACK * triangles.faces.length) + 64);
    const vertices = new Found(mesh.vertexSlots);
    for (let v = 0; v < mesh.vertexSlots; v++) vertices.add(v);
    this.#reserveVertices(mesh.vertexSlots);
    if (this.#smooth) this.#smooth.set(vertexNormals(mesh));
    this.#move(mesh, vertices);
    const faces = mesh.faces().toArray();
    this.#place(faces, triangles);
    if (this.#isIndexed && this.#smooth) {
      for (const v of vertices.items) this.#normal?.write(v, this.#smooth, 3 * v);
    }
    this.#writeRows(triangles, faces);
    this.#resized = true;
    this.setDrawRange(0, 3 * this.#slots.end);
    this.#attach();
  }

  /** The faces and vertices at which something may have changed. */
  #find(mesh: HalfedgeMesh): { faces: Found; vertices: Found } {
    const { core } = linksOf(mesh);
    const { next, toVertex, face, faceHalfedge } = mesh.connectivity;
    const faces = new Found(Math.max(mesh.faceSlots, faceHalfedge.length));
    const vertices = new Found(mesh.vertexSlots);
    const facesOf = (from: number, to: number) => {
      for (let h = from; h < to; h++) if (next[h] >= 0) faces.add(face[h]);
    };
    const all = (found: Found) => (from: number, to: number) => {
      for (let item = from; item < to; item++) found.add(item);
    };
    this.#digests.next.update(core, next, facesOf);
    this.#digests.toVertex.update(core, toVertex, facesOf);
    this.#digests.faceHalfedge.update(core, faceHalfedge, all(faces));
    const rows =
      (found: (from: number, to: number) => void, components: number) =>
      (from: number, to: number) =>
        found(Math.floor(from / components), Math.ceil(to / components));
    this.#digests.positions.update(core, mesh.positions, rows(all(vertices), 3));
    for (const { info, digest } of this.#shown) {
      const found = info.kind === 'vertex' ? all(vertices) : facesOf;
      digest.update(core, mesh.attributes.get(info.kind, info.name), rows(found, info.components));
    }
    return { faces, vertices };
  }

  /** Whether there are fewer slots of faces than before: those beyond may still be shown. */
  get #hasLostFaces(): boolean {
    return this.mesh.faceSlots < this.#slots.faces;
  }

  /** Room for so many vertices. */
  #reserveVertices(slots: number): void {
    if (3 * slots > this.#points.length) {
      const room = 3 * (Math.ceil(SLACK * slots) + 64);
      const longer = (array: Float32Array) => {
        const grown = newArray('the vertices', Float32Array, room);
        grown.set(array);
        return grown;
      };
      this.#points = longer(this.#points).fill(Number.NaN, this.#points.length);
      if (this.#smooth) this.#smooth = longer(this.#smooth);
    }
    if (this.#isIndexed) this.#reserveRows(this.#points.length / 3);
  }

  #reserveRows(rows: number): void {
    const buffers = [this.#position, ...this.#shown.map(({ buffer }) => buffer)];
    if (this.#normal) buffers.push(this.#normal);
    for (const buffer of buffers) this.#resized = buffer.reserve(rows) || this.#resized;
  }

  /** Writes vertices that have changed; adds the faces that change with them. Returns those that moved. */
  #move(mesh: HalfedgeMesh, vertices: Found, faces?: Found): number[] {
    const { next, face, vertexHalfedge } = mesh.connectivity;
    const { positions } = mesh;
    const columns = this.#columns();
    const points = this.#points;
    const moved: number[] = [];
    for (const v of vertices.items) {
      let hasMoved = false;
      for (let k = 3 * v; k < 3 * v + 3; k++) {
        if (Object.is(points[k], positions[k])) continue;
        points[k] = positions[k];
        hasMoved = true;
      }
      if (hasMoved && vertexHalfedge[v] >= -1) moved.push(v);
      if (this.#isIndexed) {
        this.#position.write(v, positions, 3 * v);
        for (const { buffer, values } of columns) buffer.write(v, values, v * buffer.components);
      }
      if (this.#isIndexed && !hasMoved) continue;
      eachOutgoing(next, vertexHalfedge[v], (h) => faces?.add(face[h]));
    }
    this.#widenBounds(moved);
    return moved;
  }

  #widenBounds(moved: number[]): void {
    const { boundingBox, boundingSphere } = this;
    if (boundingBox === null && boundingSphere === null) return;
    for (const v of moved) {
      point.fromArray(this.#points, 3 * v);
      if (!Number.isFinite(point.x + point.y + point.z)) continue;
      boundingBox?.expandByPoint(point);
      boundingSphere?.expandByPoint(point);
    }
  }

  /** The attributes shown, as they lie in memory until something allocates. */
  #columns(): ShownColumn[] {
    return this.#shown.map(({ info, buffer }) => {
      const { kind, name } = info;
      return {
        buffer,
        isOfVertices: kind === 'vertex',
        values: this.mesh.attributes.get(kind, name),
      };
    });
  }

  /**
   * Finds a place for the triangles of these faces, which come in the same order. Returns how many faces
   * have others than before, and the vertices that those had and have.
   */
  #place(
    faces: readonly number[],
    { halfedges, faces: faceOf }: FaceTriangles,
  ): { faces: number; corners: number[] } {
    const { toVertex } = this.mesh.connectivity;
    const slots = this.#slots;
    const changed: { face: number; at: number; count: number }[] = [];
    const corners: number[] = [];
    let written = 0;
    let at = 0;
    const free = (face: number) => {
      this.#clear(slots.first(face), slots.count(face), corners);
      slots.release(face);
    };
    for (const face of faces) {
      const from = at;
      while (faceOf[at] === face) at += 1;
      const count = at - from;
      if (count === slots.count(face)) {
        if (this.#writeIndex(slots.first(face), halfedges, from, count, toVertex, corners))
          written += 1;
        continue;
      }
      // All that is freed comes first, so that what is new can take it.
      free(face);
      written += 1;
      if (count > 0) changed.push({ face, at: from, count });
    }
    const { faceSlots } = this.mesh;
    for (let face = faceSlots; face < slots.faces; face++) {
      if (slots.count(face) === 0) continue;
      free(face);
      written += 1;
    }
    slots.resize(faceSlots);
    for (const { face, count } of changed) slots.take(face, count);
    const isLonger = this.#index.reserve(slots.capacity);
    if (this.#isIndexed) this.#resized ||= isLonger;
    else this.#reserveRows(3 * slots.capacity);
    for (const { face, at: from, count } of changed) {
      this.#writeIndex(slots.first(face), halfedges, from, count, toVertex, corners);
    }
    return { faces: written, corners };
  }

  /** Makes triangles that show nothing, and adds the vertices that they had. */
  #clear(first: number, count: number, corners: number[]): void {
    for (let t = first; t < first + count; t++) {
      for (let k = 0; k < 3; k++) {
        corners.push(this.#index.array[3 * t + k]);
        if (!this.#isIndexed) this.#position.write(3 * t + k, NOWHERE, 0);
      }
      this.#index.write(t, NOWHERE, 0);
    }
  }

  /** Writes the vertices of triangles; if they are others, adds those that were and are there. */
  #writeIndex(
    first: number,
    halfedges: Uint32Array,
    from: number,
    count: number,
    toVertex: Int32Array,
    corners: number[],
  ): boolean {
    const { array } = this.#index;
    const known = corners.length;
    let isOther = false;
    for (let i = 0; i < count; i++) {
      const row = 3 * (first + i);
      for (let k = 0; k < 3; k++) triple[k] = toVertex[halfedges[3 * (from + i) + k]];
      corners.push(array[row], array[row + 1], array[row + 2], ...triple);
      if (this.#index.write(first + i, triple, 0)) isOther = true;
    }
    // With one of its triangles the whole face has another normal.
    if (!isOther) corners.length = known;
    return isOther;
  }

  /** Computes the normals around vertices that moved and at the corners of faces that changed. */
  #recompute(moved: readonly number[], corners: readonly number[]): void {
    const smooth = this.#smooth;
    if (smooth === undefined) return;
    const shape = shapeOf(this.mesh);
    const { next, toVertex, face, vertexHalfedge } = shape;
    const stale = new Found(vertexHalfedge.length);
    for (const v of corners) if (vertexHalfedge[v] >= -1) stale.add(v);
    for (const v of moved) {
      stale.add(v);
      eachOutgoing(next, vertexHalfedge[v], (h) => {
        stale.add(toVertex[h]);
        if (face[h] < 0) return;
        for (let g = next[h]; g !== h; g = next[g]) stale.add(toVertex[g]);
      });
    }
    for (const v of stale.items) {
      writeVertexNormal(shape, v, smooth, 3 * v);
      if (this.#isIndexed) this.#normal?.write(v, smooth, 3 * v);
      else eachOutgoing(next, vertexHalfedge[v], (h) => this.#writeNormalAt(v, face[h]));
    }
  }

  /** Writes the normal of a vertex into the corners of a face that are at it. */
  #writeNormalAt(v: number, face: number): void {
    if (face < 0) return;
    const first = 3 * this.#slots.first(face);
    const end = first + 3 * this.#slots.count(face);
    for (let row = first; row < end; row++) {
      if (this.#index.array[row] === v)
        this.#normal?.write(row, this.#smooth as Float32Array, 3 * v);
    }
  }

  /** Where triangles have vertices of their own, writes them. */
  #writeRows({ halfedges }: FaceTriangles, faces: readonly number[]): void {
    if (this.#isIndexed) return;
    const shape = shapeOf(this.mesh);
    const columns = this.#columns();
    let at = 0;
    for (const face of faces) {
      const first = this.#slots.first(face);
      const count = this.#slots.count(face);
      if (count > 0 && this.#normal && !this.#smooth) writeFaceNormal(shape, face, flat, 0);
      for (let i = 0; i < 3 * count; i++)
        this.#writeCorner(3 * first + i, halfedges[at++], shape, columns);
    }
    this.#index.forget();
  }

  #writeCorner(
    row: number,
    h: number,
    { toVertex, positions }: Shape,
    columns: readonly ShownColumn[],
  ): void {
    const v = toVertex[h];
    this.#position.write(row, positions, 3 * v);
    for (const { buffer, isOfVertices, values } of columns) {
      buffer.write(row, values, buffer.components * (isOfVertices ? v : h));
    }
    if (this.#smooth) this.#normal?.write(row, this.#smooth, 3 * v);
    else this.#normal?.write(row, flat, 0);
  }
}

const NOWHERE = [0, 0, 0];
const triple = [0, 0, 0];
const flat = new Float32Array(3);
const point = new Vector3();

function eachOutgoing(next: Int32Array, first: number, use: (h: number) => void): void {
  if (!(first >= 0)) return;
  let h = first;
  do {
    use(h);
    h = next[h ^ 1];
  } while (h !== first);
}
