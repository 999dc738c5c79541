// The content of a file as a string: what is often passed instead, and how it becomes bytes.

import { describe } from './arguments.js';
import { HalfedgeError } from './errors.js';

/** The bytes of a text. Throws a sentence for what can't be the text of a file. */
export function bytesOfText(argument: string, text: string): Uint8Array {
  checkText(argument, text);
  return new TextEncoder().encode(text);
}

/** Throws a sentence for the name of a file, and for a binary file that was read as text. */
export function checkText(argument: string, text: string): void {
  if (isName(text)) {
    throw new HalfedgeError(
      'unknown-format',
      `${argument} is ${describe(text)}, the name of a file; expected what is in it, so fetch or read it first.`,
    );
  }
  if (isBinary(text)) {
    throw new HalfedgeError(
      'not-text',
      `${argument} is ${describe(text)}, a binary file that was read as text, which loses bytes; expected an ArrayBuffer or a Uint8Array.`,
    );
  }
}

/** One word that is an address, or ends as names of files do; no file has nothing else in it. */
function isName(text: string): boolean {
  return (
    text.length < 2000 &&
    /^(?:(?:https?|file|blob|data):\S*|[^#\s]\S*\.(?:obj|off|ply|stl|gltf|glb)(?:[?#]\S*)?)$/i.test(
      text,
    )
  );
}

/** Whether anything is seen behind a NUL, as in no text, and letters that bytes were taken for. */
function isBinary(text: string): boolean {
  const nul = text.indexOf('\0');
  return nul >= 0 && /[!-~\u0080-\uffff]/.test(text.slice(nul)) && /[\u0080-\uffff]/.test(text);
}
