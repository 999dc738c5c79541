import { checkNotNegative, newArray } from './arguments.js';
import { STORAGE_OPTIONS, type StorageOptions, storesPrev } from './build.js';
import { checkFlag, refuse } from './checks.js';
import type { RawRepair } from './core.js';
import { HalfedgeError, type Problem } from './errors.js';
import { Links } from './links.js';
import { type Core, core } from './loader.js';
import { withInputs } from './memory.js';
import { checkOptions, type OptionNames } from './options.js';
import { LISTED, problemOf, unwrap } from './reports.js';
import { take } from './rings.js';
import { in32Bits, isSigned, soupArrays } from './soup-arrays.js';

/** In the order of the enum RepairCode in C++. */
const CODES = [
  'non-finite-position',
  'index-out-of-range',
  'degree-below-three',
  'repeated-vertex',
  'coincident-position',
  'duplicate-face',
  'edge-with-many-faces',
  'opposite-orientation',
  'non-orientable',
  'neighbours-cut',
  'pinched-vertex',
  'isolated-vertex',
] as const;

/** What a repair can find. */
export type RepairCode = (typeof CODES)[number];

/** Worth knowing, but no defect. */
const HARMLESS: readonly string[] = ['coincident-position', 'isolated-vertex'];

/** How to make a mesh out of any polygons. */
export interface SoupOptions extends StorageOptions {
  /**
   * Joins vertices: `true` or 0 joins those at the same position, a number joins those closer than that. Any
   * two joined vertices are closer than the tolerance; a chain of vertices that is longer is cut. Default:
   * false.
   */
  weld?: boolean | number | undefined;
  /** Whether to leave out vertices without faces. Default: false. */
  dropIsolated?: boolean | undefined;
}

export const SOUP_OPTIONS: OptionNames<SoupOptions> = {
  ...STORAGE_OPTIONS,
  weld: true,
  dropIsolated: true,
};

/** What became of a face of the input, if it was touched. */
export interface FaceVerdict {
  readonly face: number;
  /** Whether it became a face of the mesh. */
  readonly kept: boolean;
  /** Why it was left out, or what was done to it. */
  readonly codes: readonly RepairCode[];
}

/** What a repair has done. */
export interface RepairReport {
  /** One sentence each; at most 100 of each code. Indices are those of the input. */
  readonly problems: readonly Problem[];
  /** How many faces, edges or vertices there are with each code, listed or not. */
  readonly counts: Readonly<Partial<Record<RepairCode, number>>>;
  /** How many of each code are not listed in `problems`. One entry stands for all isolated vertices. */
  readonly unlisted: Readonly<Partial<Record<RepairCode, number>>>;
  /** The faces that were touched, in order. All others are unchanged. */
  readonly verdicts: readonly FaceVerdict[];
  /** By vertex of the input: its (first) vertex in the mesh, or -1. */
  readonly vertexMap: Int32Array;
  /** By vertex of the mesh: the vertex of the input that it was, or is a copy of. */
  readonly vertexOrigin: Uint32Array;
  /** By face of the input: the face of the mesh, or -1. */
  readonly faceMap: Int32Array;
  /** All of it in one readable line. */
  readonly summary: string;
}

/** A mesh of whatever polygons there are. */
export function soupLinks(
  positions: unknown,
  faces: unknown,
  options: unknown,
): { links: Links; report: RepairReport } {
  const { weld, dropIsolated, withPrev } = soupOptions(checkOptions(options, SOUP_OPTIONS));
  const { points, sizes, corners: given } = soupArrays(positions, faces);
  const { corners, names } = in32Bits(given, sizes);
  const wasm = core();
  const raw = withInputs(wasm, (inputs) => {
    inputs.hold(points, sizes, corners);
    const at = inputs.floats('positions', points);
    const lengths = sizes === undefined ? NOTHING : inputs.indices('sizes', sizes);
    const lines = names === '' ? NOTHING : inputs.bytes('names', new TextEncoder().encode(names));
    const vertices = inputs.indices('faces', corners);
    return wasm.buildFromSoup(
      at.address,
      at.count,
      lengths.address,
      lengths.count,
      vertices.address,
      vertices.count,
      weld,
      dropIsolated,
      isSigned(corners),
      lines.address,
      lines.count,
      withPrev,
    );
  });
  // The core saw unsigned numbers: say what was really given.
  if ('problems' in raw && sizes !== undefined) checkNotNegative('sizes', sizes);
  const done = unwrap(raw);
  return new Links(wasm, done.mesh).orDispose((links) => {
    return { links, report: repairReport(wasm, done) };
  });
}

