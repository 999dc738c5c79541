// Programs that give nothing back: they stop with an error, go on for ever, or can't be started.

import { itemName } from '../../teaching/items.js';
import { type Asked, type Finding, finding, isIndex, subjectOf, TEXT_FOR_ITEM } from './finding.js';
import { type Fault, type Outcome, type Read, shown } from './outcome.js';
import { stepsOf } from './trail.js';

type Threw = Outcome & { readonly kind: 'threw' };
type Ended = Outcome & { readonly kind: 'endless' };

/** Why there is no program to call. */
export function judgeFault(fault: Fault, call: string): Finding {
  switch (fault.kind) {
    case 'syntax': {
      const { message, line, column, hint = UNREADABLE } = fault;
      return finding({
        code: 'syntax',
        title: `Line ${line}, column ${column}: ${message}.`,
        hint,
        line,
        column,
      });
    }
    case 'no-function': {
      const found = fault.found.length > 0 ? ` It has ${fault.found.join(', ')}.` : '';
      return finding({
        code: 'no-function',
        title: `The code has no function ${call}.${found}`,
        hint: `Write function ${call}(…) { … }: it is called by that name.`,
      });
    }
    case 'threw':
      return finding({
        code: 'throws',
        title: `${place(fault.line)}: ${withStop(fault.message)}`,
        hint: `It happens outside of ${call}, before that is called.`,
        line: fault.line,
      });
    case 'forbidden':
      return finding({
        code: 'forbidden',
        title: 'The security policy of this page forbids to run code that was typed in.',
        hint: "It has to allow 'unsafe-eval' for the worker of the exercise.",
      });
  }
}

const UNREADABLE =
  'The code can’t be read from there on; often something before it is not closed: a bracket, a brace, a quote.';

/** What an error says, and what lies behind it where that is an empty link. */
export function judgeThrown(asked: Asked, { message, line, reads }: Threw): Finding {
  const last = reads.at(-1);
  const parts = { line, steps: stepsOf(asked.mesh, reads) };
  if (last && last.gave === null && last.of === -1) return emptyLink(asked, reads, last, line);
  if (last && last.gave === null && !isIndex(last.of)) {
    return finding({
      ...parts,
      code: 'asks-for-nothing',
      title: `${place(line)}: it asks for ${last.name}(${shown(last.of)}).`,
      hint:
        typeof last.of === 'string'
          ? TEXT_FOR_ITEM
          : `${message} Does the variable have a value there?`,
    });
  }
  // The other tasks have a mesh with accessors, and some programs go on as if this one had, too.
  const calls = asked.task.gets === 'links' && message.includes('is not a function');
  return finding({
    ...parts,
    code: 'throws',
    title: `${place(line)}: ${withStop(message)}`,
    ...(calls && { hint: 'There are arrays only, no functions: next[h], not next(h).' }),
  });
}

function emptyLink(asked: Asked, reads: readonly Read[], last: Read, line: number | null): Finding {
  const source = [...reads].reverse().find(({ gave }) => gave === -1);
  const subject = subjectOf(asked);
  const parts = {
    line,
    steps: stepsOf(asked.mesh, reads),
    title: `${place(line)}: it asks for ${last.name}(−1), and −1 is no item.`,
  };
  if (source?.name === 'face') {
    return finding({
      ...parts,
      code: 'reads-null-face',
      hint: `h${shown(source.of)} is a boundary halfedge, its face is NONE. Look for that before using the face.`,
      marks: isIndex(source.of) ? [{ kind: 'halfedge', index: source.of }] : [],
    });
  }
  if (source?.name === 'vertexHalfedge') {
    return finding({
      ...parts,
      code: 'reads-null-halfedge',
      hint: `${itemName(subject)} is isolated: no halfedge leaves it, vertexHalfedge gives NONE. Look for that before the walk.`,
      marks: subject ? [subject] : [],
    });
  }
  return finding({
    ...parts,
    code: 'reads-null',
    hint: 'NONE, which is −1, is what an empty link holds.',
  });
}

/** Where a loop that doesn't end goes round and round. */
export function judgeEndless(asked: Asked, { line, recursive, turns, reads }: Ended): Finding {
  if (recursive) {
    return finding({
      code: 'endless-recursion',
      title: `${place(line)}: the function calls itself without end.`,
      hint: 'A walk that calls itself needs to know where it began, and to stop there.',
      line,
      steps: stepsOf(asked.mesh, reads),
    });
  }
  // Where the walk stands at each turn: what it came to last before.
  const stops = turns.flatMap((count) => stepsOf(asked.mesh, reads.slice(0, count)).slice(-1));
  const subject = subjectOf(asked);
  const walked = stops.map(({ item }) => item.index);
  const [first] = subject?.kind === 'halfedge' ? [subject.index] : walked;
  return finding({
    code: 'endless',
    title: `The loop in line ${line} does not end.`,
    // Nobody notes what is read of arrays.
    hint: asked.task.gets === 'links' ? THROUGH_ARRAYS : roundabout(walked, first),
    line,
    steps: stops,
  });
}

const THROUGH_ARRAYS =
  'What changes from turn to turn? A walk along links that were changed may go elsewhere than before, and never come back.';

/** The halfedges between which a walk goes to and fro, as a sentence. */
function roundabout(walked: readonly number[], first: number): string {
  if (new Set(walked).size < 2) {
    return walked.length === 0
      ? 'It asks the mesh for no next halfedge: what changes from turn to turn?'
      : `It stays at h${walked[0]}: what takes it to the next halfedge?`;
  }
  const again = walked.lastIndexOf(walked[walked.length - 1], walked.length - 2);
  if (again < 0) return 'It goes on from halfedge to halfedge, and never looks whether it is back.';
  const lap = walked.slice(again, -1);
  const names = lap.slice(0, 8).map((h) => `h${h}`);
  const round = `It goes round and round over ${names.join(', ')}${lap.length > 8 ? ', …' : ''}`;
  return lap.includes(first)
    ? `${round}, past h${first}, where it began: compare the halfedge with the first one, after each step.`
    : `${round}, and never comes back to h${first}, where it began: does each step stay in the walk that was meant?`;
}

/** For a worker that was ended because nothing came from it. */
export function judgeSilence(limit: number): Finding {
  return finding({
    code: 'too-slow',
    title: `Nothing came for ${limit / 1000} seconds, and the program was ended.`,
    hint: 'It is busy with something that does not end, or is far too long.',
  });
}

function place(line: number | null): string {
  return line === null ? 'The code stops with an error' : `Line ${line}`;
}

function withStop(message: string): string {
  return /[.!?]$/.test(message) ? message : `${message}.`;
}
