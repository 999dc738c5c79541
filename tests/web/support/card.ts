import type { BufferAttribute } from 'three';

/** What a graphics card holds of an attribute, which is sent ranges of it. */
export class Card {
  readonly #copies = new Map<BufferAttribute, { array: ArrayLike<number>; version: number }>();
  bytes = 0;

  upload(attribute: BufferAttribute): void {
    const { array, version, updateRanges } = attribute;
    const known = this.#copies.get(attribute);
    if (known?.version === version) return;
    const copy = known && updateRanges.length > 0 ? (known.array as Float32Array) : array.slice();
    if (copy === known?.array) {
      for (const { start, count } of updateRanges) {
        // WebGL would refuse it.
        if (start + count > array.length) throw new RangeError('A range ends beyond its array.');
        copy.set(array.subarray(start, start + count), start);
        this.bytes += 4 * count;
      }
    } else {
      this.bytes += array.byteLength;
    }
    attribute.clearUpdateRanges();
    this.#copies.set(attribute, { array: copy, version });
  }

  read(attribute: BufferAttribute): ArrayLike<number> {
    return this.#copies.get(attribute)?.array ?? [];
  }
}
