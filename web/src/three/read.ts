import type { BufferGeometry } from 'three';
import { describe, newArray } from '../arguments.js';
import { checkFlag } from '../checks.js';
import { counted } from '../counted.js';
import { addAttributes, type CornerAttribute, cornersOf } from '../gltf/corners.js';
import { HalfedgeMesh } from '../mesh.js';
import { checkOptions, type OptionNames } from '../options.js';
import { type RepairReport, refuseMended, SOUP_OPTIONS, type SoupOptions } from '../repair.js';
import type { Rows } from '../rings.js';
import {
  checkAttribute,
  checkGeometry,
  checkIndex,
  columnOf,
  floatsOf,
  geometryError,
  morphColumns,
} from './attributes.js';

/** How to read a geometry. */
export interface FromGeometryOptions extends SoupOptions {
  /**
   * Joins the vertices that a geometry repeats along the seams of its attributes. `true` joins those at the
   * same position, allowing for the rounding of sines and cosines (2^-21 of the largest coordinate); 0 joins
   * those at exactly the same position; any other number joins those closer than that; `false` joins none,
   * and takes the index buffer as it is. Default: true.
   */
  weld?: boolean | number | undefined;
  /**
   * Whether triangles that don't form a manifold are repaired and reported; otherwise they are an error.
   * Default: true.
   */
  repair?: boolean | undefined;
}

const FROM_GEOMETRY_OPTIONS: OptionNames<FromGeometryOptions> = { ...SOUP_OPTIONS, repair: true };

/** What became of what. -1 means none. */
export interface GeometryMaps {
  /** By vertex of the geometry: its vertex in the mesh. */
  readonly vertices: Int32Array;
  /** By drawn triangle: its face. */
  readonly faces: Int32Array;
  /** By face: the triangle that it was. */
  readonly triangles: Int32Array;
  /** By halfedge: the vertex of the geometry in the corner where it ends. */
  readonly corners: Int32Array;
  /** Row i: the halfedges in whose corners vertex i of the geometry is. */
  readonly halfedges: Rows;
}

/** A mesh made of a geometry. */
export interface GeometryMesh {
  readonly mesh: HalfedgeMesh;
  readonly maps: GeometryMaps;
  readonly report: RepairReport;
}

/**
 * Makes a mesh from a three.js geometry, indexed or not, interleaved or not. Vertices that are repeated along
 * seams become one again. Values that differ between them become attributes of halfedges (corners), so that
 * nothing is lost; all others become attributes of vertices. Attributes keep their names: `normal`, `uv`,
 * `uv1`, `color`, `tangent`, `skinIndex`, ... Normalised integers become floats, except colours in bytes.
 * Edits copy integers, and `skinWeight` along with `skinIndex`; they interpolate the rest.
 * Morph targets become `morph position 0` and so on, relative to the attribute; their names are not kept.
 * Groups become the face attribute `group`, which holds the index of the material (-1 where nothing is
 * drawn). Triangles outside the draw range are not part of the mesh; their vertices stay, without faces,
 * unless `dropIsolated` leaves them out. Triangles that don't form a manifold are repaired, as by
 * `HalfedgeMesh.fromSoup`.
 *
 * ```ts
 * const { mesh, maps } = fromBufferGeometry(new BoxGeometry()); // 8 vertices, 24 in the geometry
 * const v = maps.vertices[intersection.face.a];
 * ```
 *
 * @throws HalfedgeError `no-positions`, `unsupported-attribute`, `unsupported-geometry`, `truncated`,
 * `bad-group`, or with `repair: false` the first thing that would have to be repaired; TypeError for anything
 * but a geometry
 */
export function fromBufferGeometry(
  given: BufferGeometry,
  options: FromGeometryOptions = {},
): GeometryMesh {
  const {
    weld = true,
    repair = true,
    dropIsolated,
    storePrev,
  } = checkOptions(options, FROM_GEOMETRY_OPTIONS);
  checkFlag('options.repair', repair);
  const geometry = checkGeometry(given);
  if (geometry.attributes.position === undefined) {
    throw geometryError(
      'no-positions',
      'geometry.attributes.position is missing; expected x, y and z of each vertex.',
    );
  }
  const position = checkAttribute('position', geometry.attributes.position);
  if (position.itemSize !== 3) {
    throw geometryError(
      'no-positions',
      `geometry.attributes.position has ${counted(position.itemSize, 'component')}; expected 3, x, y and z.`,
    );
  }
  const positions = floatsOf('position', position);
  const { indices, groups } = trianglesOf(geometry, position.count);
  const attributes = columnsOf(geometry, positions);
  const { mesh, report } = HalfedgeMesh.fromSoup(positions, indices, {
    weld: weld === true ? tolerance(positions) : weld,
    ...(dropIsolated === undefined ? {} : { dropIsolated }),
    ...(storePrev === undefined ? {} : { storePrev }),
  });
  try {
    if (!repair) refuseMended(report);
    addAttributes(mesh, report, indices, attributes);
    if (groups !== undefined) addGroups(mesh, report.faceMap, groups);
    return { mesh, report, maps: mapsOf(mesh, report, indices) };
  } catch (error) {
    mesh.dispose();
    throw error;
  }
}

