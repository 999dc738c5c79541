// What methods that measure a mesh return.

import { newArray, typedArrayName } from './arguments.js';
import { refuse } from './checks.js';
import { counted } from './counted.js';
import { HalfedgeError } from './errors.js';
import type { Floats, XYZ } from './measures.js';

export type FloatsConstructor = new (length: number) => Floats;

/** What `write` leaves in an array. */
export function pointOf(write: (out: Float64Array) => void): XYZ {
  write(point);
  return [point[0], point[1], point[2]];
}
const point = new Float64Array(3);

/**
 * An array of this length: `into`, or the first part of it, if that is long enough; else a new one. Refuses what lies
 * over the positions, as it is written while these are read.
 */
export function arrayFor(
  length: number,
  Default: FloatsConstructor,
  positions: Float32Array,
  into?: Floats,
): Floats {
  if (into === undefined) return newArray<Floats>('the result', Default, length);
  const name = typedArrayName(into);
  if (name !== 'Float32Array' && name !== 'Float64Array') {
    refuse('into', into, 'a Float32Array or a Float64Array');
  }
  if (overlap(into, positions)) refuse('into', into, 'another array than that of the positions');
  if (into.length === length) return into;
  if (into.length > length) return into.subarray(0, length);
  return newArray<Floats>(
    'the result',
    name === 'Float32Array' ? Float32Array : Float64Array,
    length,
  );
}

/** Throws if there are boundary loops, which `remedy` closes: a volume needs a closed surface. */
export function checkClosed(loops: number, remedy: string): void {
  if (loops === 0) return;
  throw new HalfedgeError(
    'open-surface',
    `This mesh has ${counted(loops, 'boundary loop')}; expected a closed surface, which has none: ${remedy} closes them.`,
  );
}

function overlap(a: Floats, b: Floats): boolean {
  if (a.buffer !== b.buffer) return false;
  return a.byteOffset < b.byteOffset + b.byteLength && b.byteOffset < a.byteOffset + a.byteLength;
}