const NOTHING = { address: 0, count: 0 };

/** The report of the core, whose arrays are freed. */
export function repairReport(wasm: Core, raw: RawRepair): RepairReport {
  const words = { ...raw.verdicts, count: 2 * raw.verdicts.count };
  const [verdicts, vertexMap, vertexOrigin, faceMap] = take(
    wasm,
    words,
    raw.vertexMap,
    raw.vertexOrigin,
    raw.faceMap,
  );
  const problems = raw.repairs.map((problem) =>
    problemOf(problem, HARMLESS.includes(problem.code) ? 'info' : 'warning'),
  );
  const counts = Object.fromEntries(
    CODES.map((code, i) => [code, raw.counts[i]] as const).filter(([, count]) => count > 0),
  );
  return {
    problems,
    counts,
    unlisted: unlistedOf(problems, counts),
    verdicts: verdictsOf(verdicts),
    vertexMap: new Int32Array(vertexMap.buffer),
    vertexOrigin,
    faceMap: new Int32Array(faceMap.buffer),
    summary: raw.summary,
  };
}

/** Throws if anything of `what`, which was to be taken as it is, was mended. */
export function refuseMended({ problems }: RepairReport, what = 'This'): void {
  const mended = problems.filter(({ severity }) => severity !== 'info');
  if (mended.length === 0) return;
  const [{ code, message, witness }] = mended;
  throw new HalfedgeError(code, `${what} can't be built without repair, which says: ${message}`, {
    problems: mended.map((problem): Problem => ({ ...problem, severity: 'error' })),
    ...(witness && { witness }),
  });
}

function unlistedOf(
  problems: readonly Problem[],
  counts: RepairReport['counts'],
): RepairReport['unlisted'] {
  const unlisted = CODES.map((code) => {
    const listed = problems.filter((problem) => problem.code === code).length;
    return [code, listed < LISTED ? 0 : (counts[code] ?? 0) - listed] as const;
  });
  return Object.fromEntries(unlisted.filter(([, count]) => count > 0));
}

/** The report of a strict build: nothing was done. */
export function untouched(vertices: number, faces: number): RepairReport {
  const identity = (length: number) => newArray('a map', Int32Array, length).map((_, i) => i);
  const vertexMap = identity(vertices);
  return {
    problems: [],
    counts: {},
    unlisted: {},
    verdicts: [],
    vertexMap,
    vertexOrigin: new Uint32Array(vertexMap),
    faceMap: identity(faces),
    summary: '',
  };
}

/** Two words for each: the face; whether it is kept, and in the upper half its codes. */
function verdictsOf(words: Uint32Array): FaceVerdict[] {
  const lists = new Map<number, readonly RepairCode[]>();
  const verdicts: FaceVerdict[] = [];
  for (let i = 0; i < words.length; i += 2) {
    const mask = words[i + 1] >>> 16;
    let codes = lists.get(mask);
    if (codes === undefined) {
      codes = Object.freeze(CODES.filter((_, code) => (mask & (1 << code)) !== 0));
      lists.set(mask, codes);
    }
    verdicts.push({ face: words[i], kept: (words[i + 1] & 0xff) !== 0, codes });
  }
  return verdicts;
}

/** Options as the core takes them: `weld` is a tolerance, negative where vertices stay apart. */
export function soupOptions(options: SoupOptions): {
  weld: number;
  dropIsolated: boolean;
  withPrev: boolean;
} {
  const { weld = false, dropIsolated = false } = options;
  const withPrev = storesPrev(options);
  checkFlag('options.dropIsolated', dropIsolated);
  if (typeof weld === 'boolean') return { weld: weld ? 0 : -1, dropIsolated, withPrev };
  if (!(Number.isFinite(weld) && weld >= 0)) {
    refuse('options.weld', weld, 'true, false or a finite distance from 0', 'number');
  }
  return { weld, dropIsolated, withPrev };
}
