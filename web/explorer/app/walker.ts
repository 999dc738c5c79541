import type { Direction, HalfedgeMesh } from 'halfedge';
import {
  type Circulator,
  CirculatorPlayer,
  type DialectId,
  dialectOf,
  type Item,
  type QueryGroup,
  queriesFor,
} from 'halfedge/teaching';
import { Signal, together } from './signal.js';

/** Steps a second, as they are offered. */
export const SPEEDS = [0.5, 1, 1.5, 2.5, 4, 8] as const;

/** The position of the one that a new page has. */
export const DEFAULT_SPEED = 2;

/** A circulator as the user chose it: one of the offered groups, one of its circulators. */
export interface Choice {
  readonly group: number;
  readonly circulator: Circulator;
}

/** The player as it stands; a new object after every step. */
export interface Play {
  readonly player: CirculatorPlayer;
  readonly position: number;
  readonly playing: boolean;
}

/** Offers the circulators around an item, and walks along the one that was chosen. Knows nothing of the DOM. */
export class Walker {
  readonly groups = new Signal<readonly QueryGroup[]>([]);
  readonly choice = new Signal<Choice | null>(null);
  readonly direction = new Signal<Direction>('ccw');
  /** Whose names the code and the links have. */
  readonly dialect = new Signal<DialectId>('halfedge');
  readonly play = new Signal<Play | null>(null);
  /** A position among `SPEEDS`. */
  readonly speed = new Signal<number>(DEFAULT_SPEED);

  #mesh: HalfedgeMesh | null = null;
  #item: Item | null = null;
  /** What was chosen last, by the kind of the item. */
  readonly #preferred = new Map<string, { group: number; name: string }>();
  #timer: ReturnType<typeof setTimeout> | undefined;

  /** Offers what goes around an item of a mesh, and rests at the beginning of what was chosen for its kind last. */
  offer(mesh: HalfedgeMesh, item: Item): void {
    this.#mesh = mesh;
    this.#item = item;
    const groups = queriesFor(mesh, item);
    const preferred = this.#preferred.get(item.kind);
    const wanted = preferred && groups[preferred.group] ? preferred : { group: 0, name: '' };
    const { circulators } = groups[wanted.group];
    const circulator = circulators.find(({ name }) => name === wanted.name) ?? circulators[0];
    this.groups.value = groups;
    this.choice.value = { group: wanted.group, circulator };
    this.#load();
  }

  /** Offers nothing. */
  clear(): void {
    this.#mesh = null;
    this.#item = null;
    this.groups.value = [];
    this.choice.value = null;
    this.play.value = null;
  }

  choose(choice: Choice): void {
    const item = this.#item;
    if (!item) return;
    this.#preferred.set(item.kind, { group: choice.group, name: choice.circulator.name });
    this.choice.value = choice;
    this.#load();
  }

  setDirection(direction: Direction): void {
    this.direction.value = direction;
    this.#load();
  }

  /** Shows and runs the same query in other names, as far as it has come. */
  setDialect(dialect: DialectId): void {
    const position = this.play.value?.position ?? 0;
    // Nobody hears of a walk that begins again.
    together(() => {
      this.dialect.value = dialect;
      this.#load();
      if (position > 0) this.seek(position);
    });
  }

  /** Plays to the end of the lap; from the beginning if it is there already. */
  start(): void {
    const player = this.play.value?.player;
    if (!player || player.count === 0) return;
    if (player.done) player.seek(0);
    this.#publish(true);
    this.#tick();
  }

  pause(): void {
    clearTimeout(this.#timer);
    if (this.play.value?.playing) this.#publish(false);
  }

  toggle(): void {
    if (this.play.value?.playing) this.pause();
    else this.start();
  }

  /** One step, forward (1) or back (-1). */
  step(by: 1 | -1): void {
    const player = this.play.value?.player;
    if (player) this.seek(player.position + by);
  }

  seek(position: number): void {
    this.pause();
    const player = this.play.value?.player;
    if (!player) return;
    player.seek(position);
    this.#publish(false);
  }

  #load(): void {
    clearTimeout(this.#timer);
    const choice = this.choice.value;
    const group = choice ? this.groups.value[choice.group] : undefined;
    if (!this.#mesh || !choice || !group) {
      this.play.value = null;
      return;
    }
    const query = {
      circulator: choice.circulator,
      index: group.index,
      direction: this.direction.value,
      ...(group.start === undefined ? {} : { start: group.start }),
    };
    const player = new CirculatorPlayer(this.#mesh, query, dialectOf(this.dialect.value));
    this.play.value = { player, position: 0, playing: false };
  }

  #publish(playing: boolean): void {
    const player = this.play.value?.player;
    if (player) this.play.value = { player, position: player.position, playing };
  }

  #tick(): void {
    clearTimeout(this.#timer);
    const player = this.play.value?.player;
    if (!player) return;
    player.forward();
    this.#publish(!player.done);
    if (player.done) return;
    this.#timer = setTimeout(() => this.#tick(), 1000 / SPEEDS[this.speed.value]);
  }
}
