import { arrowSizes } from './arrows.js';
import type { DrawnMesh, HalfedgeGlyphs } from './glyphs.js';
import { ARROW_FLOATS } from './mitre.js';
import { distanceToLine, type Projection, type ScreenPoint } from './projection.js';

/** The corner, edge and arrow of a face that are nearest to a place on the canvas, in CSS pixels. */
export interface Nearest {
  readonly vertex: number;
  readonly vertexDistance: number;
  /** The halfedge at the nearest edge, and how long and how far that and its arrow are. */
  readonly halfedge: number;
  readonly edgeDistance: number;
  readonly edgeLength: number;
  readonly arrowDistance: number;
  /** The mean length of the edges, were they seen from the front. */
  readonly meanEdge: number;
}

/** What of a face is nearest. pre: there is such a face */
export function nearestOf(
  face: number,
  at: ScreenPoint,
  { mesh, points }: DrawnMesh,
  glyphs: HalfedgeGlyphs,
  projection: Projection,
): Nearest {
  const { next, toVertex, faceHalfedge } = mesh.connectivity;
  const first = next[faceHalfedge[face]];
  const { x, y, z, meanEdge } = measure(first, next, toVertex, points);
  const pixel = projection.pixelAt(x, y, z);
  glyphs.face(face, arrowSizes(pixel));
  const nearest = {
    vertex: toVertex[first],
    vertexDistance: Infinity,
    halfedge: first,
    edgeDistance: Infinity,
    edgeLength: 0,
    arrowDistance: Infinity,
    meanEdge: meanEdge / pixel,
  };
  let h = first;
  let place = 0;
  do {
    const [x, y] = projection.project(points, 3 * toVertex[h]);
    const vertexDistance = Math.hypot(x - at[0], y - at[1]);
    if (vertexDistance < nearest.vertexDistance) {
      nearest.vertexDistance = vertexDistance;
      nearest.vertex = toVertex[h];
    }
    const [from, to] = projection.projectLine(points, 3 * toVertex[h ^ 1], 3 * toVertex[h]);
    const edgeDistance = distanceToLine(at, from, to);
    if (edgeDistance < nearest.edgeDistance) {
      nearest.edgeDistance = edgeDistance;
      nearest.halfedge = h;
      nearest.edgeLength = Math.hypot(to[0] - from[0], to[1] - from[1]);
      nearest.arrowDistance = distanceToArrow(at, glyphs, place, projection);
    }
    place += ARROW_FLOATS;
    h = next[h];
  } while (h !== first);
  return nearest;
}

/** How far the shaft is of an arrow that was traced. */
export function distanceToArrow(
  at: ScreenPoint,
  { arrows }: HalfedgeGlyphs,
  place: number,
  projection: Projection,
): number {
  return distanceToLine(at, ...projection.projectLine(arrows, place, place + 3));
}

/** The centre of the corners of a loop, and the mean length of its edges. */
function measure(
  first: number,
  next: Int32Array,
  toVertex: Int32Array,
  points: ArrayLike<number>,
): { x: number; y: number; z: number; meanEdge: number } {
  let [x, y, z, perimeter, degree] = [0, 0, 0, 0, 0];
  let h = first;
  do {
    const [a, b] = [3 * toVertex[h ^ 1], 3 * toVertex[h]];
    x += points[b];
    y += points[b + 1];
    z += points[b + 2];
    perimeter += Math.hypot(
      points[b] - points[a],
      points[b + 1] - points[a + 1],
      points[b + 2] - points[a + 2],
    );
    degree += 1;
    h = next[h];
  } while (h !== first);
  return { x: x / degree, y: y / degree, z: z / degree, meanEdge: perimeter / degree };
}
