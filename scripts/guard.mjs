// `npm run guard`: whether the main loops of the core still take as few instructions and cache misses as
// tests/guard/counts.json says, in multiples of what the flat baseline takes in the same run.
// Nothing is timed: callgrind counts. `--update` writes the table anew.

import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { argv } from 'node:process';
import { configurePreset } from './build.mjs';
import { compare, measures, relativeToFlat, tableOf } from './guard/compare.mjs';
import { asProgram, capture, Failure, isProgram, root, run, which } from './lib/run.mjs';
import { counts } from './lib/steps.mjs';
import { setup } from './setup.mjs';

const table = join(root, 'tests/guard/counts.json');
const report = join(root, 'build/reports/callgrind.out');

/**
 * A small cache of two levels, the same on every machine: with all data of a loop larger than it,
 * what is fetched twice counts twice.
 */
const caches = ['--cache-sim=yes', '--I1=32768,8,64', '--D1=32768,8,64', '--LL=262144,8,64'];

/**
 * Counts don't change from run to run, but with each line of code. Between g++ 12 and clang 14 some of the
 * ratios differ by 0.57 in instructions and 0.16 in misses.
 */
const tolerances = {
  sameCompiler: { instructions: 0.1, misses: 0.2 },
  otherCompiler: { instructions: 0.6, misses: 0.2 },
};

/** Counts, and compares with the table. Returns how many loops are as they should be. */
export async function guard() {
  const skipped = await whatIsMissing();
  if (skipped) {
    console.log(skipped);
    return counts(0, 0, 1);
  }
  const counted = await count();
  const stored = JSON.parse(readFileSync(table, 'utf8'));
  const { failures, gains } = compare(counted, stored, tolerances);
  for (const sentence of gains) console.log(`Cheaper now: ${sentence}`);
  if (gains.length > 0) console.log('`npm run guard -- --update` makes that the measure.');
  const passed = counted.loops.length - failures.length;
  if (failures.length === 0) return counts(passed);
  const failure = new Failure(
    `${failures.join('\n')}\nIf it has to be so, \`npm run guard -- --update\` writes the new counts ` +
      `into tests/guard/counts.json.`,
  );
  failure.counts = counts(passed, failures.length);
  throw failure;
}

async function update() {
  const missing = await whatIsMissing();
  if (missing) throw new Failure(missing);
  const { compiler, loops } = await count();
  writeFileSync(table, `${JSON.stringify(tableOf(compiler, loops), null, 2)}\n`);
  print(loops);
}

/** A sentence, if this machine can't count. */
async function whatIsMissing() {
  if (!which('valgrind')) return 'Skipped: there is no valgrind here, which counts instructions.';
  return undefined;
}

/** Builds the loops and counts them. */
async function count() {
  await configurePreset('release');
  await run('cmake', ['--build', '--preset', 'release', '--target', 'halfedge_guard']);
  mkdirSync(join(root, 'build/reports'), { recursive: true });
  rmSync(report, { force: true });
  const { ok, output } = await capture('valgrind', [
    '--tool=callgrind',
    '--quiet',
    '--instr-atstart=no',
    '--combine-dumps=yes',
    `--callgrind-out-file=${report}`,
    ...caches,
    join(root, 'build/release/tests/guard/halfedge_guard'),
  ]);
  if (!ok || !existsSync(report)) throw new Failure(`${output}\nvalgrind has counted nothing.`);
  const lines = output.split('\n').map((line) => line.split('\t'));
  const [[, compiler], ...rows] = lines.filter(({ length }) => length > 1);
  const loops = rows.map(([whose, name, yardstick, faces]) => {
    return { whose, name, yardstick, faces: Number(faces) };
  });
  return { compiler, loops: relativeToFlat({ loops, counts: readCounts() }) };
}

/** The sums of callgrind's report, by the title of the loop. */
function readCounts() {
  const byTitle = new Map();
  let title;
  let events = [];
  for (const line of readFileSync(report, 'utf8').split('\n')) {
    const [, key, value] = /^(desc: Trigger|events|totals): (.*)$/.exec(line) ?? [];
    if (key === 'desc: Trigger') title = value.replace('Client Request: ', '');
    else if (key === 'events') events = value.split(' ');
    else if (key === 'totals') {
      const sums = value.split(' ').map(Number);
      const of = (event) => sums[events.indexOf(event)] ?? 0;
      byTitle.set(title, { instructions: of('Ir'), misses: of('DLmr') + of('DLmw') });
    }
  }
  return byTitle;
}

/** All counts, as a table in Markdown. */
function print(loops) {
  console.log(
    `| loop | ${Object.values(measures).join(' a face | of flat | ')} a face | of flat |`,
  );
  console.log('|---|---:|---:|---:|---:|');
  for (const { name, perFace, ofFlat } of loops) {
    const cells = Object.keys(measures).flatMap((measure) => [
      perFace[measure].toPrecision(3),
      `${ofFlat[measure].toPrecision(3)}×`,
    ]);
    console.log(`| ${name} | ${cells.join(' | ')} |`);
  }
}

if (isProgram(import.meta.url)) {
  await asProgram(async () => {
    await setup(['build', 'tests']);
    if (argv.includes('--update')) return update();
    const { passed } = await guard();
    if (passed > 0) console.log(`${passed} loops are as cheap as the table says.`);
  });
}
