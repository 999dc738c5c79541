// The element in one file for pages without a bundler: the build puts Lit, three.js, CodeMirror, the
// WebAssembly module and the script of the worker into it.

import { workerOf } from '../connection.js';
import { init } from '../inline.js';
import { define } from './define.js';
import { threadSource } from './thread-source.js';

define(init, () => workerOf(threadSource));

export { HalfedgeFigure } from '../figure/element.js';
export * from '../inline.js';
export type { ExerciseEventMap } from './define.js';
export { type ExerciseState, HalfedgeExercise } from './element.js';
export type { ExerciseEvents } from './events.js';
export * from './judge/index.js';
