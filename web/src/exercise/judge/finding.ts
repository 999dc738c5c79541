import type { HalfedgeMesh } from '../../api.js';
import { type Item, itemName } from '../../teaching/items.js';
import { shown } from './outcome.js';
import type { Argument, ExerciseTask } from './task.js';

/** One call of a student's function, and what is known of it. */
export interface Asked {
  readonly task: ExerciseTask;
  readonly mesh: HalfedgeMesh;
  readonly parameters: readonly Argument[];
  /** The call before, which may be on another mesh; null for the first. */
  readonly before: { readonly mesh: HalfedgeMesh; readonly parameters: readonly Argument[] } | null;
}

/** One step of a trail that a picture shows. */
export interface TrailStep {
  readonly item: Item;
  /** The halfedge that led there. */
  readonly halfedge: number;
  /** What the step did. */
  readonly words: string;
}

/** What is wrong with an answer. */
export interface Finding {
  /** A stable name, such as `misses-last`. */
  readonly code: string;
  /** What the program does, as a sentence. */
  readonly title: string;
  /** How to think on; may be empty. */
  readonly hint: string;
  /** What was given back, and what was expected, where that helps; otherwise empty. */
  readonly got: string;
  readonly expected: string;
  /** The line of the code that it is about, where that is known. */
  readonly line: number | null;
  /** From 1 on, of a mistake of syntax. */
  readonly column?: number;
  /** Where the program went, or what it gave back. */
  readonly steps: readonly TrailStep[];
  /** What is missing, or wrong. */
  readonly marks: readonly Item[];
}

type Parts = Partial<Finding> & Pick<Finding, 'code' | 'title'>;

export function finding(parts: Parts): Finding {
  return { hint: '', got: '', expected: '', line: null, steps: [], marks: [], ...parts };
}

/** The item that a call is about: its first parameter, where that is one. */
export function subjectOf({ parameters }: Asked): Item | null {
  const [first] = parameters;
  return typeof first === 'object' ? first : null;
}

/** `v1, v4, v2`; a long list is cut. */
export function namesOf(kind: Item['kind'], indices: readonly unknown[]): string {
  const names = indices.map((index) => (isIndex(index) ? itemName({ kind, index }) : shown(index)));
  if (names.length === 0) return 'nothing';
  const first = names.slice(0, MOST_NAMES).join(', ');
  return names.length > MOST_NAMES ? `${first}, … (${names.length})` : first;
}

const MOST_NAMES = 16;

export function isIndex(value: unknown): value is number {
  return typeof value === 'number' && Number.isInteger(value) && value >= 0;
}

/** `the 3rd` */
export function ordinal(place: number): string {
  const teen = place % 100 > 10 && place % 100 < 14;
  const ending = (teen ? undefined : ['th', 'st', 'nd', 'rd'][place % 10]) ?? 'th';
  return `the ${place}${ending}`;
}

/** For a text in the place of an item. */
export const TEXT_FOR_ITEM =
  'Items are numbers, and this is a text. Does it come from for … in? That gives names, such as those of the places in a list; for … of gives the items.';
