import { type ChildProcess, spawn } from 'node:child_process';
import type { Readable } from 'node:stream';
import { which } from '../../scripts/lib/run.mjs';

/** Where a browser draws that needs a screen, though nobody looks: Xvfb, with WebGL in software. */
export class Display {
  readonly #process: ChildProcess;
  /** What a browser that is to draw there needs in its environment. */
  readonly environment: Record<string, string>;

  private constructor(process: ChildProcess, name: string) {
    this.#process = process;
    this.environment = { DISPLAY: name, LIBGL_ALWAYS_SOFTWARE: '1' };
  }

  /** Starts one at the first number that is free; undefined where there is no Xvfb. */
  static async start(): Promise<Display | undefined> {
    const xvfb = which('Xvfb');
    if (xvfb === undefined) return undefined;
    const args = ['-displayfd', '3', '-screen', '0', '1400x1000x24', '-nolisten', 'tcp'];
    const process = spawn(xvfb, args, { stdio: ['ignore', 'ignore', 'ignore', 'pipe'] });
    const name = await new Promise<string>((resolve, reject) => {
      process.on('error', reject);
      process.on('close', (status) => reject(new Error(`Xvfb ended (${status}).`)));
      (process.stdio[3] as Readable).once('data', (number) => resolve(`:${String(number).trim()}`));
    });
    return new Display(process, name);
  }

  stop(): void {
    this.#process.kill();
  }
}
