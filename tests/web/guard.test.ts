// The script behind `npm run guard` tells which loops have become dearer, and only those.

import { compare, relativeToFlat, tableOf } from '../../scripts/guard/compare.mjs';

const tolerances = {
  sameCompiler: { instructions: 0.1, misses: 0.2 },
  otherCompiler: { instructions: 0.5, misses: 0.2 },
};

const line = (whose: string, name: string) => ({ whose, name, yardstick: 'build', faces: 100 });

/** A run in which our build takes so many instructions and misses, and the baseline's 2000 and 100. */
function runOf(instructions: number, misses = 200, compiler = 'g++ 12') {
  const loops = [line('flat', 'build'), line('halfedge', 'build'), line('halfedge', 'validate')];
  const counts = new Map([
    ['flat: build', { instructions: 2000, misses: 100 }],
    ['halfedge: build', { instructions, misses }],
    ['halfedge: validate', { instructions: 500, misses: 50 }],
  ]);
  return { compiler, loops: relativeToFlat({ loops, counts }) };
}

const table = tableOf('g++ 12', runOf(3000).loops);

test('the table holds multiples of the flat baseline', () => {
  expect(table).toEqual({
    compiler: 'g++ 12',
    loops: {
      build: { instructions: 1.5, misses: 2 },
      validate: { instructions: 0.25, misses: 0.5 },
    },
  });
});

test('the same counts, and counts within the tolerance, pass', () => {
  expect(compare(runOf(3000), table, tolerances)).toEqual({ failures: [], gains: [] });
  expect(compare(runOf(3290, 239), table, tolerances)).toEqual({ failures: [], gains: [] });
  expect(compare(runOf(2800), table, tolerances)).toEqual({ failures: [], gains: [] });
});

test('more instructions fail with the loop, what was measured and what is allowed', () => {
  expect(compare(runOf(3400), table, tolerances).failures).toEqual([
    '"build" takes 34.0 instructions a face, 1.70 times what "build" of the flat baseline takes; ' +
      'allowed is 1.65 (1.5 and 10 %).',
  ]);
});

test('more cache misses fail', () => {
  expect(compare(runOf(3000, 250), table, tolerances).failures).toEqual([
    '"build" takes 2.50 cache misses a face, 2.50 times what "build" of the flat baseline takes; ' +
      'allowed is 2.40 (2 and 20 %).',
  ]);
});

test('another compiler is allowed more instructions, not more misses', () => {
  expect(compare(runOf(4000, 200, 'g++ 13'), table, tolerances).failures).toEqual([]);
  expect(compare(runOf(4600, 200, 'g++ 13'), table, tolerances).failures).toHaveLength(1);
  expect(compare(runOf(3000, 250, 'g++ 13'), table, tolerances).failures).toHaveLength(1);
});

test('far fewer instructions are told as a gain', () => {
  const { failures, gains } = compare(runOf(2000), table, tolerances);
  expect(failures).toEqual([]);
  expect(gains).toEqual([expect.stringContaining('1.00 times')]);
});

test('a loop that only one of them has fails', () => {
  const { validate, ...loops } = table.loops;
  const missing = { ...table, loops: { ...loops, circulator: validate } };
  expect(compare(runOf(3000), missing, tolerances).failures).toEqual([
    '"validate" is not in the table.',
    '"circulator" is no longer counted.',
  ]);
});
