import { ARROW_FLOATS, ArrowRows, type ArrowSizes, rowLength } from '../three/index.js';
import { roomFor } from '../three/rows.js';
import type { Surface } from './surface.js';

/** With more numbers than this, the rows of faces that are no longer looked at are given up. */
const MOST = 1_000_000;

/**
 * Places the arrows of faces. What they depend on besides their sizes is measured when a face is first asked for, and
 * kept until its corners have changed.
 */
export class FaceRows {
  readonly #surface: Surface;
  readonly #rows = new ArrowRows();
  /** By face: where its row is; 0 if it has none. */
  #at: Int32Array;
  /** The faces that have one. */
  #faces: number[] = [];
  #end = 1;
  readonly #corners: number[] = [];
  /** The arrows that were placed last. */
  arrows = new Float32Array(0);

  constructor(surface: Surface) {
    this.#surface = surface;
    this.#at = new Int32Array(surface.mesh.faceSlots);
  }

  /** Writes the arrows of a face to `arrows`. Returns how many they are. */
  place(face: number, sizes: ArrowSizes): number {
    const known = this.#at[face];
    return this.#rows.place(known > 0 ? known : this.#measure(face), sizes, this.arrows, 0);
  }

  /** Measures some faces anew when they are next asked for, because they have changed; all of them for null. */
  forget(faces: Iterable<number> | null): void {
    const { faceSlots } = this.#surface.mesh;
    if (faceSlots > this.#at.length) {
      const known = this.#at;
      this.#at = new Int32Array(roomFor(faceSlots));
      this.#at.set(known);
    }
    for (const face of faces ?? this.#faces) this.#at[face] = 0;
    if (faces !== null) return;
    this.#faces = [];
    this.#end = 1;
  }

  #measure(face: number): number {
    if (this.#end > MOST) this.forget(null);
    const degree = this.#surface.corners(face, this.#corners);
    const at = this.#end;
    this.#rows.measureFace(at, this.#corners, degree);
    this.#end += rowLength(degree);
    this.#at[face] = at;
    this.#faces.push(face);
    if (degree * ARROW_FLOATS > this.arrows.length) {
      this.arrows = new Float32Array(2 * degree * ARROW_FLOATS);
    }
    return at;
  }
}
