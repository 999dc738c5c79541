import { refuse } from '../../checks.js';
import { attempt } from './attempt.js';
import { checkTask } from './check-task.js';
import { askedIn, deal, type Trial } from './deal.js';
import { judge } from './judge.js';
import { judgeFault } from './judge-trouble.js';
import type { Outcome } from './outcome.js';
import { compile } from './program.js';
import { type ExerciseTask, plain } from './task.js';
import {
  type Failure,
  failureBefore,
  failureOf,
  type MeshResult,
  type Verdict,
  verdictOf,
} from './verdict.js';

/**
 * Runs a program in this very thread and judges it: for scripts that grade, and for tests. Loops that do not
 * end are ended, but what else is slow is not; a page runs programs in a worker.
 *
 * Needs `init()`.
 *
 * @throws TypeError for wrong arguments, such as the bytes of a file for its text
 */
export function grade(task: ExerciseTask, code: string, seed: number): Verdict {
  checkTask('task', task);
  if (typeof code !== 'string') refuse('code', code, 'the text of a program');
  if (!Number.isInteger(seed)) refuse('seed', seed, 'an integer', 'number');
  const program = compile(code, task.call);
  if (typeof program !== 'function') {
    return verdictOf(task, seed, [], failureBefore(judgeFault(program, task.call)));
  }
  const trials = deal(task, seed);
  try {
    const meshes = trials.map(({ mesh }, index) =>
      resultOf(task, trials, index, (parameters) => attempt(program, task, mesh, parameters)),
    );
    return verdictOf(task, seed, meshes, null);
  } finally {
    for (const { mesh } of trials) mesh.dispose();
  }
}

/** Makes the calls of a trial up to the first that is wrong. */
function resultOf(
  task: ExerciseTask,
  trials: readonly Trial[],
  index: number,
  run: (parameters: (number | string)[]) => Outcome,
): MeshResult {
  const trial = trials[index];
  for (let call = 0; call < trial.calls.length; call++) {
    const outcome = run(trial.calls[call].map(plain));
    const failure = failureIn(task, trials, index, call, outcome);
    if (failure) return meshResult(trial, failure);
  }
  return meshResult(trial, null);
}

/** What is wrong in a call; null where it is right. */
export function failureIn(
  task: ExerciseTask,
  trials: readonly Trial[],
  index: number,
  call: number,
  outcome: Outcome,
): Failure | null {
  const found = judge(askedIn(task, trials, index, call), outcome);
  return found && failureOf(task, trials[index], index, call, found);
}

export function meshResult({ sample, numbering }: Trial, failure: Failure | null): MeshResult {
  const { name: mesh, words } = sample;
  return { mesh, words, numbering, passed: failure === null, failure };
}
