import type { WorkerLike } from '../connection.js';
import { define as defineFigure } from '../figure/define.js';
import { HalfedgeExercise, runWith } from './element.js';
import type { ExerciseEvents } from './events.js';

/** The events of exercises, as listeners get them. */
export type ExerciseEventMap = {
  [Name in keyof ExerciseEvents]: CustomEvent<ExerciseEvents[Name]>;
};

declare global {
  interface HTMLElementTagNameMap {
    'halfedge-exercise': HalfedgeExercise;
  }
  interface HTMLElementEventMap extends ExerciseEventMap {}
}

/**
 * Makes exercises and figures of the elements, with a way to load the WebAssembly module and one to start
 * workers; `advice` says what to do where the script of a worker isn't found. The first call counts.
 */
export function define(init: () => Promise<void>, worker: () => WorkerLike, advice?: string): void {
  defineFigure(init);
  runWith({ worker, advice });
  // There are no elements where there is no page.
  if (typeof customElements === 'undefined' || customElements.get('halfedge-exercise')) return;
  customElements.define('halfedge-exercise', HalfedgeExercise);
}
