import type { HalfedgeMesh } from '../api.js';
import { type Deed, deedTitle, operandsOf, parseDeed, selectionAfter } from '../teaching/deeds.js';
import { type Item, isLive } from '../teaching/items.js';
import { motionOf, renumbering, stateBefore } from '../teaching/motion.js';
import { checkOperation, type Refusal, runOperation } from '../teaching/operation.js';
import { type Done, EditStory } from './edit-story.js';
import { lack } from './words.js';

/** Operations, as an attribute names them: `flip e3, collapse h5`. */
export class DeedStory extends EditStory {
  readonly count: number;
  readonly #mesh: HalfedgeMesh;
  readonly #deeds: readonly Deed[];

  /** Throws a sentence for what is no operation. */
  constructor(mesh: HalfedgeMesh, operation: string) {
    super(mesh);
    this.#mesh = mesh;
    this.#deeds = operation.split(/[,;]/).map((text) => parseDeed(text));
    const foreign = this.#deeds.find((deed) => deed.operation.opens);
    if (foreign) throw new Error(`${foreign.operation.stem} makes another mesh: a figure has one.`);
    // Those of later ones may be made by those before.
    const [{ first, second }] = this.#deeds;
    for (const item of [first, second]) {
      if (item && !isLive(mesh, item))
        throw new Error(`operation is “${operation}”: ${lack(mesh, item)}.`);
    }
    this.count = this.#deeds.length;
  }

  protected override title(step: number): string {
    return deedTitle(this.#deeds[step]);
  }

  protected override item(step: number): Item | null {
    return this.#deeds[step]?.first ?? null;
  }

  protected override attempt(step: number): Done | Refusal {
    const mesh = this.#mesh;
    const deed = this.#deeds[step];
    const operands = operandsOf(mesh, deed);
    const { operation, first } = deed;
    const refusal = checkOperation(operation, operands);
    if (refusal) return refusal;
    const state = stateBefore(operation, operands);
    const result = runOperation(operation, operands);
    return {
      edit: operation.renumbers ? renumbering : motionOf(operation, state, mesh),
      after: selectionAfter(operation, result, mesh, [first, ...state.neighbours]),
      words: `Done: ${deedTitle(deed)}.`,
    };
  }
}
