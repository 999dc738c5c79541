import {
  anyNumbers,
  indices,
  lengthOf,
  lengthOfArrayLike,
  type NumberArray,
  newArray,
  refuseIndex,
  typedArrayName,
} from './arguments.js';
import type { Polygons } from './build.js';
import { counted } from './counted.js';
import { LISTED } from './reports.js';

/** An index that no mesh has. */
const NO_VERTEX = 2 ** 32 - 1;

/** A soup as typed arrays: those that were given, if they are such. Without sizes, all are triangles. */
export interface SoupArrays {
  readonly points: NumberArray;
  readonly sizes?: NumberArray;
  readonly corners: NumberArray;
}

/** Checks a soup as far as that doesn't take the core. */
export function soupArrays(positions: unknown, faces: unknown): SoupArrays {
  const points = anyNumbers('positions', positions);
  if (lengthOf(points) % 3 !== 0) {
    throw new RangeError(
      `positions has ${counted(lengthOf(points), 'element')}; expected a multiple of 3, x, y and z of each vertex.`,
    );
  }
  return { points, ...faceArrays(faces) };
}

/** Faces in any of the three forms. */
function faceArrays(faces: unknown): { sizes?: NumberArray; corners: NumberArray } {
  if (typeof faces === 'object' && faces !== null && !('length' in faces) && 'corners' in faces) {
    const { sizes, corners } = faces as Polygons;
    const lengths = indices('faces.sizes', sizes);
    const vertices = anyIntegers('faces.corners', corners);
    if (lengthOf(lengths) === 0 && lengthOf(vertices) > 0) {
      throw new RangeError(
        `faces.sizes is empty, but faces.corners has ${counted(lengthOf(vertices), 'element')}; expected a size for each face.`,
      );
    }
    return { sizes: lengths, corners: vertices };
  }
  const form = 'an array of faces, an index buffer or { sizes, corners }';
  const count = lengthOfArrayLike('faces', faces, form);
  if (typedArrayName(faces) === undefined && typeof (faces as ArrayLike<unknown>)[0] !== 'number') {
    return flatten(faces as ArrayLike<unknown>, count);
  }
  if (count % 3 !== 0) {
    throw new RangeError(
      `faces has ${counted(count, 'number')}; expected a multiple of 3, three vertices for each triangle.`,
    );
  }
  return { corners: anyIntegers('faces', faces) };
}

/** An array for each face, in a row. */
function flatten(
  faces: ArrayLike<unknown>,
  count: number,
): { sizes: NumberArray; corners: NumberArray } {
  if (count > 0) lengthOfArrayLike(`faces[${count - 1}]`, faces[count - 1]); // or a lying length costs memory
  const sizes = newArray('faces', Uint32Array, count);
  let total = 0;
  for (let f = 0; f < count; f++) {
    sizes[f] = lengthOfArrayLike(`faces[${f}]`, faces[f]);
    total += sizes[f];
  }
  const corners = new Corners('faces', total);
  for (let f = 0; f < count; f++) {
    const face = faces[f] as ArrayLike<unknown>;
    for (let i = 0; i < sizes[f]; i++) corners.add(anyInteger(`faces[${f}]`, i, face[i]));
  }
  return { sizes, corners: corners.array };
}

/** Vertices of corners: whatever is no index of a vertex is the core's to report, with its face. */
function anyIntegers(argument: string, source: unknown): NumberArray {
  const name = typedArrayName(source);
  if (name !== undefined && !name.startsWith('Float')) return indices(argument, source);
  const count = lengthOfArrayLike(argument, source);
  const from = source as ArrayLike<unknown>;
  if (count > 0) anyInteger(argument, count - 1, from[count - 1]); // or a lying length costs memory
  const to = new Corners(argument, count);
  for (let i = 0; i < count; i++) to.add(anyInteger(argument, i, from[i]));
  return to.array;
}

/** Whole numbers in 32 bits, signed if there are negative ones; or doubles, where those don't hold all. */
class Corners {
  readonly #argument: string;
  #words: Uint32Array;
  #doubles: Float64Array | undefined;
  #count = 0;
  #least = 0;
  #most = 0;

  constructor(argument: string, count: number) {
    this.#argument = argument;
    this.#words = newArray(argument, Uint32Array, count);
  }

  add(vertex: number): void {
    if (vertex < this.#least || vertex > this.#most) this.#extend(vertex);
    (this.#doubles ?? this.#words)[this.#count++] = vertex;
  }

  get array(): NumberArray {
    if (this.#doubles !== undefined) return this.#doubles;
    return this.#least < 0 ? signed(this.#words) : this.#words;
  }

  #extend(vertex: number): void {
    const wasSigned = this.#least < 0;
    this.#least = Math.min(this.#least, vertex);
    this.#most = Math.max(this.#most, vertex);
    const most = this.#least < 0 ? 2 ** 31 - 1 : NO_VERTEX;
    if (this.#doubles !== undefined || (this.#least >= -(2 ** 31) && this.#most <= most)) return;
    this.#doubles = newArray(this.#argument, Float64Array, this.#words.length);
    this.#doubles.set(wasSigned ? signed(this.#words) : this.#words);
    this.#words = new Uint32Array();
  }
}

/**
 * The corners as the core takes them: those of vertices that 32 bits don't hold are of none, and named, in
 * lines that have the corner and the vertex that was given. The first of each face is enough.
 */
export function in32Bits(
  corners: NumberArray,
  sizes: NumberArray | undefined,
): { corners: NumberArray; names: string } {
  let names = '';
  if (!(corners instanceof Float64Array)) return { corners, names };
  const isHeld = (vertex: number) => vertex >= 0 && vertex <= NO_VERTEX;
  const faces = sizes === undefined ? corners.length / 3 : lengthOf(sizes);
  for (let f = 0, begin = 0, named = 0; f < faces && named < LISTED; f++) {
    const end = begin + (sizes === undefined ? 3 : sizes[f]);
    let at = begin;
    while (at < end && isHeld(corners[at])) at++;
    if (at < end && at < corners.length) {
      names += `${at} ${corners[at]}\n`;
      named++;
    }
    begin = end;
  }
  const words = newArray('faces', Uint32Array, corners.length);
  for (let i = 0; i < words.length; i++) words[i] = isHeld(corners[i]) ? corners[i] : NO_VERTEX;
  return { corners: words, names };
}

/** The same 32 bits as signed numbers. */
function signed(array: Uint32Array): Int32Array {
  return new Int32Array(array.buffer, array.byteOffset, array.length);
}

/** Whether the numbers of an array may be negative. */
export function isSigned(array: NumberArray): boolean {
  return typedArrayName(array)?.startsWith('Int') ?? false;
}

function anyInteger(argument: string, i: number, value: unknown): number {
  if (typeof value !== 'number' || !Number.isInteger(value)) refuseIndex(argument, i, value);
  return value;
}
