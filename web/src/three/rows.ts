import { BufferAttribute, type TypedArray } from 'three';
import { newArray } from '../arguments.js';

/** Rows that lie so close are uploaded in one go: a call costs more than some bytes. */
const GAP = 16;
/** With more ranges than this, waiting to be uploaded, all between them is uploaded as well. */
const MOST_RANGES = 1000;

/** Room for so much more than there is that few edits need new buffers. */
export function roomFor(count: number): number {
  return Math.ceil(1.125 * count) + 64;
}

/**
 * A column of a geometry, and which of its rows have changed. Its usage is the one that attributes have by themselves:
 * of one that is to be dynamic, WebGPURenderer uploads all in each frame.
 */
export class RowBuffer {
  readonly components: number;
  attribute: BufferAttribute;
  /** The rows written since the last `mark`, in any order. */
  readonly #written: number[] = [];

  /** `itemSize`: as three.js knows it; the rows of an index are triangles. */
  constructor(array: TypedArray, components: number, normalized = false, itemSize = components) {
    this.components = components;
    this.attribute = new BufferAttribute(array, itemSize, normalized);
  }

  get array(): TypedArray {
    return this.attribute.array;
  }

  /** Writes a row from `at` of `values`; returns whether that changed it. */
  write(row: number, values: ArrayLike<number>, at: number): boolean {
    const { array, components } = this;
    const to = row * components;
    let same = true;
    for (let k = 0; k < components; k++) {
      const old = array[to + k];
      array[to + k] = values[at + k];
      if (!Object.is(array[to + k], old)) same = false;
    }
    if (!same) this.#written.push(row);
    return !same;
  }

  /** Makes the array long enough for so many rows: then it is another one, and so is the attribute. */
  reserve(rows: number): void {
    const { array, components, attribute } = this;
    if (rows * components <= array.length) return;
    const Kind = array.constructor as new (length: number) => TypedArray;
    const grown = newArray('a buffer', Kind, rows * components);
    grown.set(array);
    this.attribute = new BufferAttribute(grown, attribute.itemSize, attribute.normalized);
  }

  /** What was written is not to be marked, because all of it is uploaded, or nothing. */
  forget(): void {
    this.#written.length = 0;
    this.attribute.clearUpdateRanges();
  }

  /** Tells three.js which ranges to upload. Returns the bytes of them. */
  mark(): number {
    if (this.#written.length === 0) return 0;
    const rows = newArray('what was written', Uint32Array, this.#written.length);
    rows.set(this.#written);
    rows.sort(); // many times as fast as sorting the list
    const { attribute, components } = this;
    let bytes = 0;
    for (let i = 0; i < rows.length; ) {
      const from = rows[i];
      let to = from + 1;
      for (; i < rows.length && rows[i] <= to + GAP; i++) to = Math.max(to, rows[i] + 1);
      attribute.addUpdateRange(from * components, (to - from) * components);
      bytes += (to - from) * components * attribute.array.BYTES_PER_ELEMENT;
    }
    this.#written.length = 0;
    const ranges = attribute.updateRanges;
    if (ranges.length > MOST_RANGES) {
      let start = Infinity;
      let end = 0;
      for (const range of ranges) {
        start = Math.min(start, range.start);
        end = Math.max(end, range.start + range.count);
      }
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(start, end - start);
    }
    attribute.needsUpdate = true;
    return bytes;
  }
}
