import { describe } from './arguments.js';

// What `into` of a range writes to.

/** How many items there is room for. To find out what something isn't, V8 goes through all its prototypes. */
export function roomIn(buffer: Int32Array | Uint32Array): number {
  if (buffer instanceof Int32Array || buffer instanceof Uint32Array) return buffer.length;
  return roomInForeign(buffer);
}

/** Arrays of other realms, too. Their names would do for all, but JavaScriptCore takes 30 ns to tell one. */
function roomInForeign(buffer: Int32Array | Uint32Array): number {
  const name = (buffer as Int32Array | Uint32Array | null)?.[Symbol.toStringTag];
  if (name === 'Int32Array' || name === 'Uint32Array') return buffer.length;
  throw new TypeError(`buffer is ${describe(buffer)}; expected an Int32Array or a Uint32Array.`);
}

/** `into` in all cases: goes through all items, and tells how many there are if there is no room for them. */
export function intoSlowly(items: Iterable<number>, buffer: Int32Array | Uint32Array): number {
  const room = buffer.length;
  let count = 0;
  for (const item of items) {
    if (count < room) buffer[count] = item;
    count += 1;
  }
  if (count <= room) return count;
  throw new RangeError(`buffer has length ${room}; expected at least ${count}.`);
}
