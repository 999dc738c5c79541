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

/** Whether it is what our script sends, as far as its kind tells. */
export function isReply(data: unknown): data is Reply {
  return ['progress', 'done', 'failed'].includes(Object(data).kind);
}

/** An error as it is sent: classes don't survive. */
export interface SentError {
  readonly name: string;
  readonly message: string;
  readonly code?: string;
  readonly witness?: Witness;
  readonly problems?: readonly Problem[];
  readonly cause?: SentError;
}

/** What is sent of an error, and of its causes: four at most, as they may go in a circle. */
export function toSent(error: unknown, causes = 4): SentError {
  const given = error instanceof Error ? error : new Error(String(error));
  const { name, message } = given;
  const why =
    given.cause === undefined || causes === 0 ? {} : { cause: toSent(given.cause, causes - 1) };
  if (!(given instanceof HalfedgeError)) return { name, message, ...why };
  const { code, witness, problems } = given;
  return { name, message, code, witness, problems, ...why };
}

/** An error of the same class, if that is one of ours or of the language; of the same name in any case. */
export function fromSent(sent: SentError): Error {
  const { name, message, code, witness, problems } = sent;
  const why = sent.cause === undefined ? {} : { cause: fromSent(sent.cause) };
  if (code !== undefined && witness !== undefined && problems !== undefined) {
    return new HalfedgeError(code, message, { witness, problems, ...why });
  }
  if (name === 'RangeError') return new RangeError(message, why);
  if (name === 'TypeError') return new TypeError(message, why);
  const error = new Error(message, why);
  if (name !== 'Error') Object.defineProperty(error, 'name', { value: name, configurable: true });
  return error;
}

const isNamedBlob = (data: unknown) =>
  /^\[object (Blob|File)\]$/.test(Object.prototype.toString.call(data));

/** Whether it is a Blob or a File, of whatever realm, or of what stands in for a browser in Node. */
export function isBlob(data: unknown): data is Blob {
  return isNamedBlob(data) || (typeof Blob === 'function' && data instanceof Blob);
}

/** Those of jsdom and happy-dom come over as objects without content. */
export function canBeSent(blob: Blob): boolean {
  try {
    return isNamedBlob(structuredClone(blob));
  } catch {
    return false;
  }
}
