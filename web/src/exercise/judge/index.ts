// What judges the programs of students: tasks, meshes, and messages. `halfedge/exercise` shows it in a page;
// this entry knows nothing of the DOM, and grades in Node as well.

export { deal, type Numbering, type Trial } from './deal.js';
export type { Finding, TrailStep } from './finding.js';
export { grade } from './grade.js';
export { type MeshName, type Sample, samples } from './meshes.js';
export type { LinkArrays } from './outcome.js';
export type { Answer, Argument, ExerciseTask, Mistake } from './task.js';
export { taskNamed, tasks } from './tasks.js';
export type { Failure, MeshResult, Verdict } from './verdict.js';
