import { HalfedgeError, type Problem, type Witness } from './errors.js';
import type { ParseOptions, ParseReport } from './parse.js';
import type { ParseStage } from './progress.js';
import type { RepairReport, SoupOptions } from './repair.js';

/** What a worker is asked for. */
export type Job =
  | {
      readonly kind: 'parse';
      readonly data: unknown;
      readonly options: ParseOptions;
      /** Whether progress is asked for: functions can't be sent. */
      readonly tells: boolean;
    }
  | {
      readonly kind: 'soup';
      readonly positions: unknown;
      readonly faces: unknown;
      readonly options: SoupOptions;
    };

/** What is sent to a worker: first the module, then jobs, one at a time. */
export type Request = { readonly kind: 'start'; readonly module: WebAssembly.Module } | Job;

/** What a worker answers to a job, perhaps after telling how far it is. */
export type Reply =
  | { readonly kind: 'progress'; readonly fraction: number; readonly stage: ParseStage }
  | {
      readonly kind: 'done';
      /** Those of `mesh.toBytes()`. */
      readonly bytes: Uint8Array;
      readonly report: RepairReport | ParseReport;
    }
  | { readonly kind: 'failed'; readonly error: SentError };

/** An error as it is sent: classes don't survive. */
export interface SentError {
  readonly name: string;
  readonly message: string;
  readonly code?: string;
  readonly witness?: Witness;
  readonly problems?: readonly Problem[];
}

export function toSent(error: unknown): SentError {
  if (error instanceof HalfedgeError) {
    const { name, message, code, witness, problems } = error;
    return { name, message, code, witness, problems };
  }
  const { name, message } = error instanceof Error ? error : new Error(String(error));
  return { name, message };
}

/** The error of the class that it was of. */
export function fromSent({ name, message, code, witness, problems }: SentError): Error {
  if (code !== undefined && witness !== undefined && problems !== undefined) {
    return new HalfedgeError(code, message, { witness, problems });
  }
  if (name === 'RangeError') return new RangeError(message);
  return name === 'TypeError' ? new TypeError(message) : new Error(message);
}

/** Whether it is a Blob or a File, of whatever realm. */
export function isBlob(data: unknown): data is Blob {
  return /^\[object (Blob|File)\]$/.test(Object.prototype.toString.call(data));
}
