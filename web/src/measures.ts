import { newArray } from './arguments.js';
import { corrupt } from './links.js';

// Normals, areas, lengths and angles, from the links and positions of a mesh. All of it is computed in double
// precision and relative to a corner: far from the origin nothing is lost to rounding.

/** What is read of a mesh: views that are good until something allocates. */
export interface Surface {
  readonly next: Int32Array;
  readonly toVertex: Int32Array;
  readonly face: Int32Array;
  readonly vertexHalfedge: Int32Array;
  readonly faceHalfedge: Int32Array;
  readonly positions: Float32Array;
}

/** What results are written to. */
export type Floats = Float32Array | Float64Array;

/** x, y and z of a vector, and its length. */
const sum = new Float64Array(4);
/** Another one. */
const other = new Float64Array(4);

/** Of a sum of vectors that cancel each other to less than this share of their lengths, rounding alone is left. */
const LEAST = 1e-10;

/** Looked up once: in Jest, where global names are looked up slowly, that takes longer than a root. */
const { abs, sqrt } = Math;

// No Math.hypot, which takes ten times as long: squares of differences of floats don't overflow.
const lengthOf = (x: number, y: number, z: number) => sqrt(x * x + y * y + z * z);

/** The error for a walk that has left the links, or has taken more steps than there are halfedges. */
export const noOrbit = () => corrupt('The halfedges around an item form no closed orbit');

// ---- faces --------------------------------------------------------------------------------------

/**
 * Writes the area vector of the loop through `first`, and its length. Its direction is the normal of the face, its
 * length twice the area (Newell's method).
 */
export function writeAreaVector(surface: Surface, first: number, out: Float64Array): void {
  const { next, toVertex, positions } = surface;
  const second = next[first];
  if (next[next[second]] !== first) writePolygonVector(surface, first, out);
  else writeTriangleVector(positions, toVertex[first], toVertex[second], toVertex[first ^ 1], out);
}

/** Of any face. On its own, because V8 inlines nothing that is so long: triangles go past it. */
function writePolygonVector(surface: Surface, first: number, out: Float64Array): void {
  const { next, toVertex, positions } = surface;
  const o = 3 * toVertex[first];
  const [ox, oy, oz] = [positions[o], positions[o + 1], positions[o + 2]];
  let [ax, ay, az] = [0, 0, 0];
  let [x, y, z] = [0, 0, 0];
  let left = next.length;
  for (let h = next[first]; h !== first; h = next[h]) {
    if (!(h >= 0 && left-- > 0)) throw noOrbit();
    const b = 3 * toVertex[h];
    const [bx, by, bz] = [positions[b] - ox, positions[b + 1] - oy, positions[b + 2] - oz];
    x += ay * bz - az * by;
    y += az * bx - ax * bz;
    z += ax * by - ay * bx;
    [ax, ay, az] = [bx, by, bz];
  }
  writeVector(out, x, y, z);
}

/** Of the triangle of three vertices: the same to the last bit. */
function writeTriangleVector(
  positions: Float32Array,
  o: number,
  a: number,
  b: number,
  out: Float64Array,
): void {
  const ox = positions[3 * o];
  const oy = positions[3 * o + 1];
  const oz = positions[3 * o + 2];
  const ax = positions[3 * a] - ox;
  const ay = positions[3 * a + 1] - oy;
  const az = positions[3 * a + 2] - oz;
  const bx = positions[3 * b] - ox;
  const by = positions[3 * b + 1] - oy;
  const bz = positions[3 * b + 2] - oz;
  writeVector(out, ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx);
}

/** Writes x, y and z of a vector, and its length. */
const writeVector = (out: Float64Array, x: number, y: number, z: number) => {
  // Adding 0 makes 0 of -0.
  out[0] = x + 0;
  out[1] = y + 0;
  out[2] = z + 0;
  out[3] = lengthOf(x, y, z);
};

/** Writes the direction of a sum of vectors; zeros where they cancel each other. */
function writeDirection(total: Float64Array, at: number, out: Floats, to: number): void {
  const [x, y, z] = [total[at], total[at + 1], total[at + 2]];
  const length = lengthOf(x, y, z);
  const isGood = length > LEAST * total[at + 3]; // nor so if both are infinite, or NaN
  out[to] = isGood ? x / length : 0;
  out[to + 1] = isGood ? y / length : 0;
  out[to + 2] = isGood ? z / length : 0;
}

