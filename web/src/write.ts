import { checkOptions, describe } from './arguments.js';
import type { Links } from './links.js';
import { outOfMemory } from './memory.js';
import { type FileFormat, formatIndex } from './parse.js';
import { unwrap } from './reports.js';

/** How the numbers of a file are written. */
export type FileEncoding = 'text' | 'binary' | 'binary-big-endian';

/** In the order of the enum Encoding in C++. */
const ENCODINGS: readonly FileEncoding[] = ['text', 'binary', 'binary-big-endian'];

/** How to write a file. */
export interface WriteOptions {
  /**
   * Text for OBJ and OFF and binary for PLY and STL where it is left out. `'binary'` is in the byte
   * order that the format is defined with: little-endian of PLY and STL, big-endian of OFF. Only PLY
   * has another.
   */
  encoding?: FileEncoding;
}

/** The bytes of the file, or its text. */
export function writeFile(links: Links, format: unknown, options: unknown): string | Uint8Array {
  links.checkAlive();
  const index = formatIndex('format', format);
  const encoding = encodingOf(checkOptions(options), format as FileFormat);
  const { core } = links;
  const { address, count } = unwrap(
    core.write(links.address, index, ENCODINGS.indexOf(encoding)),
  ).bytes;
  try {
    const bytes = new Uint8Array(core.memory.buffer, address, count);
    return encoding === 'text' ? new TextDecoder().decode(bytes) : bytes.slice();
  } catch {
    throw outOfMemory(`The ${count} bytes of the file`);
  } finally {
    core.free(address);
  }
}

function encodingOf({ encoding }: WriteOptions, format: FileFormat): FileEncoding {
  if (encoding === undefined) return format === 'obj' || format === 'off' ? 'text' : 'binary';
  if (ENCODINGS.includes(encoding)) return encoding;
  const sentence = `options.encoding is ${describe(encoding)}; expected 'text', 'binary' or 'binary-big-endian'.`;
  throw typeof encoding === 'string' ? new RangeError(sentence) : new TypeError(sentence);
}
