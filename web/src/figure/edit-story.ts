import type { HalfedgeMesh } from '../api.js';
import { type Item, isLive } from '../teaching/items.js';
import { type Edit, renumbering, reversed } from '../teaching/motion.js';
import { type Refusal, refusalOf, witnessItems } from '../teaching/operation.js';
import type { Story } from './story.js';

/** A step that was made: how the mesh changed, what is selected after it, and what to say of it. */
export interface Done {
  readonly edit: Edit;
  readonly after: Item | null;
  readonly words: string;
}

/** A step that was made, and how many steps the history of the mesh had before and after it. */
interface Kept {
  readonly done: Done;
  before: number;
  after: number;
}

/** Changes of the mesh, one after the other; ends with the first that is refused. */
export abstract class EditStory implements Story {
  readonly visits = [];
  abstract readonly count: number;
  refusal: Refusal | null = null;
  readonly #mesh: HalfedgeMesh;
  readonly #done: Kept[] = [];

  /** Takes the history of the mesh into use. */
  constructor(mesh: HalfedgeMesh) {
    this.#mesh = mesh;
    mesh.history.enabled = true;
  }

  /** Makes a step, or says why it can't be made. May throw what the package throws. */
  protected abstract attempt(step: number): Done | Refusal;
  /** What a step does, in a few words. */
  protected abstract title(step: number): string;
  /** What a step is done to. */
  protected abstract item(step: number): Item | null;

  get position(): number {
    return this.#done.length + (this.refusal ? 1 : 0);
  }

  get current(): Item | null {
    const last = this.#done.at(-1);
    const item = last && !this.refusal ? last.done.after : this.item(this.#done.length);
    // A step may name what was never there, or what an earlier one has deleted.
    return item && isLive(this.#mesh, item) ? item : null;
  }

  get words(): string {
    const next = this.#done.length;
    if (this.refusal) return `Refused: ${this.title(next)}. ${this.refusal.message}`;
    return this.#done.at(-1)?.done.words ?? `Before: ${this.title(next)}.`;
  }

  get witness(): readonly Item[] | null {
    if (!this.refusal) return null;
    return witnessItems(this.refusal.witness).filter((it) => isLive(this.#mesh, it));
  }

  seek(position: number): Edit | null {
    const target = Math.max(0, Math.min(this.count, Math.round(position)));
    const edits: Edit[] = [];
    const add = (edit: Edit | null) => void (edit && edits.push(edit));
    while (this.position < target && !this.refusal) add(this.#forward());
    while (this.position > target) add(this.#back());
    return edits.some(({ renumbers }) => renumbers) ? renumbering : (edits.at(-1) ?? null);
  }

  #forward(): Edit | null {
    const { history, version } = this.#mesh;
    const before = history.undoCount;
    try {
      const outcome = this.attempt(this.#done.length);
      if ('edit' in outcome) {
        const after = history.undoCount;
        this.#done.push({ done: outcome, before, after });
        if (this.#mesh.version !== version && after <= before) this.#forget(before + 1 - after);
        return outcome.edit;
      }
      this.refusal = outcome;
    } catch (error) {
      this.refusal = refusalOf(error);
    }
    return null;
  }

  #back(): Edit | null {
    if (this.refusal) {
      this.refusal = null;
      return null;
    }
    const step = this.#done.pop();
    if (step === undefined) return null;
    const { history } = this.#mesh;
    const { undoCount } = history;
    // None where there was nothing to do, or a program has taken it back; more where one has edited the mesh since.
    while (history.undoCount > step.before && history.undo());
    if (history.undoCount === undoCount) return null;
    return undoCount === step.after ? reversed(step.done.edit) : renumbering;
  }

  /** The history has forgotten so many of its oldest steps. */
  #forget(steps: number): void {
    for (const [i, step] of this.#done.entries()) {
      step.before -= steps;
      if (i < this.#done.length - 1) step.after -= steps;
    }
  }
}
