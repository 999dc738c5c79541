import { describe } from '../arguments.js';
import { fileError } from './container.js';

/** The parts of a glTF document that make geometry, checked: all references lead somewhere. */
export interface GltfDocument {
  readonly asset: { readonly version: string };
  readonly scene?: number;
  readonly scenes: { nodes?: number[] }[];
  readonly nodes: GltfNode[];
  readonly meshes: { name?: string; primitives: GltfPrimitive[] }[];
  readonly accessors: GltfAccessor[];
  readonly bufferViews: GltfView[];
  readonly buffers: GltfBuffer[];
  readonly extensionsUsed?: string[];
  readonly extensionsRequired?: string[];
}

export interface GltfBuffer {
  readonly uri?: string;
  readonly byteLength: number;
  readonly extensions?: Record<string, Record<string, unknown>>;
}
export interface GltfNode {
  readonly mesh?: number;
  readonly children?: number[];
  readonly extensions?: Record<string, Record<string, unknown>>;
  readonly [other: string]: unknown;
}
export interface GltfPrimitive {
  readonly attributes: Record<string, number>;
  readonly indices?: number;
  readonly mode?: number;
  readonly extensions?: Record<string, Record<string, unknown>>;
  readonly [other: string]: unknown;
}
export interface GltfAccessor {
  readonly bufferView?: number;
  readonly byteOffset?: number;
  readonly componentType: number;
  readonly count: number;
  readonly type: string;
  readonly sparse?: {
    readonly count: number;
    readonly indices: { bufferView: number; byteOffset?: number; componentType: number };
    readonly values: { bufferView: number; byteOffset?: number };
  };
}
export interface GltfView {
  buffer: number;
  byteOffset?: number;
  byteLength: number;
  readonly byteStride?: number;
  readonly extensions?: Record<string, Record<string, unknown>>;
}

type Dictionary = Record<string, unknown>;

/** Checks the shape of a document, as far as geometry is concerned. */
export function checkDocument(json: unknown): GltfDocument {
  const root = dictionary('The JSON of the file', json);
  const { version, minVersion } = dictionary('asset', root.asset);
  const refuseVersion = (name: string, value: unknown) => {
    const text = `glTF: asset.${name} is ${describe(value)}, expected "2.0".`;
    throw fileError('unsupported-format', text);
  };
  if (typeof version !== 'string' || !/^2\.\d+$/.test(version)) refuseVersion('version', version);
  // A later 2.x can be read as 2.0, unless it says that this doesn't do.
  if (minVersion !== undefined && minVersion !== '2.0') refuseVersion('minVersion', minVersion);
  const list = (name: string) =>
    array(name, root[name] ?? []).map((entry, i) => dictionary(`${name}[${i}]`, entry));
  const document = {
    asset: { version },
    scenes: list('scenes'),
    nodes: list('nodes'),
    meshes: list('meshes'),
    accessors: list('accessors'),
    bufferViews: list('bufferViews'),
    buffers: list('buffers'),
    extensionsUsed: names(root, 'extensionsUsed'),
    extensionsRequired: names(root, 'extensionsRequired'),
  };
  for (const [i, scene] of document.scenes.entries()) {
    references(`scenes[${i}].nodes`, scene.nodes, document.nodes.length);
  }
  for (const [i, buffer] of document.buffers.entries()) {
    count(`buffers[${i}].byteLength`, buffer.byteLength);
    if (buffer.uri !== undefined && typeof buffer.uri !== 'string') {
      throw wrong(`buffers[${i}].uri`, buffer.uri, 'a string');
    }
    extensionsOf(`buffers[${i}]`, buffer);
  }
  checkViews(document.bufferViews, document.buffers);
  checkAccessors(document.accessors, document.bufferViews);
  checkMeshes(document.meshes, document.accessors);
  checkNodes(document.nodes, document.meshes.length, document.accessors.length);
  if (root.scene === undefined) return document as unknown as GltfDocument;
  const scene = reference('scene', root.scene, document.scenes.length);
  return { ...document, scene } as unknown as GltfDocument;
}

function checkViews(views: Dictionary[], buffers: Dictionary[]): void {
  for (const [i, view] of views.entries()) {
    const what = `bufferViews[${i}]`;
    const buffer = reference(`${what}.buffer`, view.buffer, buffers.length);
    const offset = count(`${what}.byteOffset`, view.byteOffset ?? 0);
    const length = count(`${what}.byteLength`, view.byteLength);
    const size = buffers[buffer].byteLength as number;
    if (offset + length > size) {
      throw wrongly(
        what,
        `bytes ${offset} to ${offset + length}`,
        `at most ${size} of buffer ${buffer}`,
      );
    }
    const stride = view.byteStride;
    if (
      stride !== undefined &&
      (count(`${what}.byteStride`, stride) < 4 || (stride as number) > 252)
    ) {
      throw wrong(`${what}.byteStride`, stride, 'a number from 4 to 252');
    }
    extensionsOf(what, view);
  }
}

