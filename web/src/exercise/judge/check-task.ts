import { HalfedgeMesh } from '../../api.js';
import { refuse } from '../../checks.js';
import { samples } from './meshes.js';
import type { ExerciseTask } from './task.js';

const TEXTS = ['name', 'title', 'statement', 'call', 'starter', 'solution'] as const;
const KINDS: readonly unknown[] = ['vertex', 'halfedge', 'edge', 'face'];
const ANSWERS: readonly unknown[] = ['cycle', 'item', 'number', 'boolean', 'links'];

/** A task of a teacher. Throws a sentence that names the property where it is none. */
export function checkTask(argument: string, task: ExerciseTask): ExerciseTask {
  if (typeof task !== 'object' || task === null) {
    refuse(argument, task, 'a task, as taskNamed() gives it');
  }
  const { gets, uses, meshes, answer, mistakes } = task;
  for (const key of TEXTS) checkText(`${argument}.${key}`, task[key]);
  if (gets !== 'mesh' && gets !== 'links') {
    refuse(`${argument}.gets`, gets, '"mesh" or "links"', 'string');
  }
  for (const [i, name] of listOf(`${argument}.uses`, uses)) {
    checkText(`${argument}.uses[${i}]`, name);
    if (name in HalfedgeMesh.prototype) continue;
    refuse(
      `${argument}.uses[${i}]`,
      name,
      'the name of a method or property of HalfedgeMesh',
      'string',
    );
  }
  if (meshes !== undefined) checkMeshes(`${argument}.meshes`, meshes);
  checkFunction(`${argument}.asks`, task.asks);
  checkFunction(`${argument}.reference`, task.reference);
  if (task.check !== undefined) checkFunction(`${argument}.check`, task.check);
  if (!ANSWERS.includes(answer?.kind)) {
    refuse(`${argument}.answer`, answer?.kind ?? answer, `a kind: one of ${ANSWERS.join(', ')}`);
  }
  if ((answer.kind === 'cycle' || answer.kind === 'item') && !KINDS.includes(answer.of)) {
    refuse(`${argument}.answer.of`, answer.of, `one of ${KINDS.join(', ')}`, 'string');
  }
  for (const [i, mistake] of listOf(`${argument}.mistakes`, mistakes ?? [])) {
    const name = `${argument}.mistakes[${i}]`;
    checkText(`${name}.code`, mistake?.code);
    checkText(`${name}.says`, mistake?.says);
    checkFunction(`${name}.answer`, mistake?.answer);
  }
  return task;
}

function checkMeshes(argument: string, meshes: ExerciseTask['meshes']): void {
  const known = samples.map(({ name }) => name);
  const names = listOf(argument, meshes);
  if (names.length === 0) refuse(argument, meshes, 'one mesh or more');
  for (const [i, name] of names) {
    if (!(known as readonly unknown[]).includes(name)) {
      refuse(`${argument}[${i}]`, name, `one of ${known.join(', ')}`, 'string');
    }
  }
}

/** With their places. */
function listOf<Entry>(argument: string, list: readonly Entry[] | undefined): [number, Entry][] {
  if (!Array.isArray(list)) refuse(argument, list, 'an array');
  return [...list.entries()];
}

function checkText(argument: string, text: unknown): void {
  if (typeof text !== 'string') refuse(argument, text, 'a text');
}

function checkFunction(argument: string, given: unknown): void {
  if (typeof given !== 'function') refuse(argument, given, 'a function');
}
