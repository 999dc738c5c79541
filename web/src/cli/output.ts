import { rmSync, type Stats } from 'node:fs';
import {
  access,
  constants,
  type FileHandle,
  lstat,
  open,
  realpath,
  rename,
  rm,
  stat,
  writeFile,
} from 'node:fs/promises';
import { basename, dirname, join } from 'node:path';
import { writeGltf } from '../gltf/index.js';
import type { AttributeNames, FileEncoding, HalfedgeMesh, WriteOptions } from '../index.js';
import type { Arguments } from './arguments.js';
import { Complaint, isSystemError, orComplain, unwritable } from './complaint.js';
import { type AnyFormat, isGltf } from './formats.js';
import type { Loaded } from './input.js';

const ENCODINGS: readonly FileEncoding[] = ['text', 'binary', 'binary-big-endian'];

/** A line on standard output. */
export function print(line: string): void {
  process.stdout.write(`${line}\n`);
}

/** A line on standard error. */
export function printError(line: string): void {
  process.stderr.write(`${line}\n`);
}

/** Names and values, in two columns. */
export function table(rows: readonly (readonly [string, string])[]): string {
  const width = Math.max(...rows.map(([name]) => name.length)) + 2;
  return rows.map(([name, value]) => `${name.padEnd(width)}${value}`.trimEnd()).join('\n');
}

/**
 * Writes a mesh, and the names that its report has, to a file or to standard output (`-`). Returns a
 * sentence for each thing that is not in it.
 */
export async function save(
  { mesh, report }: Loaded,
  path: string,
  format: AnyFormat,
  args: Arguments,
): Promise<string[]> {
  const encoding = args.choice('encoding', ENCODINGS);
  const notes: string[] = [];
  const content = await orComplain(nameOfOutput(path), () =>
    contentOf(mesh, format, {
      ...(encoding === undefined ? {} : { encoding }),
      ...('names' in report ? { names: report.names as AttributeNames } : {}),
      onNote: (note) => notes.push(note),
    }),
  );
  if (path === '-' && process.stdout.isTTY && typeof content !== 'string') {
    const inText = isGltf(format) ? '--to gltf' : '--encoding text';
    throw new Complaint(
      `Binary ${format.toUpperCase()} is nothing for a terminal; name a file for it, or ask for ${inText}.`,
    );
  }
  try {
    if (path !== '-') {
      await replaceFile(path, content);
      return notes;
    }
    await new Promise<void>((resolve, reject) => {
      process.stdout.write(content, (error) => (error ? reject(error) : resolve()));
    });
  } catch (error) {
    if (!isSystemError(error)) throw error;
    if (path === '-') return notes; // main.ts tells, and ends the program
    throw new Complaint(unwritable(path, error));
  }
  return notes;
}

/**
 * Writes a file under another name first, so that what was there is lost only to the whole of the new one:
 * `repair scan.ply scan.ply` on a full disk. What is no file (a pipe, a device, a link to nothing), and what lies
 * in a folder that takes no new file, is written to as it is.
 */
async function replaceFile(path: string, content: string | Uint8Array): Promise<void> {
  const known = await stat(path)
    .catch(() => lstat(path))
    .catch(() => undefined);
  if (known !== undefined && !known.isFile()) return writeFile(path, content);
  if (known !== undefined) await access(path, constants.W_OK);
  const target = known === undefined ? path : await realpath(path);
  const draft = join(dirname(target), `.${basename(target)}.${process.pid}.part`);
  await unlessEnded(draft, async () => {
    const file = await open(draft, 'wx', known?.mode).catch(() => undefined);
    if (file === undefined) return writeFile(path, content);
    try {
      if (known !== undefined) await giveTo(file, known);
      await file.writeFile(content);
      await file.close();
      await rename(draft, target);
    } catch (error) {
      await file.close().catch(() => {});
      await rm(draft, { force: true });
      throw error;
    }
  });
}

/** Gives a file the owner and the permissions of another, as far as that is allowed. */
async function giveTo(file: FileHandle, { uid, gid, mode }: Stats): Promise<void> {
  await file.chown(uid, gid).catch(() => {});
  await file.chmod(mode & 0o777).catch(() => {});
}

/** The signals that end a program: Ctrl-C, `kill`, a terminal that is closed. */
const ENDING = ['SIGINT', 'SIGTERM', 'SIGHUP'] as const;

/** Does some work; a signal that ends the program meanwhile takes a file with it. */
async function unlessEnded(path: string, work: () => Promise<void>): Promise<void> {
  const end = (signal: NodeJS.Signals) => {
    rmSync(path, { force: true });
    process.kill(process.pid, signal); // nobody listens to it any more
  };
  for (const signal of ENDING) process.once(signal, end);
  try {
    await work();
  } finally {
    for (const signal of ENDING) process.off(signal, end);
  }
}

/** What a file to write is called in messages. */
export const nameOfOutput = (path: string) => (path === '-' ? 'standard output' : path);

async function contentOf(
  mesh: HalfedgeMesh,
  format: AnyFormat,
  options: WriteOptions,
): Promise<string | Uint8Array> {
  if (isGltf(format) && options.encoding !== undefined) {
    throw new Complaint('--encoding is for OBJ, OFF, PLY and STL; choose --to glb or --to gltf.');
  }
  if (!isGltf(format)) return mesh.write(format, options);
  const { onNote } = options;
  return writeGltf(mesh, onNote === undefined ? { format } : { format, onNote });
}

/**
 * Turns texture coordinates upside down where a file goes from glTF, which counts from the upper edge of
 * an image, to a format that counts from the lower one, or the other way.
 */
export function adaptTextures(mesh: HalfedgeMesh, from: AnyFormat, to: AnyFormat): void {
  if (isGltf(from) === isGltf(to)) return;
  for (const { kind, name, components } of mesh.attributes.list()) {
    if (name !== 'uv' || components !== 2) continue;
    const uv = mesh.attributes.get(kind, name);
    for (let i = 1; i < uv.length; i += 2) uv[i] = 1 - uv[i];
  }
}
