import type { HalfedgeMesh, ItemKind } from '../api.js';
import { refuse } from '../checks.js';
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

  /** Throws a sentence for what is no trail, and for an item that the mesh does not have. */
  constructor(mesh: HalfedgeMesh, trail: Trail) {
    const { steps, missing = [] } = trail;
    if (!Array.isArray(steps))
      refuse('trail.steps', steps, 'an array of { item, halfedge, sentence }');
    if (!Array.isArray(missing)) refuse('trail.missing', missing, 'an array of names of items');
    this.#trail = trail;
    this.missing = missing.map((name, i) => itemOf(mesh, `trail.missing[${i}]`, name));
    this.#visits = steps.map((step, i) => {
      const found = itemOf(mesh, `trail.steps[${i}].item`, step?.item);
      const { halfedge } = step;
      const carrier =
        halfedge === undefined
          ? -1
          : itemOf(mesh, `trail.steps[${i}].halfedge`, halfedge, 'halfedge').index;
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

function itemOf(mesh: HalfedgeMesh, argument: string, name: unknown, kind?: ItemKind): Item {
  const found = typeof name === 'string' ? parseItemName(name) : null;
  if (found && isLive(mesh, found) && (kind === undefined || found.kind === kind)) return found;
  const [what, example] = kind === undefined ? ['an item', 'v3'] : [`a ${kind}`, 'h7'];
  refuse(argument, name, `${what} of this mesh, such as "${example}"`, 'string');
}
