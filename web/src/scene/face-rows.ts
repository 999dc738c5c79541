import { ArrowRows, rowLength } from '../three/index.js';
import { roomFor } from '../three/rows.js';
import type { Surface } from './surface.js';

/** With more numbers than this, the rows of faces that are no longer looked at are given up. */
const MOST = 1_000_000;

/**
 * What of faces their arrows depend on, besides their sizes: measured when a face is first asked for, and kept until
 * its corners have changed.
 */
export class FaceRows {
  readonly rows = new ArrowRows();
  readonly #surface: Surface;
  /** By face: where its row is; 0 if it has none. */
  #at: Int32Array;
  /** The faces that have one. */
  #faces: number[] = [];
  #end = 1;
  readonly #corners: number[] = [];

  constructor(surface: Surface) {
    this.#surface = surface;
    this.#at = new Int32Array(surface.mesh.faceSlots);
  }

  /** Where in `rows` the row of a face is. */
  at(face: number): number {
    return this.#at[face] || this.#measure(face);
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
    this.rows.measureFace(at, this.#corners, degree);
    this.#end += rowLength(degree);
    this.#at[face] = at;
    this.#faces.push(face);
    return at;
  }
}
