// What a student's program did, in a form that can be sent from a worker.

import { MOST_TURNS } from './program.js';

/** A question that the program asked of the mesh: `next(3)` gave 7. */
export interface Read {
  readonly name: string;
  /** What was asked for, as it came. */
  readonly of: Plain;
  /** Null where it was refused; undefined for a list, such as that of all halfedges. */
  readonly gave: number | boolean | null | undefined;
}

/** Copies of the arrays of links, by the names in the API. */
export type LinkArrays = Readonly<
  Record<'next' | 'prev' | 'toVertex' | 'face' | 'vertexHalfedge' | 'faceHalfedge', Int32Array>
>;

/** Something that is no plain value, in words: `an object`, `a function`. */
export interface Strange {
  readonly strange: string;
}

export type Plain = number | boolean | string | null | undefined | Strange;

/** What came of one call. */
export type Outcome = (
  | { readonly kind: 'returned'; readonly value: Plain | readonly Plain[] | Partial<LinkArrays> }
  | { readonly kind: 'threw'; readonly message: string; readonly line: number | null }
  /** A loop was ended that went on and on. */
  | {
      readonly kind: 'endless';
      readonly line: number | null;
      readonly recursive: boolean;
      /** How many questions had been asked when each of the first turns of the loop began. */
      readonly turns: readonly number[];
    }
) & { readonly reads: readonly Read[] };

/** Why a program could not even be called. */
export type Fault =
  | {
      readonly kind: 'syntax';
      readonly message: string;
      readonly line: number;
      /** From 1 on. */
      readonly column: number;
      /** What to do about it, where that is known. */
      readonly hint?: string;
    }
  | { readonly kind: 'no-function'; readonly found: readonly string[] }
  /** What stands outside of functions threw. */
  | { readonly kind: 'threw'; readonly message: string; readonly line: number | null }
  /** The policy of the page forbids to make code of a text. */
  | { readonly kind: 'forbidden' };

/** The value in a form that can be sent, and in which it can be judged. */
export function sendable(value: unknown): Plain | readonly Plain[] {
  if (isList(value)) {
    const list: Plain[] = [];
    let pulled = 0;
    for (const element of value) {
      if (list.length < MOST) list.push(plainOf(element));
      // A generator goes on while it is asked: one whose loop doesn't end is ended there, and that is told.
      pulled += 1;
      if (pulled > MOST_TURNS) break;
    }
    return list;
  }
  return plainOf(value);
}

/** A list that is longer is wrong anyway. */
const MOST = 2000;

function isList(value: unknown): value is Iterable<unknown> {
  return typeof value === 'object' && value !== null && Symbol.iterator in value;
}

/** The value, if it is plain; otherwise what it is. */
export function plainOf(value: unknown): Plain {
  if (value === null || value === undefined) return value;
  if (typeof value === 'number' || typeof value === 'boolean' || typeof value === 'string') {
    return value;
  }
  if (Array.isArray(value)) return { strange: 'a list' };
  if (value instanceof Promise) return { strange: 'a promise' };
  if (typeof value === 'object' && Symbol.asyncIterator in value) {
    return { strange: 'an async generator' };
  }
  return { strange: typeof value === 'object' ? 'an object' : `a ${typeof value}` };
}

/** A text that is longer is cut where it is told. */
const LONGEST_TEXT = 80;

/** The value as a list or a call has it: `3`, `“3”`, `undefined`, `an object`. */
export function shown(value: unknown): string {
  if (typeof value === 'string') {
    if (value.length <= LONGEST_TEXT) return `“${value}”`;
    return `“${value.slice(0, LONGEST_TEXT)} …” (${value.length} characters)`;
  }
  return strangeness(value) ?? String(value);
}

/** The value as a sentence has it: `the number 3`, `the text “3”`. */
export function described(value: unknown): string {
  if (typeof value === 'string') return `the text ${shown(value)}`;
  if (typeof value === 'number') return `the number ${value}`;
  return shown(value);
}

/** What a value is that is none of the plain ones. */
export function strangeness(value: unknown): string | null {
  if (typeof value !== 'object' || value === null || !('strange' in value)) return null;
  return String(value.strange);
}
