import { newArray } from './arguments.js';

/** A byte for each letter. By a loop: `Uint8Array.from` first makes a list of all letters, which is slow. */
export function bytesIn(letters: string): Uint8Array {
  const bytes = newArray('what is in a string', Uint8Array, letters.length);
  for (let i = 0; i < letters.length; i++) bytes[i] = letters.charCodeAt(i);
  return bytes;
}
