import { ARROW_FLOATS, ArrowTracer, arrowSizes } from 'halfedge/three';
import {
  cross,
  edgesOf,
  inside,
  type Point,
  type Polygon,
  type Segment,
  side,
} from './polygons.js';

export interface FlatArrow {
  readonly shaft: Segment;
  readonly barb: Segment;
}

/** Where a polygon lies in space: two unit vectors at right angles that span its plane. */
export interface Plane {
  readonly x: readonly number[];
  readonly y: readonly number[];
}

const GROUND: Plane = { x: [1, 0, 0], y: [0, 1, 0] };

/** A plane that is turned anyhow. */
export function randomPlane(next: () => number): Plane {
  const [a, b, c] = [0, 0, 0].map(() => 2 * Math.PI * next());
  const [ca, sa, cb, sb, cc, sc] = [a, b, c].flatMap((t) => [Math.cos(t), Math.sin(t)]);
  return {
    x: [ca * cc - sa * cb * sc, sa * cc + ca * cb * sc, sb * sc],
    y: [-ca * sc - sa * cb * cc, -sa * sc + ca * cb * cc, sb * cc],
  };
}

const dot = (a: readonly number[], b: readonly number[]) => a.reduce((s, x, i) => s + x * b[i], 0);

/** The shaft and the barb of each arrow of a flat polygon, with one pixel `pixel` long. */
export function arrowsOf(polygon: Polygon, pixel: number, plane = GROUND): FlatArrow[] {
  const corners = polygon.flatMap(([u, v]) => plane.x.map((x, k) => u * x + v * plane.y[k]));
  const out = new Float32Array(polygon.length * ARROW_FLOATS);
  new ArrowTracer().traceFace(corners, polygon.length, arrowSizes(pixel), out, 0);
  return polygon.map((_, i) => {
    const at = (k: number): Point => {
      const point = [...out.subarray(i * ARROW_FLOATS + 3 * k, i * ARROW_FLOATS + 3 * k + 3)];
      return [dot(point, plane.x), dot(point, plane.y)];
    };
    return { shaft: [at(0), at(1)], barb: [at(1), at(2)] };
  });
}

/** Says what is wrong with the arrows of a polygon; an empty list if nothing is. */
export function faults(polygon: Polygon, pixel: number, plane?: Plane): string[] {
  const arrows = arrowsOf(polygon, pixel, plane);
  const found: string[] = [];
  const edges = edgesOf(polygon);
  arrows.forEach((arrow, i) => {
    const parts = [arrow.shaft, arrow.barb];
    for (const point of [...arrow.shaft, arrow.barb[1]]) {
      if (!inside(point, polygon)) found.push(`arrow ${i} leaves the face at ${point}`);
    }
    for (const part of parts) {
      if (edges.some((edge) => cross(part, edge))) found.push(`arrow ${i} crosses an edge`);
    }
    arrows.slice(i + 1).forEach(({ shaft, barb }, k) => {
      if (parts.some((mine) => cross(mine, shaft) || cross(mine, barb))) {
        found.push(`arrows ${i} and ${i + 1 + k} cross`);
      }
    });
    if (along(arrow.shaft, edges[i]) <= 0) found.push(`arrow ${i} does not run along its edge`);
    if (side(...arrow.shaft, arrow.barb[1]) <= 0) found.push(`arrow ${i} has its barb outwards`);
    if (along(arrow.barb, edges[i]) >= 0) found.push(`arrow ${i} has its barb before its tip`);
  });
  return found;
}

/** How far the first goes in the direction of the second, times the length of that. */
function along([a, b]: Segment, [c, d]: Segment): number {
  return (b[0] - a[0]) * (d[0] - c[0]) + (b[1] - a[1]) * (d[1] - c[1]);
}