/** Bytes of a number, by its type. */
const SIZES: Record<number, number> = { 5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4 };
const COMPONENTS: Record<string, number> = {
  ...{ SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT2: 4, MAT3: 9, MAT4: 16 },
};

/** Bytes of one number. */
export const numberSize = ({ componentType }: { readonly componentType: number }): number =>
  SIZES[componentType];

/** Bytes of the numbers of a row. */
export const rowSize = (accessor: GltfAccessor): number =>
  numberSize(accessor) * COMPONENTS[accessor.type];

function checkAccessors(accessors: Dictionary[], views: Dictionary[]): void {
  for (const [i, accessor] of accessors.entries()) {
    const what = `accessors[${i}]`;
    const size = checkedSize(`${what}.componentType`, accessor.componentType);
    if (typeof accessor.type !== 'string' || !Object.hasOwn(COMPONENTS, accessor.type)) {
      throw wrong(`${what}.type`, accessor.type, Object.keys(COMPONENTS).join(', '));
    }
    const bytes = size * COMPONENTS[accessor.type];
    const rows = count(`${what}.count`, accessor.count);
    if (accessor.bufferView !== undefined) {
      checkRange(what, accessor, { rows, bytes, size }, views);
    }
    if (accessor.sparse === undefined) continue;
    const sparse = dictionary(`${what}.sparse`, accessor.sparse);
    const indices = dictionary(`${what}.sparse.indices`, sparse.indices);
    const values = dictionary(`${what}.sparse.values`, sparse.values);
    const some = count(`${what}.sparse.count`, sparse.count);
    const width = checkedSize(`${what}.sparse.indices.componentType`, indices.componentType);
    checkRange(`${what}.sparse.indices`, indices, { rows: some, bytes: width, size: width }, views);
    checkRange(`${what}.sparse.values`, values, { rows: some, bytes, size }, views);
  }
}

/** The rows of an accessor lie in its view, each at a multiple of the size of its numbers. */
function checkRange(
  what: string,
  { bufferView, byteOffset = 0 }: Dictionary,
  { rows, bytes, size }: { rows: number; bytes: number; size: number },
  views: Dictionary[],
): void {
  const which = reference(`${what}.bufferView`, bufferView, views.length);
  const view = views[which] as unknown as GltfView;
  const offset = count(`${what}.byteOffset`, byteOffset);
  const stride = view.byteStride ?? bytes;
  // Views are copied out of their buffer: where they begin there doesn't matter, files are found that err.
  if (offset % size !== 0 || stride % size !== 0) {
    const [name, value] =
      offset % size !== 0 ? ['byteOffset', offset] : ['view.byteStride', stride];
    throw wrong(`${what}.${name}`, value, `a multiple of ${size}, the size of its numbers`);
  }
  const needed = rows === 0 ? 0 : offset + stride * (rows - 1) + bytes;
  if (needed > view.byteLength) {
    throw fileError(
      'truncated',
      `glTF: ${what} has ${rows} rows, which need ${needed} bytes, but bufferViews[${which}] has ${view.byteLength}.`,
    );
  }
}

function checkedSize(what: string, type: unknown): number {
  if (typeof type === 'number' && Object.hasOwn(SIZES, type)) return SIZES[type];
  throw wrong(what, type, `one of ${Object.keys(SIZES).join(', ')}`);
}

/** Bytes, shorts and words without a sign. */
const INDEX_TYPES: readonly unknown[] = [5121, 5123, 5125];

function checkMeshes(meshes: Dictionary[], accessors: Dictionary[]): void {
  const accessorOf = (what: string, index: unknown) =>
    accessors[reference(what, index, accessors.length)];
  for (const [i, mesh] of meshes.entries()) {
    for (const [j, entry] of array(`meshes[${i}].primitives`, mesh.primitives).entries()) {
      const what = `meshes[${i}].primitives[${j}]`;
      const { attributes, indices, mode = 4, ...rest } = dictionary(what, entry);
      for (const [name, accessor] of Object.entries(dictionary(`${what}.attributes`, attributes))) {
        const { type } = accessorOf(`${what}.attributes.${name}`, accessor);
        if (name !== 'POSITION' || type === 'VEC3') continue;
        throw wrong(`accessors[${accessor}].type`, type, 'VEC3, as its rows are positions');
      }
      if (indices !== undefined) {
        const { type, componentType } = accessorOf(`${what}.indices`, indices);
        if (type !== 'SCALAR' || !INDEX_TYPES.includes(componentType)) {
          const rows = `${type} of ${componentType}`;
          throw wrongly(`accessors[${indices}]`, rows, 'SCALAR of 5121, 5123 or 5125 for indices');
        }
      }
      if (!(Number.isInteger(mode) && (mode as number) >= 0 && (mode as number) <= 6)) {
        throw wrong(`${what}.mode`, mode, 'a number from 0 to 6');
      }
      extensionsOf(what, rest);
    }
  }
}

