import type { HalfedgeMesh } from '../../api.js';
import { callsFrom } from './check-task.js';
import type { Asked } from './finding.js';
import { type Sample, samplesNamed } from './meshes.js';
import { randomOf } from './random.js';
import { shuffle } from './shuffle.js';
import type { Argument, ExerciseTask } from './task.js';

/** Whether the items are numbered as they were made, or every which way. */
export type Numbering = 'tidy' | 'shuffled';

/** A mesh on which a program is tried, and with what it is called there. */
export interface Trial {
  readonly sample: Sample;
  readonly numbering: Numbering;
  /** The caller disposes of it. */
  readonly mesh: HalfedgeMesh;
  readonly calls: readonly (readonly Argument[])[];
}

/**
 * The meshes of a task: each first as it was made, then all again with other indices and other anchors.
 * The same seed gives the same ones.
 */
export function deal(task: ExerciseTask, seed: number): Trial[] {
  const random = randomOf(seed);
  const trials: Trial[] = [];
  try {
    for (const numbering of ['tidy', 'shuffled'] as const) {
      for (const sample of samplesNamed(task.meshes)) {
        const calls: (readonly Argument[])[] = [];
        const mesh = sample.make();
        trials.push({ sample, numbering, mesh, calls });
        if (numbering === 'shuffled') shuffle(mesh, random);
        calls.push(...callsFrom(task.asks(mesh), mesh));
      }
    }
    if (trials.some(({ calls }) => calls.length > 0)) return trials;
    throw new Error('asks gives no call on any mesh: every program would be right.');
  } catch (error) {
    for (const { mesh } of trials) mesh.dispose();
    throw error;
  }
}

/** One call of a trial, as a judge wants it. */
export function askedIn(
  task: ExerciseTask,
  trials: readonly Trial[],
  trial: number,
  call: number,
): Asked {
  const { mesh, calls } = trials[trial];
  const before = call > 0 ? { mesh, parameters: calls[call - 1] } : lastCall(trials[trial - 1]);
  return { task, mesh, parameters: calls[call], before };
}

function lastCall(trial: Trial | undefined): Asked['before'] {
  const parameters = trial?.calls.at(-1);
  return trial && parameters ? { mesh: trial.mesh, parameters } : null;
}