/** How far rounding puts points apart that are meant to be one. */
function tolerance(positions: Float32Array): number {
  let largest = 0;
  for (const x of positions) if (Number.isFinite(x)) largest = Math.max(largest, Math.abs(x));
  return largest * 2 ** -21;
}

function columnsOf(geometry: BufferGeometry, positions: Float32Array): CornerAttribute[] {
  const rows = positions.length / 3;
  const columns = Object.entries(geometry.attributes)
    .filter(([name]) => name !== 'position')
    .map(([name, attribute]) => columnOf(name, checkAttribute(name, attribute, rows), rows));
  const position = { name: 'position', components: 3, values: positions };
  return [...columns, ...morphColumns(geometry, [position, ...columns], rows)];
}

/** The vertices of the triangles that are drawn, and the material of each where there are groups. */
function trianglesOf(
  { index, drawRange, groups }: BufferGeometry,
  rows: number,
): { indices: Uint32Array; groups?: Int32Array } {
  if (index !== null) checkIndex(index);
  const length = index?.count ?? rows;
  const first = Math.max(0, drawRange.start);
  // A start before 0 takes from the count, as where three.js draws.
  const count = Math.max(0, Math.min(length, drawRange.start + drawRange.count) - first);
  if (count % 3 !== 0) {
    throw geometryError(
      'truncated',
      `${index === null ? 'geometry.attributes.position' : 'geometry.index'} has ${counted(count, 'element')} to be drawn; expected a multiple of 3, three for each triangle.`,
    );
  }
  const indices = newArray('the index', Uint32Array, count);
  for (let i = 0; i < count; i++) indices[i] = index === null ? first + i : index.getX(first + i);
  if (groups.length === 0) return { indices };
  const materials = newArray('the groups', Int32Array, count / 3).fill(-1);
  groups.forEach((group, i) => {
    const { start, materialIndex = 0 } = group;
    const from = Math.max(start, first) - first;
    const to = Math.min(start + group.count, first + count) - first;
    if (from >= to) return;
    const wrong = (what: string) => geometryError('bad-group', `geometry.groups[${i}] ${what}.`);
    if (from % 3 !== 0 || to % 3 !== 0) {
      throw wrong(
        `goes from ${start} to ${start + group.count}; expected whole triangles from ${first} on`,
      );
    }
    if (!(Number.isInteger(materialIndex) && materialIndex >= 0)) {
      throw wrong(`has the materialIndex ${describe(materialIndex)}; expected an integer from 0`);
    }
    const taken = materials.subarray(from / 3, to / 3).findIndex((material) => material >= 0);
    if (taken >= 0)
      throw wrong(
        `has triangle ${from / 3 + taken}, which an earlier one has; expected each triangle once`,
      );
    materials.fill(materialIndex, from / 3, to / 3);
  });
  return { indices, groups: materials };
}

/** The name of the attribute of faces that says with which material they are drawn. */
export const GROUP = 'group';

function addGroups(mesh: HalfedgeMesh, faceMap: Int32Array, groups: Int32Array): void {
  const options = { type: 'int32', default: -1, onSplit: 'copy' } as const;
  const view = mesh.attributes.add('face', GROUP, options);
  faceMap.forEach((f, triangle) => {
    if (f >= 0) view[f] = groups[triangle];
  });
}

function mapsOf(mesh: HalfedgeMesh, report: RepairReport, indices: Uint32Array): GeometryMaps {
  const { vertexMap: vertices, faceMap: faces } = report;
  const triangles = newArray('the faces', Int32Array, mesh.faceSlots).fill(-1);
  faces.forEach((f, triangle) => {
    if (f >= 0) triangles[f] = triangle;
  });
  const corners = cornersOf(mesh, report, indices);
  return { vertices, faces, triangles, corners, halfedges: inverse(corners, vertices.length) };
}

/** Row i: where the map has the value i. */
function inverse(map: Int32Array, rows: number): Rows {
  const offsets = newArray('the maps', Uint32Array, rows + 1);
  for (const row of map) if (row >= 0) offsets[row + 1] += 1;
  for (let row = 0; row < rows; row++) offsets[row + 1] += offsets[row];
  const items = newArray('the maps', Uint32Array, offsets[rows]);
  const ends = newArray('the maps', Uint32Array, rows + 1);
  ends.set(offsets);
  map.forEach((row, item) => {
    if (row >= 0) items[ends[row]++] = item;
  });
  return { offsets, items };
}
