import { newArray } from '../arguments.js';
import type { HalfedgeMesh } from '../mesh.js';
import { RowBuffer, roomFor } from './rows.js';
import { FaceSlots } from './slots.js';
import type { FaceTriangles } from './triangulate.js';

/** What has become of triangles. */
export interface Placement {
  /** The faces that have other triangles than before, came or went. */
  readonly faces: number[];
  /** The vertices that their triangles had, and those that they have; some several times. */
  readonly vertices: number[];
  /** The places given up, which others may have taken since. */
  readonly freed: { readonly first: number; readonly count: number }[];
}

/** The triangles that show the faces of a mesh, as vertices: those of each face lie in one place. */
export class TriangleIndex {
  /** Three vertices a triangle; those of triangles that show nothing are all 0. */
  readonly buffer = new RowBuffer(new Uint32Array(0), 3, false, 1);
  #slots = new FaceSlots(0);

  /** Where the triangles of each face are. */
  get slots(): Pick<FaceSlots, 'first' | 'count' | 'faceOf' | 'end' | 'faces' | 'isWasteful'> {
    return this.#slots;
  }

  /** For so many triangles there is room. */
  get capacity(): number {
    return this.#slots.capacity;
  }

  /** Whether there are fewer faces than before: those beyond may still be shown. */
  hasLostFaces({ faceSlots }: HalfedgeMesh): boolean {
    return faceSlots < this.#slots.faces;
  }

  /** The vertices of the triangles of a face, three each, as they were placed. */
  verticesOf(face: number): Uint32Array {
    const first = this.#slots.first(face);
    if (first < 0) return new Uint32Array(0);
    return (this.buffer.array as Uint32Array).subarray(
      3 * first,
      3 * (first + this.#slots.count(face)),
    );
  }

  /** Calls `use` with each corner of each triangle, counted as they are placed, and with its vertex. */
  eachCorner(use: (corner: number, vertex: number) => void): void {
    const slots = this.#slots;
    const { array } = this.buffer;
    for (let face = 0; face < slots.faces; face++) {
      const from = 3 * slots.first(face);
      for (let i = from; i < from + 3 * slots.count(face); i++) use(i, array[i]);
    }
  }

  /** All triangles in the order of their faces, as copies: their vertices, and the face of each. */
  inOrder(): { vertices: Uint32Array; faces: Uint32Array } {
    const slots = this.#slots;
    let triangles = 0;
    for (let face = 0; face < slots.faces; face++) triangles += slots.count(face);
    const vertices = newArray('the triangles', Uint32Array, 3 * triangles);
    const faces = newArray('the triangles', Uint32Array, triangles);
    const array = this.buffer.array as Uint32Array;
    let to = 0;
    for (let face = 0; face < slots.faces; face++) {
      const count = slots.count(face);
      const from = 3 * slots.first(face);
      for (let i = 0; i < 3 * count; i++) vertices[3 * to + i] = array[from + i];
      faces.fill(face, to, to + count);
      to += count;
    }
    return { vertices, faces };
  }

  /** These triangles and no others, side by side. */
  fill(mesh: HalfedgeMesh, { halfedges, faces }: FaceTriangles): void {
    this.#slots = new FaceSlots(roomFor(faces.length));
    this.#slots.assign(faces, mesh.faceSlots);
    this.buffer.reserve(this.#slots.capacity);
    const { toVertex } = mesh.connectivity;
    const array = this.buffer.array as Uint32Array;
    for (let i = 0; i < halfedges.length; i++) array[i] = toVertex[halfedges[i]];
    // Many who read a geometry, exporters among them, take all that is there for drawn.
    array.fill(0, halfedges.length);
  }

  /** Gives these faces their triangles, which come in the same order. */
  place(
    mesh: HalfedgeMesh,
    faces: readonly number[],
    { halfedges, faces: faceOf }: FaceTriangles,
  ): Placement {
    const { toVertex } = mesh.connectivity;
    const slots = this.#slots;
    const placement: Placement = { faces: [], vertices: [], freed: [] };
    const homeless: { face: number; from: number; count: number }[] = [];
    let from = 0;
    for (const face of faces) {
      let to = from;
      while (faceOf[to] === face) to += 1;
      const count = to - from;
      if (count === slots.count(face)) {
        this.#rewrite(face, halfedges, from, toVertex, placement);
      } else {
        // All that is freed comes first, so that what is new can take it.
        this.#free(face, placement);
        if (count > 0) homeless.push({ face, from, count });
      }
      from = to;
    }
    for (let face = mesh.faceSlots; face < slots.faces; face++) {
      if (slots.count(face) > 0) this.#free(face, placement);
    }
    slots.resize(mesh.faceSlots);
    for (const { face, count } of homeless) slots.take(face, count);
    this.buffer.reserve(slots.capacity);
    for (const { face, from: at, count } of homeless) {
      const first = slots.first(face);
      for (let i = 0; i < count; i++) {
        readCorners(halfedges, at + i, toVertex);
        this.buffer.write(first + i, corners, 0);
        placement.vertices.push(...corners);
      }
    }
    return placement;
  }

  /** Writes as many triangles as a face has already. */
  #rewrite(
    face: number,
    halfedges: Uint32Array,
    from: number,
    toVertex: Int32Array,
    { faces, vertices }: Placement,
  ): void {
    const { array } = this.buffer;
    const [first, count] = [this.#slots.first(face), this.#slots.count(face)];
    const known = vertices.length;
    let isOther = false;
    for (let i = 0; i < count; i++) {
      const row = 3 * (first + i);
      readCorners(halfedges, from + i, toVertex);
      vertices.push(array[row], array[row + 1], array[row + 2], ...corners);
      if (this.buffer.write(first + i, corners, 0)) isOther = true;
    }
    // With one of its triangles the whole face has another normal.
    if (isOther) faces.push(face);
    else vertices.length = known;
  }

  #free(face: number, { faces, vertices, freed }: Placement): void {
    faces.push(face);
    const [first, count] = [this.#slots.first(face), this.#slots.count(face)];
    if (count === 0) return;
    freed.push({ first, count });
    for (let t = first; t < first + count; t++) {
      for (let k = 0; k < 3; k++) vertices.push(this.buffer.array[3 * t + k]);
      this.buffer.write(t, NOTHING, 0);
    }
    this.#slots.release(face);
  }
}

const NOTHING = [0, 0, 0];
const corners = [0, 0, 0];

function readCorners(halfedges: Uint32Array, triangle: number, toVertex: Int32Array): void {
  for (let k = 0; k < 3; k++) corners[k] = toVertex[halfedges[3 * triangle + k]];
}