/** Writes the unit normal of a face; zeros where it has no area. */
export function writeFaceNormal(surface: Surface, f: number, out: Floats, to: number): void {
  writeAreaVector(surface, surface.faceHalfedge[f], sum);
  writeUnit(sum, out, to);
}

/** Writes the direction of a vector whose length is known; zeros where it is 0 or not finite. */
const writeUnit = (vector: Float64Array, out: Floats, to: number) => {
  const length = vector[3];
  const isGood = length > 0 && length < Infinity;
  out[to] = isGood ? vector[0] / length : 0;
  out[to + 1] = isGood ? vector[1] / length : 0;
  out[to + 2] = isGood ? vector[2] / length : 0;
};

export function faceArea(surface: Surface, f: number): number {
  writeAreaVector(surface, surface.faceHalfedge[f], sum);
  return sum[3] / 2;
}

/** Writes the mean of the corners of a face. */
export function writeFaceCentroid(surface: Surface, f: number, out: Floats, to: number): void {
  const { next, toVertex, positions, faceHalfedge } = surface;
  const first = faceHalfedge[f];
  const o = 3 * toVertex[first];
  const [ox, oy, oz] = [positions[o], positions[o + 1], positions[o + 2]];
  let [x, y, z] = [0, 0, 0];
  let degree = 1;
  for (let h = next[first]; h !== first; h = next[h]) {
    if (!(h >= 0 && degree++ < next.length)) throw noOrbit();
    const v = 3 * toVertex[h];
    x += positions[v] - ox;
    y += positions[v + 1] - oy;
    z += positions[v + 2] - oz;
  }
  out[to] = ox + x / degree;
  out[to + 1] = oy + y / degree;
  out[to + 2] = oz + z / degree;
}

/** How many corners the face of `first` has. */
export function degreeOf({ next }: Surface, first: number): number {
  let degree = 1;
  for (let h = next[first]; h !== first; h = next[h]) {
    if (!(h >= 0 && degree++ < next.length)) throw noOrbit();
  }
  return degree;
}

// ---- edges and corners --------------------------------------------------------------------------

export function edgeLength({ toVertex, positions }: Surface, e: number): number {
  const [a, b] = [3 * toVertex[2 * e + 1], 3 * toVertex[2 * e]];
  const x = positions[b] - positions[a];
  const y = positions[b + 1] - positions[a + 1];
  const z = positions[b + 2] - positions[a + 2];
  return lengthOf(x, y, z);
}

export function writeEdgeMidpoint(surface: Surface, e: number, out: Floats, to: number): void {
  const { toVertex, positions } = surface;
  const [a, b] = [3 * toVertex[2 * e + 1], 3 * toVertex[2 * e]];
  for (let k = 0; k < 3; k++) out[to + k] = (positions[a + k] + positions[b + k]) / 2;
}

/**
 * Puts what tells the angle between the sides to the left and right of a corner into `corner`: their cross product,
 * and the dot product. The corner lies at vertex `o`, its sides lead to `a` and `b`.
 */
function measureCorner(positions: Float32Array, o: number, a: number, b: number): void {
  const ox = positions[3 * o];
  const oy = positions[3 * o + 1];
  const oz = positions[3 * o + 2];
  const ax = positions[3 * a] - ox;
  const ay = positions[3 * a + 1] - oy;
  const az = positions[3 * a + 2] - oz;
  const bx = positions[3 * b] - ox;
  const by = positions[3 * b + 1] - oy;
  const bz = positions[3 * b + 2] - oz;
  corner[0] = ay * bz - az * by;
  corner[1] = az * bx - ax * bz;
  corner[2] = ax * by - ay * bx;
  corner[3] = ax * bx + ay * by + az * bz;
}
const corner = new Float64Array(4);

/** The angle inside the face of `h` where `h` ends; 0 where it has no face. */
export function cornerAngle(surface: Surface, h: number): number {
  const { next, toVertex, face, positions } = surface;
  if (!(face[h] >= 0)) return 0;
  const after = next[h];
  measureCorner(positions, toVertex[h], toVertex[after], toVertex[h ^ 1]);
  const { 0: x, 1: y, 2: z, 3: cosine } = corner;
  const angle = Math.atan2(lengthOf(x, y, z), cosine);
  if (next[next[after]] === h) return angle; // a triangle has no reflex corners
  writeAreaVector(surface, h, sum);
  return x * sum[0] + y * sum[1] + z * sum[2] < 0 ? 2 * Math.PI - angle : angle;
}

