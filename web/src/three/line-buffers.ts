import { DynamicDrawUsage, InstancedInterleavedBuffer, InterleavedBufferAttribute } from 'three';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';

/** Segments are uploaded in blocks of so many, those of which one has changed. */
const BLOCK = 64;
/** With more ranges than this, of an object that isn't drawn, the whole buffer waits to be uploaded. */
const MOST_RANGES = 1000;

/** xyz of both ends of a segment. */
export const SEGMENT_FLOATS = 6;

/**
 * The buffers of coloured line segments; memory grows and is kept. The graphics card is sent the blocks of them that
 * were touched since it was sent them last.
 */
export class LineBuffers {
  readonly geometry = new LineSegmentsGeometry();
  /** xyz of both ends by segment; another array when there was not room enough. */
  positions = new Float32Array(0);
  /** One colour for both ends. */
  colors = new Float32Array(0);
  readonly #buffers: InstancedInterleavedBuffer[] = [];
  /** By block: whether a segment of it is other than what was uploaded. */
  #isStale = new Uint8Array(0);

  constructor(capacity = BLOCK) {
    this.geometry.instanceCount = 0;
    this.#grow(capacity);
  }

  /** Makes room for so many segments; those that are there stay. */
  reserve(count: number): void {
    if (count * SEGMENT_FLOATS > this.positions.length) this.#grow(2 * count);
  }

  /** Whether a segment is uploaded anyhow. */
  isStale(segment: number): boolean {
    return this.#isStale[(segment / BLOCK) | 0] === 1;
  }

  /** Notes that the segments from `first` on, before `end`, are others now. */
  touch(first: number, end: number): void {
    const last = ((end - 1) / BLOCK) | 0;
    for (let block = (first / BLOCK) | 0; block <= last; block++) this.#isStale[block] = 1;
  }

  /** Draws the first segments, so many, and hands the graphics card those of them that it doesn't have. */
  upload(count: number): void {
    this.geometry.instanceCount = count;
    const blocks = Math.ceil(count / BLOCK);
    for (let from = 0; from < blocks; from++) {
      if (this.#isStale[from] === 0) continue;
      let to = from;
      while (to < blocks && this.#isStale[to] === 1) this.#isStale[to++] = 0;
      for (const buffer of this.#buffers) {
        const start = from * BLOCK * buffer.stride;
        const end = Math.min(to * BLOCK * buffer.stride, buffer.array.length);
        if (buffer.updateRanges.length >= MOST_RANGES) {
          // A range all the same: three.js uploads the whole buffer only as long as there is none.
          buffer.clearUpdateRanges();
          buffer.addUpdateRange(0, buffer.array.length);
        } else {
          buffer.addUpdateRange(start, end - start);
        }
        buffer.needsUpdate = true;
      }
      from = to;
    }
  }

  #grow(capacity: number): void {
    this.positions = grown(this.positions, SEGMENT_FLOATS * capacity);
    this.colors = grown(this.colors, 3 * capacity);
    // Other buffers are uploaded whole.
    this.#isStale = new Uint8Array(Math.ceil(capacity / BLOCK));
    const positions = new InstancedInterleavedBuffer(this.positions, SEGMENT_FLOATS, 1);
    const colors = new InstancedInterleavedBuffer(this.colors, 3, 1);
    this.#buffers.splice(0, 2, positions, colors);
    for (const buffer of this.#buffers) buffer.setUsage(DynamicDrawUsage);
    const { geometry } = this;
    geometry.dispose();
    const both = new InterleavedBufferAttribute(colors, 3, 0);
    geometry.setAttribute('instanceStart', new InterleavedBufferAttribute(positions, 3, 0));
    geometry.setAttribute('instanceEnd', new InterleavedBufferAttribute(positions, 3, 3));
    geometry.setAttribute('instanceColorStart', both);
    geometry.setAttribute('instanceColorEnd', both);
  }
}

function grown(from: Float32Array, length: number): Float32Array<ArrayBuffer> {
  const array = new Float32Array(length);
  array.set(from);
  return array;
}
