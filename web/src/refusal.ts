import type { Refusal } from './edit.js';
import type { Witness } from './errors.js';
import type { Core } from './loader.js';
import { sentenceOf } from './reports.js';

// How a refusal crosses from the core: as words and bytes that are read in place. Loops ask for checks by the
// million and throw most refusals away. Even so it is read at once: to decode the sentence takes less than to
// make an object with a getter for it, which consoles would show as one.

/** All of the core's memory. Growth detaches and so empties it. */
let words = new Uint32Array(0);
const decoder = new TextDecoder();
/** By address: they are constants of the core. */
const codes = new Map<number, string>();

/** Why the core has refused what it was called for last. Nothing of it is left in the core. */
export function takeRefusal(core: Core): Refusal {
  const at = core._last_refusal() >>> 2;
  if (words.length === 0) words = new Uint32Array(core.memory.buffer);
  const code = codes.get(words[at]) ?? readCode(words[at], words[at + 1]);
  const message = sentenceOf(code, readText(words[at + 2], words[at + 3]));
  const witness: Witness = {
    vertices: readItems(words[at + 4], words[at + 5]),
    halfedges: readItems(words[at + 6], words[at + 7]),
    edges: readItems(words[at + 8], words[at + 9]),
    faces: readItems(words[at + 10], words[at + 11]),
  };
  core._forget_refusal();
  return Object.freeze({ code, message, witness });
}

function readCode(address: number, length: number): string {
  const code = readText(address, length);
  codes.set(address, code);
  return code;
}

function readText(address: number, length: number): string {
  return decoder.decode(new Uint8Array(words.buffer, address, length));
}

function readItems(address: number, count: number): number[] {
  const items: number[] = [];
  for (let i = address >>> 2; items.length < count; i++) items.push(words[i]);
  return items;
}
