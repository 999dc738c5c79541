import type { HalfedgeMesh } from 'halfedge';
import type { Query } from './circulators.js';
import type { Item } from './items.js';
import { hopWords, startWords } from './words.js';

/** One visit: the halfedge where the circulator stood, and the item it showed. */
export interface Visit {
  readonly halfedge: number;
  readonly item: Item;
}

/**
 * Steps an endless circulator of the mesh through one lap, forward and back, and remembers what
 * it visited. Position 0 is before the first visit; `count` is the length of the lap.
 */
export class CirculatorPlayer {
  readonly query: Query;
  readonly count: number;
  readonly #mesh: HalfedgeMesh;
  readonly #visits: Visit[] = [];
  readonly #circulator: ReturnType<HalfedgeMesh['circulate']>;

  constructor(mesh: HalfedgeMesh, query: Query) {
    this.#mesh = mesh;
    this.query = query;
    this.count = lapLength(mesh, query);
    this.#circulator = mesh.circulate(query.circulator.name, query.index, {
      direction: query.direction,
      ...(query.start === undefined ? {} : { start: query.start }),
    });
  }

  /** How many items are visited; the last of them is the current one. */
  get position(): number {
    return this.#visits.length;
  }

  /** The items visited so far, in order. */
  get visits(): readonly Visit[] {
    return this.#visits;
  }

  get current(): Visit | null {
    return this.#visits.at(-1) ?? null;
  }

  get done(): boolean {
    return this.position === this.count;
  }

  /** Visits one more item. False at the end of the lap. */
  forward(): boolean {
    if (this.done) return false;
    if (this.position > 0) this.#circulator.next();
    this.#visits.push(this.#look());
    return true;
  }

  /** Takes the last visit back. False at the beginning. */
  back(): boolean {
    if (this.position === 0) return false;
    if (this.position > 1) this.#circulator.prev();
    this.#visits.pop();
    return true;
  }

  /** Steps until `position` items are visited. */
  seek(position: number): void {
    const target = Math.max(0, Math.min(this.count, Math.round(position)));
    while (this.position < target) this.forward();
    while (this.position > target) this.back();
  }

  /** What the last step did, in words; empty before the first. */
  get words(): string {
    const last = this.current;
    if (!last) return '';
    const before = this.#visits.at(-2);
    return before
      ? hopWords(this.#mesh, this.query, before.halfedge, last.halfedge)
      : startWords(this.#mesh, this.query, last.halfedge);
  }

  #look(): Visit {
    const { yields } = this.query.circulator;
    return {
      halfedge: this.#circulator.halfedge,
      item: { kind: yields, index: this.#circulator.current },
    };
  }
}

function lapLength(mesh: HalfedgeMesh, { circulator, index, direction, start }: Query): number {
  const range = (
    mesh[circulator.name] as (i: number, d?: string, s?: number) => Iterable<number>
  ).call(mesh, index, direction, start);
  let length = 0;
  for (const _ of range) length += 1;
  return length;
}
