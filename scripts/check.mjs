// `npm run check`: formatting, lint and types of both languages, and whether the pages of docs/reference are those of
// the docstrings. `npm run format` (`--fix`) mends the formatting instead.

import { mkdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import os from 'node:os'; // by name, a Node too old to have it would tell of that alone
import { join } from 'node:path';
import { argv } from 'node:process';
import { build, configurePreset } from './build.mjs';
import { cppFiles } from './lib/files.mjs';
import { asProgram, capture, Failure, isProgram, root, run } from './lib/run.mjs';
import { counts, Steps } from './lib/steps.mjs';
import { setup } from './setup.mjs';

const cppFolders = ['src', 'wasm', 'tests', 'bench', 'examples'];
const biome = 'node_modules/@biomejs/biome/bin/biome';
const colors = process.stdout.isTTY ? 'force' : 'off';
const tsc = 'node_modules/typescript/bin/tsc';

/** Adds the checks to a run of steps. The types of the tests are those of the built package. */
export async function check(steps) {
  await steps.run('Format of C++ (clang-format)', () =>
    run('clang-format', ['--dry-run', '-Werror', ...cppFiles(...cppFolders)]),
  );
  await steps.run('Format and lint of TypeScript (Biome)', () =>
    run(process.execPath, [biome, 'ci', '--error-on-warnings', `--colors=${colors}`, '.']),
  );
  await steps.run('Types (tsc)', async () => {
    await run(process.execPath, [tsc, '-p', 'tsconfig.build.json', '--noEmit']);
    await run(process.execPath, [tsc, '-p', 'tsconfig.cli.json', '--noEmit']);
    await run(process.execPath, [tsc, '-p', 'tsconfig.json']);
  });
  await steps.run('Reference and docstrings', async () => {
    const { checkReference } = await import('./reference.mjs'); // it takes packages, which are there by now
    return counts(checkReference());
  });
  await steps.run('Lint of C++ (clang-tidy)', clangTidy);
}

/** Formats everything, and mends what Biome can mend safely. */
export async function format() {
  await run('clang-format', ['-i', ...cppFiles(...cppFolders)]);
  await run(process.execPath, [biome, 'check', '--write', '.']);
}

/**
 * Lints the core, as many folders at a time as there are processors: the preset compiles the files of one
 * together, and headers take most of the time.
 */
async function clangTidy() {
  await configurePreset('asan');
  const folders = commandsOfTheCore()
    .map(({ file }) => file)
    .sort((a, b) => statSync(a).size - statSync(b).size);
  if (folders.length === 0) throw new Failure('There are no C++ sources to lint.');
  const jobs = [
    ...sourcesWithUsing().map((path) => [path, `--checks=-*,${ofTheFileAlone}`]),
    // What stands for a folder includes sources.
    ...folders.map((path) => [path, '--checks=-bugprone-suspicious-include']),
  ];
  const count = jobs.length;
  const complaints = [];
  const worker = async () => {
    for (let job = jobs.pop(); job !== undefined; job = jobs.pop()) {
      const { ok, output } = await capture('clang-tidy', ['-p', lintFolder, '--quiet', ...job]);
      if (!ok) complaints.push(withoutCounts(output));
    }
  };
  await Promise.all(Array.from({ length: os.availableParallelism() }, worker));
  if (complaints.length === 0) return counts(count);
  console.log(complaints.join('\n'));
  const failure = new Failure(`clang-tidy objects in ${complaints.length} of ${count} runs.`);
  failure.counts = counts(count - complaints.length, complaints.length);
  throw failure;
}

const lintFolder = 'build/asan/lint';

/**
 * How the folders of the core are compiled, written to where clang-tidy looks: a single source is in no list, and
 * it takes the command of the file with the name most alike, which must not be a test with a precompiled header.
 */
function commandsOfTheCore() {
  const all = JSON.parse(readFileSync(join(root, 'build/asan/compile_commands.json'), 'utf8'));
  const core = all.filter(({ file }) => file.includes('/halfedge.dir/Unity/'));
  mkdirSync(join(root, lintFolder), { recursive: true });
  writeFileSync(join(root, lintFolder, 'compile_commands.json'), JSON.stringify(core));
  return core;
}

/** The checks that look at the file that clang-tidy is given, and not at what that includes. */
const ofTheFileAlone = 'misc-unused-alias-decls,misc-unused-using-decls';

/** The sources in which those checks can find something. */
function sourcesWithUsing() {
  return cppFiles('src').filter(
    (path) =>
      path.endsWith('.cpp') &&
      /^\s*(using [\w:]+;|namespace \w+ = )/m.test(readFileSync(path, 'utf8')),
  );
}

/** clang-tidy counts the warnings of system headers, which it doesn't show. */
function withoutCounts(output) {
  return output
    .split('\n')
    .filter((line) => !/^(\d+ warnings?.* generated|Suppressed \d+|Use -header-filter)/.test(line))
    .join('\n');
}

if (isProgram(import.meta.url)) {
  await asProgram(async () => {
    await setup(['build', 'tests']);
    if (argv[2] === '--fix') return format();
    await build();
    const steps = new Steps();
    await check(steps);
    if (!steps.close()) process.exitCode = 1;
  });
}