/** Nodes are trees: else whoever walks through them would never arrive. */
function checkNodes(nodes: Dictionary[], meshes: number, accessors: number): void {
  const parents = new Int32Array(nodes.length).fill(-1);
  for (const [i, node] of nodes.entries()) {
    const what = `nodes[${i}]`;
    if (node.mesh !== undefined) reference(`${what}.mesh`, node.mesh, meshes);
    for (const child of references(`${what}.children`, node.children, nodes.length)) {
      if (parents[child] >= 0 || child === i) {
        throw wrongly(
          `nodes[${child}]`,
          `a child of nodes ${Math.max(parents[child], 0)} and ${i}`,
          'one parent',
        );
      }
      parents[child] = i;
    }
    for (const [name, length] of Object.entries({
      matrix: 16,
      translation: 3,
      rotation: 4,
      scale: 3,
    })) {
      const value = node[name];
      if (value === undefined) continue;
      const isRight =
        Array.isArray(value) && value.length === length && value.every(Number.isFinite);
      if (!isRight) throw wrong(`${what}.${name}`, value, `${length} numbers`);
    }
    const instancing = extensionsOf(what, node).EXT_mesh_gpu_instancing?.attributes;
    for (const [name, accessor] of Object.entries(Object(instancing))) {
      reference(
        `${what}.extensions.EXT_mesh_gpu_instancing.attributes.${name}`,
        accessor,
        accessors,
      );
    }
  }
  for (const start of nodes.keys()) {
    // Each has one parent at most: going up either ends or comes back.
    let depth = 0;
    for (let i = start; i >= 0; i = parents[i]) {
      if (++depth > MAX_DEPTH) {
        throw wrongly(
          `nodes[${start}]`,
          `below ${MAX_DEPTH} others, or below itself`,
          'less than that',
        );
      }
    }
  }
}

/** Deeper ones exhaust the stack of those who walk through them by recursion, as three.js does. */
const MAX_DEPTH = 1000;

// ---- what a value is -------------------------------------------------------------------------------

/** A value of the file. */
export function wrong(what: string, value: unknown, expected: string): Error {
  return wrongly(what, describe(value), expected);
}

/** What is wrong, in words. */
export function wrongly(what: string, words: string, expected: string): Error {
  return fileError('parse-error', `glTF: ${what} is ${words}, expected ${expected}.`);
}

function dictionary(what: string, value: unknown): Dictionary {
  if (typeof value === 'object' && value !== null && !Array.isArray(value))
    return value as Dictionary;
  throw wrong(what, value, 'an object');
}

function array(what: string, value: unknown): unknown[] {
  if (Array.isArray(value)) return value;
  throw wrong(what, value, 'an array');
}

function names(root: Dictionary, name: string): string[] {
  const list = array(name, root[name] ?? []);
  for (const [i, entry] of list.entries()) {
    if (typeof entry !== 'string') throw wrong(`${name}[${i}]`, entry, 'a string');
  }
  return list as string[];
}

function extensionsOf(what: string, { extensions = {} }: Dictionary): Record<string, Dictionary> {
  const all = dictionary(`${what}.extensions`, extensions);
  for (const [name, value] of Object.entries(all)) dictionary(`${what}.extensions.${name}`, value);
  return all as Record<string, Dictionary>;
}

/** An integer that sums of such can't round. */
export function count(what: string, value: unknown): number {
  if (Number.isInteger(value) && (value as number) >= 0 && (value as number) < 2 ** 40) {
    return value as number;
  }
  throw wrong(what, value, 'an integer from 0');
}

export function reference(what: string, value: unknown, length: number): number {
  if (Number.isInteger(value) && (value as number) >= 0 && (value as number) < length) {
    return value as number;
  }
  throw wrong(
    what,
    value,
    length === 0 ? 'nothing, as there are none' : `an index from 0 to ${length - 1}`,
  );
}

function references(what: string, value: unknown, length: number): number[] {
  const list = value === undefined ? [] : array(what, value);
  return list.map((entry, i) => reference(`${what}[${i}]`, entry, length));
}
