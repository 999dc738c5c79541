import { BufferAttribute, BufferGeometry } from 'three';
import { newArray } from '../arguments.js';
import { checkFlag } from '../checks.js';
import { buffersOf, type CornerAttribute } from '../gltf/corners.js';
import type { HalfedgeMesh } from '../mesh.js';
import { checkOptions } from '../options.js';
import { morphName } from './attributes.js';
import { checkMesh, columnsToShow, GEOMETRY_OPTIONS, type GeometryOptions } from './columns.js';
import { GROUP } from './read.js';
import { type FaceTriangles, triangulateFaces } from './triangulate.js';

/** How to make a geometry from a mesh. */
export interface ToGeometryOptions extends GeometryOptions {
  /** Whether the face attribute `group` becomes groups, which sorts the triangles by group. Default: true. */
  groups?: boolean | undefined;
}

/** A geometry, and which parts of the mesh it shows where. */
export interface MeshBuffers {
  readonly geometry: BufferGeometry;
  /** By triangle: its face. `faces[intersection.faceIndex]` is the face that a ray has hit. */
  readonly faces: Uint32Array;
  /** By vertex of the geometry: its vertex in the mesh. */
  readonly vertices: Uint32Array;
}

/**
 * Makes an indexed three.js geometry from a mesh as it is now. Polygons are cut into triangles, each by
 * itself, as `mesh.triangulate(face)` cuts them; the mesh is not changed. Vertices come in the order of the
 * mesh, followed by copies of those whose corners have different attributes. Attributes keep their names. The
 * face attribute `group` becomes groups. `morph position 0` and so on, up to the first number that is
 * missing, become relative morph targets.
 *
 * ```ts
 * const { geometry, faces } = toBufferGeometry(mesh, { normals: 'flat' });
 * scene.add(new Mesh(geometry, material));
 * ```
 *
 * @throws HalfedgeError `out-of-memory`; TypeError or RangeError for wrong options
 */
export function toBufferGeometry(
  given: HalfedgeMesh,
  options: ToGeometryOptions = {},
): MeshBuffers {
  const names = { ...GEOMETRY_OPTIONS, groups: true } as const;
  const { groups = true } = checkOptions<ToGeometryOptions>(options, names);
  checkFlag('options.groups', groups);
  const mesh = checkMesh(given);
  const columns = columnsToShow(mesh, options);
  const geometry = new BufferGeometry();
  const info = mesh.attributes.list().find(({ kind, name }) => kind === 'face' && name === GROUP);
  let triangles = triangulateFaces(mesh);
  if (groups && info?.components === 1) {
    triangles = inGroups(triangles, mesh.attributes.get('face', GROUP), geometry);
  }
  const { positions, indices, attributes, vertexOf } = buffersOf(
    mesh,
    columns,
    triangles.halfedges,
  );
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setIndex(new BufferAttribute(indices, 1));
  const targets = morphTargets(attributes);
  for (const attribute of attributes) addTo(geometry, attribute, targets.get(attribute.name));
  const vertices = newArray('the vertices', Uint32Array, vertexOf.length);
  vertices.set(vertexOf);
  return { geometry, faces: triangles.faces, vertices };
}

type MorphTarget = readonly [base: 'position' | 'normal' | 'color', i: number];

/** By the name of their attribute. From the first on: three.js takes no list with gaps. */
function morphTargets(attributes: readonly CornerAttribute[]): Map<string, MorphTarget> {
  const names = new Set(attributes.map(({ name }) => name));
  const targets = new Map<string, MorphTarget>();
  for (const base of ['position', 'normal', 'color'] as const) {
    for (let i = 0; names.has(morphName(base, i)); i++) targets.set(morphName(base, i), [base, i]);
  }
  return targets;
}

function addTo(
  geometry: BufferGeometry,
  { name, components, values }: CornerAttribute,
  target: MorphTarget | undefined,
): void {
  const isNormalized =
    name === 'color' && (values instanceof Uint8Array || values instanceof Uint16Array);
  const attribute = new BufferAttribute(values, components, isNormalized);
  if (target === undefined) {
    geometry.setAttribute(name, attribute);
    return;
  }
  const [base, i] = target;
  geometry.morphTargetsRelative = true;
  geometry.morphAttributes[base] ??= [];
  geometry.morphAttributes[base][i] = attribute;
}

/** The triangles in the order of their groups, which are added; those in none come last. */
function inGroups(
  { halfedges, faces }: FaceTriangles,
  groupOf: ArrayLike<number>,
  geometry: BufferGeometry,
): FaceTriangles {
  const rank = (triangle: number) => {
    const group = groupOf[faces[triangle]];
    return group >= 0 ? group : Infinity;
  };
  const order = newArray('the triangles', Uint32Array, faces.length);
  for (let i = 0; i < order.length; i++) order[i] = i;
  // By group, and within it as they were.
  order.sort((a, b) => (rank(a) === rank(b) ? a - b : rank(a) < rank(b) ? -1 : 1));
  for (let from = 0; from < order.length; ) {
    const group = rank(order[from]);
    let to = from;
    while (to < order.length && rank(order[to]) === group) to += 1;
    if (group < Infinity) geometry.addGroup(3 * from, 3 * (to - from), group);
    from = to;
  }
  const sorted = newArray('the triangles', Uint32Array, halfedges.length);
  order.forEach((triangle, i) => {
    sorted.set(halfedges.subarray(3 * triangle, 3 * triangle + 3), 3 * i);
  });
  for (let i = 0; i < order.length; i++) order[i] = faces[order[i]];
  return { halfedges: sorted, faces: order };
}
