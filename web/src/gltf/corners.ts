// Attributes by corner: between buffers, whose vertices are doubled where values differ, and meshes,
// whose vertices are not.

import { describe, newArray } from '../arguments.js';
import type { AttributeInfo, OnSplit } from '../attributes.js';
import type { ItemKind } from '../items.js';
import type { HalfedgeMesh } from '../mesh.js';
import type { RepairReport } from '../repair.js';

export type CornerValues =
  | Float32Array
  | Int8Array
  | Uint8Array
  | Int16Array
  | Uint16Array
  | Int32Array
  | Uint32Array;

/** A named column of numbers by vertex of a buffer. */
export interface CornerAttribute {
  readonly name: string;
  readonly components: number;
  readonly values: CornerValues;
  /** What a split makes of it. Default: 'normalize' for normals, 'copy' for bones of vertices, else 'interpolate'. */
  readonly onSplit?: OnSplit;
}

const TYPES = {
  Float32Array: 'float32',
  Int8Array: 'int8',
  Uint8Array: 'uint8',
  Int16Array: 'int16',
  Uint16Array: 'uint16',
  Int32Array: 'int32',
  Uint32Array: 'uint32',
} as const;

/**
 * Gives the attributes of a triangle soup to the mesh that was made of it: to its vertices, or to its
 * halfedges (corners) where the corners at a vertex differ.
 */
export function addAttributes(
  mesh: HalfedgeMesh,
  report: RepairReport,
  indices: Uint32Array,
  attributes: readonly CornerAttribute[],
): void {
  if (attributes.length === 0) return;
  const corners = cornersOf(mesh, report, indices);
  // A copy: adding attributes can detach the views.
  const toVertex = newArray('the vertices of corners', Int32Array, mesh.halfedgeSlots);
  toVertex.set(mesh.connectivity.toVertex);
  const beside = withBoundary(mesh, corners);
  for (const attribute of attributes) {
    const rows = rowsByVertex(attribute, corners, toVertex, report.vertexOrigin);
    if (rows === undefined) fill(mesh, 'halfedge', attribute, beside);
    else fill(mesh, 'vertex', attribute, rows);
  }
}

/** A halfedge without a face gets what the next face around its vertex has there, as in files that the core reads. */
function withBoundary(mesh: HalfedgeMesh, corners: Int32Array): Int32Array {
  const { next, face } = mesh.connectivity;
  const rows = newArray('the corners', Int32Array, corners.length);
  for (let h = 0; h < rows.length; h++) rows[h] = corners[face[h] < 0 ? next[h] ^ 1 : h];
  return rows;
}

/** By halfedge of the mesh of a soup: the vertex of the soup in the corner where it ends, or -1. */
export function cornersOf(
  mesh: HalfedgeMesh,
  { vertexMap, vertexOrigin, faceMap }: RepairReport,
  indices: Uint32Array,
): Int32Array {
  const { toVertex, face } = mesh.connectivity;
  const faceOrigin = newArray('the faces', Uint32Array, mesh.faceSlots);
  faceMap.forEach((f, input) => {
    if (f >= 0) faceOrigin[f] = input;
  });
  const corners = newArray('the corners', Int32Array, face.length).fill(-1);
  for (let h = 0; h < face.length; h++) {
    if (face[h] < 0) continue;
    const vertex = vertexMap[vertexOrigin[toVertex[h]]];
    const first = 3 * faceOrigin[face[h]];
    for (let k = first; k < first + 3; k++) {
      if (vertexMap[indices[k]] === vertex) corners[h] = indices[k];
    }
  }
  return corners;
}

/** By vertex of the mesh a row that is that of all its corners, if they are all alike. */
function rowsByVertex(
  { components, values }: CornerAttribute,
  corners: Int32Array,
  toVertex: Int32Array,
  vertexOrigin: Uint32Array,
): Int32Array | undefined {
  const rows = newArray('the vertices', Int32Array, vertexOrigin.length).fill(-1);
  for (let h = 0; h < corners.length; h++) {
    const row = corners[h];
    if (row < 0) continue;
    const other = rows[toVertex[h]];
    if (other < 0) rows[toVertex[h]] = row;
    else if (other !== row && !areEqual(values, components, row, other)) return undefined;
  }
  for (let v = 0; v < rows.length; v++) if (rows[v] < 0) rows[v] = vertexOrigin[v];
  return rows;
}

