import { NONE } from '../../api.js';
import type { Item } from '../../teaching/items.js';
import { isRun, rotated, sameCycle, sameCycleEitherWay, sameList, turned } from './cycles.js';
import {
  type Asked,
  type Finding,
  finding,
  isIndex,
  namesOf,
  ordinal,
  subjectOf,
  TEXT_FOR_ITEM,
} from './finding.js';
import { otherLists, wrongWalk } from './judge-walk.js';
import { wasGiven, zeroHint, zeroIsFalse } from './judge-zero.js';
import { described, type Read } from './outcome.js';
import { stepsOf, stepsTo } from './trail.js';

/** What is asked, what was expected, and what came. */
export interface Lists {
  readonly asked: Asked;
  readonly of: Item['kind'];
  readonly eitherWay: boolean;
  readonly anyStart: boolean;
  readonly expected: readonly number[];
  readonly got: readonly unknown[];
  /** What the program has asked of the mesh. */
  readonly reads: readonly Read[];
}

/** Compares a list with the one that was expected; null where it is right. */
export function judgeCycle(lists: Lists): Finding | null {
  if (isRight(lists)) return null;
  const { asked, of, expected, got } = lists;
  const found =
    keptFromBefore(lists) ??
    strangeMember(lists) ??
    nullMember(lists) ??
    otherLists(lists) ??
    wrongWalk(lists) ??
    nothingOrSomething(lists) ??
    repeated(lists) ??
    foreign(lists) ??
    missingZero(lists) ??
    missing(lists) ??
    otherOrder(lists);
  const missed = expected.filter((index) => !got.includes(index));
  return finding({
    got: namesOf(of, got),
    expected: namesOf(of, expected),
    steps: stepsTo(asked, of, got),
    marks: missed.map((index) => ({ kind: of, index })),
    ...found,
  });
}

function isRight({ expected, got, eitherWay, anyStart }: Lists): boolean {
  const same = anyStart ? sameCycle : sameList;
  return same(got, expected) || (eitherWay && same(got, turned(expected)));
}

type Part = Pick<Finding, 'code' | 'title'> & Partial<Finding>;

/** The list of the call before, and then the right one. */
function keptFromBefore(lists: Lists): Part | null {
  const { asked, of, got } = lists;
  if (!asked.before) return null;
  const { mesh, parameters } = asked.before;
  const expected = [...(asked.task.reference(mesh, ...parameters) as Iterable<number>)];
  const [kept, own] = [got.slice(0, expected.length), got.slice(expected.length)];
  if (kept.length === 0 || own.length === 0) return null;
  if (!isRight({ ...lists, expected, got: kept }) || !isRight({ ...lists, got: own })) return null;
  return {
    code: 'keeps-list',
    title: `Its list still holds what the call before put into it: ${namesOf(of, kept)}.`,
    hint: 'The function is called again and again, and each time its list has to begin empty: make it inside of the function.',
  };
}

function strangeMember({ of, got }: Lists): Part | null {
  const place = got.findIndex((value) => !isIndex(value) && value !== NONE);
  if (place < 0) return null;
  const value = got[place];
  return {
    code: 'not-an-item',
    title: `${capital(ordinal(place + 1))} in its list is ${described(value)}, which is no ${of}.`,
    hint:
      typeof value === 'string'
        ? TEXT_FOR_ITEM
        : 'Items are whole numbers from 0 on. Was something pushed before it had a value?',
  };
}

function nullMember({ asked, of, got }: Lists): Part | null {
  const place = got.indexOf(NONE);
  if (place < 0) return null;
  if (of === 'face') {
    return {
      code: 'null-face',
      title: 'It takes −1 for a face.',
      hint: `A boundary halfedge has no face: mesh.face(h) is NONE, which is −1. Leave it out, and walk on${onwards(asked)}.`,
      marks: boundaryOf(asked),
    };
  }
  return {
    code: 'null-item',
    title: `${capital(ordinal(place + 1))} in its list is −1, “no such item”.`,
    hint: `A ${of} was asked for; NONE, which is −1, is what an empty link holds.`,
  };
}

