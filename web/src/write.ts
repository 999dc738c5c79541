import { noRoomHere } from './arguments.js';
import { checkCallback, checkFlag, indexOfChoice, refuse } from './checks.js';
import type { Links } from './links.js';
import type { Core } from './loader.js';
import { withInputs } from './memory.js';
import { checkOptions, isPlain, type OptionNames } from './options.js';
import { type AttributeNames, type FileFormat, formatIndex } from './parse.js';
import { sentence, unwrap } from './reports.js';

/**
 * Bytes in a buffer of their own, as a Blob or a Response takes them. Defined in a way that TypeScript before
 * 5.7, which doesn't tell such buffers from shared ones, also understands.
 */
export type OwnBytes = ReturnType<Uint8Array['slice']>;

/** How to write the numbers in a file. */
export type FileEncoding = 'text' | 'binary' | 'binary-big-endian';

/** In the order of the enum Encoding in C++. */
const ENCODINGS: readonly FileEncoding[] = ['text', 'binary', 'binary-big-endian'];

/** The encodings that each format has. */
export interface FileEncodings {
  obj: 'text';
  off: FileEncoding;
  ply: FileEncoding;
  stl: 'text' | 'binary';
}

/** How to write a file: of one format, or of any. */
export interface WriteOptions<Format extends FileFormat = FileFormat> {
  /**
   * Default: text for OBJ and OFF, binary for PLY and STL. `'binary'` uses the byte order that defines the
   * format: little-endian for PLY and STL, big-endian for OFF. Only PLY has another.
   */
  encoding?: FileEncodings[Format] | undefined;
  /** Whether to write attributes, as far as the format has a place for them. Default: true. */
  attributes?: boolean | undefined;
  /**
   * The names behind the numbers of the face attributes `group`, `object` and `material` in OBJ, as in the
   * report of reading it. Without them, numbers are written.
   */
  names?: AttributeNames | undefined;
  /**
   * Called with a sentence for each attribute that is missing or changed in the file, and with one if
   * vertices lie in the same place, where readers of STL will join them.
   */
  onNote?: ((sentence: string) => void) | undefined;
}

const WRITE_OPTIONS: OptionNames<WriteOptions> = {
  encoding: true,
  attributes: true,
  names: true,
  onNote: true,
};

/** The bytes of the file, or its text. */
export function writeFile(links: Links, format: unknown, options: unknown): string | OwnBytes {
  links.checkAlive();
  const index = formatIndex('format', format);
  const { encoding, attributes, names, onNote } = checkWriteOptions(options, format as FileFormat);
  const { core } = links;
  const withNotes = onNote !== undefined;
  const raw = withInputs(core, (inputs) => {
    const { address, count } = inputs.bytes('options.names', names);
    const code = ENCODINGS.indexOf(encoding);
    return core.write(links.address, index, code, attributes, withNotes, address, count);
  });
  const { bytes: block, notes } = unwrap(raw);
  const content = takeContent(core, block, encoding);
  for (const note of notes) onNote?.(sentence(note));
  return content;
}

/** A copy of the bytes of the core, which are freed. */
function takeContent(
  core: Core,
  { address, count }: { address: number; count: number },
  encoding: FileEncoding,
): string | OwnBytes {
  try {
    const bytes = new Uint8Array(core.memory.buffer, address, count);
    return encoding === 'text' ? new TextDecoder().decode(bytes) : bytes.slice();
  } catch (cause) {
    throw noRoomHere(`the file needs room for ${count} bytes`, cause);
  } finally {
    core.free(address);
  }
}

function checkWriteOptions(options: unknown, format: FileFormat) {
  const { encoding, attributes = true, names = {}, onNote } = checkOptions(options, WRITE_OPTIONS);
  checkFlag('options.attributes', attributes);
  checkCallback('options.onNote', onNote);
  return { encoding: encodingOf(encoding, format), attributes, names: textOf(names), onNote };
}

/** Tables as the core reads them: lines, the name of the attribute first, and NUL at the end of each. */
function textOf(names: unknown): Uint8Array {
  if (!isPlain(names)) refuse('options.names', names, 'a plain object of lists of names');
  let text = '';
  for (const [attribute, list] of Object.entries(names)) {
    if (!Array.isArray(list) || !list.every((name) => typeof name === 'string')) {
      refuse(`options.names.${attribute}`, list, 'strings');
    }
    // Of the control characters, of which the core makes _ and says so, these two end words.
    const words = [attribute, ...list].map((word) => `${word.replace(/[\0\n]/g, '\x01')}\n`);
    text += `${words.join('')}\0`;
  }
  return new TextEncoder().encode(text);
}

function encodingOf(encoding: FileEncoding | undefined, format: FileFormat): FileEncoding {
  if (encoding === undefined) return format === 'obj' || format === 'off' ? 'text' : 'binary';
  return ENCODINGS[indexOfChoice('options.encoding', encoding, ENCODINGS)];
}