/** By how much the surface bends at an edge. */
export function dihedralAngle(surface: Surface, e: number): number {
  const { face, toVertex, positions } = surface;
  const h = 2 * e;
  if (!(face[h] >= 0 && face[h + 1] >= 0)) return 0;
  writeAreaVector(surface, h, sum);
  writeAreaVector(surface, h + 1, other);
  const [a, b] = [3 * toVertex[h + 1], 3 * toVertex[h]];
  const x = positions[b] - positions[a];
  const y = positions[b + 1] - positions[a + 1];
  const z = positions[b + 2] - positions[a + 2];
  const sine =
    x * (sum[1] * other[2] - sum[2] * other[1]) +
    y * (sum[2] * other[0] - sum[0] * other[2]) +
    z * (sum[0] * other[1] - sum[1] * other[0]);
  const cosine = sum[0] * other[0] + sum[1] * other[1] + sum[2] * other[2];
  // Of -0, too: faces that are folded onto each other are at pi, not at -pi.
  return Math.atan2(sine + 0, cosine * lengthOf(x, y, z));
}

/** A face beside an edge that is no triangle, -1 if there is none. */
export function nonTriangleBeside(surface: Surface, e: number): number {
  if (!isTriangle(surface, 2 * e)) return surface.face[2 * e];
  return isTriangle(surface, 2 * e + 1) ? -1 : surface.face[2 * e + 1];
}

/** Whether the face of `h` is a triangle, if it has one. */
const isTriangle = ({ next, face }: Surface, h: number) =>
  !(face[h] >= 0) || next[next[next[h]]] === h;

/** Half the sum of the cotangents opposite to an edge. */
export function cotanWeight(surface: Surface, e: number): number {
  return (cotangentBeside(surface, 2 * e) + cotangentBeside(surface, 2 * e + 1)) / 2;
}

/** The cotangent of the angle opposite to `h` in its triangle; 0 where it has no face or no area. */
function cotangentBeside({ next, toVertex, face, positions }: Surface, h: number): number {
  if (!(face[h] >= 0)) return 0;
  measureCorner(positions, toVertex[next[h]], toVertex[h ^ 1], toVertex[h]);
  const sine = lengthOf(corner[0], corner[1], corner[2]);
  return sine > 0 ? corner[3] / sine : 0;
}

// ---- vertices -----------------------------------------------------------------------------------

/** The next halfedge that leaves a vertex, -1 after the last. */
const nextAround = (surface: Surface, h: number, first: number, steps: number): number => {
  const after = surface.next[h ^ 1];
  if (!(after >= 0 && steps <= surface.next.length)) throw noOrbit();
  return after === first ? -1 : after;
};

/** Writes the mean of the normals of the faces at a vertex, weighted by area; zeros where there is none. */
export function writeVertexNormal(surface: Surface, v: number, out: Floats, to: number): void {
  const { vertexHalfedge, face, faceHalfedge } = surface;
  total.fill(0);
  const first = vertexHalfedge[v];
  for (let [h, steps] = [first, 0]; h >= 0; h = nextAround(surface, h, first, ++steps)) {
    if (!(face[h] >= 0)) continue;
    writeAreaVector(surface, faceHalfedge[face[h]], sum); // from where that of the face begins, bit for bit
    for (let k = 0; k < 4; k++) total[k] += sum[k];
  }
  writeDirection(total, 0, out, to);
}
const total = new Float64Array(4);

/** The share that a vertex has in the areas of its faces. */
export function vertexArea(surface: Surface, v: number): number {
  const { vertexHalfedge, face } = surface;
  const first = vertexHalfedge[v];
  let area = 0;
  for (let [h, steps] = [first, 0]; h >= 0; h = nextAround(surface, h, first, ++steps)) {
    if (face[h] >= 0) area += faceArea(surface, face[h]) / degreeOf(surface, h);
  }
  return area;
}

/** What the angles at a vertex lack to a full turn, less half a turn for each gap on the boundary. */
export function angleDefect(surface: Surface, v: number): number {
  const { vertexHalfedge, face } = surface;
  const first = vertexHalfedge[v];
  let defect = 2 * Math.PI;
  for (let [h, steps] = [first, 0]; h >= 0; h = nextAround(surface, h, first, ++steps)) {
    defect -= cornerAngle(surface, h ^ 1) + (face[h] >= 0 ? 0 : Math.PI);
  }
  return defect;
}

