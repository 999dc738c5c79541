import type { WriteStream } from 'node:tty';

/** Shorter work shows nothing on a terminal. */
const DELAY = 500;
const INTERVAL = 100;

export type ProgressMode = 'automatic' | 'always' | 'never';

/**
 * Tells on standard error how far the work on a file is: on a terminal in one line that is cleared at
 * the end, and elsewhere, if asked for, in a line for each tenth.
 */
export class Progress {
  readonly #stream: WriteStream;
  readonly #isShown: boolean;
  readonly #start = performance.now();
  #file = '';
  #last = -Infinity;
  #lastLine = '';

  constructor(mode: ProgressMode, stream: WriteStream = process.stderr) {
    this.#stream = stream;
    this.#isShown = mode === 'always' || (mode === 'automatic' && stream.isTTY === true);
  }

  /** A file that is worked on from here on. */
  begin(file: string): void {
    this.#file = file;
    this.#lastLine = '';
  }

  /** `stage` is a word such as "reading"; `fraction` of it is done. */
  update(stage: string, fraction: number): void {
    if (!this.#isShown) return;
    const percent = Math.floor(100 * fraction);
    if (!this.#stream.isTTY) {
      this.#print(`${this.#file}: ${stage} ${percent - (percent % 10)} %\n`);
      return;
    }
    const now = performance.now();
    if (now - this.#start < DELAY || now - this.#last < INTERVAL) return;
    this.#last = now;
    const told = `: ${stage} ${percent} %`;
    this.#print(`\r\x1b[K${this.#fitted(told.length)}${told}`);
  }

  /** The end of the file's name, beside so many letters: a line that goes on in the next can't be cleared. */
  #fitted(letters: number): string {
    const room = Math.max(1, (this.#stream.columns || 80) - 1 - letters);
    return this.#file.length <= room
      ? this.#file
      : `…${this.#file.slice(this.#file.length + 1 - room)}`;
  }

  /** Removes the line, so that something else can be written. */
  clear(): void {
    if (this.#stream.isTTY && this.#lastLine !== '') this.#stream.write('\r\x1b[K');
    this.#lastLine = '';
  }

  #print(line: string): void {
    if (line === this.#lastLine) return;
    this.#lastLine = line;
    this.#stream.write(line);
  }
}