function onwards(asked: Asked): string {
  return subjectOf(asked)?.kind === 'vertex' ? ': behind the gap there may be more' : '';
}

/** The halfedges without a face that leave the vertex that was asked about. */
function boundaryOf(asked: Asked): Item[] {
  const subject = subjectOf(asked);
  if (subject?.kind !== 'vertex') return [];
  const { mesh } = asked;
  return [...mesh.vertexOutgoingHalfedges(subject.index)]
    .filter((h) => mesh.isBoundaryHalfedge(h))
    .map((index) => ({ kind: 'halfedge', index }));
}

function nothingOrSomething({ asked, of, expected, got, reads }: Lists): Part | null {
  if (got.length === 0) {
    if (isAtBoundary(asked)) return STOPS_AT_BOUNDARY;
    return {
      code: 'empty',
      title: 'Its list is empty.',
      // The same questions come from both mistakes.
      hint: [
        `A walk of do … while takes its first ${of} before it looks whether it is done; while looks first, and is back before it has left.`,
        zeroHint(reads, 'Or was 0 taken for none?'),
      ]
        .filter(Boolean)
        .join(' '),
    };
  }
  if (expected.length > 0) return null;
  return {
    code: 'not-empty',
    title: `There is no ${of} here, and it gives some.`,
    hint: 'Nothing meets an isolated vertex: mesh.vertexHalfedge(v) is NONE. Look at that before the walk.',
  };
}

const STOPS_AT_BOUNDARY: Part = {
  code: 'stops-at-boundary',
  title: 'It stops at the boundary.',
  hint: 'A boundary halfedge has no face, but next, prev and opposite like any other: the walk goes on across the gap, and is done where it began.',
};

function isAtBoundary(asked: Asked): boolean {
  const subject = subjectOf(asked);
  const { mesh } = asked;
  if (subject?.kind === 'vertex') return mesh.isBoundaryVertex(subject.index);
  if (subject?.kind === 'face') return mesh.isBoundaryFace(subject.index);
  return false;
}

function repeated({ of, expected, got }: Lists): Part | null {
  const twice = got.findIndex(
    (value, i) => got.indexOf(value) < i && expected.indexOf(value as number) >= 0,
  );
  if (twice < 0 || new Set(expected).size < expected.length) return null;
  const name = namesOf(of, [got[twice]]);
  if (got.length === expected.length + 1 && twice === got.length - 1 && got[0] === got[twice]) {
    return {
      code: 'start-twice',
      title: `It takes ${name} twice: at the start, and again at the end.`,
      hint: 'It is done as soon as the walk is back at the halfedge where it began: that one is taken already.',
    };
  }
  const laps = got.length / expected.length;
  if (laps > 1 && Number.isInteger(laps) && sameList(got, rotated(got, expected.length))) {
    return {
      code: 'several-laps',
      title: `It goes round ${laps} times.`,
      hint: 'One lap is over as soon as the walk is back at the halfedge where it began.',
    };
  }
  return {
    code: 'repeats',
    title: `It takes ${name} twice.`,
    hint: `Each ${of} was to be given once.`,
  };
}

function foreign({ of, expected, got }: Lists): Part | null {
  const wrong = got.filter((value) => !expected.includes(value as number));
  if (wrong.length === 0) return null;
  return {
    code: 'foreign',
    title: `It takes ${namesOf(of, wrong)}, which ${wrong.length > 1 ? 'do' : 'does'} not belong there.`,
    hint: '',
    marks: wrong.filter(isIndex).map((index) => ({ kind: of, index })),
  };
}

