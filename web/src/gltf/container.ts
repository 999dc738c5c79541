import { HalfedgeError } from '../errors.js';
import { messageOf } from '../loader.js';

/** A glTF file taken apart. */
export interface GltfFile {
  readonly format: 'glb' | 'gltf';
  /** Whatever the JSON holds: `checkDocument` looks at it. */
  readonly json: unknown;
  /** The binary chunk of a GLB file. */
  readonly binary?: Uint8Array;
}

const MAGIC = 0x46546c67; // "glTF"
const JSON_CHUNK = 0x4e4f534a;
const BINARY_CHUNK = 0x004e4942;

/** An error of a file, with what was expected. On one line, also where it quotes names or text of the file. */
export const fileError = (code: string, message: string) =>
  new HalfedgeError(code, message.replace(/\p{Cc}+/gu, ' '));

/** Whether the bytes are a GLB file, or text that begins as a JSON object does, and not as Geomview's: `{ OFF 8 6 12`. */
export function looksLikeGltf(bytes: Uint8Array): boolean {
  if (bytes.length >= 4 && viewOf(bytes).getUint32(0, true) === MAGIC) return true;
  return /^\uFEFF?\s*\{(?!\s*[a-z\d]+\s+[^\s:])/i.test(
    new TextDecoder().decode(bytes.subarray(0, 64)),
  );
}

/** Takes a file apart: GLB by its first four bytes, else JSON. */
export function openGltf(bytes: Uint8Array): GltfFile {
  if (bytes.length === 0) {
    throw fileError('unknown-format', 'The file is empty (0 bytes), expected a glTF or GLB file.');
  }
  const isBinary = bytes.length >= 4 && viewOf(bytes).getUint32(0, true) === MAGIC;
  return isBinary ? openGlb(bytes) : { format: 'gltf', json: parseJson(bytes, 0) };
}

function openGlb(bytes: Uint8Array): GltfFile {
  const view = viewOf(bytes);
  if (bytes.length < 12) throw truncated(bytes.length, 'a header of 12 bytes');
  const version = view.getUint32(4, true);
  if (version !== 2) {
    throw fileError('unsupported-format', `Byte 4: the version of GLB is ${version}, expected 2.`);
  }
  const end = view.getUint32(8, true);
  if (end > bytes.length) throw truncated(bytes.length, `${end} bytes as its header says`);
  let json: unknown;
  let binary: Uint8Array | undefined;
  for (let at = 12, chunk = 0; at < end; chunk++) {
    if (end - at < 8) throw truncated(end, `the header of a chunk at byte ${at}`);
    const length = view.getUint32(at, true);
    const kind = view.getUint32(at + 4, true);
    const begin = at + 8;
    if (length > end - begin) {
      throw truncated(end, `a chunk of ${length} bytes from byte ${begin} on`);
    }
    if ((chunk === 0) !== (kind === JSON_CHUNK)) {
      throw fileError(
        'parse-error',
        `Byte ${at + 4}: chunk ${chunk} is ${chunk === 0 ? 'not JSON' : 'JSON'}, expected JSON first, and once.`,
      );
    }
    const content = bytes.subarray(begin, begin + length);
    if (kind === JSON_CHUNK) json = parseJson(content, begin);
    else if (kind === BINARY_CHUNK) binary ??= content;
    at = begin + length; // chunks of other kinds are to be ignored
  }
  if (json === undefined) throw truncated(end, 'a chunk of JSON at byte 12');
  return binary === undefined ? { format: 'glb', json } : { format: 'glb', json, binary };
}

function parseJson(bytes: Uint8Array, offset: number): unknown {
  let text: string;
  try {
    text = new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    throw fileError(
      'not-text',
      `Byte ${offset}: what follows is no text in UTF-8, expected the JSON of a glTF file.`,
    );
  }
  try {
    return JSON.parse(text);
  } catch (cause) {
    throw fileError(
      'parse-error',
      `Byte ${offset}: what follows is not the JSON of a glTF file: ${messageOf(cause)}.`,
    );
  }
}

const truncated = (size: number, expected: string) =>
  fileError('truncated', `The GLB file ends at byte ${size}, expected ${expected}.`);

const viewOf = (bytes: Uint8Array) =>
  new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);

/** A GLB file of a document with one buffer, or with none. */
export function makeGlb(json: unknown, binary?: Uint8Array): ArrayBuffer {
  const text = new TextEncoder().encode(JSON.stringify(json));
  const textSize = Math.ceil(text.length / 4) * 4;
  const size = 12 + 8 + textSize + (binary === undefined ? 0 : 8 + binary.length);
  const glb = new Uint8Array(size);
  const view = viewOf(glb);
  const words = [MAGIC, 2, size, textSize, JSON_CHUNK];
  for (const [i, word] of words.entries()) view.setUint32(4 * i, word, true);
  glb.fill(0x20, 20, 20 + textSize).set(text, 20);
  if (binary === undefined) return glb.buffer;
  view.setUint32(20 + textSize, binary.length, true);
  view.setUint32(24 + textSize, BINARY_CHUNK, true);
  glb.set(binary, 28 + textSize);
  return glb.buffer;
}
