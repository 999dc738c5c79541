import { extname } from 'node:path';
import type { FileFormat } from '../index.js';
import { type Arguments, listed } from './arguments.js';
import { Complaint } from './complaint.js';

/** A format that can be read and written. */
export type AnyFormat = FileFormat | 'glb' | 'gltf';

export const FORMATS: readonly AnyFormat[] = ['obj', 'off', 'ply', 'stl', 'glb', 'gltf'];

/** Whether it is one of the two that three.js reads and writes. */
export function isGltf(format: AnyFormat | undefined): format is 'glb' | 'gltf' {
  return format === 'glb' || format === 'gltf';
}

/** The format that the name of a file tells, or undefined. */
export function formatOfName(path: string): AnyFormat | undefined {
  const extension = extname(path).slice(1).toLowerCase();
  return FORMATS.find((format) => format === extension);
}

/** The format to write, which `--to` tells, or the name of the output, or the input. */
export function outputFormat(args: Arguments, output: string, otherwise?: AnyFormat): AnyFormat {
  const format = args.choice('to', FORMATS) ?? formatOfName(output) ?? otherwise;
  if (format !== undefined) return format;
  const where = output === '-' ? 'Standard output' : `The name ${JSON.stringify(output)}`;
  throw new Complaint(
    `${where} doesn't tell the format to write; expected --to ${listed(FORMATS)}, or a file that ends so.`,
  );
}
