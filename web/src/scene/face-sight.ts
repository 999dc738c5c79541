import { Matrix4 } from 'three';
import type { FaceFrames } from './faces.js';
import type { Stage } from './stage.js';

/** Tells how large faces appear to the camera, as it was when it was taken over last. */
export class FaceSight {
  /** The length of a CSS pixel at the face that was looked at last. */
  pixel = 0;
  readonly #toClip = new Matrix4();
  /** The sixteen numbers of that, column by column, and xyz of the camera. */
  readonly #camera = new Float64Array(19);
  /** The length of a CSS pixel at depth 1. */
  #pixelAtOne = 0;
  #isClosed = false;

  /** Takes over where the camera is. Of closed surfaces no face is in sight from behind. */
  aim(stage: Stage, isClosed: boolean): void {
    const { camera } = stage;
    this.#toClip.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    this.#camera.set(this.#toClip.elements);
    camera.position.toArray(this.#camera, 16);
    this.#pixelAtOne = stage.pixelAt(1);
    this.#isClosed = isClosed;
  }

  /** The mean length of the edges of a face, as seen, in CSS pixels; 0 where it is out of sight. */
  edgeOf(face: number, frames: FaceFrames): number {
    const at = frames.at(face);
    const { data } = frames;
    const m = this.#camera;
    const x = data[at];
    const y = data[at + 1];
    const z = data[at + 2];
    const edge = data[at + 6];
    const w = m[3] * x + m[7] * y + m[11] * z + m[15];
    if (w <= 0) return 0;
    const reach = 1.15 * w + edge * 4;
    if (Math.abs(m[0] * x + m[4] * y + m[8] * z + m[12]) > reach) return 0;
    if (Math.abs(m[1] * x + m[5] * y + m[9] * z + m[13]) > reach) return 0;
    const dx = m[16] - x;
    const dy = m[17] - y;
    const dz = m[18] - z;
    const across = data[at + 3] * dx + data[at + 4] * dy + data[at + 5] * dz;
    if (this.#isClosed && across < 0) return 0;
    const facing = Math.abs(across) / Math.sqrt(dx * dx + dy * dy + dz * dz);
    this.pixel = this.#pixelAtOne * w;
    // Edges of a face seen from the side are foreshortened, on average about this much.
    return (edge / this.pixel) * (0.35 + 0.65 * facing);
  }
}
