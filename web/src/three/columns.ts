// The attributes of a mesh that a geometry shows.

import { describe, newArray } from '../arguments.js';
import type { AttributeInfo } from '../attributes.js';
import { refuse } from '../checks.js';
import type { Column, CornerValues } from '../gltf/corners.js';
import { HalfedgeMesh } from '../mesh.js';
import { linksOf } from '../navigation.js';
import type { OptionNames } from '../options.js';
import { geometryError } from './attributes.js';
import { cornerNormals } from './normals.js';

/** How normals are made: see {@link GeometryOptions}. */
export type NormalOption = 'smooth' | 'flat' | 'none';

/** What a geometry shows of a mesh. */
export interface GeometryOptions {
  /**
   * `'smooth'` uses the attribute `normal` or, without one, the mean of the faces at each vertex, weighted by
   * area; `'flat'` uses the normals of the faces; `'none'` makes none. Default: 'smooth'.
   */
  normals?: NormalOption | undefined;
  /** The names of the attributes of vertices and halfedges to show. Default: all. */
  attributes?: readonly string[] | undefined;
}

export const GEOMETRY_OPTIONS: OptionNames<GeometryOptions> = { normals: true, attributes: true };

const NORMALS: readonly unknown[] = ['smooth', 'flat', 'none'];

/** Throws a sentence for what is no mesh that lives. */
export function checkMesh(mesh: unknown): HalfedgeMesh {
  if (!(mesh instanceof HalfedgeMesh)) refuse('mesh', mesh, 'a HalfedgeMesh');
  linksOf(mesh).checkAlive();
  return mesh;
}

/** Throws a sentence for what is no way to make normals. */
export function checkNormals(normals: unknown = 'smooth'): NormalOption {
  if (NORMALS.includes(normals)) return normals as NormalOption;
  throw new TypeError(
    `options.normals is ${describe(normals)}; expected 'smooth', 'flat' or 'none'.`,
  );
}

/** The attributes to show, once each: those of halfedges are finer than those of vertices. */
export function shownAttributes(
  mesh: HalfedgeMesh,
  { attributes: names, normals }: GeometryOptions,
): AttributeInfo[] {
  if (names !== undefined && !Array.isArray(names)) {
    refuse('options.attributes', names, 'an array of names');
  }
  const shown = new Map<string, AttributeInfo>();
  for (const info of mesh.attributes.list()) {
    if (info.kind !== 'vertex' && info.kind !== 'halfedge') continue;
    if (info.name === 'position' || (names !== undefined && !names.includes(info.name))) continue;
    // Normals are shown as the option asks for them, whether named or not.
    if (info.name === 'normal' && (info.components !== 3 || checkNormals(normals) !== 'smooth'))
      continue;
    if (info.kind === 'halfedge' || !shown.has(info.name)) shown.set(info.name, info);
  }
  const missing = names?.find((name) => name !== 'normal' && !shown.has(name));
  if (missing === undefined) return [...shown.values()];
  throw new RangeError(
    `options.attributes names ${describe(missing)}; expected attributes of the vertices or halfedges of the mesh.`,
  );
}

/** Throws a sentence unless the mesh has these attributes still, as they were. */
export function checkShown(mesh: HalfedgeMesh, shown: readonly AttributeInfo[]): void {
  if (shown.length === 0) return;
  const list = mesh.attributes.list();
  for (const { kind, name, type, components } of shown) {
    const now = list.find((info) => info.kind === kind && info.name === name);
    if (now?.type === type && now.components === components) continue;
    const has = now ? `has ${now.components} × ${now.type}` : 'is gone';
    throw geometryError(
      'unsupported-attribute',
      `The ${kind} attribute ${describe(name)} ${has}; expected ${components} × ${type}, as when the geometry was made: make another one.`,
    );
  }
}

/** Whether its integers stand for numbers from 0 to 1. */
export const isNormalized = ({ name, type }: AttributeInfo) =>
  name === 'color' && (type === 'uint8' || type === 'uint16');

/** An array for so many numbers of an attribute, of a type that a graphics card takes. */
export function arrayFor(mesh: HalfedgeMesh, { kind, name }: AttributeInfo, length: number) {
  const view = mesh.attributes.get(kind, name);
  const Kind = view instanceof Float64Array ? Float32Array : view.constructor;
  return newArray<CornerValues>(name, Kind as new (length: number) => CornerValues, length);
}

/** A copy of the values, of such a type. */
function valuesOf(mesh: HalfedgeMesh, info: AttributeInfo): CornerValues {
  const view = mesh.attributes.get(info.kind, info.name);
  const values = arrayFor(mesh, info, view.length);
  values.set(view);
  return values;
}

/** Copies of all that is shown, normals included. */
export function columnsToShow(mesh: HalfedgeMesh, options: GeometryOptions): Column[] {
  const normals = checkNormals(options.normals);
  const columns = shownAttributes(mesh, options).map((info): Column => {
    const { kind, name, components } = info;
    return { kind: kind as Column['kind'], name, components, values: valuesOf(mesh, info) };
  });
  if (normals === 'none' || columns.some(({ name }) => name === 'normal')) return columns;
  const [kind, values] =
    normals === 'flat'
      ? (['halfedge', cornerNormals(mesh)] as const)
      : (['vertex', mesh.allVertexNormals()] as const);
  return [{ kind, name: 'normal', components: 3, values }, ...columns];
}
