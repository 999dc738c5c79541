import type { ConnectivityViews } from '../api.js';
import { LineBuffers } from '../three/index.js';
import { roomFor } from '../three/rows.js';
import { FaceSlots } from '../three/slots.js';
import type { Surface } from './surface.js';

/** The look of faces that have no place. */
const NONE = -1;

/**
 * Coloured lines of faces. What those of a face look like comes of the face and of one number, its look: each face
 * keeps its place in the buffers from frame to frame, and what is written there as long as its look is the same.
 *
 * Each frame: `begin`, `keep` for each face, `end`.
 */
export abstract class KeptLines {
  readonly lines: LineBuffers;
  protected surface: Surface | null = null;
  /** The links of the mesh, in the frame that is drawn. */
  protected links: ConnectivityViews | null = null;
  #slots = new FaceSlots(0);
  /** By face: how it looks where it is; -1 without a place. */
  #looks = new Int32Array(0);
  /** By face: the frame that it was kept in last. */
  #seen = new Uint32Array(0);
  #frame = 0;
  /** The faces that have a place. */
  #placed: number[] = [];

  /** Lines through so many points. */
  constructor(points: number) {
    this.lines = new LineBuffers(points);
  }

  /** Measures a face that is to be written; returns how many lines that will be, at least one. */
  protected abstract measure(face: number, look: number): number;

  /** Writes the lines of the face that was measured; `former` is the look of what stands there, or -1. */
  protected abstract write(first: number, look: number, former: number): void;

  /** Of another surface. */
  reset(surface: Surface): void {
    this.surface = surface;
    this.forget(null);
  }

  /** Writes the lines of some faces anew, because they have changed; those of all faces for null. */
  forget(faces: Iterable<number> | null): void {
    if (faces === null) this.clear();
    for (const face of faces ?? []) this.#release(face);
    this.#placed = this.#placed.filter((face) => this.#looks[face] !== NONE);
    const faceSlots = this.surface?.mesh.faceSlots ?? 0;
    this.#slots.resize(faceSlots);
    if (faceSlots <= this.#seen.length) return;
    const [looks, seen] = [this.#looks, this.#seen];
    this.#looks = new Int32Array(roomFor(faceSlots)).fill(NONE);
    this.#looks.set(looks);
    this.#seen = new Uint32Array(this.#looks.length);
    this.#seen.set(seen);
  }

  begin(): void {
    this.#frame += 1;
    this.links = this.surface?.mesh.connectivity ?? null;
  }

  /** Takes away the lines of the faces that were not kept again, and hands all to the graphics card. */
  end(): void {
    const placed = this.#placed;
    let kept = 0;
    for (let i = 0; i < placed.length; i++) {
      if (this.#seen[placed[i]] === this.#frame) placed[kept++] = placed[i];
      else this.#release(placed[i]);
    }
    placed.length = kept;
    if (this.#slots.isWasteful) this.#closeUp();
    this.lines.upload(this.#slots.end);
  }

  /** Shows the lines of a face. */
  protected keep(face: number, look: number): void {
    this.#seen[face] = this.#frame;
    const former = this.#looks[face];
    if (former !== look) this.#renew(face, look, former);
  }

  /** Writes the lines of all faces anew. */
  protected clear(): void {
    for (const face of this.#placed) this.#looks[face] = NONE;
    this.#placed = [];
    this.#slots.clear();
  }

  #renew(face: number, look: number, former: number): void {
    const count = this.measure(face, look);
    if (former !== NONE && this.#slots.count(face) === count) {
      this.#write(this.#slots.first(face), count, look, former);
    } else {
      if (former === NONE) this.#placed.push(face);
      else this.#release(face);
      const first = this.#slots.take(face, count);
      this.lines.reserve(this.#slots.end);
      this.#write(first, count, look, NONE);
    }
    this.#looks[face] = look;
  }

  #write(first: number, count: number, look: number, former: number): void {
    this.write(first, look, former);
    this.lines.touch(first, first + count);
  }

  #release(face: number): void {
    const count = this.#slots.count(face);
    if (count === 0) return;
    const first = this.#slots.first(face);
    this.#slots.release(face);
    this.#looks[face] = NONE;
    this.lines.hide(first, first + count);
  }

  /** Gives all faces places one after the other. */
  #closeUp(): void {
    const faces = this.#placed;
    const looks = faces.map((face) => this.#looks[face]);
    this.clear();
    faces.forEach((face, i) => {
      this.#renew(face, looks[i], NONE);
    });
  }
}
