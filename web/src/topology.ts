import { newArray } from './arguments.js';
import { refuse } from './checks.js';
import type { RawFinding } from './core.js';
import type { Problem } from './errors.js';
import type { Halfedge } from './items.js';
import type { Links } from './links.js';
import { sentence, unwrap } from './reports.js';
import { rings, take } from './rings.js';

/** One connected component of a mesh. */
export interface Component {
  /** Its vertices and faces, in ascending order. */
  readonly vertices: Uint32Array;
  readonly faces: Uint32Array;
  readonly edgeCount: number;
  /** V - E + F. */
  readonly eulerCharacteristic: number;
  readonly boundaryLoopCount: number;
  /** Its handles: 0 for a sphere, a disk and an annulus, 1 for a torus, punctured or not. */
  readonly genus: number;
}

/**
 * What `validate` checks: level 4 adds the rules of polygon meshes, and 'geometry' adds where the vertices
 * lie.
 */
export type ValidationLevel = LinkLevel | 'geometry';
/** The levels of `validate` at which positions don't matter. Any kind of mesh has them. */
export type LinkLevel = 0 | 1 | 2 | 3 | 4;
/** A number that only the program knows, such as one that is counted: no literal, which the compiler can check. */
export type Computed<Level extends number> = number extends Level ? Level : never;
/** The number that 'geometry' has in C++. */
const GEOMETRY = 5;
/** What corners of triangles are named by, in C++. */
const AS_VERTICES = 0;

/** What is wrong with the mesh, up to a level. */
export function problemsOf(links: Links, level: unknown): Problem[] {
  const number = level === 'geometry' ? GEOMETRY : checkLevel(level, ", or 'geometry'");
  return findings(links.core.validate(links.address, number));
}

/** What a validation has found, in sentences. */
export function findings(raw: RawFinding[]): Problem[] {
  return raw.map(({ message, ...rest }) => ({ ...rest, message: sentence(message) }) as Problem);
}

/** `level`, if `validate` knows it. */
export function checkLevel(level: unknown, others = ''): number {
  if ([0, 1, 2, 3, 4].includes(level as number)) return level as number;
  refuse('level', level, `an integer from 0 to 4${others}`, 'number');
}

/** One halfedge of each boundary loop. */
export function boundaryLoopsOf(links: Links): Halfedge[] {
  const { core, address } = links;
  const [halfedges] = take(core, unwrap(core.boundaryLoops(address)).halfedges);
  return Array.from(halfedges) as Halfedge[];
}

/** The connected components, in the order of their smallest vertices. */
export function componentsOf(links: Links): Component[] {
  const { core, address } = links;
  const raw = unwrap(core.components(address));
  // Four words for each component: vertices, edges, faces, boundary loops.
  const list = { ...raw.list, count: 4 * raw.list.count };
  const [counts, ofVertex, ofFace] = take(core, list, raw.ofVertex, raw.ofFace);
  const vertices = group(ofVertex, counts, 0);
  const faces = group(ofFace, counts, 2);
  return vertices.map((own, i) => {
    const [, edgeCount, , boundaryLoopCount] = counts.subarray(4 * i);
    const eulerCharacteristic = own.length - edgeCount + faces[i].length;
    const genus = (2 - eulerCharacteristic - boundaryLoopCount) / 2;
    return {
      vertices: own,
      faces: faces[i],
      edgeCount,
      eulerCharacteristic,
      boundaryLoopCount,
      genus,
    };
  });
}

/** The items of each component, of which `counts` tells how many there are at `field` of 4. */
function group(componentOf: Uint32Array, counts: Uint32Array, field: number): Uint32Array[] {
  const groups = Array.from({ length: counts.length / 4 }, (_, i) =>
    newArray('a component', Uint32Array, counts[4 * i + field]),
  );
  const filled = newArray('the components', Uint32Array, groups.length);
  componentOf.forEach((component, item) => {
    if (component < groups.length) groups[component][filled[component]++] = item;
  });
  return groups;
}

/** The live faces as polygons. */
export function polygonsOf(links: Links): { sizes: Uint32Array; corners: Uint32Array } {
  const { offsets, items } = rings(links, 'faceVertices', 'ccw');
  const sizes = newArray('the sizes', Uint32Array, links.faceCount);
  let face = 0;
  for (let f = 0; f + 1 < offsets.length; f++) {
    const size = offsets[f + 1] - offsets[f];
    if (size > 0) sizes[face++] = size; // a deleted slot has no corners
  }
  return { sizes, corners: items };
}

/** The live faces cut into triangles: the vertices of their corners. */
export function trianglesOf(links: Links): { indices: Uint32Array; faces: Uint32Array } {
  const { core, address } = links;
  const raw = unwrap(core.toTriangles(address, AS_VERTICES, 0, 0));
  const [indices, faces] = take(core, raw.corners, raw.faces);
  return { indices, faces };
}
