import { STORAGE_OPTIONS, type StorageOptions, storesPrev } from './build.js';
import { checkFlag, indexOfChoice } from './checks.js';
import type { RawRepair } from './core.js';
import { contentOf, unwrapFile } from './file-content.js';
import { nameIn } from './letters.js';
import { Links } from './links.js';
import { core } from './loader.js';
import { withInputs } from './memory.js';
import { checkOptions, type OptionNames } from './options.js';
import { follow, PROGRESS_OPTIONS, type ProgressOptions } from './progress.js';
import { type RepairReport, repairReport, untouched } from './repair.js';
import { fileReport, sentence } from './reports.js';

/** The file formats that can be read and written. */
export type FileFormat = 'obj' | 'off' | 'ply' | 'stl';

/** In the order of the enum Format in C++. */
export const FORMATS: readonly FileFormat[] = ['obj', 'off', 'ply', 'stl'];

/** How to read a file. */
export interface ParseOptions extends StorageOptions, ProgressOptions {
  /** Decides if the content leaves the format open; otherwise the content decides. */
  format?: FileFormat | undefined;
  /**
   * Whether faces that don't form a manifold are repaired, as by {@link HalfedgeMesh.fromSoup}, and reported;
   * otherwise they are an error, as in a strict build. Files that need no repair give the same mesh either
   * way. Default: true.
   */
  repair?: boolean | undefined;
  /**
   * Whether everything else that the file says about vertices, corners and faces becomes
   * {@link HalfedgeMesh.attributes}: `normal`, `color`, `uv`, and whatever else it names. Texture coordinates
   * and normals of corners become attributes of halfedges. With false, they cost nothing. Default: true.
   */
  attributes?: boolean | undefined;
}

export const PARSE_OPTIONS: OptionNames<ParseOptions> = {
  ...STORAGE_OPTIONS,
  ...PROGRESS_OPTIONS,
  format: true,
  repair: true,
  attributes: true,
};

/** What reading a file has found: what was repaired, followed by what was ignored. */
export interface ParseReport extends RepairReport {
  /** The format of the content. */
  readonly format: FileFormat;
  /**
   * For an OBJ file, the names behind the numbers of the face attributes `group`, `object` and `material`:
   * `names.material[2]` is the material of faces with the value 2, and `names.material[0]` stands for none.
   * Left out if the names are numbers themselves. `names.library` lists the material files. Pass it on to
   * {@link HalfedgeMesh.write}.
   */
  readonly names: AttributeNames;
}

/** The names behind the numbers of an attribute, by the name of the attribute. */
export type AttributeNames = Readonly<Record<string, readonly string[]>>;

/** The mesh in a file. */
export function parseFile(data: unknown, options: unknown): { links: Links; report: ParseReport } {
  const given = checkOptions(options, PARSE_OPTIONS);
  const { claimed, repair, attributes, withPrev } = checkParseOptions(given);
  const follower = follow(given);
  const bytes = contentOf(data);
  const wasm = core();
  const raw = withInputs(wasm, (inputs) => {
    const { address, count } = inputs.bytes('data', bytes);
    return wasm.parse(address, count, claimed, repair, attributes, withPrev, follower.report);
  });
  follower.check(raw);
  const done = unwrapFile(raw);
  return new Links(wasm, done.mesh).orDispose((links) => {
    const found = repair
      ? repairReport(wasm, done as RawRepair)
      : untouched(links.vertexCount, links.faceCount);
    const notes = done.notes.map(sentence);
    const format = FORMATS[done.format];
    const report = fileReport(format.toUpperCase(), links, found, notes);
    return { links, report: { ...report, format, names: namesIn(done.names) } };
  });
}

/** The names of a file, of which the core gives the letters of bytes. */
export function namesIn(raw: AttributeNames): AttributeNames {
  return Object.fromEntries(
    Object.entries(raw).map(([attribute, names]) => [attribute, names.map(nameIn)]),
  );
}

export function checkParseOptions(options: ParseOptions) {
  const { format, repair = true, attributes = true } = options;
  checkFlag('options.repair', repair);
  checkFlag('options.attributes', attributes);
  return { claimed: claimOf(format), repair, attributes, withPrev: storesPrev(options) };
}

/** What the core is told of the format. */
export function claimOf(format: unknown): number {
  return format === undefined ? -1 : formatIndex('options.format', format);
}

/** The value of the enum Format in C++. */
export function formatIndex(argument: string, format: unknown): number {
  return indexOfChoice(argument, format, FORMATS);
}
