import { itemName } from '../../teaching/items.js';
import type { Numbering, Trial } from './deal.js';
import { type Finding, finding } from './finding.js';
import type { Argument, ExerciseTask } from './task.js';

/** How a program did on one mesh. */
export interface MeshResult {
  /** The name of the mesh, and in words. */
  readonly mesh: string;
  readonly words: string;
  readonly numbering: Numbering;
  readonly passed: boolean;
  /** What was wrong first. */
  readonly failure: Failure | null;
}

/** What was wrong in one call. */
export interface Failure extends Finding {
  readonly mesh: string;
  readonly numbering: Numbering;
  /** The call: `valence(mesh, v3)`; empty where it never came to one. */
  readonly call: string;
  /** What it was asked about: `v3`, or null. */
  readonly item: string | null;
  /** All of it, as one text: mesh, call, what was given back and what was expected. */
  readonly message: string;
  /** Which of the trials it is; -1 where it never came to one. */
  readonly trial: number;
}

/** What is to be said of a program. */
export interface Verdict {
  readonly task: string;
  readonly passed: boolean;
  /** What numbers the shuffled meshes have: the same seed, the same ones. */
  readonly seed: number;
  /** What was wrong first; null where all is right. */
  readonly failure: Failure | null;
  readonly meshes: readonly MeshResult[];
}

/** The failure of a call in a trial. */
export function failureOf(
  task: ExerciseTask,
  trial: Trial,
  index: number,
  call: number,
  found: Finding,
): Failure {
  const { sample, numbering } = trial;
  const parameters = trial.calls[call] ?? [];
  const [first] = parameters;
  const written = callWords(task, parameters);
  const how = numbering === 'shuffled' ? `${sample.words}, shuffled` : sample.words;
  const got = found.got ? `it gave ${found.got}` : '';
  const expected = found.expected ? `expected ${found.expected}` : '';
  const facts = [got, expected].filter(Boolean).join('; ');
  const where = `On ${how}, ${written}${facts ? `: ${facts}` : ''}.`;
  return {
    ...found,
    mesh: sample.name,
    numbering,
    call: written,
    item: typeof first === 'object' ? itemName(first) : null,
    message: [found.title, where, found.hint].filter(Boolean).join(' '),
    trial: index,
  };
}

/** A failure before any call: nothing of a mesh is to be said. */
export function failureBefore(found: Finding): Failure {
  const message = [found.title, found.hint].filter(Boolean).join(' ');
  return { ...found, mesh: '', numbering: 'tidy', call: '', item: null, message, trial: -1 };
}

/** `oneRing(mesh, v3, 'cw')` */
function callWords({ call, gets }: ExerciseTask, parameters: readonly Argument[]): string {
  const words = parameters.map((parameter) => {
    if (typeof parameter === 'object') return itemName(parameter);
    return typeof parameter === 'string' ? `'${parameter}'` : String(parameter);
  });
  return `${call}(${[gets, ...words].join(', ')})`;
}

/** Sums up: the first failure is the one to tell, and one that only other numbers show is told as such. */
export function verdictOf(
  task: ExerciseTask,
  seed: number,
  meshes: readonly MeshResult[],
  fault: Failure | null,
): Verdict {
  const failed = meshes.find(({ passed }) => !passed);
  const first = fault ?? failed?.failure ?? null;
  const failure = first && !fault && first.numbering === 'shuffled' ? asNumbering(first) : first;
  return { task: task.name, passed: failure === null, seed, failure, meshes };
}

/** Right on all tidy meshes, and wrong on a shuffled one. */
function asNumbering(failure: Failure): Failure {
  const title = 'It is right as long as the numbers are tidy, and wrong with others.';
  const reason = `${failure.title} ${failure.hint}`.trim();
  const hint = `Does it calculate with indices, or rely on where a walk begins? Only the links say what lies beside what. Here: ${reason}`;
  const { steps, marks, got, expected, line } = failure;
  const found = finding({ code: 'numbering', title, hint, steps, marks, got, expected, line });
  return { ...failure, ...found, message: `${title} ${failure.message}` };
}
