import { Box3, BufferGeometry, Sphere } from 'three';
import type { AttributeInfo } from '../attributes.js';
import { refuse } from '../checks.js';
import { type Face, type FaceLike, NONE } from '../items.js';
import type { HalfedgeMesh } from '../mesh.js';
import { takeOptions } from '../options.js';
import { isMorph } from './attributes.js';
import { fitBox, fitSphere, widen } from './bounds.js';
import {
  checkMesh,
  checkNormals,
  checkShown,
  GEOMETRY_OPTIONS,
  type GeometryOptions,
  shownAttributes,
} from './columns.js';
import { CornerRows } from './corner-rows.js';
import { eachOutgoing, type GeometryRows } from './geometry-rows.js';
import { ItemSet } from './item-set.js';
import { MeshChanges } from './mesh-changes.js';
import type { RowBuffer } from './rows.js';
import { TriangleIndex } from './triangle-index.js';
import { triangulateFaces } from './triangulate.js';
import { VertexRows } from './vertex-rows.js';
import { toBufferGeometry } from './write.js';

/** What an update has found. */
export interface GeometryUpdate {
  /** Faces whose corners have changed, and faces that are new or gone. */
  readonly faces: number;
  /** Bytes that three.js will upload because of it. */
  readonly bytes: number;
}

/**
 * Called with the faces that look different, each once: with other corners, moved, new or gone. Null if that
 * may be all of them.
 */
export type ChangeListener = (faces: readonly number[] | null) => void;

/** Where the triangles of a geometry are, for the modules of this package. */
export let trianglesOf: (geometry: MeshGeometry) => TriangleIndex;

/**
 * A three.js geometry that stays in step with a mesh. After edits, undo and redo, `compact()`, or writing
 * into `mesh.positions` or into an attribute that it shows, call `update()`: only what has changed is written
 * and marked for upload.
 *
 * ```ts
 * const geometry = new MeshGeometry(mesh);
 * scene.add(new Mesh(geometry, material));
 * mesh.flipEdge(e);
 * geometry.update(); // { faces: 2, bytes: 84 }
 * ```
 *
 * Without halfedge attributes and with smooth normals, it is indexed, and its vertex v is vertex v of the
 * mesh. Otherwise each triangle has three vertices of its own. Its buffers are longer than their content, so
 * that they can grow; the draw range tells how far they are used. Unused triangles have no area. Exporters
 * would write them too, so pass them the result of `toBufferGeometry` instead. Nothing else may reorder the
 * triangles, as a MeshBVH that isn't `indirect` does. Groups and morph targets are not shown: see
 * `toBufferGeometry`. The attributes shown are those that the mesh had when the geometry was made, without those of
 * morph targets. Each renderer needs a
 * geometry of its own, as it does of helpers: what is to be uploaded is noted for one.
 *
 * To find what has changed, `update` makes a digest of the links, positions and attributes shown. For a
 * million triangles, that takes some 5 ms, or 1 ms if the links are unchanged. Beyond that, the cost depends
 * only on what has changed; to move all vertices takes about as long as making the geometry, or up to three
 * times as long where each triangle has its own.
 */
export class MeshGeometry extends BufferGeometry {
  override readonly type = 'MeshGeometry' as 'BufferGeometry';
  /** The mesh that it shows. */
  readonly mesh: HalfedgeMesh;
  readonly #options: GeometryOptions;
  readonly #shown: readonly AttributeInfo[];
  readonly #changes: MeshChanges;
  readonly #triangles = new TriangleIndex();
  readonly #rows: GeometryRows;
  readonly #listeners = new Set<ChangeListener>();
  /** Whether an update has failed halfway, such as for want of memory: the next one makes everything anew. */
  #isTorn = false;

  static {
    trianglesOf = (geometry) => geometry.#triangles;
  }

