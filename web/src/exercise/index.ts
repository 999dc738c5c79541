// `<halfedge-exercise>`: importing this entry defines the element, and `<halfedge-figure>`. Lit, three.js,
// three-mesh-bvh, acorn and CodeMirror are peer dependencies of it.

import { init } from '../init.js';
import { newWorker } from '../new-worker.js';
import { define } from './define.js';

const ADVICE = "import 'halfedge/exercise/standalone' instead, which contains it";

const newExerciseWorker = () =>
  newWorker(
    'exercise/thread.js',
    // In this form, bundlers recognise a worker.
    () => new Worker(new URL('./thread.js', import.meta.url), { type: 'module' }),
    ADVICE,
  );

define(
  init,
  newExerciseWorker,
  `Some bundlers (Angular, Bun, esbuild, Rollup) leave it behind: ${ADVICE}`,
);

export type { ExerciseEventMap } from './define.js';
export { type ExerciseState, HalfedgeExercise } from './element.js';
export type { ExerciseEvents } from './events.js';
export * from './judge/index.js';
