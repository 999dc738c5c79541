// Between the attributes of three.js's geometries and plain arrays.

import {
  type BufferAttribute,
  type BufferGeometry,
  type InterleavedBufferAttribute,
  MathUtils,
} from 'three';
import { describe, newArray } from '../arguments.js';
import { counted } from '../counted.js';
import { HalfedgeError } from '../errors.js';
import type { CornerAttribute, CornerValues } from '../gltf/corners.js';
import { GETTERS } from '../gltf/geometry.js';

export type AnyAttribute = BufferAttribute | InterleavedBufferAttribute;

/** What a morph target moves: the attribute of the mesh that has its i-th one. */
export const morphName = (name: string, i: number) => `morph ${name} ${i}`;

/** Whether an attribute is named as that of a morph target is. */
export const isMorph = (name: string) => /^morph (position|normal|color) \d+$/.test(name);

/** An error of a geometry, with what was expected. */
export const geometryError = (code: string, message: string) => new HalfedgeError(code, message);

/** The attribute, if it is one with numbers in an array, as many rows as there are positions. */
export function checkAttribute(name: string, attribute: unknown, rows?: number): AnyAttribute {
  const { count, itemSize, data } = attribute as Partial<InterleavedBufferAttribute>;
  const numbers = arrayOf(attribute);
  if (numbers === undefined || count === undefined || itemSize === undefined) {
    throw withoutArray(`geometry.attributes.${name}`);
  }
  if (
    'isInstancedBufferAttribute' in (attribute as object) ||
    data?.['isInstancedInterleavedBuffer' as never]
  ) {
    throw geometryError(
      'unsupported-attribute',
      `geometry.attributes.${name} is one of instances, not of vertices; expected a geometry without instances.`,
    );
  }
  if (!Number.isInteger(count)) {
    throw geometryError(
      'truncated',
      `geometry.attributes.${name} has ${counted((numbers as Float32Array).length, 'number')}; expected a multiple of ${data?.stride ?? itemSize}, for whole rows.`,
    );
  }
  if (rows !== undefined && count < rows) {
    throw geometryError(
      'truncated',
      `geometry.attributes.${name} has ${counted(count, 'row')}; expected ${rows}, one for each position.`,
    );
  }
  if (!(itemSize >= 1 && itemSize <= 16)) {
    throw geometryError(
      'unsupported-attribute',
      `geometry.attributes.${name} has ${itemSize} components; expected 1 to 16.`,
    );
  }
  return attribute as AnyAttribute;
}

function arrayOf(attribute: unknown): ArrayBufferView | undefined {
  const { array, data } = attribute as Partial<InterleavedBufferAttribute>;
  const numbers: unknown = array ?? data?.array;
  return ArrayBuffer.isView(numbers) ? numbers : undefined;
}

const withoutArray = (where: string) =>
  geometryError(
    'unsupported-attribute',
    `${where} has no array (a GLBufferAttribute has its numbers on the graphics card alone); expected a BufferAttribute or an InterleavedBufferAttribute.`,
  );

/** Throws unless it is an index with a number for each corner. */
export function checkIndex(index: AnyAttribute): void {
  if (arrayOf(index) === undefined) throw withoutArray('geometry.index');
  if (index.itemSize === 1) return;
  throw geometryError(
    'unsupported-attribute',
    `geometry.index has ${counted(index.itemSize, 'component')}; expected 1, a vertex for each corner.`,
  );
}

/** A copy of the numbers as floats: normalised integers divided, interleaved ones put in a row. */
export function floatsOf(
  name: string,
  attribute: AnyAttribute,
  rows = attribute.count,
): Float32Array {
  const { itemSize, array } = attribute;
  const length = rows * itemSize;
  // Those that lie side by side as floats are copied bit for bit.
  if (array instanceof Float32Array && !('isInterleavedBufferAttribute' in attribute)) {
    return array.slice(0, length);
  }
  const values = newArray(name, Float32Array, length);
  for (let i = 0; i < length; i++)
    values[i] = component(name, attribute, Math.floor(i / itemSize), i % itemSize);
  return values;
}

