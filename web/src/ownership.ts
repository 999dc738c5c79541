// Whose the buffers are that a worker is given.

import { typedArrayName } from './arguments.js';

/**
 * Typed arrays whose buffers are the worker's, taken over or copied: later changes here don't matter.
 * Anything else is as it was. Views of one buffer stay that.
 */
export function owned(sources: readonly unknown[], transfer: boolean): unknown[] {
  const result = [...sources];
  const byBuffer = new Map<ArrayBufferLike, number[]>();
  for (const [i, source] of sources.entries()) {
    if (typedArrayName(source) === undefined) continue;
    const { buffer } = source as Uint8Array;
    byBuffer.set(buffer, [...(byBuffer.get(buffer) ?? []), i]);
  }
  for (const [buffer, places] of byBuffer) {
    const views = places.map((i) => sources[i]);
    const taken = transfer && isUnshared(buffer) ? take(views, buffer as ArrayBuffer) : undefined;
    const own = taken ?? views.map(copyOf);
    for (const [i, place] of places.entries()) result[place] = own[i];
  }
  return result;
}

/** The same views of a buffer that is detached here; undefined if it stays where it is. */
function take(views: unknown[], buffer: ArrayBuffer): unknown[] | undefined {
  try {
    return structuredClone(views, { transfer: [buffer] });
  } catch {
    return undefined; // WebAssembly's memory, Node's pool
  }
}

/** Of any typed array; Node's Buffer has another slice. In shared memory others may write meanwhile. */
const copyOf = (view: unknown): unknown => Uint8Array.prototype.slice.call(view);

/** The buffer of a typed array that `owned` made. */
export function transferable(data: unknown): object | undefined {
  if (typedArrayName(data) === undefined) return undefined;
  const { buffer } = data as Uint8Array;
  return isUnshared(buffer) ? buffer : undefined;
}

const isUnshared = (buffer: object) =>
  Object.prototype.toString.call(buffer) === '[object ArrayBuffer]';
