import { newArray } from '../arguments.js';
import { type Floats, parts, sumsOf, writeUnitVectors } from '../measures.js';
import type { DirectedLinks } from './links.js';
import * as walks from './walks.js';

// Constants of this module's own: see ../walks.ts.
const { after, before, faceOf } = walks;
const {
  LEAST,
  corner,
  lengthOf,
  measureCorner,
  noOrbit,
  spreadTriangle,
  writeDirection,
  writeTriangleVector,
  writeUnit,
} = parts;

// The measures of measures.ts over Directed Edges, to the last bit. They stand apart from those, as the circulators do:
// here the corners of a face lie side by side, and V8 compiles each of the two for the one kind of links that it meets.

/** x, y and z of a vector, and its length. */
const sum = new Float64Array(4);
/** Another one. */
const other = new Float64Array(4);

// ---- faces --------------------------------------------------------------------------------------

/** Writes the area vector of a face, and its length. */
function writeAreaVector({ toVertex, positions }: DirectedLinks, f: number, out: Float64Array) {
  writeTriangleVector(positions, toVertex[3 * f], toVertex[3 * f + 1], toVertex[3 * f + 2], out);
}

/** Writes the unit normal of a face; zeros where it has no area. */
export function writeFaceNormal(links: DirectedLinks, f: number, out: Floats, to: number): void {
  writeAreaVector(links, f, sum);
  writeUnit(sum, out, to);
}

export function faceArea(links: DirectedLinks, f: number): number {
  writeAreaVector(links, f, sum);
  return sum[3] / 2;
}

/** Writes the mean of the corners of a face. */
export function writeFaceCentroid(
  { toVertex, positions }: DirectedLinks,
  f: number,
  out: Floats,
  to: number,
): void {
  const o = 3 * toVertex[3 * f];
  const a = 3 * toVertex[3 * f + 1];
  const b = 3 * toVertex[3 * f + 2];
  for (let k = 0; k < 3; k++) {
    const x = positions[o + k];
    out[to + k] = x + (positions[a + k] - x + (positions[b + k] - x)) / 3;
  }
}

// ---- edges and corners --------------------------------------------------------------------------

// The edge `e` is its halfedge `e`, which has a face.

export function edgeLength(links: DirectedLinks, e: number): number {
  const { toVertex, positions } = links;
  const [a, b] = [3 * toVertex[before(links, e)], 3 * toVertex[e]];
  const x = positions[b] - positions[a];
  const y = positions[b + 1] - positions[a + 1];
  const z = positions[b + 2] - positions[a + 2];
  return lengthOf(x, y, z);
}

export function writeEdgeMidpoint(links: DirectedLinks, e: number, out: Floats, to: number): void {
  const { toVertex, positions } = links;
  const [a, b] = [3 * toVertex[before(links, e)], 3 * toVertex[e]];
  for (let k = 0; k < 3; k++) out[to + k] = (positions[a + k] + positions[b + k]) / 2;
}

/** The angle inside the face of `h` where `h` ends; 0 where it has no face. */
export function cornerAngle(links: DirectedLinks, h: number): number {
  const { toVertex, positions, sides } = links;
  if (!(h < sides)) return 0;
  measureCorner(positions, toVertex[h], toVertex[after(links, h)], toVertex[before(links, h)]);
  return Math.atan2(lengthOf(corner[0], corner[1], corner[2]), corner[3]);
}

/** By how much the surface bends at an edge. */
export function dihedralAngle(links: DirectedLinks, e: number): number {
  const { toVertex, positions } = links;
  const opposite = links.opposite[e];
  if (!(faceOf(links, opposite) >= 0)) return 0;
  writeVectorFrom(links, e, sum);
  writeVectorFrom(links, opposite, other);
  const [a, b] = [3 * toVertex[before(links, e)], 3 * toVertex[e]];
  const x = positions[b] - positions[a];
  const y = positions[b + 1] - positions[a + 1];
  const z = positions[b + 2] - positions[a + 2];
  const sine =
    x * (sum[1] * other[2] - sum[2] * other[1]) +
    y * (sum[2] * other[0] - sum[0] * other[2]) +
    z * (sum[0] * other[1] - sum[1] * other[0]);
  const cosine = sum[0] * other[0] + sum[1] * other[1] + sum[2] * other[2];
  return Math.atan2(sine + 0, cosine * lengthOf(x, y, z)); // a fold at pi, not at -pi
}

/** The area vector of the face of `h`, from the corner where `h` ends. */
function writeVectorFrom(links: DirectedLinks, h: number, out: Float64Array): void {
  const { toVertex, positions } = links;
  const [a, b] = [toVertex[after(links, h)], toVertex[before(links, h)]];
  writeTriangleVector(positions, toVertex[h], a, b, out);
}

/** Half the sum of the cotangents opposite to an edge. */
export function cotanWeight(links: DirectedLinks, e: number): number {
  return (cotangentBeside(links, e) + cotangentBeside(links, links.opposite[e])) / 2;
}

