/** What is drawn, frame by frame. */
export interface Frames {
  /** Asked before each frame: where it says so, none is drawn any more. */
  isOver(): boolean;
  /** Draws one frame. Whether another one has to follow. */
  draw(now: number): boolean;
}

/**
 * Draws a frame when one was asked for, and more as long as they have to follow; nothing runs while nothing
 * changes. Asleep, it remembers that frames were asked for, and draws one when it wakes.
 */
export class FrameLoop {
  readonly #frames: Frames;
  readonly #woken: (() => void)[] = [];
  readonly #rested: (() => void)[] = [];
  readonly #awaiting: (() => void)[] = [];
  /** What the browser calls it; 0 while none is asked for. */
  #frame = 0;
  #asleep = false;
  #missed = false;

  constructor(frames: Frames) {
    this.#frames = frames;
  }

  set asleep(asleep: boolean) {
    this.#asleep = asleep;
    if (asleep || !this.#missed) return;
    this.#missed = false;
    this.request();
  }

  /** Calls `begins` when a frame is asked for after a rest, and `rests` after the last one. */
  onChange(begins: () => void, rests: () => void): void {
    this.#woken.push(begins);
    this.#rested.push(rests);
  }

  /** Fulfilled when the next frame has been drawn, and the browser asks for another one. */
  drawn(): Promise<void> {
    return new Promise((resolve) => this.#awaiting.push(resolve));
  }

  /** Asks for one more frame. */
  request(): void {
    if (this.#asleep) {
      this.#missed = true;
      return;
    }
    if (this.#frame !== 0) return;
    this.#frame = requestAnimationFrame((now) => this.#draw(now));
    for (const listener of this.#woken) listener();
  }

  /** Draws at once instead of with the next frame, unless it is asleep. */
  redraw(): void {
    this.#giveUp();
    if (this.#asleep) this.#missed = true;
    else this.#draw(performance.now());
  }

  /** Draws at once, also asleep. */
  drawNow(): void {
    this.#giveUp();
    this.#missed = false;
    this.#draw(performance.now());
  }

  /** Draws no more. */
  stop(): void {
    this.#asleep = true;
    this.#giveUp();
  }

  #giveUp(): void {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
  }

  #draw(now: number): void {
    this.#frame = 0;
    if (this.#frames.isOver()) return;
    const goesOn = this.#frames.draw(now);
    for (const resolve of this.#awaiting.splice(0)) requestAnimationFrame(() => resolve());
    if (goesOn) this.request();
    else for (const listener of this.#rested) listener();
  }
}
