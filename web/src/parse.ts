import { bytesOf, describe } from './arguments.js';
import { type StorageOptions, storesPrev } from './build.js';
import type { Problem } from './errors.js';
import { Links } from './links.js';
import { core } from './loader.js';
import { withInputs } from './memory.js';
import { sentence, unwrap } from './reports.js';

/** The file formats that can be read and written. */
export type FileFormat = 'obj' | 'off' | 'ply' | 'stl';

/** In the order of the enum Format in C++. */
const FORMATS: readonly FileFormat[] = ['obj', 'off', 'ply', 'stl'];

/** How to read a file. */
export interface ParseOptions extends StorageOptions {
  /** Decides where the content leaves the format open. The content is believed first. */
  format?: FileFormat;
  /**
   * Whether faces that make no manifold may be mended. Nothing is mended yet: they are an error, as in
   * a strict build, whatever is said here.
   */
  repair?: boolean;
}

/** What reading a file has found. */
export interface ParseReport {
  /** The format of the content. */
  readonly format: FileFormat;
  /** What was ignored or is worth knowing; nothing that stood in the way of the mesh. */
  readonly problems: readonly Problem[];
  /** All of it in one readable line. */
  readonly summary: string;
}

/** The mesh in a file. */
export function parseFile(data: unknown, options: unknown): { links: Links; report: ParseReport } {
  const withPrev = storesPrev(options);
  const claimed = claimedFormat(options as ParseOptions);
  const bytes = contentOf(data);
  const wasm = core();
  const raw = withInputs(wasm, (inputs) => {
    const { address, count } = inputs.bytes('data', bytes);
    return wasm.parse(address, count, claimed, withPrev);
  });
  const { mesh, format, notes } = unwrap(raw);
  const links = new Links(wasm, mesh);
  return { links, report: reportOf(links, FORMATS[format], notes.map(sentence)) };
}

function claimedFormat({ format, repair }: ParseOptions): number {
  if (repair !== undefined && typeof repair !== 'boolean') {
    throw new TypeError(`options.repair is ${describe(repair)}; expected true or false.`);
  }
  return format === undefined ? -1 : formatIndex('options.format', format);
}

/** The value of the enum Format in C++. */
export function formatIndex(argument: string, format: unknown): number {
  const index = FORMATS.indexOf(format as FileFormat);
  if (index >= 0) return index;
  const sentence = `${argument} is ${describe(format)}; expected 'obj', 'off', 'ply' or 'stl'.`;
  throw typeof format === 'string' ? new RangeError(sentence) : new TypeError(sentence);
}

function contentOf(data: unknown): Uint8Array {
  if (typeof data === 'string') return new TextEncoder().encode(data);
  const bytes = bytesOf('data', data);
  if (bytes !== undefined) return bytes;
  throw new TypeError(
    `data is ${describe(data)}; expected the content of a file as a string, an ArrayBuffer or a Uint8Array.`,
  );
}

function reportOf(links: Links, format: FileFormat, notes: string[]): ParseReport {
  const problems = notes.map((message): Problem => {
    return { code: 'note', severity: 'info', kind: 'mesh', index: -1, message };
  });
  const counts = [
    counted(links.vertexCount, 'vertex', 'vertices'),
    counted(links.edgeCount, 'edge', 'edges'),
    counted(links.faceCount, 'face', 'faces'),
  ];
  const found = `${format.toUpperCase()}: ${counts.join(', ')}.`;
  return { format, problems, summary: [found, ...notes].join(' ') };
}

const counted = (count: number, one: string, many: string) =>
  `${count} ${count === 1 ? one : many}`;
