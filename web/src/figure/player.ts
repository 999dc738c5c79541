import type { Edit } from '../teaching/motion.js';
import { isPlayable, type Story } from './story.js';

/** What a player tells its figure. */
export interface PlayerListener {
  /** A step was made; `edit` is the change of the mesh, where there was one. */
  moved(edit: Edit | null): void;
  /** It began to play, or stopped. */
  played(): void;
  /** Whether there is nothing left to go through: it has no story then. */
  isLost(): boolean;
}

/** Takes a story on by itself, step by step. */
export class Player {
  /** Steps a second. */
  speed = 1.5;
  readonly #listener: PlayerListener;
  #story: Story | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #playing = false;

  constructor(listener: PlayerListener) {
    this.#listener = listener;
  }

  get playing(): boolean {
    return this.#playing;
  }

  get story(): Story | null {
    return this.#story;
  }

  /** Leaves the story that there is as it stands. */
  set story(story: Story | null) {
    this.pause();
    this.#story = story;
  }

  /** Plays on; from the beginning, where the end is reached, or what is refused. */
  play(): void {
    const story = this.#story;
    if (!story || !isPlayable(story) || this.#playing || this.#listener.isLost()) return;
    if (story.refusal || story.position >= story.count) this.#go(0);
    this.#playing = true;
    this.#listener.played();
    this.#tick();
  }

  pause(): void {
    clearTimeout(this.#timer);
    if (!this.#playing) return;
    this.#playing = false;
    this.#listener.played();
  }

  toggle(): void {
    if (this.#playing) this.pause();
    else this.play();
  }

  /** Goes to a step, and rests there. */
  seek(position: number): void {
    this.pause();
    this.#go(position);
  }

  #go(position: number): void {
    const story = this.#story;
    if (!story || this.#listener.isLost()) return;
    const before = story.position;
    const edit = story.seek(position);
    if (story.position !== before || edit) this.#listener.moved(edit);
  }

  #tick(): void {
    const story = this.#story;
    if (!story) return;
    this.#go(story.position + 1);
    if (this.#story === null) return;
    if (story.refusal || story.position >= story.count) this.pause();
    else this.#timer = setTimeout(() => this.#tick(), 1000 / this.speed);
  }
}
