/** What of a mesh the picture was drawn from: enough to tell one state from the next. */
export interface Drawn {
  /** xyz by vertex. */
  readonly points: Float32Array;
  /** By halfedge: the vertex it points to; negative where it is deleted. */
  readonly toVertex: Int32Array;
  /** Three vertices of each triangle. */
  readonly triangles: Uint32Array;
  /** By triangle, in ascending order: the face that it is part of. */
  readonly faceOf: Uint32Array;
}

/** The triangles of faces that differ between two states, as positions in `triangles`. */
export interface ChangedTriangles {
  readonly before: number[];
  readonly after: number[];
  readonly faces: Set<number>;
}

/**
 * Compares the triangles of two states face by face. Null if more than `most` triangles differ:
 * then the change is too large to be shown piece by piece.
 */
export function changedTriangles(
  before: Drawn,
  after: Drawn,
  most: number,
): ChangedTriangles | null {
  const changed: ChangedTriangles = { before: [], after: [], faces: new Set() };
  let b = 0;
  let a = 0;
  while (b < before.faceOf.length || a < after.faceOf.length) {
    const face = Math.min(before.faceOf[b] ?? Infinity, after.faceOf[a] ?? Infinity);
    const [b0, a0] = [b, a];
    while (before.faceOf[b] === face) b += 1;
    while (after.faceOf[a] === face) a += 1;
    if (sameTriangles(before, b0, b, after, a0, a)) continue;
    for (let i = b0; i < b; i++) changed.before.push(i);
    for (let i = a0; i < a; i++) changed.after.push(i);
    changed.faces.add(face);
    if (changed.before.length + changed.after.length > most) return null;
  }
  return changed;
}

/** Whether the triangles from `p0` to `p1` and from `q0` to `q1` have the same corners in the same places. */
function sameTriangles(
  p: Drawn,
  p0: number,
  p1: number,
  q: Drawn,
  q0: number,
  q1: number,
): boolean {
  if (p1 - p0 !== q1 - q0) return false;
  for (let i = 0; i < 3 * (p1 - p0); i++) {
    const v = p.triangles[3 * p0 + i];
    if (v !== q.triangles[3 * q0 + i]) return false;
    for (let x = 3 * v; x < 3 * v + 3; x++) if (p.points[x] !== q.points[x]) return false;
  }
  return true;
}

/** An edge that is not the same in two states: its ends before and after, -1 where it is not there. */
export interface ChangedEdge {
  readonly edge: number;
  readonly before: readonly [number, number];
  readonly after: readonly [number, number];
}

/** The edges that appeared, vanished, or have other ends. */
export function changedEdges(before: Drawn, after: Drawn): ChangedEdge[] {
  const changed: ChangedEdge[] = [];
  const [p, q] = [before.toVertex, after.toVertex];
  const slots = Math.max(p.length, q.length);
  for (let h = 0; h < slots; h += 2) {
    const [a, b] = [p[h] ?? -1, p[h + 1] ?? -1];
    const [c, d] = [q[h] ?? -1, q[h + 1] ?? -1];
    if (a === c && b === d) continue;
    const ends = (x: number, y: number) =>
      x < 0 || y < 0 ? ([-1, -1] as const) : ([x, y] as const);
    const edge = { edge: h / 2, before: ends(a, b), after: ends(c, d) };
    if (edge.before[0] >= 0 || edge.after[0] >= 0) changed.push(edge);
  }
  return changed;
}
