import type { Color } from 'three';
import { arrowSizes, LineBuffers, SEGMENT_FLOATS, SEGMENTS_OF_ARROW } from '../three/index.js';
import { roomFor } from '../three/rows.js';
import { FaceSlots } from '../three/slots.js';
import type { FaceRows } from './face-rows.js';

/** How many shades there are from the faintest to the strongest, besides the former. */
const SHADES = 31;
/** A look is the shade of arrows, in its lowest bits, and the step of their size. */
const SHADE_BITS = 5;
/** Of the bits of a pixel's length as a 32-bit float, those that don't matter: 64 steps lie between it and its double. */
const FINER_BITS = 17;
/** Where a segment is never in sight: what belongs to no face. */
const NOWHERE = [1e9, 1e9, 1e9, 1e9, 1e9, 2e9];

/**
 * The arrows of the faces that are large enough in sight. Each face keeps its place in the buffers from frame to frame, and
 * what is written there as long as it would look the same. Sizes go in steps that are too small to be seen (at most an
 * eighth of a pixel), so that most faces look the same while the camera or the pointer moves a little.
 *
 * Each frame: `begin`, `show` for each face, `end`.
 */
export class FaceArrows {
  readonly lines = new LineBuffers(4096);
  #rows: FaceRows | null = null;
  #slots = new FaceSlots(0);
  /** By face that has a place: how its arrows look there. */
  #looks = new Int32Array(0);
  /** By face: the frame that it was shown in last. */
  #seen = new Uint32Array(0);
  #frame = 0;
  /** The faces of this frame and of the one before. */
  #faces: number[] = [];
  #before: number[] = [];
  readonly #shades = new Float32Array(3 * (SHADES + 1));
  readonly #sizes = { inset: 0, trim: 0, barb: 0 };

  /** The arrows of other faces, of which there are so many at most, from what was measured of them. */
  reset(rows: FaceRows, faceSlots: number): void {
    this.#rows = rows;
    this.forget(null, faceSlots);
  }

  /** Writes the arrows of some faces anew, because they have changed; those of all faces for null. */
  forget(faces: Iterable<number> | null, faceSlots: number): void {
    if (faces === null) this.#clear();
    for (const face of faces ?? []) this.#release(face);
    this.#slots.resize(faceSlots);
    if (faceSlots <= this.#seen.length) return;
    const [looks, seen] = [this.#looks, this.#seen];
    this.#looks = new Int32Array(roomFor(faceSlots));
    this.#looks.set(looks);
    this.#seen = new Uint32Array(this.#looks.length);
    this.#seen.set(seen);
  }

  /** The colours of the faintest and of the strongest arrows. */
  setColors(faint: Color, strong: Color): void {
    for (let shade = 0; shade <= SHADES; shade++) {
      faint
        .clone()
        .lerp(strong, shade / SHADES)
        .toArray(this.#shades, 3 * shade);
    }
    this.#clear();
  }

  begin(): void {
    this.#frame += 1;
    const faces = this.#before;
    this.#before = this.#faces;
    this.#faces = faces;
    faces.length = 0;
  }

  /** Shows the arrows of a face where a CSS pixel is `pixel` long; from `strength` 0 to 1 they are stronger. */
  show(face: number, pixel: number, strength: number): void {
    this.#faces.push(face);
    this.#seen[face] = this.#frame;
    const look = (stepOf(pixel) << SHADE_BITS) | (strength * SHADES + 0.5);
    if (this.#slots.count(face) === 0) this.#place(face, look);
    else if (this.#looks[face] !== look) this.#rewrite(face, look);
  }

  /** Takes away the arrows of the faces that were not shown again, and hands all to the graphics card. */
  end(): void {
    for (const face of this.#before) {
      if (this.#seen[face] !== this.#frame) this.#release(face);
    }
    if (this.#slots.isWasteful) {
      this.#clear();
      for (const face of this.#faces) this.#place(face, this.#looks[face]);
    }
    this.lines.upload(SEGMENTS_OF_ARROW * this.#slots.end);
  }

  #clear(): void {
    const slots = new FaceSlots(this.#slots.capacity);
    slots.resize(this.#slots.faces);
    this.#slots = slots;
  }

  /** Writes the arrows of a face that has no place. */
  #place(face: number, look: number): void {
    const { rows } = this.#rows as FaceRows;
    const count = rows.degree((this.#rows as FaceRows).at(face));
    const first = this.#slots.take(face, count);
    this.lines.reserve(SEGMENTS_OF_ARROW * this.#slots.end);
    this.#paint(first, count, look & SHADES);
    this.#write(face, first, count, look);
  }

  /** Writes the arrows of a face where they are. */
  #rewrite(face: number, look: number): void {
    const [first, count] = [this.#slots.first(face), this.#slots.count(face)];
    const shade = look & SHADES;
    if ((this.#looks[face] & SHADES) !== shade) this.#paint(first, count, shade);
    this.#write(face, first, count, look);
  }

  #write(face: number, first: number, count: number, look: number): void {
    const faceRows = this.#rows as FaceRows;
    this.#looks[face] = look;
    const sizes = arrowSizes(pixelOf(look >> SHADE_BITS), this.#sizes);
    const { positions } = this.lines;
    faceRows.rows.placeSegments(
      faceRows.at(face),
      sizes,
      positions,
      SEGMENTS_OF_ARROW * SEGMENT_FLOATS * first,
    );
    this.lines.touch(SEGMENTS_OF_ARROW * first, SEGMENTS_OF_ARROW * (first + count));
  }

  #paint(first: number, count: number, shade: number): void {
    const { colors } = this.lines;
    const r = this.#shades[3 * shade];
    const g = this.#shades[3 * shade + 1];
    const b = this.#shades[3 * shade + 2];
    const end = 3 * SEGMENTS_OF_ARROW * (first + count);
    for (let c = 3 * SEGMENTS_OF_ARROW * first; c < end; c += 3) {
      colors[c] = r;
      colors[c + 1] = g;
      colors[c + 2] = b;
    }
  }

  #release(face: number): void {
    const [first, count] = [this.#slots.first(face), this.#slots.count(face)];
    if (count === 0) return;
    this.#slots.release(face);
    const [from, end] = [SEGMENTS_OF_ARROW * first, SEGMENTS_OF_ARROW * (first + count)];
    for (let s = from; s < end; s++) this.lines.positions.set(NOWHERE, SEGMENT_FLOATS * s);
    this.lines.touch(from, end);
  }
}

const float = new Float32Array(1);
const bits = new Int32Array(float.buffer);

/** Which step of sizes is nearest to a length. */
function stepOf(pixel: number): number {
  float[0] = pixel;
  return (bits[0] + (1 << (FINER_BITS - 1))) >> FINER_BITS;
}

function pixelOf(step: number): number {
  bits[0] = step << FINER_BITS;
  return float[0];
}