/** The cotangent of the angle opposite to `h` in its triangle; 0 where it has no face or no area. */
function cotangentBeside(links: DirectedLinks, h: number): number {
  if (!(faceOf(links, h) >= 0)) return 0;
  const { toVertex, positions } = links;
  measureCorner(positions, toVertex[after(links, h)], toVertex[before(links, h)], toVertex[h]);
  const sine = lengthOf(corner[0], corner[1], corner[2]);
  return sine > 0 ? corner[3] / sine : 0;
}

// ---- vertices -----------------------------------------------------------------------------------

/** The next halfedge that leaves a vertex, -1 after the last. */
const nextAround = (links: DirectedLinks, h: number, first: number, steps: number): number => {
  const next = after(links, links.opposite[h]);
  if (!(next >= 0 && steps <= links.halfedges)) throw noOrbit();
  return next === first ? -1 : next;
};

/** Writes the mean of the normals of the faces at a vertex, weighted by area; zeros where there is none. */
export function writeVertexNormal(links: DirectedLinks, v: number, out: Floats, to: number): void {
  total.fill(0);
  const first = links.vertexHalfedge[v];
  for (let [h, steps] = [first, 0]; h >= 0; h = nextAround(links, h, first, ++steps)) {
    const f = faceOf(links, h);
    if (f < 0) continue;
    writeAreaVector(links, f, sum);
    for (let k = 0; k < 4; k++) total[k] += sum[k];
  }
  writeDirection(total, 0, out, to);
}
const total = new Float64Array(4);

/** The share that a vertex has in the areas of its faces. */
export function vertexArea(links: DirectedLinks, v: number): number {
  const first = links.vertexHalfedge[v];
  let area = 0;
  for (let [h, steps] = [first, 0]; h >= 0; h = nextAround(links, h, first, ++steps)) {
    const f = faceOf(links, h);
    if (f >= 0) area += faceArea(links, f) / 3;
  }
  return area;
}

/** What the angles at a vertex lack to a full turn, less half a turn for each gap on the boundary. */
export function angleDefect(links: DirectedLinks, v: number): number {
  const { opposite, vertexHalfedge, sides } = links;
  const first = vertexHalfedge[v];
  let defect = 2 * Math.PI;
  for (let [h, steps] = [first, 0]; h >= 0; h = nextAround(links, h, first, ++steps)) {
    defect -= cornerAngle(links, opposite[h]) + (h < sides ? 0 : Math.PI);
  }
  return defect;
}

// ---- all items ----------------------------------------------------------------------------------

/** The normals of all faces. */
export function writeFaceNormals(links: DirectedLinks, out: Floats): void {
  const { toVertex, sides, positions } = links;
  for (let h = 0; h < sides; h += 3) {
    writeTriangleVector(positions, toVertex[h], toVertex[h + 1], toVertex[h + 2], sum);
    writeUnit(sum, out, h);
  }
}

/** The normals of all vertices: those of faces are spread over their corners, in one pass. */
export function writeVertexNormals(links: DirectedLinks, out: Floats): void {
  const { toVertex, sides, vertices, positions } = links;
  const sums = sumsOf(3 * vertices);
  let all = 0;
  for (let h = 0; h < sides; h += 3) {
    all += spreadTriangle(positions, sums, toVertex[h], toVertex[h + 1], toVertex[h + 2]);
  }
  writeUnitVectors(sums, 3 * vertices, LEAST * all, out, () => lengthsAround(links));
}

/** By vertex, the lengths of the area vectors of its faces together. */
function lengthsAround({ toVertex, sides, vertices, positions }: DirectedLinks): Float64Array {
  const lengths = newArray('the lengths of normals', Float64Array, vertices);
  for (let h = 0; h < sides; h += 3) {
    writeTriangleVector(positions, toVertex[h], toVertex[h + 1], toVertex[h + 2], sum);
    for (let k = 0; k < 3; k++) lengths[toVertex[h + k]] += sum[3];
  }
  return lengths;
}

/** The areas of all vertices. */
export function writeVertexAreas(links: DirectedLinks, out: Floats): void {
  const { toVertex, sides } = links;
  out.fill(0);
  for (let f = 0; 3 * f < sides; f++) {
    const share = faceArea(links, f) / 3;
    for (let h = 3 * f; h < 3 * f + 3; h++) out[toVertex[h]] += share;
  }
}

// ---- the whole mesh -----------------------------------------------------------------------------

/** The sum of the areas of the faces. */
export function totalArea(links: DirectedLinks): number {
  let area = 0;
  for (let f = 0; 3 * f < links.sides; f++) area += faceArea(links, f);
  return area;
}

/** The volume inside of a closed surface: what all faces enclose with a point near to them, with sign. */
export function enclosedVolume(links: DirectedLinks): number {
  const { toVertex, positions, sides } = links;
  const o = 3 * toVertex[0];
  const [ox, oy, oz] = [positions[o], positions[o + 1], positions[o + 2]];
  let volume = 0;
  for (let f = 0; 3 * f < sides; f++) {
    writeAreaVector(links, f, sum);
    writeFaceCentroid(links, f, other, 0);
    // The pyramid has half of the length of `sum` as its base.
    volume += (sum[0] * (other[0] - ox) + sum[1] * (other[1] - oy) + sum[2] * (other[2] - oz)) / 6;
  }
  return volume;
}
