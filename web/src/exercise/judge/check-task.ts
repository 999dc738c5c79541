import { HalfedgeMesh } from '../../api.js';
import { checkIterable, refuse } from '../../checks.js';
import { type Item, isLive } from '../../teaching/items.js';
import { samples } from './meshes.js';
import type { Argument, ExerciseTask } from './task.js';

const TEXTS = ['name', 'title', 'statement', 'call', 'starter', 'solution'] as const;
const KINDS: readonly unknown[] = ['vertex', 'halfedge', 'edge', 'face'];
const FUNCTION_NAME = /^[\p{ID_Start}$_][\p{ID_Continue}$]*$/u;
const ANSWERS: readonly unknown[] = ['cycle', 'item', 'number', 'boolean', 'links'];

/** A task of a teacher. Throws a sentence that names the property where it is none. */
export function checkTask(argument: string, task: ExerciseTask): ExerciseTask {
  if (typeof task !== 'object' || task === null) {
    refuse(argument, task, 'a task, as taskNamed() gives it');
  }
  const { gets, uses, meshes, answer, mistakes } = task;
  for (const key of TEXTS) checkText(`${argument}.${key}`, task[key]);
  if (!FUNCTION_NAME.test(task.call)) {
    refuse(`${argument}.call`, task.call, 'the name of a function', 'string');
  }
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

/** The calls that a task asks for on a mesh. Throws a sentence where they can't be made. */
export function callsFrom(asked: unknown, mesh: HalfedgeMesh): (readonly Argument[])[] {
  const expected = 'a list of items, numbers or words';
  checkIterable('What asks gives', asked, `a list of calls, each ${expected}`);
  const calls = [...((asked ?? []) as Iterable<unknown>)];
  for (const call of calls) {
    if (!Array.isArray(call)) refuse('A call that asks gives', call, expected);
    for (const parameter of call) checkParameter(parameter, mesh);
  }
  return calls as (readonly Argument[])[];
}

function checkParameter(parameter: unknown, mesh: HalfedgeMesh): void {
  if (typeof parameter === 'number' || typeof parameter === 'string') return;
  const item = Object(parameter) as Item;
  if (!KINDS.includes(item.kind)) {
    refuse('A parameter that asks gives', parameter, "an item such as { kind: 'face', index: 0 }");
  }
  if (isLive(mesh, item)) return;
  throw new RangeError(`asks gives ${item.kind} ${item.index}, which the mesh does not have.`);
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
