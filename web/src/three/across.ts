/** Of polygons with more corners, it is not looked for: their arrows lie in one plane. */
const MOST_CORNERS = 64;
const NONE: readonly number[] = [];
/** Of a quad: where it is cut from its first corner, and where it is from the second. */
const FROM_FIRST: readonly number[] = [2, 0, 0, 2];
const FROM_SECOND: readonly number[] = [3, 3, 1, 1];

/**
 * By edge of a polygon: the corner across it in the triangle that is drawn there; -1 where none is. The first `degree`
 * of `corners` are vertices, `triangles` three vertices each. Empty where no triangles are, or very many corners.
 */
export function cornersAcross(
  corners: ArrayLike<number>,
  degree: number,
  triangles: ArrayLike<number>,
): readonly number[] {
  if (triangles.length === 0 || degree > MOST_CORNERS) return NONE;
  if (degree > 4) {
    return Array.from({ length: degree }, (_, i) => acrossEdge(corners, degree, triangles, i));
  }
  const has = (vertex: number) =>
    triangles[0] === vertex || triangles[1] === vertex || triangles[2] === vertex;
  return has(corners[1]) && has(corners[3]) ? FROM_SECOND : FROM_FIRST;
}

function acrossEdge(
  corners: ArrayLike<number>,
  degree: number,
  triangles: ArrayLike<number>,
  edge: number,
): number {
  const [from, to] = [corners[edge], corners[(edge + 1) % degree]];
  for (let t = 0; t < triangles.length; t += 3) {
    for (let k = 0; k < 3; k++) {
      if (triangles[t + k] !== from || triangles[t + ((k + 1) % 3)] !== to) continue;
      const apex = triangles[t + ((k + 2) % 3)];
      for (let corner = 0; corner < degree; corner++) if (corners[corner] === apex) return corner;
    }
  }
  return -1;
}
