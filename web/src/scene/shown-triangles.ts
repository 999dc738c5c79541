import type { BufferAttribute } from 'three';
import type { HalfedgeMesh } from '../mesh.js';
import { TriangleIndex } from '../three/triangle-index.js';
import { triangulateFaces } from '../three/triangulate.js';

/** The triangles that faces are drawn as, in an index where each face keeps its place: edits upload what they change. */
export class ShownTriangles {
  readonly #index = new TriangleIndex();
  /** The vertices of faces that are not to be seen. */
  readonly #hidden = new Map<number, Uint32Array>();
  #isInOrder = true;

  constructor(mesh: HalfedgeMesh) {
    this.fill(mesh);
  }

  /** Another one, when there was not room enough. */
  get index(): BufferAttribute {
    return this.#index.buffer.attribute;
  }

  /** How many triangles are to be drawn; some of them show nothing. */
  get count(): number {
    return this.#index.slots.end;
  }

  /** Whether more of them show nothing than is worth while. */
  get isWasteful(): boolean {
    return this.#index.slots.isWasteful;
  }

  /** The faces from here on have none. */
  get faces(): number {
    return this.#index.slots.faces;
  }

  /** Three vertices for each triangle of a face, hidden or not. */
  verticesOf(face: number): Uint32Array {
    return this.#hidden.get(face) ?? this.#index.verticesOf(face);
  }

  /** All faces anew, in their order. */
  fill(mesh: HalfedgeMesh): void {
    this.#hidden.clear();
    this.#index.fill(mesh, triangulateFaces(mesh));
    this.#index.buffer.forget();
    this.index.needsUpdate = true;
    this.#isInOrder = true;
  }

  /** Takes up faces that are others now, came or went. None is hidden then. */
  place(mesh: HalfedgeMesh, faces: readonly number[]): void {
    this.hide(NONE);
    this.#index.place(mesh, faces, triangulateFaces(mesh, faces));
    this.#index.buffer.mark();
    this.#isInOrder = false;
  }

  /** Shows all faces but these. */
  hide(faces: ReadonlySet<number>): void {
    const { buffer } = this.#index;
    for (const [face, vertices] of this.#hidden) {
      if (faces.has(face)) continue;
      const first = this.#index.slots.first(face);
      for (let i = 0; i < vertices.length; i += 3) buffer.write(first + i / 3, vertices, i);
      this.#hidden.delete(face);
    }
    for (const face of faces) {
      if (this.#hidden.has(face)) continue;
      const vertices = this.#index.verticesOf(face).slice();
      const first = this.#index.slots.first(face);
      for (let t = 0; t < vertices.length / 3; t++) buffer.write(first + t, NOTHING, 0);
      this.#hidden.set(face, vertices);
    }
    buffer.mark();
  }

  /** All triangles in the order of their faces, as copies: their vertices, and the face of each. */
  inOrder(mesh: HalfedgeMesh): { vertices: Uint32Array; faces: Uint32Array } {
    if (!this.#isInOrder || this.#hidden.size > 0) return new ShownTriangles(mesh).inOrder(mesh);
    return {
      vertices: (this.#index.buffer.array as Uint32Array).slice(0, 3 * this.count),
      faces: Uint32Array.from(this.#index.slots.faceOf.subarray(0, this.count)),
    };
  }
}

const NONE: ReadonlySet<number> = new Set();
const NOTHING = [0, 0, 0];
