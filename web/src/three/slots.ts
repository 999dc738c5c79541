import { newArray } from '../arguments.js';

/** Which triangles of a geometry show which face. A face keeps its place as long as its degree stays. */
export class TriangleSlots {
  /** By triangle: the face that it shows, or -1. Longer than there are triangles. */
  faceOf: Int32Array;
  /** The triangles from here on have never been used. */
  end = 0;
  /** Faces from here on have no triangles. */
  faces = 0;
  /** By face: the first of its triangles, and how many there are. */
  #first = new Int32Array(0);
  #count = new Int32Array(0);
  /** By number of triangles, places that are free. */
  readonly #free = new Map<number, number[]>();
  #unused = 0;

  constructor(capacity: number) {
    this.faceOf = newArray('the triangles', Int32Array, capacity).fill(-1);
  }

  get capacity(): number {
    return this.faceOf.length;
  }

  /** Whether more than half of the triangles that are drawn show nothing. */
  get isWasteful(): boolean {
    return this.#unused > 1000 && 2 * this.#unused > this.end;
  }

  first(face: number): number {
    return this.#first[face] ?? -1;
  }

  count(face: number): number {
    return this.#count[face] ?? 0;
  }

  /** Faces up to this one, no more, can have triangles. pre: those beyond have none */
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

  /** Gives the triangles, from the first on, to the faces that they are of. pre: none has one yet */
  assign(faceOf: ArrayLike<number>, faces: number): void {
    this.resize(faces);
    this.faceOf.set(faceOf);
    this.end = faceOf.length;
    for (let t = this.end - 1; t >= 0; t--) {
      this.#first[faceOf[t]] = t;
      this.#count[faceOf[t]] += 1;
    }
  }

  /** Frees the triangles of a face. */
  release(face: number): void {
    const count = this.count(face);
    if (count === 0) return;
    const first = this.#first[face];
    this.faceOf.fill(-1, first, first + count);
    this.#count[face] = 0;
    this.#unused += count;
    const places = this.#free.get(count);
    if (places === undefined) this.#free.set(count, [first]);
    else places.push(first);
  }

  /** Gives a face that has none a place for so many triangles; returns the first of them. */
  take(face: number, count: number): number {
    const free = this.#free.get(count)?.pop();
    const first = free ?? this.end;
    if (free === undefined) this.end += count;
    else this.#unused -= count;
    if (this.end > this.faceOf.length) this.#grow(Math.ceil(1.25 * this.end));
    this.faceOf.fill(face, first, first + count);
    this.#first[face] = first;
    this.#count[face] = count;
    return first;
  }

  #grow(capacity: number): void {
    const grown = newArray('the triangles', Int32Array, capacity).fill(-1);
    grown.set(this.faceOf);
    this.faceOf = grown;
  }
}