function areEqual(values: CornerValues, components: number, a: number, b: number): boolean {
  for (let i = 0; i < components; i++) {
    if (values[a * components + i] !== values[b * components + i]) return false;
  }
  return true;
}

function fill(
  mesh: HalfedgeMesh,
  kind: ItemKind,
  { name, components, values, onSplit = policyFor(kind, name) }: CornerAttribute,
  rows: Int32Array,
): void {
  const type = TYPES[values.constructor.name as keyof typeof TYPES];
  const policy = kind === 'halfedge' && onSplit === 'copy' ? 'copy-corner' : onSplit;
  const view = mesh.attributes.add(kind, name, { type, components, onSplit: policy });
  rows.forEach((row, item) => {
    if (row < 0) return;
    for (let i = 0; i < components; i++) view[item * components + i] = values[row * components + i];
  });
}

function policyFor(kind: ItemKind, name: string): OnSplit {
  if (name === 'normal') return 'normalize';
  // Between two vertices with different bones, the mean of the weights is that of neither's bones.
  if (kind === 'vertex' && /^skin(Index|Weight)$/.test(name)) return 'copy';
  return 'interpolate';
}

/** What a buffer can hold of an attribute, and where the mesh has it. */
export interface Column extends CornerAttribute {
  readonly kind: 'vertex' | 'halfedge';
}

const SIZES: Record<string, readonly number[]> = { normal: [3], uv: [2], color: [3, 4] };

/** Told, in sentences, what of a mesh isn't in a file, or not as it was. */
export type Note = (sentence: string) => void;

/** Copies of the attributes that glTF has a name for: the memory under live views may grow. */
export function columnsOf(mesh: HalfedgeMesh, note: Note = () => {}): Column[] {
  const found = new Map<string, Column>();
  for (const info of mesh.attributes.list()) {
    const { kind, name, components, type } = info;
    const title = (of: string) => `the ${of} attribute ${describe(name)}`;
    const why = reasonAgainst(info);
    if (why !== undefined) {
      note(`Left out ${title(kind)}: ${why}.`);
      continue;
    }
    // Where both have it, corners are the finer; the list has vertices first.
    if (found.has(name)) note(`Left out ${title('vertex')}: halfedges have it as well.`);
    if (type === 'float64') note(`Wrote ${title(kind)} as 32-bit floats.`);
    const view = mesh.attributes.get(kind, name);
    const Kind = type.startsWith('float') ? Float32Array : view.constructor;
    const values = newArray(title(kind), Kind as new (length: number) => CornerValues, view.length);
    values.set(view);
    found.set(name, { kind: kind as Column['kind'], name, components, values });
  }
  return [...found.values()];
}

/** Why an attribute can't be in a glTF file, if that is so. */
function reasonAgainst({ kind, name, components, type }: AttributeInfo): string | undefined {
  const sizes = Object.hasOwn(SIZES, name) ? SIZES[name] : undefined;
  if (sizes === undefined || (kind !== 'vertex' && kind !== 'halfedge')) {
    return 'glTF has no place for it';
  }
  if (!sizes.includes(components)) {
    return `in glTF it has ${sizes.join(' or ')} components, not ${components}`;
  }
  if (type.startsWith('float')) return undefined;
  if (name === 'color' && (type === 'uint8' || type === 'uint16')) return undefined;
  return `in glTF it has no values of ${type}`;
}

/** What a mesh is to a graphics card. */
export interface Buffers {
  readonly positions: Float32Array;
  readonly indices: Uint32Array;
  readonly attributes: CornerAttribute[];
  /** By row of the buffers: the vertex that it shows. */
  readonly vertexOf: number[];
}

/**
 * The buffers of a mesh: vertices in order, then copies of those whose corners differ. `halfedges` are
 * those that end in the corners of its triangles: of a triangle mesh, all in the order of its faces.
 */
