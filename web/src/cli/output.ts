import { writeFile } from 'node:fs/promises';
import type { FileEncoding, FileFormat, HalfedgeMesh } from '../index.js';
import { HalfedgeError } from '../index.js';
import type { Arguments } from './arguments.js';
import { Complaint, isSystemError, reasonOf } from './complaint.js';

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

/** "1 face", "12 faces". */
export function counted(count: number, one: string, many = `${one}s`): string {
  return `${count} ${count === 1 ? one : many}`;
}

/** Writes a mesh to a file, or to standard output (`-`). */
export async function save(
  mesh: HalfedgeMesh,
  path: string,
  format: FileFormat,
  args: Arguments,
): Promise<void> {
  const content = contentOf(mesh, format, args.choice('encoding', ENCODINGS));
  if (path === '-' && process.stdout.isTTY && typeof content !== 'string') {
    throw new Complaint(
      `Binary ${format.toUpperCase()} is nothing for a terminal; name a file for it, or ask for --encoding text.`,
    );
  }
  try {
    if (path !== '-') return await writeFile(path, content);
    await new Promise<void>((resolve, reject) => {
      process.stdout.write(content, (error) => (error ? reject(error) : resolve()));
    });
  } catch (error) {
    if (!isSystemError(error)) throw error;
    if (path === '-' && error.code === 'EPIPE') return; // main.ts ends the program
    throw new Complaint(
      `${path === '-' ? 'Standard output' : path} can't be written: ${reasonOf(error)}.`,
    );
  }
}

function contentOf(
  mesh: HalfedgeMesh,
  format: FileFormat,
  encoding: FileEncoding | undefined,
): string | Uint8Array {
  try {
    return mesh.write(format, encoding === undefined ? {} : { encoding });
  } catch (error) {
    if (error instanceof HalfedgeError) throw new Complaint(error.message);
    throw error;
  }
}
