import type { Verdict } from './judge/verdict.js';

/** What the events of an exercise tell, by their names. All bubble, and cross shadow roots. */
export interface ExerciseEvents {
  /** The program was run: what is to be said of it. */
  'halfedge-result': Verdict;
  /** The code was changed, by the reader or by a program. */
  'halfedge-code': { readonly code: string };
}

/** Tells an event of an exercise. */
export function tell<Name extends keyof ExerciseEvents>(
  exercise: Element,
  name: Name,
  detail: ExerciseEvents[Name],
): void {
  exercise.dispatchEvent(new CustomEvent(name, { detail, bubbles: true, composed: true }));
}
