// Between three.js's geometries and plain arrays.

import type {
  BufferAttribute,
  BufferGeometry,
  InterleavedBufferAttribute,
  Matrix4,
  Mesh,
} from 'three';
import { newArray } from '../arguments.js';
import { oneOf, widen } from './colors.js';
import type { CornerAttribute, CornerValues } from './corners.js';

/** Triangles with attributes by vertex, as they lie in buffers. */
export interface Triangles {
  readonly positions: Float32Array;
  readonly indices: Uint32Array;
  readonly attributes: readonly CornerAttribute[];
}

type AnyAttribute = BufferAttribute | InterleavedBufferAttribute;

type CornerArray = new (length: number) => CornerValues;

/** How components are read, normalised integers divided, by any three.js: `getComponent` is younger. */
export const GETTERS = ['getX', 'getY', 'getZ', 'getW'] as const;

/** three.js's names, and ours, with the numbers of components that they may have. */
const ATTRIBUTES = [
  { theirs: 'normal', name: 'normal', components: [3] },
  { theirs: 'uv', name: 'uv', components: [2] },
  { theirs: 'color', name: 'color', components: [3, 4] },
] as const;

/** The triangles of a mesh in a scene, moved to where they stand there. */
export function trianglesOf({ geometry }: Mesh, matrix: Matrix4): Triangles {
  const position = geometry.getAttribute('position') as AnyAttribute;
  const attributes: CornerAttribute[] = [];
  for (const { theirs, name, components } of ATTRIBUTES) {
    const attribute = geometry.getAttribute(theirs) as AnyAttribute | undefined;
    if (attribute === undefined || !fits(attribute, components, position)) continue;
    const values = name === 'color' ? colors(attribute) : floats(attribute);
    if (name === 'normal') turn(values as Float32Array, matrix);
    attributes.push({ name, components: attribute.itemSize, values });
  }
  const positions = floats(position);
  move(positions, matrix);
  const indices = indicesOf(geometry, position.count);
  if (matrix.determinant() < 0) {
    // Seen in a mirror, faces run the other way.
    for (let i = 0; i < indices.length; i += 3) {
      [indices[i + 1], indices[i + 2]] = [indices[i + 2], indices[i + 1]];
    }
  }
  return { positions, indices, attributes };
}

/** Whether there is a row for each position, with as many numbers as it may have. */
function fits(
  attribute: AnyAttribute,
  components: readonly number[],
  position: { readonly count: number },
): boolean {
  return attribute.count === position.count && components.includes(attribute.itemSize);
}

/** Our names of attributes that are there, but not read, as they don't fit. */
export function unfitting({ attributes }: BufferGeometry): string[] {
  return ATTRIBUTES.filter(({ theirs, components }) => {
    const attribute = attributes[theirs] as AnyAttribute | undefined;
    return attribute !== undefined && !fits(attribute, components, attributes.position);
  }).map(({ name }) => name);
}

/** How many corners are left behind the last triangle. */
export function cornersLeft({ index, attributes }: BufferGeometry): number {
  return (index?.count ?? attributes.position.count) % 3;
}

/** A copy of the index, or all vertices in a row; whole triangles only. */
function indicesOf({ index }: BufferGeometry, vertices: number): Uint32Array {
  const count = index?.count ?? vertices;
  const indices = newArray('the indices', Uint32Array, count - (count % 3));
  if (index === null) return indices.map((_, i) => i);
  indices.set((index.array as Uint32Array).subarray(0, indices.length));
  return indices;
}

/** A copy of the numbers. Those that lie side by side as floats are copied bit for bit. */
function floats(attribute: AnyAttribute): Float32Array {
  const { count, itemSize, array } = attribute;
  if (array instanceof Float32Array && !('isInterleavedBufferAttribute' in attribute)) {
    return array.slice(0, count * itemSize);
  }
  const values = newArray('an attribute', Float32Array, count * itemSize);
  for (let i = 0; i < values.length; i++) {
    values[i] = attribute[GETTERS[i % itemSize]](Math.floor(i / itemSize));
  }
  return values;
}

/** As floats, or as the integers of which 255 or 65535 are one. */
function colors(attribute: AnyAttribute): CornerValues {
  const { array, normalized, count, itemSize } = attribute;
  const Kind = INTEGER_COLORS.find((kind) => normalized && array instanceof kind);
  if (Kind === undefined) return floats(attribute);
  const values = newArray('the colours', Kind, count * itemSize);
  const one = oneOf(values);
  for (let i = 0; i < values.length; i++) {
    values[i] = Math.round(one * attribute[GETTERS[i % itemSize]](Math.floor(i / itemSize)));
  }
  return values;
}

