// What a page and the worker of an exercise tell each other.

import type { Terms } from './judge/attempt.js';
import type { Fault, Outcome } from './judge/outcome.js';

/** To the worker: a program, and the meshes on which it is to be called. */
export interface Job {
  /** The core, compiled. */
  readonly module: WebAssembly.Module;
  readonly code: string;
  readonly call: string;
  readonly terms: Terms;
  readonly trials: readonly {
    /** As `HalfedgeMesh.toBytes` writes them. */
    readonly bytes: Uint8Array;
    readonly calls: readonly (readonly (number | string)[])[];
  }[];
}

/** From the worker, in this order: it is at work; then why there is no program, or one outcome after the other. */
export type Reply =
  | { readonly kind: 'ready' }
  | { readonly kind: 'fault'; readonly fault: Fault }
  | {
      readonly kind: 'outcome';
      readonly trial: number;
      readonly call: number;
      readonly outcome: Outcome;
    }
  | { readonly kind: 'done' };
