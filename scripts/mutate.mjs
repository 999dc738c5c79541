// `npm run mutate`: deletes or negates the statements of the operations, one by one, and tells which
// of these mutants the C++ tests don't notice.
//
//   npm run mutate -- [files] [--limit N] [--seed S] [--jobs N] [--list]
//
// files    of src/halfedge, or folders there such as mend; by default operations, decorator,
//          history and attributes
// --limit  so many mutants of each file, chosen by the seed
// --list   prints the mutants and stops
//
// A mutant that doesn't compile isn't counted; one that doesn't end counts as noticed. Survivors that
// no test can notice stand in scripts/mutate/explained.json, each with the reason. Ctrl-C stops, and
// reports what was tried.

import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join, relative, resolve } from 'node:path';
import { performance } from 'node:perf_hooks';
import process, { argv } from 'node:process';
import { parseArgs } from 'node:util';
import { cppFiles } from './lib/files.mjs';
import { asProgram, Failure, root } from './lib/run.mjs';
import { applied, findMutants } from './mutate/find.mjs';
import { Laboratory } from './mutate/laboratory.mjs';
import { inParallel } from './mutate/workshop.mjs';

const folders = ['operations', 'decorator', 'history', 'attributes'];

function readOptions() {
  const { values, positionals } = parseArgs({
    args: argv.slice(2),
    allowPositionals: true,
    options: {
      limit: { type: 'string' },
      seed: { type: 'string', default: '1' },
      jobs: { type: 'string', default: '2' },
      list: { type: 'boolean', default: false },
    },
  });
  const number = (name) => {
    const value = Number(values[name] ?? Infinity);
    if (value > 0) return value;
    throw new Failure(`--${name} is ${values[name]}, expected a positive number.`);
  };
  return {
    files: positionals,
    limit: number('limit'),
    seed: number('seed'),
    jobs: number('jobs'),
    list: values.list,
  };
}

/** The files to mutate, as paths from the root. */
function chosenFiles(named) {
  const isFolder = (name) => existsSync(join(root, 'src/halfedge', name));
  const files = named.flatMap((path) =>
    isFolder(path) ? cppFiles(join('src/halfedge', path)) : [resolve(path)],
  );
  const paths = [...new Set(files.map((path) => relative(root, path)))];
  const missing = paths.find((path) => !existsSync(join(root, path)));
  if (missing !== undefined) throw new Failure(`There is no file ${missing}.`);
  if (paths.length > 0) return paths;
  const all = cppFiles(...folders.map((folder) => join('src/halfedge', folder)));
  return all.map((path) => relative(root, path));
}

/** `count` of the items, chosen by a seed, in their order. */
function sample(items, count, seed) {
  const keyed = items.map((item, index) => {
    // A multiplicative hash of index and seed is all the chance that is needed.
    let key = Math.imul(index + 1, 0x9e3779b1) ^ Math.imul(seed, 0x85ebca6b);
    key = Math.imul(key ^ (key >>> 15), 0x2c1b3c6d);
    return { item, index, key: (key ^ (key >>> 13)) >>> 0 };
  });
  const chosen = keyed.sort((a, b) => a.key - b.key).slice(0, count);
  return chosen.sort((a, b) => a.index - b.index).map(({ item }) => item);
}

function printTable(rows) {
  console.log('\n| file | mutants | noticed | of them by not ending | explained | survived |');
  console.log('|---|--:|--:|--:|--:|--:|');
  const sum = { mutants: 0, noticed: 0, timeouts: 0, explained: 0, survived: 0 };
  const line = (name, row) =>
    `| ${name} | ${row.mutants} | ${row.noticed} (${Math.round((100 * row.noticed) / Math.max(1, row.mutants - row.explained))} %) | ${row.timeouts} | ${row.explained} | ${row.survived} |`;
  for (const [file, row] of rows) {
    if (row.mutants === 0) continue;
    console.log(line(file.replace('src/halfedge/', ''), row));
    for (const key of Object.keys(sum)) sum[key] += row[key];
  }
  console.log(line('all', sum));
  return sum;
}

