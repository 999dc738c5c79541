import { counted } from './counted.js';
import { HalfedgeError } from './errors.js';

/** A short name for any value, for the sentence of an error. Never throws, never long. */
export function describe(value: unknown): string {
  switch (typeof value) {
    case 'string':
      return value.length <= 40 ? JSON.stringify(value) : `a string of ${value.length} characters`;
    case 'bigint':
      return `the bigint ${shorten(`${value}n`)}`;
    case 'symbol':
      return 'a symbol';
    case 'function':
      return 'a function';
    case 'number':
      return Object.is(value, -0) ? '-0' : String(value);
    case 'object':
      return value === null ? 'null' : describeObject(value);
    default:
      return String(value);
  }
}

function describeObject(value: object): string {
  const typed = typedArrayName(value);
  if (typed !== undefined)
    return `${withArticle(typed)} of ${counted((value as Uint8Array).length, 'element')}`;
  try {
    if (Array.isArray(value)) return `an array of ${counted(value.length, 'element')}`;
    const tag = Object.prototype.toString.call(value).slice(8, -1);
    if (tag === 'Promise') return 'a Promise, which is to be awaited';
    return withArticle((tag === 'Object' && className(value)) || shorten(tag));
  } catch {
    return 'an object'; // a revoked proxy, or a getter that throws
  }
}

/** "Vector3" and so on for an object that a class has made. */
function className({ constructor: made }: object): string | undefined {
  return typeof made === 'function' && /^\w{1,40}$/.test(made.name) ? made.name : undefined;
}

const shorten = (text: string) => (text.length <= 40 ? text : `${text.slice(0, 37)}...`);
/** "Uint8Array" and "URL" begin as "you" does. */
const withArticle = (name: string) =>
  /^[AEIO]|^U(?!int|RL)/.test(name) ? `an ${name}` : `a ${name}`;

const typedArrayTag = Object.getOwnPropertyDescriptor(
  Object.getPrototypeOf(Int8Array.prototype),
  Symbol.toStringTag,
)?.get;

/**
 * "Float32Array" and so on for a typed array, also one of another realm (a frame, a worker's
 * sandbox), where `instanceof` fails; undefined for anything else.
 */
export function typedArrayName(value: unknown): string | undefined {
  return typedArrayTag?.call(value) as string | undefined;
}

const typedArrayLength = Object.getOwnPropertyDescriptor(
  Object.getPrototypeOf(Int8Array.prototype),
  'length',
)?.get;

/** The typed arrays whose elements are numbers, not bigints. */
export type NumberArray =
  | Int8Array
  | Uint8Array
  | Uint8ClampedArray
  | Int16Array
  | Uint16Array
  | Int32Array
  | Uint32Array
  | Float32Array
  | Float64Array;

/**
 * Numbers as a typed array: typed arrays as they are, anything else array-like converted to floats
 * and checked element by element. No caller's code (a getter, a proxy) runs after this.
 */
export function numbers(argument: string, source: unknown): NumberArray {
  return numberArray(argument, source) ?? convert(argument, source, Float32Array, float);
}

/** As {@link numbers}, where what is too large for a 32-bit float is somebody else's to mend. */
export function anyNumbers(argument: string, source: unknown): NumberArray {
  return (
    numberArray(argument, source) ??
    convert(argument, source, Float32Array, (value, i) =>
      typeof value === 'number' ? value : refuseElement(argument, i, value),
    )
  );
}

/**
 * As {@link numbers}, of indices: integers from 0. Signed arrays are passed on unchecked: see
 * `checkNotNegative`. `refuse` throws what is wrong with an element that is no index.
 */
export function indices(
  argument: string,
  source: unknown,
  refuse = refuseIndex,
  expected?: string,
): NumberArray {
  const typed = numberArray(argument, source);
  const isFloat = typed !== undefined && typedArrayName(typed)?.startsWith('Float');
  if (typed !== undefined && !isFloat) return typed;
  const check = (value: unknown, i: number) =>
    isIndex(value) ? value : refuse(argument, i, value);
  return convert(argument, source, Uint32Array, check, expected);
}

/** Whether `value` can be an index at all. */
export function isIndex(value: unknown): value is number {
  return typeof value === 'number' && value >= 0 && value < MAX_INDEX && Number.isInteger(value);
}

/** One more than what an index can be: 2^32 - 1 is the empty link. */
const MAX_INDEX = 2 ** 32 - 1;

/** Throws what is wrong with `argument[i]`, which is no index. */
export function refuseIndex(argument: string, i: number, value: unknown): never {
  throw wrongElement(argument, i, value, `an index, an integer from 0 to ${MAX_INDEX - 1}`);
}

/** Throws if one of them is negative. */
export function checkNotNegative(argument: string, array: NumberArray): void {
  const i = array.findIndex((value) => value < 0);
  if (i >= 0) refuseIndex(argument, i, array[i]);
}

/** Throws if one of them is finite, but too large for a 32-bit float. */
export function checkFloats(argument: string, array: NumberArray): void {
  array.forEach((value, i) => void float(value, i, argument));
}

/** `value` as an element of positions; infinities and NaN are the builder's to refuse, with their vertex. */
function float(value: unknown, i: number, argument: string): number {
  if (typeof value !== 'number') refuseElement(argument, i, value);
  if (Number.isFinite(value) && !Number.isFinite(Math.fround(value))) {
    throw wrongElement(argument, i, value, 'a number that fits a 32-bit float');
  }
  return value;
}

