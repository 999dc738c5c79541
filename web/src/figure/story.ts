import { type Item, itemName } from '../teaching/items.js';
import type { Edit } from '../teaching/motion.js';
import type { Refusal } from '../teaching/operation.js';
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
  /** What a walk should have come to, where it is known: lit throughout. */
  readonly missing?: readonly Item[];
  /** Goes to a step from 0 to `count`; returns the change of the mesh, where there was one. */
  seek(position: number): Edit | null;
  /** The item that the last step came to. */
  readonly current: Item | null;
}

/** Whether there is anything to play: not where the first step is refused. */
export function isPlayable({ count, position, refusal }: Story): boolean {
  return count > 0 && (refusal === null || position > 1);
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