/** All mutants of the sources that are to be tried. */
function chosenMutants(sources, { limit, seed }) {
  return [...sources].flatMap(([file, text]) =>
    sample(findMutants(text), limit, seed).map((mutant) => ({ file, ...mutant })),
  );
}

const describe = (mutant) => `${mutant.file}:${mutant.line}: ${mutant.kind}: ${mutant.text}`;

/** Gives each mutant its outcome, until Ctrl-C: then those underway are the last. */
async function tryAll(mutants, sources, { jobs, minutes }) {
  const explained = JSON.parse(readFileSync(join(root, 'scripts/mutate/explained.json'), 'utf8'));
  const laboratory = new Laboratory(jobs);
  await laboratory.prepare(new Set(mutants.map(({ file }) => file)), console.log);
  console.log(`${mutants.length} mutants of ${sources.size} files (${minutes()})`);
  let tried = 0;
  let isStopped = false;
  process.once('SIGINT', () => {
    isStopped = true;
    console.log('stopping after those underway');
  });
  await inParallel(mutants, jobs, async (mutant, worker) => {
    if (isStopped) return;
    const text = applied(sources.get(mutant.file), mutant);
    Object.assign(mutant, await laboratory.try(mutant.file, text, worker));
    if (mutant.outcome === 'survived') explain(mutant, explained);
    ++tried;
    if (mutant.outcome === 'survived') console.log(`survived: ${describe(mutant)}`);
    if (tried % 25 === 0) console.log(`${tried} of ${mutants.length} (${minutes()})`);
  });
}

/** Notes the reason of a survivor that no test can notice. */
function explain(mutant, explained) {
  const entry = explained.find(
    ({ file, kind, text }) => mutant.file === file && mutant.kind === kind && mutant.text === text,
  );
  if (entry) Object.assign(mutant, { outcome: 'explained', reason: entry.reason });
}

/** How many of each outcome there are, by file; those that don't compile aren't counted. */
function tally(files, done) {
  const rows = new Map(
    files.map((file) => [file, { mutants: 0, noticed: 0, timeouts: 0, explained: 0, survived: 0 }]),
  );
  for (const { file, outcome } of done) {
    if (outcome === 'invalid') continue;
    const row = rows.get(file);
    row.mutants += 1;
    row.timeouts += outcome === 'timeout' ? 1 : 0;
    row[outcome === 'timeout' ? 'noticed' : outcome] += 1;
  }
  return rows;
}

await asProgram(async () => {
  const options = readOptions();
  const files = chosenFiles(options.files);
  const sources = new Map(files.map((file) => [file, readFileSync(join(root, file), 'utf8')]));
  const mutants = chosenMutants(sources, options);
  if (options.list) {
    for (const mutant of mutants) console.log(describe(mutant));
    return;
  }
  if (mutants.length === 0) throw new Failure('There is nothing to mutate in these files.');

  const start = performance.now();
  const minutes = () => `${((performance.now() - start) / 60000).toFixed(1)} min`;
  await tryAll(mutants, sources, { jobs: options.jobs, minutes });

  const done = mutants.filter(({ outcome }) => outcome !== undefined);
  const sum = printTable(tally(files, done));
  mkdirSync(join(root, 'build/reports'), { recursive: true });
  writeFileSync(join(root, 'build/reports/mutate.json'), JSON.stringify(done, undefined, 1));
  const invalid = done.length - sum.mutants;
  console.log(
    `\n${invalid} more did not compile. It took ${minutes()}; build/reports/mutate.json has all.`,
  );
  for (const mutant of done) {
    if (mutant.outcome === 'survived') console.log(`survived: ${describe(mutant)}`);
  }
  if (sum.survived > 0) throw new Failure(`${sum.survived} mutants were not noticed.`);
});
