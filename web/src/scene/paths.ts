import type { Edit } from '../teaching/motion.js';
import type { ChangedEdge, SurfaceChange } from './change.js';
import type { Surface } from './surface.js';

/**
 * How a change is shown. What slides together is shown as it was until it coincides with what it
 * becomes; what grows apart, as it becomes, from where it coincides with what it was; anything else
 * fades from one to the other, while edges grow, shrink and turn.
 */
export type Manner = 'slide' | 'grow' | 'fade';

/** From where to where something goes: xyz twice, or for a segment the six numbers of both ends. */
export type Path = readonly [from: readonly number[], to: readonly number[]];

/**
 * Along which way everything goes from how a surface was to how it is. To be asked for before `moveTo` is
 * called for the first time: that moves the vertices of the surface.
 */
export class Paths {
  readonly manner: Manner;
  readonly segments: readonly Path[];
  readonly #surface: Surface;
  readonly #change: SurfaceChange;
  readonly #edit: Edit;
  /** The vertices of the surface that are not at rest. */
  readonly #moving: (readonly [vertex: number, path: Path])[] = [];

  constructor(surface: Surface, change: SurfaceChange, edit: Edit) {
    this.#surface = surface;
    this.#change = change;
    this.#edit = edit;
    this.manner = edit.slides.size > 0 ? 'slide' : edit.grows.size > 0 ? 'grow' : 'fade';
    for (const v of change.vertices.keys()) {
      const moves = this.#wasLive(v) || edit.grows.has(v);
      if (moves && surface.isLive(v)) this.#moving.push([v, this.newPath(v)]);
    }
    this.segments = change.edges
      .map((edge) => this.#segmentPath(edge))
      .filter((path): path is Path => path !== null);
  }

  /** Whether a vertex was there before. */
  #wasLive(v: number): boolean {
    return this.#change.vertices.get(v)?.isLive ?? this.#surface.isLive(v);
  }

  /** Where a vertex was before. */
  #was(v: number): readonly number[] {
    return this.#change.vertices.get(v)?.place ?? this.#is(v);
  }

  /** Where a vertex is. */
  #is(v: number): readonly number[] {
    const { points } = this.#surface;
    return [points[3 * v], points[3 * v + 1], points[3 * v + 2]];
  }

  /** Moves the vertices of the surface to where they are at `t` from 0 to 1. */
  moveTo(t: number): void {
    const { points } = this.#surface;
    for (const [v, [from, to]] of this.#moving) {
      for (let k = 0; k < 3; k++)
        points[3 * v + k] = t === 1 ? to[k] : from[k] + t * (to[k] - from[k]);
    }
    if (this.#moving.length > 0) this.#surface.movePoints(this.#moving.map(([v]) => v));
  }

  /** The path of a vertex as a corner of what was there before. */
  oldPath(v: number): Path {
    const from = this.#was(v);
    const target = this.#edit.slides.get(v);
    if (target !== undefined) return [from, this.#is(target)];
    return [from, this.#surface.isLive(v) ? this.#is(v) : from];
  }

  /** The path of a vertex as a corner of what there is now. */
  newPath(v: number): Path {
    const to = this.#is(v);
    if (this.#wasLive(v)) return [this.#was(v), to];
    const origin = this.#edit.grows.get(v);
    return [origin === undefined ? to : this.#was(origin), to];
  }

  /** How the line of an edge moves; null where it is not drawn. */
  #segmentPath({ before, after }: ChangedEdge): Path | null {
    if (this.manner === 'slide')
      return before[0] < 0 ? null : join(before.map((v) => this.oldPath(v)));
    if (this.manner === 'grow')
      return after[0] < 0 ? null : join(after.map((v) => this.newPath(v)));
    const was = before.map((v) => this.#was(v));
    const is = after.map((v) => this.#is(v));
    if (before[0] < 0) {
      // A new edge comes out of its new end, or else runs from its start.
      const start = this.#wasLive(after[0]) ? is[1] : is[0];
      return [[...start, ...start], is.flat()];
    }
    if (after[0] < 0) {
      const end = this.#surface.isLive(before[0]) ? was[1] : was[0];
      return [was.flat(), [...end, ...end]];
    }
    return [was.flat(), is.flat()];
  }
}

function join([a, b]: readonly Path[]): Path {
  return [
    [...a[0], ...b[0]],
    [...a[1], ...b[1]],
  ];
}
