// `npm run fuzz`: names the fuzz targets. `npm run fuzz -- soup --minutes 10` runs one of them (or
// several, or `all`) for so long each; what it has learnt stays in build/fuzz. `npm run fuzz -- soup
// <file>` tries one input, and `npm run fuzz -- soup --minimize <file>` makes it smaller. The target
// gltf is tests/fuzz/gltf.fuzz.ts, which Jest runs with other seeds each time.

import { existsSync, mkdirSync } from 'node:fs';
import { basename, join, relative, resolve } from 'node:path';
import { argv } from 'node:process';
import { parseArgs } from 'node:util';
import { configurePreset } from './build.mjs';
import { filesBelow } from './lib/files.mjs';
import { asProgram, Failure, root, run } from './lib/run.mjs';
import { setup } from './setup.mjs';

const folder = join(root, 'tests/fuzz');
const native = filesBelow(folder)
  .filter((path) => path.endsWith('.cpp') && resolve(path, '..') === folder)
  .map((path) => basename(path, '.cpp'));
const targets = [...native, 'gltf'];

/** What is checked step by step gets short inputs, or it is slow. */
const longest = { mend: 512, operations: 400, soup: 1024 };

const program = (target) => join(root, 'build/asan/tests/fuzz', `fuzz_${target}`);

async function buildTargets(names) {
  await configurePreset('asan');
  const programs = names.map((name) => `fuzz_${name}`);
  await run('cmake', ['--build', '--preset', 'asan', '--target', ...programs]);
}

/** Runs one target. Its corpus grows from run to run; an input that fails is kept, and named. */
async function fuzz(target, seconds) {
  const learnt = join(root, 'build/fuzz', target);
  const failures = join(root, 'build/fuzz/failures', target);
  for (const path of [learnt, failures]) mkdirSync(path, { recursive: true });
  console.log(`\n${target}: ${seconds} s; inputs that fail go to ${relative(root, failures)}/`);
  const dictionary = join(folder, 'dictionaries', `${target}.dict`);
  await run(program(target), [
    `-max_total_time=${seconds}`,
    `-max_len=${longest[target] ?? 4096}`,
    ...(existsSync(dictionary) ? [`-dict=${dictionary}`] : []),
    ...['-timeout=20', '-rss_limit_mb=1024', '-print_final_stats=1', '-use_value_profile=1'],
    `-artifact_prefix=${failures}/`,
    learnt,
    join(folder, 'corpus', target),
  ]);
}

/** Files that are nearly glTF, through Jest: with what dist/ holds. */
async function fuzzGltf(seconds) {
  const seed = String(Date.now() % 1e6);
  console.log(`\ngltf: ${seconds} s from seed ${seed} on`);
  const jest = ['node_modules/jest/bin/jest.js', '--selectProjects', 'fuzz'];
  await run(process.execPath, ['--experimental-vm-modules', '--no-warnings', ...jest], {
    env: { HALFEDGE_FUZZ_SECONDS: String(seconds), HALFEDGE_FUZZ_SEED: seed },
  });
}

await asProgram(async () => {
  const { values, positionals } = parseArgs({
    args: argv.slice(2),
    allowPositionals: true,
    options: { minutes: { type: 'string', default: '1' }, minimize: { type: 'string' } },
  });
  const seconds = Math.round(60 * Number(values.minutes));
  if (!(seconds > 0)) {
    throw new Failure(`--minutes is ${values.minutes}, expected a number above 0.`);
  }
  const inputs = positionals.filter((name) => name !== 'all' && !targets.includes(name));
  const unknown = inputs.filter((path) => !existsSync(path));
  if (positionals.length === 0 || unknown.length > 0) {
    const what = unknown.length > 0 ? `There is no target or file ${unknown}. ` : '';
    throw new Failure(`${what}The targets are ${targets.join(', ')}, and all.`);
  }
  const names = positionals.includes('all')
    ? targets
    : positionals.filter((name) => targets.includes(name));
  if (names.length === 0) throw new Failure(`Name a target: ${targets.join(', ')}.`);

  await setup(['build', 'tests']);
  const toBuild = names.filter((name) => native.includes(name));
  if (toBuild.length > 0) await buildTargets(toBuild);
  for (const name of names) {
    if (name === 'gltf') {
      await fuzzGltf(seconds);
      continue;
    }
    if (values.minimize) {
      const smaller = `${values.minimize}.smaller`;
      const options = ['-minimize_crash=1', `-exact_artifact_path=${smaller}`];
      await run(program(name), [...options, `-max_total_time=${seconds}`, values.minimize]);
      console.log(`The smallest input that fails is ${smaller}.`);
    } else if (inputs.length > 0) {
      await run(program(name), inputs);
    } else {
      await fuzz(name, seconds);
    }
  }
});
