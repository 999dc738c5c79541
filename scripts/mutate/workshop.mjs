// A copy of the sources below build/mutate, compiled there: quickly, without optimisation, and anew
// only where a file has changed since the last time.

import { spawn } from 'node:child_process';
import {
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  rmSync,
  statSync,
  writeFileSync,
} from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { filesBelow } from '../lib/files.mjs';
import { Failure, root, which } from '../lib/run.mjs';

export const folder = join(root, 'build/mutate');
/** Everything is compiled in here, so that paths are relative to it. */
export const tree = join(folder, 'tree');

/** clang++ takes half the time of g++ for what isn't optimised. */
const compiler = which('clang++') ? 'clang++' : 'g++';
const flags = ['-std=c++20', '-O0', '-g0', '-w', '-fno-exceptions'];
const definitions = [
  `-DHALFEDGE_TEST_DIR="${join(root, 'tests')}"`,
  `-DHALFEDGE_DATA_DIR="${join(root, '../shared/data')}"`,
];
const prelude = 'prelude.h'; // what all test programs include
const precompiled = `${prelude}.${compiler === 'g++' ? 'gch' : 'pch'}`;

/** Runs a program niced, with a limit of time and memory. `status` is 'timeout' if that ended it. */
export function execute(command, args, seconds) {
  return new Promise((resolve, reject) => {
    const limited = ['-c', 'ulimit -S -v 4000000; exec nice "$0" "$@"', command, ...args];
    const stdio = ['ignore', 'pipe', 'pipe'];
    const env = { ...process.env, HALFEDGE_RANDOM_STEPS: '150' }; // of random sequences: fewer
    const child = spawn('sh', limited, { cwd: tree, env, stdio, detached: true });
    let output = '';
    let timedOut = false;
    for (const stream of [child.stdout, child.stderr]) {
      stream.setEncoding('utf8').on('data', (text) => {
        if (output.length < 100_000) output += text;
      });
    }
    const timer = setTimeout(() => {
      timedOut = true;
      process.kill(-child.pid, 'SIGKILL');
    }, 1000 * seconds);
    child.on('error', reject);
    child.on('close', (code) => {
      clearTimeout(timer);
      resolve({ status: timedOut ? 'timeout' : code, output });
    });
  });
}

/** Calls `each` with every item, `jobs` at a time; each of these workers has a number. */
export async function inParallel(items, jobs, each) {
  const waiting = [...items];
  const worker = async (number) => {
    while (waiting.length > 0) await each(waiting.shift(), number);
  };
  await Promise.all(Array.from({ length: jobs }, (_, number) => worker(number)));
}

/** Brings the copy up to date. */
export async function copySources() {
  const parts = ['src', 'tests/cpp'];
  for (const part of parts) {
    for (const path of filesBelow(join(root, part))) {
      const copy = join(tree, relative(root, path));
      const text = readFileSync(path);
      if (existsSync(copy) && readFileSync(copy).equals(text)) continue;
      mkdirSync(dirname(copy), { recursive: true });
      writeFileSync(copy, text);
    }
    for (const copy of filesBelow(join(tree, part))) {
      if (!existsSync(join(root, relative(tree, copy)))) rmSync(copy);
    }
  }
  if (existsSync(join(tree, precompiled))) return;
  writeFileSync(join(tree, prelude), '#include <gtest/gtest.h>\n');
  await compile(['-x', 'c++-header', prelude, '-o', precompiled], 'The header of GoogleTest');
}

/** Paths below a folder of the copy, from the root of the copy. */
export const sourcesBelow = (part) =>
  readdirSync(join(tree, part), { recursive: true })
    .filter((path) => path.endsWith('.cpp'))
    .map((path) => join(part, path));

/** Whether it compiles. With `what`, a name for it, it has to. */
async function compile(args, what) {
  const { status, output } = await execute(compiler, [...flags, ...definitions, ...args], 600);
  if (status !== 0 && what) throw new Failure(`${what} did not compile:\n${output}`);
  return status === 0;
}

const argumentsFor = (path) =>
  path.startsWith('tests/') ? ['-Isrc', '-Itests/cpp', '-include', prelude] : ['-Isrc'];

/** Compiles an unchanged source if that is not done yet: `{ path, object, depends }`. */
export async function compileUnchanged(path) {
  const object = join('objects', `${path.replaceAll('/', '.')}.o`);
  const list = object.replace(/o$/, 'd');
  mkdirSync(join(tree, 'objects'), { recursive: true });
  const isNewer = (file) =>
    !existsSync(join(tree, file)) ||
    statSync(join(tree, file)).mtimeMs > statSync(join(tree, object)).mtimeMs;
  if (!existsSync(join(tree, object)) || [...dependencies(list)].some(isNewer)) {
    const args = ['-MD', '-MF', list, ...argumentsFor(path), '-c', path, '-o', object];
    await compile(args, path);
  }
  return { path, object, depends: dependencies(list) };
}

/** The files of the copy that a list of dependencies of the compiler names. */
function dependencies(list) {
  const words = readFileSync(join(tree, list), 'utf8').replace(/\\\n/g, ' ').split(/\s+/);
  return new Set(words.filter((word) => /^(?:src|tests)\//.test(word) || word === prelude));
}

/** Compiles a source with the files below `place` in place of those of the copy. */
export function compileWith(place, path, object) {
  const mutated = join(place, path);
  const text = existsSync(mutated) ? mutated : path;
  return compile(['-I', join(place, 'src'), ...argumentsFor(path), '-c', text, '-o', object]);
}

/** The library, which is linked after the objects of a program. */
export async function archive(objects) {
  rmSync(join(tree, 'library.a'), { force: true });
  await execute('ar', ['rcs', 'library.a', ...objects], 60);
}

export function link(objects, path, what) {
  return compile(
    [...objects, 'library.a', '-lgtest', '-lgtest_main', '-pthread', '-o', path],
    what,
  );
}