export function buffersOf(
  mesh: HalfedgeMesh,
  columns: readonly Column[] = columnsOf(mesh),
  halfedges: Uint32Array = mesh.allFaceHalfedges().items,
): Buffers {
  const ofCorners = columns.filter(({ kind }) => kind === 'halfedge');
  const { toVertex } = mesh.connectivity;
  const rank = newArray('the vertices', Int32Array, mesh.vertexSlots).fill(-1);
  // Of each row of the buffers: its vertex, a corner that it stands for, the next copy of that vertex.
  const vertexOf: number[] = mesh.vertices().toArray();
  vertexOf.forEach((v, i) => {
    rank[v] = i;
  });
  const cornerOf: number[] = new Array(vertexOf.length).fill(-1);
  const nextCopy: number[] = new Array(vertexOf.length).fill(-1);
  const copies = new CopyFinder(ofCorners, cornerOf, nextCopy);
  const indices = newArray('the indices', Uint32Array, halfedges.length);
  for (let i = 0; i < halfedges.length; i++) {
    const h = halfedges[i];
    const v = toVertex[h];
    let row = copies.find(h, rank[v]);
    if (row < 0) {
      row = vertexOf.length;
      vertexOf.push(v);
      cornerOf.push(-1);
      nextCopy.push(-1);
      copies.add(h, rank[v], row);
    }
    cornerOf[row] = h;
    indices[i] = row;
  }
  const positions = gather({ components: 3, values: mesh.positions }, vertexOf) as Float32Array;
  const attributes = columns.map(({ kind, ...column }) => {
    const rows = kind === 'vertex' ? vertexOf : cornerOf;
    return { ...column, values: gather(column, rows) };
  });
  return { positions, indices, attributes, vertexOf };
}

/** More copies of a vertex than these are found by their values: the tip of a cone has as many as it has sides. */
const FEW_COPIES = 16;

/** Finds, among the copies of a vertex, the one whose corners are like another. */
class CopyFinder {
  readonly #columns: readonly Column[];
  readonly #cornerOf: readonly number[];
  readonly #nextCopy: number[];
  /** By the first row of a vertex with many copies: the last of them, and each by what its corners have. */
  readonly #many = new Map<number, { last: number; readonly rows: Map<string, number> }>();

  /** By row of the buffers: a corner that it stands for, and the next copy of its vertex; -1 for none. */
  constructor(columns: readonly Column[], cornerOf: readonly number[], nextCopy: number[]) {
    this.#columns = columns;
    this.#cornerOf = cornerOf;
    this.#nextCopy = nextCopy;
  }

  /** The row for the corner where `h` ends, of the vertex whose first row this is; -1 if it needs another one. */
  find(h: number, first: number): number {
    let row = first;
    for (let left = FEW_COPIES; left > 0; left--) {
      if (this.#isAlike(h, row)) return row;
      row = this.#nextCopy[row];
      if (row < 0) return -1;
    }
    return this.#manyOf(first).rows.get(this.#keyOf(h)) ?? -1;
  }

  /** Takes up a row for that corner, because none was found. */
  add(h: number, first: number, row: number): void {
    const many = this.#many.get(first);
    many?.rows.set(this.#keyOf(h), row);
    let last = many?.last ?? first;
    while (this.#nextCopy[last] >= 0) last = this.#nextCopy[last];
    this.#nextCopy[last] = row;
    if (many) many.last = row;
  }

  #manyOf(first: number): { last: number; readonly rows: Map<string, number> } {
    let many = this.#many.get(first);
    if (many === undefined) {
      many = { last: first, rows: new Map() };
      for (let row = first; row >= 0; row = this.#nextCopy[row]) {
        many.rows.set(this.#keyOf(this.#cornerOf[row]), row);
        many.last = row;
      }
      this.#many.set(first, many);
    }
    return many;
  }

  #isAlike(h: number, row: number): boolean {
    const other = this.#cornerOf[row];
    return (
      other < 0 ||
      this.#columns.every(({ values, components }) => areEqual(values, components, h, other))
    );
  }

  /** Alike for corners that are alike: -0 is written as 0. */
  #keyOf(h: number): string {
    const keys = this.#columns.map(({ values, components }) =>
      values.subarray(h * components, (h + 1) * components).join(),
    );
    return keys.join(';');
  }
}

/** Rows in this order; zeros for -1. */
function gather(
  { components, values }: Pick<CornerAttribute, 'components' | 'values'>,
  rows: readonly number[],
): CornerValues {
  const Kind = values.constructor as new (length: number) => CornerValues;
  const gathered = newArray('a buffer', Kind, rows.length * components);
  rows.forEach((row, i) => {
    if (row < 0) return;
    for (let k = 0; k < components; k++) {
      gathered[i * components + k] = values[row * components + k];
    }
  });
  return gathered;
}