  /**
   * @throws TypeError or RangeError for wrong options; HalfedgeError `out-of-memory`
   */
  constructor(mesh: HalfedgeMesh, options: GeometryOptions = {}) {
    super();
    this.#options = takeOptions(options, GEOMETRY_OPTIONS);
    this.mesh = checkMesh(mesh);
    const way = checkNormals(options.normals);
    const named = options.attributes !== undefined;
    // Only morph targets could use them, which it doesn't have.
    const attributes = shownAttributes(mesh, options).filter(({ name }) => named || !isMorph(name));
    this.#shown = attributes;
    const normals = way !== 'none' && attributes.every(({ name }) => name !== 'normal');
    const isIndexed = way !== 'flat' && attributes.every(({ kind }) => kind === 'vertex');
    const shown = { mesh, attributes, normals };
    this.#changes = new MeshChanges(attributes);
    this.#rows = isIndexed
      ? new VertexRows(shown, this.#triangles)
      : new CornerRows(shown, this.#triangles, way === 'flat');
    this.#rebuild();
  }

  /**
   * The face that a triangle belongs to, such as the `faceIndex` of an intersection; -1 if it belongs to
   * none.
   */
  face(triangle: number | null | undefined): Face {
    return (this.#triangles.slots.faceOf[triangle ?? NONE] ?? NONE) as Face;
  }

  /** The triangles of a face: the first of them, and how many there are, or 0. */
  triangles(face: FaceLike): { first: number; count: number } {
    const { slots } = this.#triangles;
    return { first: slots.first(face), count: slots.count(face) };
  }

  /** The mesh vertices at the corners of the triangles of a face, three for each triangle. */
  triangleVertices(face: FaceLike): Uint32Array {
    return this.#triangles.verticesOf(face).slice();
  }

  /**
   * By vertex of the mesh: x, y, z where it is shown, as of the last update. The array is longer than that.
   */
  get points(): Float32Array {
    return this.#rows.points;
  }

  /**
   * Calls `listener` at each update that finds changes. Returns a function that stops this. What it throws, `update`
   * throws once all listeners were called.
   */
  onChange(listener: ChangeListener): () => void {
    if (typeof listener !== 'function') refuse('listener', listener, 'a function');
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /**
   * Applies what has changed in the mesh since the last update. Bounds that are there become as wide as the mesh,
   * but not narrower: for that, call `computeBoundingBox()` or `computeBoundingSphere()`.
   *
   * @throws HalfedgeError `disposed`, `out-of-memory`, `unsupported-attribute` (an attribute that it shows
   * was removed or replaced)
   */
  update(): GeometryUpdate {
    const mesh = checkMesh(this.mesh);
    checkShown(mesh, this.#shown);
    if (this.#isTorn) return this.#renew(mesh.faceCount);
    const { faces, vertices } = this.#changes;
    this.#isTorn = true; // unless all of the following is done
    this.#changes.find(mesh);
    const isLess = this.#triangles.hasLostFaces(mesh);
    if (faces.items.length === 0 && vertices.items.length === 0 && !isLess) {
      this.#isTorn = false;
      return UNCHANGED;
    }
    const moved = this.#rows.writeVertices(vertices.items, faces);
    const triangles = triangulateFaces(mesh, faces.items); // which can detach views
    const placement = this.#triangles.place(mesh, faces.items, triangles);
    const changed = placement.faces.length;
    if (this.#triangles.slots.isWasteful) return this.#renew(changed);
    this.#rows.writeTriangles(faces.items, triangles, placement, moved);
    // More than have moved: some may have come back to where they were.
    widen(this.boundingBox, mesh, vertices.items);
    widen(this.boundingSphere, mesh, vertices.items);
    const bytes = this.#show();
    this.#isTorn = false;
    if (this.#listeners.size > 0 && (changed > 0 || moved.length > 0))
      this.#tell(this.#lookDifferent(placement.faces, moved));
    return { faces: changed, bytes };
  }

  /**
   * The bounds of the live vertices: the buffers also hold others, which `Box3.setFromObject(object, true)` and the
   * bounds of a SkinnedMesh take in.
   */
  override computeBoundingBox(): void {
    this.boundingBox ??= new Box3();
    fitBox(this.mesh, this.boundingBox);
  }

  /** A sphere around the live vertices. */
  override computeBoundingSphere(): void {
    this.boundingSphere ??= new Sphere();
    fitSphere(this.mesh, new Box3(), this.boundingSphere);
  }

  /** A geometry of its own for the same mesh. */
  override clone(): this {
    const { name, userData } = this;
    return Object.assign(new MeshGeometry(this.mesh, this.#options), { name, userData }) as this;
  }

  /**
   * Always throws: the buffers of another geometry are not those of its mesh.
   *
   * @throws TypeError
   */
  override copy(_source: BufferGeometry): never {
    throw new TypeError(
      "A MeshGeometry can't copy another geometry, because it shows its own mesh; expected clone() or new MeshGeometry(mesh), or copy() of an ordinary BufferGeometry.",
    );
  }

  /** The mesh as it is now, as an ordinary geometry without gaps: three.js's loaders know no other kind. */
  override toJSON(): ReturnType<BufferGeometry['toJSON']> {
    const { geometry } = toBufferGeometry(this.mesh, { ...this.#options, groups: false });
    const { uuid, name, userData } = this;
    return Object.assign(geometry, { uuid, name, userData }).toJSON();
  }

  /** Makes everything anew, of which so many faces have changed. */
  #renew(faces: number): GeometryUpdate {
    this.#rebuild();
    if (this.boundingBox) this.computeBoundingBox();
    if (this.boundingSphere) this.computeBoundingSphere();
    this.#isTorn = false;
    this.#tell(null);
    return { faces, bytes: this.#size() };
  }

  /** Everything, without gaps. */
  #rebuild(): void {
    const { mesh } = this;
    this.#changes.skip(mesh);
    const triangles = triangulateFaces(mesh);
    this.#triangles.fill(mesh, triangles);
    this.#rows.fill(triangles);
    this.setDrawRange(0, 3 * this.#triangles.slots.end);
    this.#attach();
  }

  /** Marks what was written for upload; returns the bytes of it. */
  #show(): number {
    this.setDrawRange(0, 3 * this.#triangles.slots.end);
    const buffers = this.#buffers();
    const isOther = buffers.some(([name, { attribute }]) => this.#attached(name) !== attribute);
    if (!isOther) return buffers.reduce((bytes, [, buffer]) => bytes + buffer.mark(), 0);
    this.#attach();
    return this.#size();
  }

  /** Gives three.js the buffers that are there now, to be uploaded whole; it frees those that it had. */
  #attach(): void {
    this.dispose();
    for (const [name, buffer] of this.#buffers()) {
      buffer.forget();
      if (name === INDEX) this.setIndex(buffer.attribute);
      else this.setAttribute(name, buffer.attribute);
    }
  }

  #attached(name: string): unknown {
    return name === INDEX ? this.index : this.attributes[name];
  }

  /** Those that are drawn. */
  #buffers(): [name: string, buffer: RowBuffer][] {
    const { buffers } = this.#rows;
    if (this.#rows instanceof VertexRows) buffers.push([INDEX, this.#triangles.buffer]);
    else this.#triangles.buffer.forget();
    return buffers;
  }

  #size(): number {
    return this.#buffers().reduce((sum, [, { array }]) => sum + array.byteLength, 0);
  }

  /** Faces with other triangles, and those around vertices that have moved. */
  #lookDifferent(others: readonly number[], moved: readonly number[]): readonly number[] {
    const faces = new ItemSet();
    const { next, face, vertexHalfedge } = this.mesh.connectivity;
    faces.begin(this.#triangles.slots.faces);
    for (const f of others) faces.add(f);
    for (const v of moved) eachOutgoing(next, vertexHalfedge[v], (h) => faces.add(face[h]));
    return faces.items;
  }

  #tell(faces: readonly number[] | null): void {
    const errors: unknown[] = [];
    for (const listener of this.#listeners) {
      try {
        listener(faces);
      } catch (error) {
        errors.push(error);
      }
    }
    // Once all of them know: no later update would tell them of these faces.
    if (errors.length > 0) throw errors[0];
  }
}

const UNCHANGED: GeometryUpdate = { faces: 0, bytes: 0 };
/** The name of no attribute. */
const INDEX = '';
