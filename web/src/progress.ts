import { checkCallback, refuse } from './checks.js';
import type { RawFailure } from './core.js';
import { HalfedgeError } from './errors.js';
import type { OptionNames } from './options.js';

declare global {
  // As of the browser. A consumer in Node may do without its types, but not without names.
  interface AbortSignal {}
}

/**
 * What is being done: reading the file; repairing its faces, if necessary; building the mesh. If a build
 * finds that faces have to be repaired, it begins again after the repair.
 */
export type ParseStage = 'read' | 'repair' | 'build';

/** In the order of the enum Stage in C++. */
const STAGES: readonly ParseStage[] = ['read', 'repair', 'build'];

/** How to follow a long job, and how to cancel it. */
export interface ProgressOptions {
  /**
   * Called with how much of a stage is done, from 0 to 1; while reading, about once per MiB. Return `false`
   * to cancel with a HalfedgeError `cancelled`. Anything that it throws is passed on.
   */
  onProgress?: ((fraction: number, stage: ParseStage) => unknown) | undefined;
  /**
   * Cancels the job: `signal.reason` is thrown. In the same thread, it can only be aborted from within
   * `onProgress`.
   */
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
