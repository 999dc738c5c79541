import type { HalfedgeMesh } from '../api.js';
import { type Item, isLive, itemName, parseItemName } from '../teaching/items.js';
import type { Visit } from '../teaching/player.js';
import type { Story } from './story.js';

/** A walk that a program tells, instead of a query: what was visited, step by step. */
export interface Trail {
  /** What there is to see before the first step. */
  readonly sentence?: string;
  readonly steps: readonly {
    /** `v3`, `h12`, … */
    readonly item: string;
    /** The halfedge that led there: `h7`. Left out, only the item is lit. */
    readonly halfedge?: string;
    /** What the step did. */
    readonly sentence?: string;
  }[];
  /** Items that the walk should have come to: they are lit throughout. */
  readonly missing?: readonly string[];
}

/** Steps through a trail. */
export class TrailStory implements Story {
  readonly refusal = null;
  readonly witness = null;
  /** What is lit throughout, as missing. */
  readonly missing: readonly Item[];
  readonly #trail: Trail;
  readonly #visits: readonly Visit[];
  #position = 0;

  /** Throws a sentence for an item that the mesh does not have. */
  constructor(mesh: HalfedgeMesh, trail: Trail) {
    this.#trail = trail;
    this.missing = (trail.missing ?? []).map((name) => itemOf(mesh, name));
    this.#visits = trail.steps.map(({ item, halfedge }) => {
      const found = itemOf(mesh, item);
      const carrier = halfedge === undefined ? -1 : itemOf(mesh, halfedge).index;
      return { item: found, halfedge: carrier, cursor: carrier, ran: [] };
    });
  }

  get count(): number {
    return this.#visits.length;
  }

  get position(): number {
    return this.#position;
  }

  get words(): string {
    const { sentence = '', steps } = this.#trail;
    if (this.#position === 0) return sentence;
    const step = steps[this.#position - 1];
    return step.sentence ?? `${this.#position} of ${this.count}: ${itemName(this.current)}`;
  }

  get visits(): readonly Visit[] {
    return this.#visits.slice(0, this.#position);
  }

  get current(): Item | null {
    return this.#visits[this.#position - 1]?.item ?? null;
  }

  seek(position: number): null {
    this.#position = Math.max(0, Math.min(this.count, Math.round(position)));
    return null;
  }
}

function itemOf(mesh: HalfedgeMesh, name: string): Item {
  const found = parseItemName(name);
  if (found && isLive(mesh, found)) return found;
  throw new Error(`The trail has “${name}”; expected an item of this mesh, such as v3.`);
}