const INTEGER_COLORS: readonly CornerArray[] = [Uint8Array, Uint16Array];

/** Applies a matrix to points, in place. The identity changes no bit. */
function move(points: Float32Array, { elements: m }: Matrix4): void {
  if (m.every((value, i) => value === (i % 5 === 0 ? 1 : 0))) return;
  for (let i = 0; i + 2 < points.length; i += 3) {
    const [x, y, z] = [points[i], points[i + 1], points[i + 2]];
    for (let row = 0; row < 3; row++) {
      points[i + row] = m[row] * x + m[row + 4] * y + m[row + 8] * z + m[row + 12];
    }
  }
}

/** Turns normals as a matrix turns the faces under them, in place. */
function turn(normals: Float32Array, matrix: Matrix4): void {
  const m = matrix.elements;
  if (m.every((value, i) => i >= 12 || value === (i % 5 === 0 ? 1 : 0))) return;
  // The cofactors of its 3 x 3 part: the transposed inverse, times the determinant.
  const at = (row: number, column: number) => m[(row % 3) + 4 * (column % 3)];
  const cofactors = Array.from({ length: 9 }, (_, i) => {
    const [row, column] = [Math.floor(i / 3), i % 3];
    return (
      at(row + 1, column + 1) * at(row + 2, column + 2) -
      at(row + 1, column + 2) * at(row + 2, column + 1)
    );
  });
  const sign = matrix.determinant() < 0 ? -1 : 1;
  for (let i = 0; i + 2 < normals.length; i += 3) {
    const n = [normals[i], normals[i + 1], normals[i + 2]];
    const turned = [0, 3, 6].map(
      (r) => sign * (cofactors[r] * n[0] + cofactors[r + 1] * n[1] + cofactors[r + 2] * n[2]),
    );
    const length = Math.hypot(...turned) || 1;
    for (let axis = 0; axis < 3; axis++) normals[i + axis] = turned[axis] / length;
  }
}

/**
 * All parts in one. Vertices of parts without an attribute that others have get zeros, or white; where
 * parts have colours of several types or with and without alpha, all become those that lose nothing.
 */
export function join(parts: readonly Triangles[], note: (sentence: string) => void): Triangles {
  if (parts.length === 1) return parts[0];
  const total = (size: (part: Triangles) => number) =>
    parts.reduce((sum, part) => sum + size(part), 0);
  const positions = newArray(
    'the positions',
    Float32Array,
    total((part) => part.positions.length),
  );
  const indices = newArray(
    'the indices',
    Uint32Array,
    total((part) => part.indices.length),
  );
  let vertices = 0;
  let corners = 0;
  for (const part of parts) {
    positions.set(part.positions, 3 * vertices);
    for (const index of part.indices) indices[corners++] = index + vertices;
    vertices += part.positions.length / 3;
  }
  const names = ATTRIBUTES.map(({ name }) => name);
  const attributes = names.flatMap((name) => joined(name, parts, vertices, note));
  return { positions, indices, attributes };
}

function joined(
  name: string,
  parts: readonly Triangles[],
  vertices: number,
  note: (sentence: string) => void,
): CornerAttribute[] {
  const all = parts.map(({ attributes }) => attributes.find((found) => found.name === name));
  const found = all.filter((attribute) => attribute !== undefined);
  if (found.length === 0) return [];
  const components = Math.max(...found.map((attribute) => attribute.components));
  const kinds = new Set(found.map(({ values }) => values.constructor as CornerArray));
  const Kind = kinds.size === 1 ? [...kinds][0] : Float32Array;
  const values = newArray(`the attribute ${name}`, Kind, vertices * components);
  const one = oneOf(values);
  let row = 0;
  for (const [i, part] of parts.entries()) {
    const end = row + part.positions.length / 3;
    const attribute = all[i];
    if (attribute === undefined) {
      if (name === 'color') values.fill(one, row * components, end * components);
    } else {
      widen(attribute, values, row, components);
    }
    row = end;
  }
  if (found.length < parts.length) {
    const filler = name === 'color' ? 'white' : 'zeros';
    note(
      `Filled ${name} with ${filler} where primitives have none (${parts.length - found.length} of ${parts.length}).`,
    );
  }
  return [{ name, components, values }];
}