// ---- all items ----------------------------------------------------------------------------------

/** By face slot, the normals of all faces. */
export function writeFaceNormals(surface: Surface, slots: number, out: Floats): void {
  // Views are looked up once: V8 doesn't move that out of a loop that writes to arrays.
  const { next, toVertex, faceHalfedge, positions } = surface;
  for (let f = 0; f < slots; f++) {
    const h = faceHalfedge[f];
    const second = next[h];
    if (!(h >= 0)) sum.fill(0);
    else if (next[next[second]] !== h) writePolygonVector(surface, h, sum);
    else writeTriangleVector(positions, toVertex[h], toVertex[second], toVertex[h ^ 1], sum);
    writeUnit(sum, out, 3 * f);
  }
}

/** By vertex slot, the normals of all vertices: those of faces are spread over their corners, in one pass. */
export function writeVertexNormals(surface: Surface, slots: number, out: Floats): void {
  const { next, toVertex, faceHalfedge, positions } = surface;
  const sums = sumsOf(3 * slots);
  let all = 0;
  for (let f = 0; f < faceHalfedge.length; f++) {
    const h = faceHalfedge[f];
    if (!(h >= 0)) continue;
    const second = next[h];
    if (next[next[second]] !== h) {
      all += spreadPolygon(surface, h, sums);
      continue;
    }
    all += spreadTriangle(positions, sums, toVertex[h], toVertex[second], toVertex[h ^ 1]);
  }
  writeUnitVectors(sums, 3 * slots, LEAST * all, out, () => lengthsAround(surface, slots));
}

/**
 * Adds the area vector of a triangle, given by its vertices, to those at its corners. Returns the sum of its absolute
 * values. `writeTriangleVector` written out: by way of an array, it takes a fifth more.
 */
function spreadTriangle(
  positions: Float32Array,
  sums: Float64Array,
  first: number,
  second: number,
  third: number,
): number {
  const o = 3 * first;
  const a = 3 * second;
  const b = 3 * third;
  const ox = positions[o];
  const oy = positions[o + 1];
  const oz = positions[o + 2];
  const ax = positions[a] - ox;
  const ay = positions[a + 1] - oy;
  const az = positions[a + 2] - oz;
  const bx = positions[b] - ox;
  const by = positions[b + 1] - oy;
  const bz = positions[b + 2] - oz;
  const x = ay * bz - az * by;
  const y = az * bx - ax * bz;
  const z = ax * by - ay * bx;
  addTo(sums, o, x, y, z);
  addTo(sums, a, x, y, z);
  addTo(sums, b, x, y, z);
  return abs(x) + abs(y) + abs(z);
}

/** The same of any face, by one of its halfedges. */
function spreadPolygon(surface: Surface, first: number, sums: Float64Array): number {
  const { next, toVertex } = surface;
  writePolygonVector(surface, first, sum);
  const { 0: x, 1: y, 2: z } = sum;
  let h = first;
  do {
    addTo(sums, 3 * toVertex[h], x, y, z);
    h = next[h];
  } while (h !== first);
  return abs(x) + abs(y) + abs(z);
}

const addTo = (sums: Float64Array, at: number, x: number, y: number, z: number) => {
  sums[at] += x;
  sums[at + 1] += y;
  sums[at + 2] += z;
};

/**
 * At least so many zeros to add vectors up in. The array is kept for the next mesh as long as nothing else needs the
 * memory: for a quarter of a million vertices, new memory took longer than their normals.
 */
export function sumsOf(length: number): Float64Array {
  const kept = sums?.deref();
  if (kept !== undefined && kept.length >= length) return kept.fill(0, 0, length);
  const fresh = newArray('the sums of normals', Float64Array, length);
  sums = new WeakRef(fresh);
  return fresh;
}
let sums: WeakRef<Float64Array> | undefined;

/** By vertex slot, the lengths of the area vectors of its faces together. */
function lengthsAround(surface: Surface, slots: number): Float64Array {
  const { next, toVertex, faceHalfedge } = surface;
  const lengths = newArray('the lengths of normals', Float64Array, slots);
  for (let f = 0; f < faceHalfedge.length; f++) {
    const first = faceHalfedge[f];
    if (!(first >= 0)) continue;
    writeAreaVector(surface, first, sum);
    let h = first;
    do {
      lengths[toVertex[h]] += sum[3];
      h = next[h];
    } while (h !== first);
  }
  return lengths;
}

