import {
  checkFloats,
  checkNotNegative,
  describe,
  indices,
  isIndex,
  lengthOf,
  lengthOfArrayLike,
  type NumberArray,
  newArray,
  numbers,
  refuseIndex,
  typedArrayName,
} from './arguments.js';
import { checkFlag } from './checks.js';
import type { RawFailure } from './core.js';
import { counted } from './counted.js';
import { HalfedgeError } from './errors.js';
import { Links } from './links.js';
import { core } from './loader.js';
import { type Block, withInputs } from './memory.js';
import { checkOptions, type OptionNames } from './options.js';
import { unwrap } from './reports.js';

/**
 * Faces as two arrays: how many corners each has, and the vertices of all corners, one face after the other.
 */
export interface Polygons {
  readonly sizes: ArrayLike<number>;
  readonly corners: ArrayLike<number>;
}

/** What a mesh stores. */
export interface StorageOptions {
  /**
   * Whether each halfedge stores the one before it. Without that, a mesh takes a fifth less memory (24 bytes
   * less per vertex of a triangle mesh), and `prev(h)` searches: it walks around the face and the vertex of
   * `h` in step, until one of the walks closes. Everything else stays the same. Default: true.
   */
  storePrev?: boolean | undefined;
}

/** How to build a mesh. */
export interface BuildOptions extends StorageOptions {}

/** How to build connectivity alone. */
export interface FaceOptions extends StorageOptions {
  /** The number of vertices, if there are more than the faces use: the others are isolated. */
  vertexCount?: number | undefined;
}

export const STORAGE_OPTIONS: OptionNames<StorageOptions> = { storePrev: true };
const FACE_OPTIONS: OptionNames<FaceOptions> = { ...STORAGE_OPTIONS, vertexCount: true };

/** Whether the options ask for prev. */
export function storesPrev({ storePrev = true }: StorageOptions): boolean {
  checkFlag('options.storePrev', storePrev);
  return storePrev;
}

/** The mesh of an index buffer. */
export function triangleLinks(positions: unknown, triangles: unknown, options: unknown): Links {
  const withPrev = storesPrev(checkOptions(options, STORAGE_OPTIONS));
  return unlessExchanged(positions, triangles, () => {
    const { points, corners } = triangleArrays(positions, triangles);
    return buildLinks(points, undefined, corners, 'indices', withPrev);
  });
}

/** Directed Edges of an index buffer: their address. */
export function buildDirectedEdges(positions: unknown, triangles: unknown): number {
  return unlessExchanged(positions, triangles, () => {
    const { points, corners } = triangleArrays(positions, triangles);
    const wasm = core();
    return build(points, undefined, corners, 'indices', (at, _, vertices) =>
      wasm.buildDirectedEdges(at.address, at.count, vertices.address, vertices.count),
    );
  });
}

function triangleArrays(
  positions: unknown,
  triangles: unknown,
): { points: NumberArray; corners: NumberArray } {
  const points = positionArray(positions);
  const corners = indices('indices', triangles);
  const count = lengthOf(corners);
  if (count % 3 !== 0) {
    throw new RangeError(
      `indices has ${counted(count, 'element')}; expected a multiple of 3, three vertices for each triangle.`,
    );
  }
  return { points, corners };
}

/**
 * What `make` returns. Where it fails for items of the mesh, and the positions could be indices of
 * the indices, the error is that they were exchanged: what is wrong with single elements misleads.
 */
function unlessExchanged<T>(positions: unknown, triangles: unknown, make: () => T): T {
  try {
    return make();
  } catch (error) {
    const isOfItems = !(error instanceof HalfedgeError) || error.witness.vertices.length > 0;
    if (!isOfItems || !couldBeExchanged(positions, triangles)) throw error;
    throw new TypeError(
      `positions is a ${typedArrayName(positions)} and indices a ${typedArrayName(triangles)}; expected positions first, then indices.`,
      { cause: error },
    );
  }
}

/** Unsigned integers where positions should be, all of them indices of as many floats as there are where indices should be. */
function couldBeExchanged(positions: unknown, triangles: unknown): boolean {
  if (!typedArrayName(positions)?.startsWith('Uint')) return false;
  if (!typedArrayName(triangles)?.startsWith('Float')) return false;
  const vertexCount = lengthOf(triangles as NumberArray) / 3;
  return (positions as NumberArray).every((index) => index < vertexCount);
}

/** The mesh of polygons in either form. */
export function polygonLinks(positions: unknown, faces: unknown, options: unknown): Links {
  const withPrev = storesPrev(checkOptions(options, STORAGE_OPTIONS));
  const points = positionArray(positions);
  const { sizes, corners } = isPolygons(faces) ? polygonArrays(faces) : flatten(faces);
  return buildLinks(points, sizes, corners, 'corners', withPrev);
}

