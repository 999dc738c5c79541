import {
  anyNumbers,
  checkNotNegative,
  indices,
  lengthOf,
  lengthOfArrayLike,
  type NumberArray,
  newArray,
  refuseIndex,
  typedArrayName,
} from './arguments.js';
import { type Polygons, STORAGE_OPTIONS, type StorageOptions, storesPrev } from './build.js';
import { checkFlag, refuse } from './checks.js';
import type { RawRepair } from './core.mjs';
import { counted } from './counted.js';
import { HalfedgeError, type Problem } from './errors.js';
import { Links } from './links.js';
import { type Core, core } from './loader.js';
import { withInputs } from './memory.js';
import { checkOptions, type OptionNames } from './options.js';
import { problemOf, unwrap } from './reports.js';
import { take } from './rings.js';

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

/** A soup as typed arrays: those that were given, if they are such. Without sizes, all are triangles. */
export interface SoupArrays {
  readonly points: NumberArray;
  readonly sizes?: NumberArray;
  readonly corners: NumberArray;
}

/** Checks a soup as far as that doesn't take the core. */
export function soupArrays(positions: unknown, faces: unknown): SoupArrays {
  const points = anyNumbers('positions', positions);
  if (lengthOf(points) % 3 !== 0) {
    throw new RangeError(
      `positions has ${counted(lengthOf(points), 'element')}; expected a multiple of 3, x, y and z of each vertex.`,
    );
  }
  return { points, ...faceArrays(faces) };
}

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

/** What the core lists of each code at most. */
const LISTED = 100;

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

/** Faces in any of the three forms. */
function faceArrays(faces: unknown): { sizes?: NumberArray; corners: NumberArray } {
  if (typeof faces === 'object' && faces !== null && !('length' in faces) && 'corners' in faces) {
    const { sizes, corners } = faces as Polygons;
    const lengths = indices('faces.sizes', sizes);
    const vertices = anyIntegers('faces.corners', corners);
    if (lengthOf(lengths) === 0 && lengthOf(vertices) > 0) {
      throw new RangeError(
        `faces.sizes is empty, but faces.corners has ${counted(lengthOf(vertices), 'element')}; expected a size for each face.`,
      );
    }
    return { sizes: lengths, corners: vertices };
  }
  const form = 'an array of faces, an index buffer or { sizes, corners }';
  const count = lengthOfArrayLike('faces', faces, form);
  if (typedArrayName(faces) === undefined && typeof (faces as ArrayLike<unknown>)[0] !== 'number') {
    return flatten(faces as ArrayLike<unknown>, count);
  }
  if (count % 3 !== 0) {
    throw new RangeError(
      `faces has ${counted(count, 'number')}; expected a multiple of 3, three vertices for each triangle.`,
    );
  }
  return { corners: anyIntegers('faces', faces) };
}

/** An array for each face, in a row. */
function flatten(
  faces: ArrayLike<unknown>,
  count: number,
): { sizes: NumberArray; corners: NumberArray } {
  if (count > 0) lengthOfArrayLike(`faces[${count - 1}]`, faces[count - 1]); // or a lying length costs memory
  const sizes = newArray('faces', Uint32Array, count);
  let total = 0;
  for (let f = 0; f < count; f++) {
    sizes[f] = lengthOfArrayLike(`faces[${f}]`, faces[f]);
    total += sizes[f];
  }
  const corners = new Corners('faces', total);
  for (let f = 0; f < count; f++) {
    const face = faces[f] as ArrayLike<unknown>;
    for (let i = 0; i < sizes[f]; i++) corners.add(anyInteger(`faces[${f}]`, i, face[i]));
  }
  return { sizes, corners: corners.array };
}

/** Vertices of corners: whatever is no index of a vertex is the core's to report, with its face. */
function anyIntegers(argument: string, source: unknown): NumberArray {
  const name = typedArrayName(source);
  if (name !== undefined && !name.startsWith('Float')) return indices(argument, source);
  const count = lengthOfArrayLike(argument, source);
  const from = source as ArrayLike<unknown>;
  if (count > 0) anyInteger(argument, count - 1, from[count - 1]); // or a lying length costs memory
  const to = new Corners(argument, count);
  for (let i = 0; i < count; i++) to.add(anyInteger(argument, i, from[i]));
  return to.array;
}

/** Whole numbers in 32 bits, signed if there are negative ones; or doubles, where those don't hold all. */
class Corners {
  readonly #argument: string;
  #words: Uint32Array;
  #doubles: Float64Array | undefined;
  #count = 0;
  #least = 0;
  #most = 0;

  constructor(argument: string, count: number) {
    this.#argument = argument;
    this.#words = newArray(argument, Uint32Array, count);
  }

  add(vertex: number): void {
    if (vertex < this.#least || vertex > this.#most) this.#extend(vertex);
    (this.#doubles ?? this.#words)[this.#count++] = vertex;
  }

  get array(): NumberArray {
    if (this.#doubles !== undefined) return this.#doubles;
    return this.#least < 0 ? signed(this.#words) : this.#words;
  }

  #extend(vertex: number): void {
    const wasSigned = this.#least < 0;
    this.#least = Math.min(this.#least, vertex);
    this.#most = Math.max(this.#most, vertex);
    const most = this.#least < 0 ? 2 ** 31 - 1 : NO_VERTEX;
    if (this.#doubles !== undefined || (this.#least >= -(2 ** 31) && this.#most <= most)) return;
    this.#doubles = newArray(this.#argument, Float64Array, this.#words.length);
    this.#doubles.set(wasSigned ? signed(this.#words) : this.#words);
    this.#words = new Uint32Array();
  }
}

/**
 * The corners as the core takes them: those of vertices that 32 bits don't hold are of none, and named, in
 * lines that have the corner and the vertex that was given. The first of each face is enough.
 */
function in32Bits(
  corners: NumberArray,
  sizes: NumberArray | undefined,
): { corners: NumberArray; names: string } {
  let names = '';
  if (!(corners instanceof Float64Array)) return { corners, names };
  const isHeld = (vertex: number) => vertex >= 0 && vertex <= NO_VERTEX;
  const faces = sizes === undefined ? corners.length / 3 : lengthOf(sizes);
  for (let f = 0, begin = 0, named = 0; f < faces && named < LISTED; f++) {
    const end = begin + (sizes === undefined ? 3 : sizes[f]);
    let at = begin;
    while (at < end && isHeld(corners[at])) at++;
    if (at < end && at < corners.length) {
      names += `${at} ${corners[at]}\n`;
      named++;
    }
    begin = end;
  }
  const words = newArray('faces', Uint32Array, corners.length);
  for (let i = 0; i < words.length; i++) words[i] = isHeld(corners[i]) ? corners[i] : NO_VERTEX;
  return { corners: words, names };
}

/** The same 32 bits as signed numbers. */
function signed(array: Uint32Array): Int32Array {
  return new Int32Array(array.buffer, array.byteOffset, array.length);
}

function isSigned(array: NumberArray): boolean {
  return typedArrayName(array)?.startsWith('Int') ?? false;
}

function anyInteger(argument: string, i: number, value: unknown): number {
  if (typeof value !== 'number' || !Number.isInteger(value)) refuseIndex(argument, i, value);
  return value;
}

/** An index that no mesh has. */
const NO_VERTEX = 2 ** 32 - 1;