function component(name: string, attribute: AnyAttribute, row: number, k: number): number {
  // Half floats are told by these only; matrices have more components than those.
  if (k < GETTERS.length) return attribute[GETTERS[k]](row);
  if ('isFloat16BufferAttribute' in attribute) {
    throw geometryError(
      'unsupported-attribute',
      `geometry.attributes.${name} has ${attribute.itemSize} components of half precision; expected at most 4.`,
    );
  }
  if (!('data' in attribute)) return attribute.getComponent(row, k);
  const { array, stride } = attribute.data;
  const value = array[row * stride + attribute.offset + k];
  return attribute.normalized ? MathUtils.denormalize(value, array as Int8Array) : value;
}

const INTEGERS = [Int8Array, Uint8Array, Int16Array, Uint16Array, Int32Array, Uint32Array];

/** The column of an attribute: colours in bytes and integers that are no fractions stay as they are. */
export function columnOf(name: string, attribute: AnyAttribute, rows: number): CornerAttribute {
  const { array, normalized, itemSize: components } = attribute;
  const isHalf = 'isFloat16BufferAttribute' in attribute;
  const Kind = INTEGERS.find((kind) => array instanceof kind && !isHalf);
  const isColor = name === 'color' && (Kind === Uint8Array || Kind === Uint16Array);
  if (Kind === undefined || normalized !== isColor) {
    return { name, components, values: floatsOf(name, attribute, rows) };
  }
  const values = newArray<CornerValues>(name, Kind, rows * components);
  const scale = !normalized ? 1 : Kind === Uint8Array ? 255 : 65535;
  for (let i = 0; i < values.length; i++) {
    values[i] = Math.round(
      scale * component(name, attribute, Math.floor(i / components), i % components),
    );
  }
  return { name, components, values, ...(isColor ? {} : { onSplit: 'copy' }) };
}

/** What stands for 1: the largest integer in colours of bytes, which are fractions of it. */
function scaleOf({ name, values }: CornerAttribute): number {
  if (name !== 'color') return 1;
  return values instanceof Uint8Array ? 255 : values instanceof Uint16Array ? 65535 : 1;
}

/** By name, what the morph targets add to positions, normals and colours. */
export function morphColumns(
  geometry: BufferGeometry,
  bases: readonly CornerAttribute[],
  rows: number,
): CornerAttribute[] {
  return Object.entries(geometry.morphAttributes).flatMap(([name, targets = []]) => {
    const base = bases.find((column) => column.name === name);
    return targets.map((target, i) => {
      const what = `${name} of the morph target ${i}`;
      const attribute = checkAttribute(what, target, rows);
      const values = floatsOf(what, attribute, rows);
      if (!geometry.morphTargetsRelative) {
        if (base?.components !== attribute.itemSize) {
          throw geometryError(
            'unsupported-attribute',
            `geometry.morphAttributes.${name}[${i}] has ${counted(attribute.itemSize, 'component')}; expected those of geometry.attributes.${name}, ${base?.components ?? 'which is missing'}.`,
          );
        }
        const scale = scaleOf(base);
        for (let k = 0; k < values.length; k++) values[k] -= base.values[k] / scale;
      }
      // Differences: they have no length to be kept.
      return {
        name: morphName(name, i),
        components: attribute.itemSize,
        values,
        onSplit: 'interpolate' as const,
      };
    });
  });
}

/** Throws unless it is a geometry of triangles that can be read. */
export function checkGeometry(geometry: unknown): BufferGeometry {
  const given = geometry as Partial<BufferGeometry> & { isInstancedBufferGeometry?: boolean };
  if (given?.isBufferGeometry !== true) {
    throw new TypeError(
      `geometry is ${describe(geometry)}; expected a BufferGeometry of three.js.`,
    );
  }
  if (given.isInstancedBufferGeometry) {
    throw geometryError(
      'unsupported-geometry',
      'geometry is an InstancedBufferGeometry; expected one without instances, such as what is drawn of each.',
    );
  }
  return geometry as BufferGeometry;
}
