// Answers that are one value: a number, yes or no, an item.

import { type HalfedgeMesh, NONE } from '../../api.js';
import { type Item, isLive, itemName } from '../../teaching/items.js';
import { type Asked, type Finding, finding, isIndex, namesOf, subjectOf } from './finding.js';
import { TURNS, turnedAround } from './judge-walk.js';
import { zeroHint } from './judge-zero.js';
import { described, type Read, shown, strangeness } from './outcome.js';
import { stepsOf } from './trail.js';

/** Compares a number with the one that was expected. */
export function judgeNumber(
  asked: Asked,
  got: unknown,
  expected: number,
  reads: readonly Read[],
): Finding | null {
  if (got === expected) return null;
  const parts = { got: shown(got), expected: String(expected), steps: stepsOf(asked.mesh, reads) };
  if (typeof got !== 'number') return wrongType(got, 'a number', parts);
  if (Number.isNaN(got)) {
    return finding({
      ...parts,
      code: 'not-a-number',
      title: 'It gives back NaN, which is no number.',
      hint: 'Something was added to undefined: was the variable given a value at first?',
    });
  }
  const found = keptFromBefore(asked, got, expected) ?? elsewhere(asked, reads);
  if (found) return finding({ ...parts, ...found });
  const off = got - expected;
  if (off === 1 || off === -1) {
    return finding({
      ...parts,
      code: off > 0 ? 'one-too-many' : 'one-too-few',
      title: `It counts one too ${off > 0 ? 'many' : 'few'}.`,
      hint: isolated(asked)
        ? NOTHING_MEETS
        : off > 0
          ? 'Is the start counted twice: when the walk begins, and when it is back?'
          : 'Is the start, or the last one, left out? do … while counts before it looks.',
    });
  }
  return finding({
    ...parts,
    code: 'wrong-number',
    title: `It gives back ${got}; expected ${expected}.`,
    hint: (got === 0 && zeroHint(reads)) || '',
  });
}

const NOTHING_MEETS = 'Nothing meets it: mesh.vertexHalfedge is NONE.';

function isolated(asked: Asked): boolean {
  const subject = subjectOf(asked);
  return subject?.kind === 'vertex' && asked.mesh.isIsolatedVertex(subject.index);
}

type Part = Pick<Finding, 'code' | 'title' | 'hint'>;

/** The count of the call before, and then the right one. */
function keptFromBefore({ task, before }: Asked, got: number, expected: number): Part | null {
  const kept = before ? Number(task.reference(before.mesh, ...before.parameters)) : 0;
  if (kept === 0 || got !== expected + kept) return null;
  return {
    code: 'keeps-count',
    title: `It goes on counting from ${kept}, where the call before ended.`,
    hint: 'The function is called again and again, and each time its count has to begin at 0: declare it inside of the function.',
  };
}

function elsewhere(asked: Asked, reads: readonly Read[]): Part | null {
  const v = turnedAround(asked, reads);
  if (v < 0) return null;
  return {
    code: 'turns-elsewhere',
    title: `It turns around ${namesOf('vertex', [v])}, not around ${itemName(subjectOf(asked))}.`,
    hint: TURNS,
  };
}

/** Compares yes or no with what was expected. */
export function judgeBoolean(
  asked: Asked,
  got: unknown,
  expected: boolean,
  reads: readonly Read[],
): Finding | null {
  if (got === expected) return null;
  const steps = stepsOf(asked.mesh, reads);
  const parts = { got: shown(got), expected: String(expected), steps };
  if (typeof got !== 'boolean') return wrongType(got, 'true or false', parts);
  return finding({
    ...parts,
    code: got ? 'wrong-true' : 'wrong-false',
    title: `It says ${got} of ${itemName(subjectOf(asked))}; expected ${expected}.`,
    hint: boundaryHint(asked, expected, reads),
    marks: expected ? gapsAt(asked) : [],
  });
}

