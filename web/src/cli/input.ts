import { open } from 'node:fs/promises';
import { pathToFileURL } from 'node:url';
import { looksLikeGltf } from '../gltf/container.js';
import { readGltf } from '../gltf/index.js';
import { HalfedgeError, HalfedgeMesh, type ParseStage, type RepairReport } from '../index.js';
import type { Arguments } from './arguments.js';
import { Complaint, isSystemError, orComplain, reasonOf } from './complaint.js';
import { type AnyFormat, FORMATS, formatOfName, isGltf } from './formats.js';
import { print, printError } from './output.js';
import type { Progress } from './progress.js';

/** What a file is read by at a time. */
const CHUNK = 2 ** 22;

/** A file that has become a mesh. */
export interface Loaded {
  readonly mesh: HalfedgeMesh;
  readonly report: RepairReport & { readonly format: AnyFormat };
  /** Bytes of the file. */
  readonly size: number;
}

/** What a file is called in messages. */
export const nameOf = (path: string) => (path === '-' ? 'standard input' : path);

/** Reads a file (`-`: standard input) and makes a mesh of it, repaired where that is necessary. */
export async function load(path: string, args: Arguments, progress: Progress): Promise<Loaded> {
  const claimed = args.choice('from', FORMATS) ?? formatOfName(path);
  progress.begin(nameOf(path));
  try {
    const bytes = await readBytes(path, progress);
    const { mesh, report } = await orComplain(nameOf(path), () =>
      meshOf(bytes, path, claimed, (fraction, stage) => progress.update(STAGES[stage], fraction)),
    );
    return { mesh, report, size: bytes.length };
  } finally {
    progress.clear();
  }
}

/** What the work on a file is called, after its bytes are there. */
const STAGES = { read: 'parsing', repair: 'repairing', build: 'building' } as const;

async function meshOf(
  bytes: Uint8Array,
  path: string,
  format: AnyFormat | undefined,
  onProgress: (fraction: number, stage: ParseStage) => void,
) {
  // Buffers in other files lie beside it.
  const asGltf = () =>
    readGltf(bytes, path === '-' ? {} : { baseUrl: pathToFileURL(path) }).catch(refuseOptions);
  if (looksLikeGltf(bytes)) return asGltf();
  if (!isGltf(format)) {
    return HalfedgeMesh.parse(bytes, { ...(format === undefined ? {} : { format }), onProgress });
  }
  // The content is believed first, whatever the name says; where it says nothing, glTF's sentence is told.
  try {
    return HalfedgeMesh.parse(bytes, { onProgress });
  } catch (error) {
    if (error instanceof HalfedgeError && error.code === 'unknown-format') return asGltf();
    throw error;
  }
}

/**
 * The package asks for options that there are none of here: Draco's decoder needs workers as browsers have them,
 * and nothing lies beside standard input.
 */
function refuseOptions(error: unknown): never {
  if (!(error instanceof HalfedgeError)) throw error;
  const { code, message } = error;
  const told = message.includes('options.dracoLoader')
    ? 'glTF: Draco has compressed the geometry, which this program does not decode: the explorer does, and saves it in other formats.'
    : message.replace(
        'expected options.baseUrl or options.resource to get it',
        'expected the name of the file, beside which it is looked for, instead of standard input',
      );
  throw told === message ? error : new HalfedgeError(code, told, { cause: error });
}

/** The bytes of a file, read into memory once. */
async function readBytes(path: string, progress: Progress): Promise<Uint8Array> {
  try {
    if (path === '-') return await readAll(process.stdin, progress);
    const file = await open(path);
    try {
      const stat = await file.stat();
      if (stat.isDirectory()) throw new Complaint(`${path} is a folder; expected a file.`);
      // A device or a pipe doesn't know its size.
      if (!stat.isFile())
        return await readAll(file.createReadStream({ autoClose: false }), progress);
      const bytes = new Uint8Array(stat.size);
      let at = 0;
      while (at < bytes.length) {
        const { bytesRead } = await file.read(bytes, at, Math.min(CHUNK, bytes.length - at));
        if (bytesRead === 0) break; // it was cut meanwhile
        at += bytesRead;
        progress.update('reading', at / bytes.length);
      }
      return bytes.subarray(0, at);
    } finally {
      await file.close();
    }
  } catch (error) {
    if (error instanceof RangeError) {
      throw new Complaint(`${nameOf(path)} is too large to be read into memory.`);
    }
    if (!isSystemError(error)) throw error;
    throw new Complaint(`${nameOf(path)} can't be read: ${reasonOf(error)}.`);
  }
}

/** All that a stream brings, whose length isn't known before it ends. */
async function readAll(stream: AsyncIterable<Buffer>, progress: Progress): Promise<Uint8Array> {
  const chunks: Buffer[] = [];
  for await (const chunk of stream) {
    chunks.push(chunk);
    progress.update('reading', 0);
  }
  return Buffer.concat(chunks);
}

/** The files that a command reads: those named, or else standard input. */
export function inputsOf(operands: readonly string[]): readonly string[] {
  if (operands.filter((path) => path === '-').length > 1) {
    throw new Complaint('Standard input (-) is named twice; it can be read once.');
  }
  refuseEmptyNames(operands);
  if (operands.length > 0) return operands;
  if (process.stdin.isTTY) {
    throw new Complaint('No file is named; expected one, or - for standard input.');
  }
  return ['-'];
}

/** A name is empty where a variable of a script is, and then no message could tell which. */
export function refuseEmptyNames(paths: readonly string[]): void {
  if (paths.includes('')) throw new Complaint('The name of a file is empty ("").');
}

/**
 * Does the same for several files, which gives each an exit status; returns the highest. A file that can't
 * be read is told of, and stops no other.
 */
export async function forEachFile(
  paths: readonly string[],
  args: Arguments,
  work: (path: string) => Promise<number>,
): Promise<number> {
  let status = 0;
  for (const path of paths) {
    try {
      status = Math.max(status, await work(path));
    } catch (error) {
      if (!(error instanceof Complaint)) throw error;
      status = 2;
      if (args.has('json')) {
        print(unreadable(path, error));
      } else {
        printError(`halfedge: ${error.message}`);
      }
    }
  }
  return status;
}

/**
 * `load`, for a command whose report goes to `tell`: so does JSON of a file that can't be read, where that is
 * asked for; there is no mesh then.
 */
export async function loadOrTell(
  path: string,
  args: Arguments,
  progress: Progress,
  tell: (line: string) => void,
): Promise<Loaded | undefined> {
  try {
    return await load(path, args, progress);
  } catch (error) {
    if (!(error instanceof Complaint && args.has('json'))) throw error;
    tell(unreadable(path, error));
    return undefined;
  }
}

/** What JSON has of a file that can't be read. */
const unreadable = (path: string, { message }: Complaint) =>
  JSON.stringify({ file: nameOf(path), readable: false, error: message });
