import { NONE } from '../api.js';
import type { Edit } from '../teaching/motion.js';
import type { ChangedEdge } from './change.js';
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
 * Along which way everything goes from one surface to the next. To be asked for before `moveTo` is
 * called for the first time: that moves the vertices of the surface after the edit.
 */
export class Paths {
  readonly manner: Manner;
  readonly segments: readonly Path[];
  readonly #before: Surface;
  readonly #after: Surface;
  readonly #edit: Edit;
  /** The vertices of the surface after the edit that are not at rest. */
  readonly #moving: (readonly [vertex: number, path: Path])[] = [];

  constructor(before: Surface, after: Surface, edit: Edit, edges: readonly ChangedEdge[]) {
    this.#before = before;
    this.#after = after;
    this.#edit = edit;
    this.manner = edit.slides.size > 0 ? 'slide' : edit.grows.size > 0 ? 'grow' : 'fade';
    for (let v = 0; v < after.vertexHalfedge.length; v++) {
      if (isLive(after, v) && this.#moves(v)) this.#moving.push([v, this.newPath(v)]);
    }
    this.segments = edges
      .map((edge) => this.#segmentPath(edge))
      .filter((path): path is Path => path !== null);
  }

  /** Whether a vertex of the surface after the edit comes from another place. */
  #moves(v: number): boolean {
    if (!isLive(this.#before, v)) return this.#edit.grows.has(v);
    const [was, is] = [this.#before.points, this.#after.points];
    const [x, y, z] = [3 * v, 3 * v + 1, 3 * v + 2];
    return was[x] !== is[x] || was[y] !== is[y] || was[z] !== is[z];
  }

  /** Moves the vertices of the surface to where they are at `t` from 0 to 1. */
  moveTo(t: number): void {
    const { points } = this.#after;
    for (const [v, [from, to]] of this.#moving) {
      for (let k = 0; k < 3; k++)
        points[3 * v + k] = t === 1 ? to[k] : from[k] + t * (to[k] - from[k]);
    }
    if (this.#moving.length > 0) this.#after.movePoints(this.#moving.map(([v]) => v));
  }

  /** The path of a vertex as a corner of what was there before. */
  oldPath(v: number): Path {
    const from = at(this.#before, v);
    const target = this.#edit.slides.get(v);
    if (target !== undefined) return [from, at(this.#after, target)];
    return [from, isLive(this.#after, v) ? at(this.#after, v) : from];
  }

  /** The path of a vertex of the surface after the edit. */
  newPath(v: number): Path {
    const to = at(this.#after, v);
    if (isLive(this.#before, v)) return [at(this.#before, v), to];
    const origin = this.#edit.grows.get(v);
    return [origin === undefined ? to : at(this.#before, origin), to];
  }

  /** How the line of an edge moves; null where it is not drawn. */
  #segmentPath({ before, after }: ChangedEdge): Path | null {
    if (this.manner === 'slide')
      return before[0] < 0 ? null : join(before.map((v) => this.oldPath(v)));
    if (this.manner === 'grow')
      return after[0] < 0 ? null : join(after.map((v) => this.newPath(v)));
    const was = before.map((v) => at(this.#before, v));
    const is = after.map((v) => at(this.#after, v));
    if (before[0] < 0) {
      // A new edge comes out of its new end, or else runs from its start.
      const start = isLive(this.#before, after[0]) ? is[1] : is[0];
      return [[...start, ...start], is.flat()];
    }
    if (after[0] < 0) {
      const end = isLive(this.#after, before[0]) ? was[1] : was[0];
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

function at({ points }: Surface, v: number): number[] {
  return [points[3 * v], points[3 * v + 1], points[3 * v + 2]];
}

function isLive({ vertexHalfedge }: Surface, v: number): boolean {
  return v < vertexHalfedge.length && vertexHalfedge[v] >= NONE;
}
