import { bytesOf, describe } from '../arguments.js';
import { refuse } from '../checks.js';
import { counted } from '../counted.js';
import { bytesIn } from '../letters.js';
import { messageOf } from '../loader.js';
import { nodeModule } from '../node-module.js';
import { fileError, type GltfFile } from './container.js';
import type { GltfDocument, GltfView } from './document.js';

/** Where the other files of a document come from. */
export interface GltfResources {
  /** The whole address of the file, to which the names of other files are relative. */
  readonly baseUrl?: URL | string | undefined;
  /** Gets the content of another file by its name in the document, instead of fetching it. */
  readonly resource?:
    | ((uri: string) => Promise<ArrayBuffer | Uint8Array> | ArrayBuffer | Uint8Array)
    | undefined;
}

/** More than any stride: three.js reads the last row of interleaved data with what lies behind it. */
const PADDING = 256;

/** All buffers of a document as one, and the document that refers to it. */
export async function joinBuffers(
  document: GltfDocument,
  file: GltfFile,
  resources: GltfResources,
): Promise<{ document: GltfDocument; binary: Uint8Array }> {
  const parts = await contents(document, file, resources);
  const { starts, binary } = inARow(parts);
  const bufferViews = document.bufferViews.map((view) => moveView(view, starts));
  const buffers = [{ byteLength: binary.length }];
  return { document: { ...document, bufferViews, buffers }, binary };
}

/** The bytes of each buffer. */
async function contents(
  document: GltfDocument,
  { binary }: GltfFile,
  resources: GltfResources,
): Promise<Uint8Array[]> {
  const parts: Uint8Array[] = [];
  for (const [i, { uri, byteLength, extensions = {} }] of document.buffers.entries()) {
    if (uri === undefined && Object.values(extensions).some(({ fallback }) => fallback === true)) {
      parts.push(new Uint8Array(0)); // its views are decompressed from another
      continue;
    }
    const bytes = uri === undefined ? binaryChunk(i, binary) : await content(i, uri, resources);
    if (bytes.length < byteLength) {
      throw fileError(
        'truncated',
        `glTF: buffers[${i}] has ${counted(bytes.length, 'byte')}, expected ${byteLength} as the document says.`,
      );
    }
    parts.push(bytes.subarray(0, byteLength));
  }
  return parts;
}

/** All parts in one array, and where each begins: where numbers of any size may. */
function inARow(parts: readonly Uint8Array[]): { starts: number[]; binary: Uint8Array } {
  const starts: number[] = [];
  let size = 0;
  for (const { length } of parts) {
    starts.push(size);
    size += Math.ceil(length / 8) * 8;
  }
  let binary: Uint8Array;
  try {
    binary = new Uint8Array(size + PADDING);
  } catch {
    throw fileError(
      'out-of-memory',
      `The ${size} bytes of the buffers are more than JavaScript has.`,
    );
  }
  for (const [i, part] of parts.entries()) binary.set(part, starts[i]);
  return { starts, binary };
}

/** The view as one of the buffer that has all. */
function moveView(view: GltfView, starts: readonly number[]): GltfView {
  const { buffer, byteOffset = 0, byteLength, byteStride = 0, extensions = {} } = view;
  return {
    ...view,
    buffer: 0,
    byteOffset: starts[buffer] + byteOffset,
    byteLength: byteLength + byteStride,
    // Those of compressed views lie in a buffer of their own.
    extensions: Object.fromEntries(
      Object.entries(extensions).map(([name, extension]) => [
        name,
        moveExtension(extension, starts),
      ]),
    ),
  };
}

function moveExtension(
  extension: Record<string, unknown>,
  starts: readonly number[],
): Record<string, unknown> {
  const { buffer, byteOffset = 0 } = extension as Partial<GltfView>;
  const start = typeof buffer === 'number' ? starts[buffer] : undefined;
  return start === undefined
    ? extension
    : { ...extension, buffer: 0, byteOffset: start + byteOffset };
}

function binaryChunk(buffer: number, binary: Uint8Array | undefined): Uint8Array {
  if (binary !== undefined && buffer === 0) return binary;
  throw fileError(
    'truncated',
    `glTF: buffers[${buffer}] has no address, expected ${buffer === 0 ? 'a binary chunk with its bytes' : 'one'}.`,
  );
}

async function content(i: number, uri: string, resources: GltfResources): Promise<Uint8Array> {
  const data = /^data:[^,]*?(;base64)?,(.*)$/s.exec(uri);
  if (data !== null) return decodeData(i, data[1] !== undefined, data[2]);
  if (resources.resource !== undefined) {
    const given: unknown = await resources.resource(uri);
    const bytes = bytesOf('resource', given);
    if (bytes !== undefined) return bytes;
    throw new TypeError(
      `options.resource gave ${describe(given)} for ${describe(uri)}; expected an ArrayBuffer or a Uint8Array.`,
    );
  }
  let address: URL;
  try {
    address = new URL(escaped(uri), resources.baseUrl);
  } catch {
    checkBase(resources.baseUrl);
    throw fileError(
      'missing-resource',
      `glTF: buffers[${i}] is in another file, ${describe(uri)}; expected options.baseUrl or options.resource to get it.`,
    );
  }
  return load(address);
}

/** As an address has it, where a program wrote the bare name of a file: buffers have no fragments. */
const escaped = (uri: string) =>
  uri.replace(/#|%(?![\da-f]{2})/gi, (letter) => encodeURIComponent(letter));

/** Throws for an address that leads nowhere by itself, such as `/models/` in a page. */
function checkBase(baseUrl: URL | string | undefined): void {
  if (baseUrl === undefined) return;
  try {
    new URL(baseUrl);
  } catch {
    const expected = 'the whole address of the file, such as new URL(path, document.baseURI)';
    refuse('options.baseUrl', baseUrl, expected, 'string');
  }
}

function decodeData(i: number, isBase64: boolean, text: string): Uint8Array {
  let letters = unescaped(text);
  try {
    if (isBase64) letters = atob(letters);
    else if (/[^\0-\xff]/.test(letters)) throw new RangeError('a letter that is no byte');
  } catch {
    throw fileError(
      'parse-error',
      `glTF: buffers[${i}].uri is a broken data: address, expected base64.`,
    );
  }
  return bytesIn(letters);
}

/** Each %41 as the letter of that byte. */
function unescaped(text: string): string {
  if (!text.includes('%')) return text;
  return text.replace(/%([\da-f]{2})/gi, (_, byte) =>
    String.fromCharCode(Number.parseInt(byte, 16)),
  );
}

/** Another file, which Node's fetch can't get from the disk. */
export async function load(address: URL): Promise<Uint8Array> {
  const failed = (why: string) =>
    fileError('missing-resource', `glTF: ${address.href} can't be loaded: ${why}.`);
  try {
    const files = address.protocol === 'file:' ? nodeModule('node:fs/promises') : undefined;
    if (files !== undefined) return await files.readFile(address);
    const response = await fetch(address);
    if (response.ok) return new Uint8Array(await response.arrayBuffer());
    throw new Error(`the server answered ${response.status} ${response.statusText}`.trimEnd());
  } catch (error) {
    throw failed(messageOf(error).replace(/, open '.*/, ''));
  }
}
