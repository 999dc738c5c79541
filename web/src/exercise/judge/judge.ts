import { sameList } from './cycles.js';
import { type Asked, type Finding, finding } from './finding.js';
import { judgeCycle } from './judge-cycle.js';
import { judgeLinks } from './judge-links.js';
import { judgeEndless, judgeThrown } from './judge-trouble.js';
import { judgeBoolean, judgeItem, judgeNumber, wrongType } from './judge-value.js';
import type { LinkArrays, Outcome } from './outcome.js';

/** What is wrong with what a program did when it was called; null where it is right. */
export function judge(asked: Asked, outcome: Outcome): Finding | null {
  switch (outcome.kind) {
    case 'threw':
      return judgeThrown(asked, outcome);
    case 'endless':
      return judgeEndless(asked, outcome);
    case 'returned':
      return judgeValue(asked, outcome);
  }
}

function judgeValue(
  asked: Asked,
  { value, reads }: Outcome & { kind: 'returned' },
): Finding | null {
  const { task, mesh, parameters } = asked;
  const { answer, check } = task;
  if (check) {
    let sentence: string | null;
    try {
      sentence = check(mesh, value, ...parameters);
    } catch (error) {
      if (value === undefined || value === null) return nothingBack(value);
      throw error;
    }
    return sentence === null ? null : finding({ code: 'refused', title: sentence });
  }
  if (answer.kind === 'links') return judgeLinks(asked, value as LinkArrays);
  if (value === undefined || value === null) return nothingBack(value);
  const expected = task.reference(mesh, ...parameters);
  const found = compare(asked, value, expected, reads);
  // The way that the program went says more than a number that happens to be that of a known mistake.
  return found && found.code !== 'turns-elsewhere' ? withMistake(asked, value, found) : found;
}

function compare(
  asked: Asked,
  value: unknown,
  expected: unknown,
  reads: Outcome['reads'],
): Finding | null {
  const { answer } = asked.task;
  switch (answer.kind) {
    case 'cycle': {
      if (!Array.isArray(value)) return wrongType(value, 'a list', {});
      const { of, eitherWay = false, anyStart = false } = answer;
      const list = [...(expected as Iterable<number>)];
      return judgeCycle({ asked, of, eitherWay, anyStart, expected: list, got: value, reads });
    }
    case 'item':
      return judgeItem(asked, value, { kind: answer.of, index: expected as number }, reads);
    case 'number':
      return judgeNumber(asked, value, expected as number, reads);
    case 'boolean':
      return judgeBoolean(asked, value, expected as boolean, reads);
    case 'links':
      return null;
  }
}

/** A wrong answer that the task knows, in the task's own words. */
function withMistake(asked: Asked, value: unknown, found: Finding): Finding {
  const { task, mesh, parameters } = asked;
  const known = task.mistakes?.find((mistake) => {
    const answer = mistake.answer(mesh, ...parameters);
    if (Array.isArray(value) && Array.isArray(answer)) return sameList(value, answer);
    return answer === value;
  });
  if (!known) return found;
  // What is said of numbers and lists at large is about another mistake.
  const { code, says, hint = '' } = known;
  return { ...found, code, title: says, hint };
}

function nothingBack(value: undefined | null): Finding {
  return finding({
    code: 'returns-nothing',
    title: `It gives back ${value}.`,
    hint:
      value === undefined
        ? 'Does it come to a return in every case? return without a value gives undefined, too.'
        : 'null is no answer: where there is nothing, give back an empty list or NONE.',
  });
}