function boundaryHint(asked: Asked, expected: boolean, reads: readonly Read[]): string {
  const subject = subjectOf(asked);
  if (subject?.kind !== 'vertex') return '';
  const gaps = gapsAt(asked).map(itemName);
  if (isolated(asked)) return NOTHING_MEETS;
  if (!expected || gaps.length === 0) {
    return `Every halfedge that leaves it has a face. ${zeroHint(reads) ?? ''}`.trim();
  }
  const leave = gaps.length > 1 ? 'leave it and have' : 'leaves it and has';
  return `${gaps.join(' and ')} ${leave} no face.`;
}

function gapsAt({ mesh, parameters: [subject] }: Asked): Item[] {
  if (typeof subject !== 'object' || subject.kind !== 'vertex') return [];
  return [...mesh.vertexOutgoingHalfedges(subject.index)]
    .filter((h) => mesh.isBoundaryHalfedge(h))
    .map((index) => ({ kind: 'halfedge', index }));
}

/** Compares an item with the one that was expected. */
export function judgeItem(
  asked: Asked,
  got: unknown,
  expected: Item,
  reads: readonly Read[],
): Finding | null {
  if (got === expected.index) return null;
  const { mesh } = asked;
  const steps = stepsOf(mesh, reads);
  const isNone = expected.index === NONE;
  const wanted = isNone ? 'NONE' : itemName(expected);
  const parts = { got: shown(got), expected: wanted, steps, marks: isNone ? [] : [expected] };
  if (typeof got !== 'number') return wrongType(got, `a ${expected.kind}, by its index`, parts);
  const item = { kind: expected.kind, index: got };
  if (!isIndex(got) || !isLive(mesh, item)) {
    return finding({
      ...parts,
      code: 'not-an-item',
      title: `It gives back ${got}; the mesh has no such ${expected.kind}.`,
    });
  }
  const relation = relationOf(mesh, asked, item);
  return finding({
    ...parts,
    got: itemName(item),
    code: 'wrong-item',
    title: `It gives back ${itemName(item)}${relation ? `, which is ${relation}` : ''}; expected ${wanted}.`,
    hint: leadsBack(asked, expected) ? LEADS_BACK : '',
  });
}

const LEADS_BACK =
  'The next of the one that is asked for is the given one: that is how to know it.';

function leadsBack(asked: Asked, { kind, index }: Item): boolean {
  const subject = subjectOf(asked);
  if (kind !== 'halfedge' || index === NONE || subject?.kind !== 'halfedge') return false;
  return asked.mesh.next(index) === subject.index;
}

/** What an item is to the one that was asked about: `its next`. */
function relationOf(mesh: HalfedgeMesh, asked: Asked, { kind, index }: Item): string | null {
  const subject = subjectOf(asked);
  if (kind !== 'halfedge' || subject?.kind !== 'halfedge') return null;
  const h = subject.index;
  const name = itemName(subject);
  const relations: [number, string][] = [
    [h, `${name} itself`],
    [mesh.next(h), `next(${name})`],
    [mesh.opposite(h), `opposite(${name})`],
    [mesh.next(mesh.opposite(h)), `next(opposite(${name}))`],
    [mesh.opposite(mesh.next(h)), `opposite(next(${name}))`],
    [mesh.opposite(mesh.prev(h)), `opposite(prev(${name})), on the other side of the edge`],
    [mesh.next(mesh.next(h)), `next(next(${name})): right in triangles only`],
  ];
  return relations.find(([other]) => other === index)?.[1] ?? null;
}

/** For an answer of another type than the one that was asked for. */
export function wrongType(got: unknown, expected: string, parts: Partial<Finding>): Finding {
  const list = Array.isArray(got);
  const words = list ? `a list of ${got.length}` : described(got);
  return finding({
    ...parts,
    got: words,
    expected,
    code: 'wrong-type',
    title: `It gives back ${words}; expected ${expected}.`,
    hint: list ? 'Is it the length of the list that was asked for?' : promiseHint(got),
  });
}

function promiseHint(got: unknown): string {
  const what = strangeness(got);
  if (what !== 'a promise' && what !== 'an async generator') return '';
  return `A function that is async gives back ${what}. Nothing here has to be waited for: leave the words async and await out.`;
}