/** The mesh of faces without geometry: every vertex is at the origin. */
export function faceLinks(faces: unknown, options: unknown): Links {
  const given = checkOptions(options, FACE_OPTIONS);
  const withPrev = storesPrev(given);
  const { vertexCount = 0 } = given;
  const { sizes, corners } = isPolygons(faces) ? polygonArrays(faces) : flatten(faces);
  if (!(isIndex(vertexCount) && vertexCount <= MOST_VERTICES)) {
    throw new RangeError(
      `options.vertexCount is ${describe(vertexCount)}; expected an integer from 0 to ${MOST_VERTICES}.`,
    );
  }
  checkNotNegative('corners', corners);
  let count: number = vertexCount;
  for (let i = 0; i < lengthOf(corners); i++) count = Math.max(count, corners[i] + 1);
  if (count > MOST_VERTICES) {
    throw new RangeError(
      `faces has the vertex ${count - 1}; expected less than ${MOST_VERTICES}, for which there is no room.`,
    );
  }
  const points = newArray('positions', Float32Array, 3 * count);
  return buildLinks(points, sizes, corners, 'corners', withPrev);
}

/** More have no room in the 4 GiB of WebAssembly: they would take 16 bytes each. */
const MOST_VERTICES = 2 ** 28 - 1;

function buildLinks(
  positions: NumberArray,
  sizes: NumberArray | undefined,
  corners: NumberArray,
  name: string,
  withPrev: boolean,
): Links {
  const wasm = core();
  const address = build(positions, sizes, corners, name, (points, lengths, vertices) =>
    wasm.build(
      points.address,
      points.count,
      lengths.address,
      lengths.count,
      vertices.address,
      vertices.count,
      withPrev,
    ),
  );
  return new Links(wasm, address);
}

/** Calls a builder of the core with copies of its inputs; throws what it refuses. */
function build(
  positions: NumberArray,
  sizes: NumberArray | undefined,
  corners: NumberArray,
  name: string,
  builder: (points: Block, lengths: Block, vertices: Block) => { mesh: number } | RawFailure,
): number {
  const raw = withInputs(core(), (inputs) => {
    inputs.hold(positions, sizes, corners);
    const points = inputs.floats('positions', positions);
    const lengths = sizes === undefined ? NOTHING : inputs.indices('sizes', sizes);
    return builder(points, lengths, inputs.indices(name, corners));
  });
  if ('problems' in raw) {
    // The core saw unsigned and 32-bit numbers: say what was really given.
    checkNotNegative(name, corners);
    if (sizes !== undefined) checkNotNegative('sizes', sizes);
    checkFloats('positions', positions);
  }
  return unwrap(raw).mesh;
}

const NOTHING: Block = { address: 0, count: 0 };

function positionArray(positions: unknown): NumberArray {
  const array = numbers('positions', positions);
  const count = lengthOf(array);
  if (count % 3 !== 0) {
    throw new RangeError(
      `positions has ${counted(count, 'element')}; expected a multiple of 3, x, y and z of each vertex.`,
    );
  }
  return array;
}

function isPolygons(faces: unknown): faces is Polygons {
  return typeof faces === 'object' && faces !== null && !('length' in faces) && 'corners' in faces;
}

function polygonArrays(faces: Polygons): { sizes: NumberArray; corners: NumberArray } {
  const sizes = indices('faces.sizes', faces.sizes);
  const corners = indices('faces.corners', faces.corners);
  if (lengthOf(sizes) === 0 && lengthOf(corners) > 0) {
    throw new RangeError(
      `faces.sizes is empty, but faces.corners has ${counted(lengthOf(corners), 'element')}; expected a size for each face.`,
    );
  }
  return { sizes, corners };
}

/** An array for each face, in a row. */
function flatten(faces: unknown): { sizes: NumberArray; corners: NumberArray } {
  const count = lengthOfArrayLike('faces', faces, 'an array of faces, or { sizes, corners }');
  const list = faces as ArrayLike<ArrayLike<unknown>>;
  const name = (f: number) => `faces[${f}]`;
  if (count > 0) lengthOfArrayLike(name(count - 1), list[count - 1]); // or a lying length costs memory
  const sizes = newArray('faces', Uint32Array, count);
  let total = 0;
  for (let f = 0; f < count; f++) {
    const face = list[f];
    sizes[f] = Array.isArray(face) ? face.length : lengthOfArrayLike(name(f), face);
    total += sizes[f];
  }
  const corners = newArray('faces', Uint32Array, total);
  let at = 0;
  for (let f = 0; f < count; f++) {
    const face = list[f];
    for (let i = 0; i < sizes[f]; i++) {
      const corner = face[i];
      corners[at++] = isIndex(corner) ? corner : refuseIndex(`faces[${f}]`, i, corner);
    }
  }
  return { sizes, corners };
}
