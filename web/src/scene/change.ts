/** An edge that is not the same in two states: its ends before and after, -1 where it is not there. */
export interface ChangedEdge {
  readonly edge: number;
  readonly before: readonly [number, number];
  readonly after: readonly [number, number];
}

/** A vertex as it was before: where, and whether it was there at all. */
export interface FormerVertex {
  readonly place: readonly [number, number, number];
  readonly isLive: boolean;
}

/** What looks different after an edit, and how it was. */
export interface SurfaceChange {
  /** The faces that have other corners, moved, came or went. */
  readonly faces: ReadonlySet<number>;
  /** Three vertices for each triangle that they were drawn as. */
  readonly before: readonly number[];
  /** The same of those that they are drawn as. */
  readonly after: readonly number[];
  /** The edges that appeared, vanished, or have other ends. */
  readonly edges: readonly ChangedEdge[];
  /** Those that moved, came or went. */
  readonly vertices: ReadonlyMap<number, FormerVertex>;
}

/** An edge with these ends before and after, negative where it is not there; null if it is as it was. */
export function changedEdge(
  edge: number,
  before: readonly [number, number],
  after: readonly [number, number],
): ChangedEdge | null {
  const [was, is] = [shown(before), shown(after)];
  return was[0] === is[0] && was[1] === is[1] ? null : { edge, before: was, after: is };
}

function shown(ends: readonly [number, number]): readonly [number, number] {
  return ends[0] < 0 || ends[1] < 0 ? NOWHERE : ends;
}

const NOWHERE = [-1, -1] as const;
