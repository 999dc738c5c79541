import { checkCallback, refuse } from './checks.js';
import type { RawFailure } from './core.mjs';
import { HalfedgeError } from './errors.js';
import type { OptionNames } from './options.js';

declare global {
  // As of the browser. A consumer in Node may do without its types, but not without names.
  interface AbortSignal {}
}

/**
 * What is being done: reading the file; mending its faces, if that is necessary; building the mesh.
 * A build that finds that faces have to be mended begins again after that.
 */
export type ParseStage = 'read' | 'repair' | 'build';

/** In the order of the enum Stage in C++. */
const STAGES: readonly ParseStage[] = ['read', 'repair', 'build'];

/** Following a long piece of work, and ending it. */
export interface ProgressOptions {
  /**
   * Is told how much of a stage is done, from 0 to 1: of reading about every MiB. `false` cancels with
   * a HalfedgeError `cancelled`; what it throws is thrown.
   */
  onProgress?: ((fraction: number, stage: ParseStage) => unknown) | undefined;
  /** Cancels: `signal.reason` is thrown. In the same thread that can only happen in `onProgress`. */
  signal?: AbortSignal | undefined;
}

export const PROGRESS_OPTIONS: OptionNames<ProgressOptions> = { onProgress: true, signal: true };

/** The other side of `onProgress`. */
export interface Follower {
  /** What the core calls: null if nobody wants to know. */
  readonly report: ((stage: number, fraction: number) => boolean) | null;
  /** Throws why the core was cancelled, if that is why it failed. */
  check(raw: object | RawFailure): void;
}

/** Checks the options, and that nothing is cancelled yet. */
export function follow({ onProgress, signal }: ProgressOptions): Follower {
  checkCallback('options.onProgress', onProgress);
  checkSignal(signal);
  signal?.throwIfAborted();
  if (onProgress === undefined && signal === undefined) return NOBODY;
  let why: { readonly reason: unknown } | undefined;
  return {
    report(stage, fraction) {
      try {
        const goesOn = onProgress?.(fraction, STAGES[stage]) !== false;
        signal?.throwIfAborted();
        if (!goesOn) why = { reason: cancelled() };
      } catch (reason) {
        why = { reason }; // nothing may be thrown through the core, which would leak
      }
      return why === undefined;
    },
    check(raw) {
      if (why !== undefined && 'problems' in raw) throw why.reason;
    },
  };
}

const NOBODY: Follower = { report: null, check() {} };

/** The error of what `onProgress` has ended. */
export const cancelled = () =>
  new HalfedgeError('cancelled', 'Reading was cancelled, as onProgress returned false.');

/** Throws a sentence unless it is an AbortSignal, or nothing. */
export function checkSignal(signal: AbortSignal | undefined): void {
  if (signal === undefined || typeof signal?.throwIfAborted === 'function') return;
  refuse('options.signal', signal, 'an AbortSignal');
}
