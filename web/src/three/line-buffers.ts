import { InstancedInterleavedBuffer, InterleavedBufferAttribute } from 'three';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';

/** Lines are uploaded in blocks of so many, those of which one has changed. */
const BLOCK = 64;
/** With more ranges than this, of an object that isn't drawn, the whole buffer waits to be uploaded. */
const MOST_RANGES = 1000;
/** Where nothing is ever in sight. */
const NOWHERE = 1e9;

/** xyz of both ends of a segment. */
export const SEGMENT_FLOATS = 6;

/**
 * The buffers of coloured lines, each through the same number of points; memory grows and is kept. The graphics card is
 * sent the blocks of them that were touched since it was sent them last.
 */
export class LineBuffers {
  /** The first one draws the first segment of each line, and so on: they share the buffers. */
  readonly geometries: readonly LineSegmentsGeometry[];
  /** xyz of all points by line; another array when there was not room enough. */
  positions: Float32Array = new Float32Array(0);
  /** One colour for all of a line. */
  colors: Float32Array = new Float32Array(0);
  /** How many numbers of `positions` a line has. */
  readonly stride: number;
  readonly #buffers: InstancedInterleavedBuffer[] = [];
  /** By block: whether a line of it is other than what was uploaded. */
  #isStale = new Uint8Array(0);

  constructor(points = 2, capacity = BLOCK) {
    this.stride = 3 * points;
    this.geometries = Array.from({ length: points - 1 }, () => new LineSegmentsGeometry());
    for (const geometry of this.geometries) geometry.instanceCount = 0;
    this.#grow(capacity);
  }

  /** Makes room for so many lines; those that are there stay. */
  reserve(count: number): void {
    if (count * this.stride > this.positions.length) this.#grow(2 * count);
  }

  /** Whether a line is uploaded anyhow. */
  isStale(line: number): boolean {
    return this.#isStale[(line / BLOCK) | 0] === 1;
  }

  /** Notes that the lines from `first` on, before `end`, are others now. */
  touch(first: number, end: number): void {
    const last = ((end - 1) / BLOCK) | 0;
    for (let block = (first / BLOCK) | 0; block <= last; block++) this.#isStale[block] = 1;
  }

  /** Takes the lines from `first` on, before `end`, out of sight. */
  hide(first: number, end: number): void {
    const { positions, stride } = this;
    // No segment is without length, which has no direction.
    for (let p = stride * first; p < stride * end; p++) positions[p] = NOWHERE + (p % 2) * NOWHERE;
    this.touch(first, end);
  }

  /** Draws the first lines, so many, and hands the graphics card those of them that it doesn't have. */
  upload(count: number): void {
    for (const geometry of this.geometries) geometry.instanceCount = count;
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
    this.positions = grown(this.positions, this.stride * capacity);
    this.colors = grown(this.colors, 3 * capacity);
    // Other buffers are uploaded whole. Their usage is as for RowBuffer.
    this.#isStale = new Uint8Array(Math.ceil(capacity / BLOCK));
    const positions = new InstancedInterleavedBuffer(this.positions, this.stride, 1);
    const colors = new InstancedInterleavedBuffer(this.colors, 3, 1);
    this.#buffers.splice(0, 2, positions, colors);
    const color = new InterleavedBufferAttribute(colors, 3, 0);
    this.geometries.forEach((geometry, segment) => {
      geometry.dispose();
      for (const [end, name] of ['instanceStart', 'instanceEnd'].entries()) {
        const at = 3 * (segment + end);
        geometry.setAttribute(name, new InterleavedBufferAttribute(positions, 3, at));
      }
      geometry.setAttribute('instanceColorStart', color);
      geometry.setAttribute('instanceColorEnd', color);
    });
  }
}

function grown(from: Float32Array, length: number): Float32Array<ArrayBuffer> {
  const array = new Float32Array(length);
  array.set(from);
  return array;
}
