import type { HalfedgeMesh } from '../api.js';
import { type Deed, deedTitle, operandsOf, parseDeed, selectionAfter } from '../teaching/deeds.js';
import { type Item, isLive, itemName } from '../teaching/items.js';
import { type Edit, motionOf, reversed, stateBefore } from '../teaching/motion.js';
import {
  checkOperation,
  type Refusal,
  refusalOf,
  runOperation,
  witnessItems,
} from '../teaching/operation.js';
import type { CirculatorPlayer, Visit } from '../teaching/player.js';

/** What a figure tells step by step: a walk around an item, or operations on the mesh. */
export interface Story {
  readonly count: number;
  readonly position: number;
  /** What the last step did, in words; before the first, what there is to see. */
  readonly words: string;
  /** What a circulator has visited so far. */
  readonly visits: readonly Visit[];
  /** Why the next operation can't be done, once it was tried. */
  readonly refusal: Refusal | null;
  readonly witness: readonly Item[] | null;
  /** Goes to a step from 0 to `count`; returns the change of the mesh, where there was one. */
  seek(position: number): Edit | null;
  /** The item that the last step came to. */
  readonly current: Item | null;
}

/** One lap of a circulator. */
export class WalkStory implements Story {
  readonly player: CirculatorPlayer;
  readonly refusal = null;
  readonly witness = null;

  constructor(player: CirculatorPlayer) {
    this.player = player;
  }

  get count(): number {
    return this.player.count;
  }

  get position(): number {
    return this.player.position;
  }

  get words(): string {
    const { player } = this;
    if (player.position > 0) return player.words;
    if (player.count === 0) return 'There is nothing to visit here: the range is empty.';
    const { circulator, index } = player.query;
    const label = circulator.around === 'halfedge' ? 'halfedges of the loop' : circulator.label;
    const around = itemName({ kind: circulator.around, index });
    return `${player.count} ${label} ${circulator.around === 'halfedge' ? 'of' : 'around'} ${around}.`;
  }

  get visits(): readonly Visit[] {
    return this.player.visits;
  }

  get current(): Item | null {
    return this.player.current?.item ?? null;
  }

  seek(position: number): null {
    this.player.seek(position);
    return null;
  }
}

/** Operations, one after the other; ends with the first that is refused. */
export class DeedStory implements Story {
  readonly visits = [];
  readonly count: number;
  refusal: Refusal | null = null;
  witness: readonly Item[] | null = null;
  readonly #mesh: HalfedgeMesh;
  readonly #deeds: readonly Deed[];
  readonly #done: { readonly edit: Edit; readonly after: Item | null }[] = [];

  /** Takes the history of the mesh into use. Throws a sentence for what is no operation. */
  constructor(mesh: HalfedgeMesh, operation: string) {
    this.#mesh = mesh;
    this.#deeds = operation.split(/[,;]/).map((text) => parseDeed(text));
    const foreign = this.#deeds.find(({ operation: { opens } }) => opens);
    if (foreign) throw new Error(`${foreign.operation.stem} makes another mesh: a figure has one.`);
    this.count = this.#deeds.length;
    mesh.history.enabled = true;
  }

  get position(): number {
    return this.#done.length + (this.refusal ? 1 : 0);
  }

  /** What the first operation is done to, before it is; then what the last one made. */
  get current(): Item | null {
    if (this.#done.length === 0 || this.refusal)
      return this.#deeds[this.#done.length]?.first ?? null;
    return this.#done.at(-1)?.after ?? null;
  }

  get words(): string {
    const next = this.#deeds[this.#done.length];
    if (this.refusal) return `Refused: ${deedTitle(next)}. ${this.refusal.message}`;
    if (this.position > 0) return `Done: ${deedTitle(this.#deeds[this.position - 1])}.`;
    return `Before: ${deedTitle(next)}.`;
  }

  seek(position: number): Edit | null {
    const target = Math.max(0, Math.min(this.count, Math.round(position)));
    let edit: Edit | null = null;
    while (this.position < target && !this.refusal) edit = this.#forward() ?? edit;
    while (this.position > target) edit = this.#back() ?? edit;
    return edit;
  }

  #forward(): Edit | null {
    const mesh = this.#mesh;
    const deed = this.#deeds[this.#done.length];
    const operands = operandsOf(mesh, deed);
    const { operation, first } = deed;
    const refusal = checkOperation(operation, operands);
    if (refusal) {
      this.#refuse(refusal);
      return null;
    }
    const state = stateBefore(operation, operands);
    try {
      const result = runOperation(operation, operands);
      const edit = motionOf(operation, state, mesh);
      const after = selectionAfter(operation, result, mesh, [first, ...state.neighbours]);
      this.#done.push({ edit, after });
      return edit;
    } catch (error) {
      this.#refuse(refusalOf(error));
      return null;
    }
  }

  #back(): Edit | null {
    if (this.refusal) {
      this.refusal = this.witness = null;
      return null;
    }
    const step = this.#done.pop();
    if (!step || !this.#mesh.history.undo()) return null;
    return reversed(step.edit);
  }

  #refuse(refusal: Refusal): void {
    this.refusal = refusal;
    this.witness = witnessItems(refusal.witness).filter((it) => isLive(this.#mesh, it));
  }
}