/** Only the item 0, which the program has been at. */
function missingZero({ of, expected, got, reads }: Lists): Part | null {
  const missed = expected.filter((index) => !got.includes(index));
  if (missed.length !== 1 || missed[0] !== 0 || !wasGiven(of, 0, reads)) return null;
  const name = namesOf(of, [0]);
  return {
    code: 'zero-is-false',
    title: `It leaves out ${name}, which it has been given.`,
    hint: `Is it asked whether there is one, as in if (mesh.${of === 'vertex' ? 'toVertex' : of}(h))? ${zeroIsFalse(name)}`,
  };
}

function missing({ asked, of, expected, got, reads }: Lists): Part | null {
  const missed = expected.filter((index) => !got.includes(index));
  if (missed.length === 0) return null;
  const names = namesOf(of, missed);
  if (isAtBoundary(asked) && isRun(got, expected)) return STOPS_AT_BOUNDARY;
  if (missed.length > 1) {
    return {
      code: isRun(got, expected) ? 'stops-early' : 'misses-some',
      title: isRun(got, expected)
        ? `It stops too early: ${names} are missing.`
        : `It skips ${names}.`,
      hint: `There are ${expected.length} to be found here.`,
    };
  }
  if (missed[0] === expected[0]) {
    return {
      code: 'misses-first',
      title: `It misses the first: ${names}.`,
      hint: 'Take the item of the halfedge where the walk begins before going on to the next one.',
    };
  }
  return {
    code: 'misses-last',
    title: `It misses one: ${names}.`,
    hint: cameBack(asked, reads) ? LOOKS_AHEAD : `There are ${expected.length} to be found here.`,
  };
}

const LOOKS_AHEAD =
  'A loop that looks ahead stops before it has taken the last: do … while takes first, then looks whether the walk is back.';

/** Whether the walk has been at one halfedge twice: what takes a fixed number of steps has not. */
function cameBack({ mesh }: Asked, reads: readonly Read[]): boolean {
  const walked = stepsOf(mesh, reads).map(({ halfedge }) => halfedge);
  return new Set(walked).size < walked.length;
}

function otherOrder({ asked, of, expected, got, anyStart }: Lists): Part {
  const [, direction] = asked.parameters;
  const first = namesOf(of, expected.slice(0, 1));
  if (!anyStart && sameCycle(got, expected)) {
    return {
      code: 'starts-elsewhere',
      title: `It starts at ${namesOf(of, got.slice(0, 1))}; expected ${first} as the first.`,
      hint: `The cycle is right. Take the item first, then step on.${isReversedClockwise(asked, got, expected) ? REVERSED_CLOCKWISE : ''}`,
    };
  }
  if (sameCycleEitherWay(got, expected)) {
    const along = subjectOf(asked)?.kind === 'halfedge';
    const way = along ? 'against next' : direction === 'cw' ? 'counter-clockwise' : 'clockwise';
    return {
      code: 'wrong-way',
      title: `It goes the wrong way round: ${way}.`,
      hint: WAYS[subjectOf(asked)?.kind ?? 'mesh'] ?? '',
    };
  }
  return {
    code: 'wrong-order',
    title: `It finds every ${of}, but not in the order in which they lie.`,
    hint: 'Walk from halfedge to halfedge, instead of looking through all of them.',
  };
}

/** Whether a list around a vertex is as the library's own walk has it: clockwise in reverse, so that it ends at the anchor. */
function isReversedClockwise(
  { parameters }: Asked,
  got: readonly unknown[],
  [first]: readonly number[],
) {
  return parameters[1] === 'ccw' && got.at(-1) === first;
}

const REVERSED_CLOCKWISE =
  ' (The circulators of the library step first when they go counter-clockwise, so that both ways give the same list, one in reverse. Here both begin at vertexHalfedge(v).)';

const WAYS: Readonly<Record<string, string>> = {
  vertex:
    'opposite(prev(h)) turns counter-clockwise around the vertex that h leaves, next(opposite(h)) clockwise.',
  face: 'next goes counter-clockwise around a face, prev clockwise.',
  halfedge: 'next goes along a loop, prev against it.',
};

export function capital(words: string): string {
  return words.charAt(0).toUpperCase() + words.slice(1);
}