/**
 * Writes the directions of the first `length` / 3 sums around vertices. One that is longer than `least`, a share of all
 * faces together, is long beside its own faces; for the others, these are asked: `lengthsOf` adds up their lengths, by
 * vertex.
 */
export function writeUnitVectors(
  sums: Float64Array,
  length: number,
  least: number,
  out: Floats,
  lengthsOf: () => Float64Array,
): void {
  let lengths: Float64Array | undefined;
  for (let i = 0; i < length; i += 3) {
    const x = sums[i];
    const y = sums[i + 1];
    const z = sums[i + 2];
    const long = lengthOf(x, y, z);
    if (long > least) {
      out[i] = x / long;
      out[i + 1] = y / long;
      out[i + 2] = z / long;
    } else {
      lengths ??= lengthsOf();
      const isGood = long > LEAST * lengths[i / 3];
      out[i] = isGood ? x / long : 0;
      out[i + 1] = isGood ? y / long : 0;
      out[i + 2] = isGood ? z / long : 0;
    }
  }
}

/** By vertex slot, the areas of all vertices. */
export function writeVertexAreas(surface: Surface, out: Floats): void {
  const { next, toVertex, faceHalfedge } = surface;
  out.fill(0);
  for (let f = 0; f < faceHalfedge.length; f++) {
    const first = faceHalfedge[f];
    if (!(first >= 0)) continue;
    const share = faceArea(surface, f) / degreeOf(surface, first);
    let h = first;
    do {
      out[toVertex[h]] += share;
      h = next[h];
    } while (h !== first);
  }
}

// ---- the whole mesh -----------------------------------------------------------------------------

/** The sum of the areas of the faces. */
export function totalArea(surface: Surface): number {
  const { faceHalfedge } = surface;
  let area = 0;
  for (let f = 0; f < faceHalfedge.length; f++) {
    if (faceHalfedge[f] >= 0) area += faceArea(surface, f);
  }
  return area;
}

/** The volume inside of a closed surface: what all faces enclose with a point near to them, with sign. */
export function enclosedVolume(surface: Surface): number {
  const { faceHalfedge, toVertex, positions } = surface;
  const start = faceHalfedge.findIndex((h) => h >= 0);
  if (start < 0) return 0;
  const o = 3 * toVertex[faceHalfedge[start]];
  const [ox, oy, oz] = [positions[o], positions[o + 1], positions[o + 2]];
  let volume = 0;
  for (let f = start; f < faceHalfedge.length; f++) {
    if (!(faceHalfedge[f] >= 0)) continue;
    writeAreaVector(surface, faceHalfedge[f], sum);
    writeFaceCentroid(surface, f, other, 0);
    // The pyramid has half of the length of `sum` as its base.
    volume += (sum[0] * (other[0] - ox) + sum[1] * (other[1] - oy) + sum[2] * (other[2] - oz)) / 6;
  }
  return volume;
}

/** The box around the live vertices whose positions are finite; null if there are none. */
export function boxOf(
  { vertexHalfedge, positions }: Pick<Surface, 'vertexHalfedge' | 'positions'>,
  slots: number,
): Box | null {
  const min: XYZ = [Infinity, Infinity, Infinity];
  const max: XYZ = [-Infinity, -Infinity, -Infinity];
  for (let v = 0; v < slots; v++) {
    const at = 3 * v;
    if (!(vertexHalfedge[v] >= -1)) continue;
    if (!Number.isFinite(positions[at] + positions[at + 1] + positions[at + 2])) continue;
    for (let k = 0; k < 3; k++) {
      const x = positions[at + k];
      if (x < min[k]) min[k] = x;
      if (x > max[k]) max[k] = x;
    }
  }
  return min[0] <= max[0] ? { min, max } : null;
}

/** x, y and z. */
export type XYZ = [x: number, y: number, z: number];

/** A box along the axes. */
export interface Box {
  readonly min: XYZ;
  readonly max: XYZ;
}

/**
 * For the measures of Directed Edges. V8 checks at each use of a constant that is exported by itself whether it has a
 * value yet, which makes normals slower by a twentieth; the properties of this one become constants over there.
 * @internal
 */
export const parts = {
  LEAST,
  corner,
  lengthOf,
  measureCorner,
  noOrbit,
  spreadTriangle,
  writeDirection,
  writeTriangleVector,
  writeUnit,
};
