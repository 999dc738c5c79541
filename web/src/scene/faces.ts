import { newellNormal } from '../three/index.js';
import { roomFor } from '../three/rows.js';
import type { Surface } from './surface.js';

const FIELDS = 7;

/** Centre, unit normal and mean edge length of faces, computed when first asked for. */
export class FaceFrames {
  readonly #surface: Surface;
  #data: Float32Array;
  readonly #corners: number[] = [];
  readonly #normal = new Float64Array(3);

  constructor(surface: Surface) {
    this.#surface = surface;
    this.#data = new Float32Array(FIELDS * surface.mesh.faceSlots);
  }

  /**
   * The offset of a face in `data`: three numbers each for centre and normal, then the mean edge
   * length.
   */
  at(face: number): number {
    const at = FIELDS * face;
    // A mean edge of 0 is one that was not computed yet (or a face that is a point).
    if (this.#data[at + 6] === 0) this.#measure(face, at);
    return at;
  }

  /** Computes some faces anew when they are next asked for, because they have changed; all of them for null. */
  forget(faces: Iterable<number> | null): void {
    const { faceSlots } = this.#surface.mesh;
    const known = this.#data;
    if (faces === null || FIELDS * faceSlots > known.length) {
      this.#data = new Float32Array(FIELDS * roomFor(faceSlots));
      if (faces !== null) this.#data.set(known);
    }
    for (const face of faces ?? []) this.#data[FIELDS * face + 6] = 0;
  }

  get data(): Float32Array {
    return this.#data;
  }

  #measure(face: number, at: number): void {
    const corners = this.#corners;
    const degree = this.#surface.corners(face, corners);
    const normal = newellNormal(corners, degree, this.#normal);
    const data = this.#data;
    let centreX = 0;
    let centreY = 0;
    let centreZ = 0;
    let perimeter = 0;
    for (let a = 3 * (degree - 1), b = 0; b < 3 * degree; a = b, b += 3) {
      const x = corners[b] - corners[a];
      const y = corners[b + 1] - corners[a + 1];
      const z = corners[b + 2] - corners[a + 2];
      perimeter += Math.sqrt(x * x + y * y + z * z);
      centreX += corners[b];
      centreY += corners[b + 1];
      centreZ += corners[b + 2];
    }
    data[at] = centreX / degree;
    data[at + 1] = centreY / degree;
    data[at + 2] = centreZ / degree;
    for (let k = 0; k < 3; k++) data[at + 3 + k] = normal[k];
    data[at + 6] = perimeter / degree;
  }
}
