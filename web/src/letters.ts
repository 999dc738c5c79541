import { newArray } from './arguments.js';

/** A byte for each letter. By a loop: `Uint8Array.from` first makes a list of all letters, which is slow. */
export function bytesIn(letters: string): Uint8Array {
  const bytes = newArray('what is in a string', Uint8Array, letters.length);
  for (let i = 0; i < letters.length; i++) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

/**
 * A name of a file, of which the core gives a letter for each byte: of UTF-8 or, where that is none, of
 * Latin-1, as older programs write.
 */
export function nameIn(letters: string): string {
  if (!/[^\0-\x7f]/.test(letters)) return letters;
  try {
    return new TextDecoder('utf-8', { fatal: true, ignoreBOM: true }).decode(bytesIn(letters));
  } catch {
    return letters;
  }
}
