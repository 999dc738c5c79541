// The content of a file: what is often passed instead, and how it becomes bytes.

import { bytesOf, describe } from './arguments.js';
import { refuse } from './checks.js';
import type { RawFailure } from './core.js';
import { HalfedgeError } from './errors.js';
import { unwrap } from './reports.js';

/** The bytes of a file, which may be given as text. Throws a sentence for what is no content of one. */
export function contentOf(
  data: unknown,
  expected = 'the content of a file as a string, an ArrayBuffer or a Uint8Array',
): Uint8Array {
  if (typeof data === 'string') {
    checkText('data', data);
    return new TextEncoder().encode(data);
  }
  const bytes = bytesOf('data', data);
  if (bytes !== undefined) return bytes;
  refuse('data', data, expected + (isBody(data) ? ': await its arrayBuffer()' : ''));
}

/** Whether it is a File, another Blob or a Response, also of another realm. */
const isBody = (data: unknown) => /^\[object (Blob|File|Response)\]$/.test(tagOf(data));
const tagOf = (data: unknown): string => Object.prototype.toString.call(data);

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

/** What the core has read of a file; throws what it failed of, and tells where glTF is read. */
export function unwrapFile<T extends object>(raw: T | RawFailure): T {
  if ('problems' in raw) {
    const [problem] = raw.problems;
    if (problem.code === 'unsupported-format' && /GLB|glTF/.test(problem.message)) {
      problem.message += ': glTF is read by readGltf of halfedge/gltf';
    }
  }
  return unwrap(raw);
}

/**
 * One word that is an address, or a line that ends as names of files do; no file has nothing else in it, but a
 * statement that names another.
 */
function isName(text: string): boolean {
  return text.length < 2000 && (ADDRESS.test(text) || (NAME.test(text) && !STATEMENT.test(text)));
}

const ADDRESS = /^(?:https?|file|blob|data):\S*$/i;
const NAME = /^[^#\s][^\r\n]*\.(?:obj|off|ply|stl|gltf|glb)(?:[?#]\S*)?$/i;
/** Of OBJ and STL. */
const STATEMENT = /^(?:o|g|s|call|mtllib|usemtl|maplib|usemap|shadow_obj|trace_obj|solid)[ \t]/i;

/** Whether anything is seen behind a NUL, as in no text, and letters that bytes were taken for. */
function isBinary(text: string): boolean {
  const nul = text.indexOf('\0');
  return nul >= 0 && /[!-~\u0080-\uffff]/.test(text.slice(nul)) && /[\u0080-\uffff]/.test(text);
}
