import { newArray } from '../arguments.js';

/**
 * Which rows of a buffer (triangles, arrows) show which face. A face keeps its place as long as the number of its rows
 * stays.
 */
export class FaceSlots {
  /** By row: the face that it shows, or -1. Longer than there are rows. */
  faceOf: Int32Array;
  /** The rows from here on have never been used. */
  end = 0;
  /** Faces from here on have no rows. */
  faces = 0;
  /** By face: the first of its rows, and how many there are. */
  #first = new Int32Array(0);
  #count = new Int32Array(0);
  /** By number of rows, places that are free. */
  readonly #free = new Map<number, number[]>();
  #unused = 0;

  constructor(capacity: number) {
    this.faceOf = newArray('a buffer', Int32Array, capacity).fill(-1);
  }

  get capacity(): number {
    return this.faceOf.length;
  }

  /** Whether more than half of the rows that are drawn show nothing. */
  get isWasteful(): boolean {
    return this.#unused > 1000 && 2 * this.#unused > this.end;
  }

  first(face: number): number {
    return this.#first[face] ?? -1;
  }

  count(face: number): number {
    return this.#count[face] ?? 0;
  }

  /** Faces up to this one, no more, can have rows. pre: those beyond have none */
  resize(faces: number): void {
    this.faces = faces;
    if (faces <= this.#first.length) return;
    const room = Math.max(faces, Math.ceil(1.25 * this.#first.length));
    const first = newArray('the faces', Int32Array, room).fill(-1);
    first.set(this.#first);
    const count = newArray('the faces', Int32Array, room);
    count.set(this.#count);
    this.#first = first;
    this.#count = count;
  }

  /** Frees all rows. */
  clear(): void {
    this.faceOf.fill(-1, 0, this.end);
    this.#count.fill(0);
    this.#free.clear();
    this.end = 0;
    this.#unused = 0;
  }

  /** Gives the rows, from the first on, to the faces that they are of. pre: none has one yet */
  assign(faceOf: ArrayLike<number>, faces: number): void {
    this.resize(faces);
    this.faceOf.set(faceOf);
    this.end = faceOf.length;
    for (let row = this.end - 1; row >= 0; row--) {
      this.#first[faceOf[row]] = row;
      this.#count[faceOf[row]] += 1;
    }
  }

  /** Frees the rows of a face. */
  release(face: number): void {
    const count = this.count(face);
    if (count === 0) return;
    const first = this.#first[face];
    for (let row = first; row < first + count; row++) this.faceOf[row] = -1;
    this.#count[face] = 0;
    this.#unused += count;
    const places = this.#free.get(count);
    if (places === undefined) this.#free.set(count, [first]);
    else places.push(first);
  }

  /** Gives a face that has none a place for so many rows; returns the first of them. */
  take(face: number, count: number): number {
    const free = this.#free.get(count)?.pop();
    const first = free ?? this.end;
    if (free === undefined) this.end += count;
    else this.#unused -= count;
    if (this.end > this.faceOf.length) this.#grow(Math.ceil(1.25 * this.end));
    for (let row = first; row < first + count; row++) this.faceOf[row] = face;
    this.#first[face] = first;
    this.#count[face] = count;
    return first;
  }

  #grow(capacity: number): void {
    const grown = newArray('a buffer', Int32Array, capacity).fill(-1);
    grown.set(this.faceOf);
    this.faceOf = grown;
  }
}