function refuseElement(argument: string, i: number, value: unknown): never {
  throw wrongElement(argument, i, value, 'a number');
}

function wrongElement(argument: string, i: number, value: unknown, expected: string): Error {
  const sentence = `${argument}[${i}] is ${describe(value)}; expected ${expected}.`;
  return typeof value === 'number' ? new RangeError(sentence) : new TypeError(sentence);
}

/** `source`, if it is a typed array of numbers; undefined if it is some other array-like object. */
function numberArray(argument: string, source: unknown): NumberArray | undefined {
  const name = typedArrayName(source);
  if (name === undefined) return undefined;
  if (name.startsWith('Big')) {
    throw new TypeError(`${argument} is ${describe(source)}; expected numbers, not bigints.`);
  }
  const typed = source as NumberArray;
  if (lengthOf(typed) === 0) checkAttached(argument, typed, name);
  return typed;
}

/** Throws if a typed array without elements has lost them. */
function checkAttached(argument: string, array: NumberArray, name: string): void {
  if (isDetached(array.buffer)) {
    throw new TypeError(
      `${argument} is a detached ${name}; expected one with its elements: was its buffer transferred to a worker?`,
    );
  }
  if (isCutOff(array)) {
    throw new TypeError(
      `${argument} is ${withArticle(name)} that reaches beyond its buffer, which was made shorter; expected one with its elements.`,
    );
  }
}

/** The true length of a typed array, whatever properties a caller has put on it. */
export function lengthOf(array: NumberArray): number {
  return typedArrayLength?.call(array) as number;
}

const typedArrayKeys = Object.getPrototypeOf(Int8Array.prototype).keys as () => unknown;

const viewOffset = Object.getOwnPropertyDescriptor(DataView.prototype, 'byteOffset')?.get;

/** Whether a resizable buffer has become too short for a view that isn't detached. */
function isCutOff(view: ArrayBufferView): boolean {
  try {
    (typedArrayName(view) === undefined ? viewOffset : typedArrayKeys)?.call(view);
    return false;
  } catch {
    return true;
  }
}

function isDetached(buffer: ArrayBufferLike): boolean {
  try {
    new Uint8Array(buffer);
    return false;
  } catch {
    return true;
  }
}

function convert<T extends Float32Array | Uint32Array>(
  argument: string,
  source: unknown,
  Kind: new (length: number) => T,
  check: (value: unknown, i: number, argument: string) => number,
  expected?: string,
): T {
  const length = lengthOfArrayLike(argument, source, expected);
  const from = source as ArrayLike<unknown>;
  if (length > 0) check(from[length - 1], length - 1, argument); // or a lying length costs memory
  const to = newArray(argument, Kind, length);
  for (let i = 0; i < length; i++) to[i] = check(from[i], i, argument);
  return to;
}

/** A typed array of zeros; throws `out-of-memory` where JavaScript's memory is exhausted. */
export function newArray<T>(what: string, Kind: new (length: number) => T, length: number): T {
  try {
    return new Kind(length);
  } catch (cause) {
    throw noRoomHere(`An array for ${what} needs room for ${length} numbers`, cause);
  }
}

/** The error where JavaScript has no room, which `need` tells of without a full stop. */
export function noRoomHere(need: string, cause: unknown): HalfedgeError {
  return new HalfedgeError('out-of-memory', `${need}, more than JavaScript has.`, { cause });
}

/** What can be iterated over as an array, but for arrays and typed arrays, which stay as anything else does. */
export function listFrom(source: unknown): unknown {
  if (typeof source !== 'object' || source === null) return source;
  if (Array.isArray(source) || ArrayBuffer.isView(source) || !(Symbol.iterator in source)) {
    return source;
  }
  const items: unknown[] = [];
  for (const item of source as Iterable<unknown>) items.push(item);
  return items;
}

/** The length of an array or of an object like one. Throws a sentence for anything else. */
export function lengthOfArrayLike(
  argument: string,
  source: unknown,
  expected = 'an array or a typed array of numbers',
): number {
  if (typeof source === 'object' && source !== null) {
    const { length } = source as { length?: unknown };
    if (typeof length === 'number' && Number.isInteger(length) && length >= 0 && length < 2 ** 32) {
      const name = length === 0 ? typedArrayName(source) : undefined;
      if (name !== undefined) checkAttached(argument, source as NumberArray, name);
      return length;
    }
  }
  throw new TypeError(`${argument} is ${describe(source)}; expected ${expected}.`);
}

/** The bytes of a buffer or of a view of one; undefined for anything else. */
export function bytesOf(argument: string, source: unknown): Uint8Array | undefined {
  const isView = ArrayBuffer.isView(source);
  if (!isView && !isBuffer(source)) return undefined;
  const buffer = isView ? source.buffer : (source as ArrayBufferLike);
  if (isDetached(buffer)) {
    throw new TypeError(
      `${argument} is a detached buffer; expected one with its bytes: was it transferred to a worker?`,
    );
  }
  if (!isView) return new Uint8Array(buffer);
  if (!isCutOff(source)) return new Uint8Array(buffer, source.byteOffset, source.byteLength);
  throw new TypeError(
    `${argument} is a view that reaches beyond its buffer, which was made shorter; expected one with its bytes.`,
  );
}

function isBuffer(source: unknown): boolean {
  return /^\[object (Shared)?ArrayBuffer\]$/.test(Object.prototype.toString.call(source));
}
