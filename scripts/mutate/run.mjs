// Builds and runs the tests against mutants, in a copy of the sources below build/mutate.
//
// Each test file is a program of its own. A mutant is tried by the programs whose sources include
// the mutated file, until one fails: first those named after it and those that noticed most of the
// mutants before. The mutated header lies in a folder that comes before the copy on the include
// path, so that nothing but that one file differs.

import { spawn } from 'node:child_process';
import {
  cpSync,
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { performance } from 'node:perf_hooks';
import { Failure, root } from '../lib/run.mjs';

const folder = join(root, 'build/mutate');
const tree = join(folder, 'tree');
const flags = ['-std=c++20', '-O0', '-g0', '-w', '-fno-exceptions'];
const definitions = [
  `-DHALFEDGE_TEST_DIR="${join(root, 'tests')}"`,
  `-DHALFEDGE_DATA_DIR="${join(root, '../shared/data')}"`,
];

/** The test programs, by the names of their files: those of what is mutated. */
const testFiles = /^(?:operations|decorator|history|attributes)\w*_test\.cpp$/;
const leftOut = /_(?:memory|scale)_test\.cpp$/;

/** Runs a program niced, with a limit of time and memory. `status` is 'timeout' if that ended it. */
function execute(command, args, seconds) {
  return new Promise((resolve, reject) => {
    const limited = ['-c', 'ulimit -v 4000000; exec nice "$0" "$@"', command, ...args];
    const child = spawn('sh', limited, {
      cwd: tree,
      stdio: ['ignore', 'pipe', 'pipe'],
      detached: true,
    });
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

async function compile(args, what) {
  const { status, output } = await execute('g++', [...flags, ...definitions, ...args], 600);
  if (status !== 0 && what) throw new Failure(`${what} did not compile:\n${output}`);
  return status === 0;
}

/** Calls `each` with every item, `jobs` at a time; each of these workers has a number. */
export async function inParallel(items, jobs, each) {
  const waiting = [...items];
  const worker = async (number) => {
    while (waiting.length > 0) await each(waiting.shift(), number);
  };
  await Promise.all(Array.from({ length: jobs }, (_, number) => worker(number)));
}

/** The files that a compiler's list of dependencies names, below the copy. */
function dependencies(path) {
  const words = readFileSync(path, 'utf8').replace(/\\\n/g, ' ').split(/\s+/).slice(1);
  return new Set(words.filter((word) => word.startsWith('src/')));
}

export class Laboratory {
  #jobs;
  /** name -> { sources: [{ path, object, depends }], seconds, noticed } */
  #programs = new Map();

  /** source -> what it includes */
  #library = new Map();

  constructor(jobs) {
    this.#jobs = jobs;
  }

  /** Copies the sources, builds the library and all programs, and sees them pass. */
  async prepare(files, log) {
    rmSync(tree, { recursive: true, force: true });
    for (const part of ['src', 'tests/cpp']) {
      cpSync(join(root, part), join(tree, part), { recursive: true });
    }
    writeFileSync(join(tree, 'prelude.h'), '#include <gtest/gtest.h>\n');
    await compile(['-x', 'c++-header', join(tree, 'prelude.h')], 'the header of GoogleTest');
    const sources = readdirSync(join(tree, 'src'), { recursive: true }).filter((path) =>
      path.endsWith('.cpp'),
    );
    log(`building the library (${sources.length} files)`);
    const objects = [];
    await inParallel(sources, this.#jobs, async (name) => {
      const path = join('src', name);
      const object = this.#object(path);
      const list = object.replace(/o$/, 'd');
      await compile(['-MD', '-MF', list, '-Isrc', '-c', path, '-o', object], path);
      this.#library.set(path, dependencies(list));
      objects.push(object);
    });
    await execute('ar', ['rcs', join(tree, 'library.a'), ...objects], 60);

    const tests = readdirSync(join(tree, 'tests/cpp')).filter(
      (name) => testFiles.test(name) && !leftOut.test(name),
    );
    const parts = existsSync(join(tree, 'tests/cpp/random'))
      ? readdirSync(join(tree, 'tests/cpp/random')).filter((name) => name.endsWith('.cpp'))
      : [];
    for (const test of tests) {
      const text = readFileSync(join(tree, 'tests/cpp', test), 'utf8');
      const paths = [
        test,
        ...(text.includes('"random/') ? parts.map((name) => `random/${name}`) : []),
      ];
      this.#programs.set(basename(test, '_test.cpp'), {
        sources: paths.map((path) => ({ path: join('tests/cpp', path) })),
        noticed: 0,
      });
    }
    log(`building ${this.#programs.size} test programs`);
    const all = [...this.#programs.values()].flatMap((program) => program.sources);
    await inParallel(all, this.#jobs, async (source) => {
      source.object = this.#object(source.path);
      const list = source.object.replace(/o$/, 'd');
      await this.#compileTest(source.path, source.object, ['-MD', '-MF', list]);
      source.depends = dependencies(list);
    });
    log('running them unchanged');
    await inParallel([...this.#programs], this.#jobs, async ([name, program]) => {
      const path = join(tree, name);
      const used = program.sources.map((source) => source.object);
      await this.#link(used, path);
      const start = performance.now();
      const { status, output } = await this.#run(path, 300);
      program.seconds = (performance.now() - start) / 1000;
      if (status !== 0) throw new Failure(`${name} fails without a mutant:\n${output}`);
    });
    for (const file of files) {
      if (this.#programsFor(file).length === 0)
        throw new Failure(`No test program covers ${file}.`);
    }
  }

  /**
   * What becomes of a mutant of `file` whose text is `text`: `{ outcome, by }`. The outcome is
   * 'noticed' by the program `by`, 'timeout' which is noticed as well, 'survived' or 'invalid': it
   * doesn't compile.
   */
  async try(file, text, worker) {
    const place = join(folder, `worker-${worker}`);
    rmSync(place, { recursive: true, force: true });
    const path = join(place, file);
    mkdirSync(dirname(path), { recursive: true });
    writeFileSync(path, text);
    const include = ['-I', join(place, 'src')];
    const changed = [];
    for (const source of this.#librarySourcesOf(file)) {
      const object = join(place, `library.${basename(source)}.o`);
      const text = source === file ? path : source;
      if (!(await compile([...include, '-Isrc', '-c', text, '-o', object])))
        return { outcome: 'invalid' };
      changed.push(object);
    }
    for (const [name, program] of this.#programsFor(file)) {
      const objects = [...changed];
      for (const source of program.sources) {
        if (!source.depends.has(file)) {
          objects.push(source.object);
          continue;
        }
        const object = join(place, `${basename(source.path)}.o`);
        if (!existsSync(object)) {
          if (!(await this.#compileTest(source.path, object, include)))
            return { outcome: 'invalid' };
        }
        objects.push(object);
      }
      const executable = join(place, 'test');
      if (!(await this.#link(objects, executable, false))) return { outcome: 'invalid' };
      const { status } = await this.#run(executable, Math.max(10, 10 * program.seconds));
      if (status === 0) continue;
      program.noticed += 1;
      return { outcome: status === 'timeout' ? 'timeout' : 'noticed', by: name };
    }
    return { outcome: 'survived' };
  }

  /** The programs that include a file, the likeliest to notice something first. */
  #programsFor(file) {
    const stem = basename(file).replace(/\.\w+$/, '');
    const part = basename(dirname(file));
    const likely = (name, program) =>
      (name.includes(stem) ? 1000 : 0) + (name.startsWith(part) ? 500 : 0) + program.noticed;
    return [...this.#programs]
      .filter(
        ([, { sources }]) =>
          file.endsWith('.cpp') || sources.some(({ depends }) => depends.has(file)),
      )
      .sort(([a, x], [b, y]) => likely(b, y) - likely(a, x) || x.seconds - y.seconds);
  }

  /**
   * The sources of the library that are compiled anew. Where many include a header, what the tests
   * instantiate of it has to do: it comes first when they are linked.
   */
  #librarySourcesOf(file) {
    if (this.#library.has(file)) return [file];
    const found = [...this.#library].filter(([, depends]) => depends.has(file));
    return found.length <= 3 ? found.map(([path]) => path) : [];
  }

  #object(path) {
    const object = join(tree, 'objects', `${path.replaceAll('/', '.')}.o`);
    mkdirSync(dirname(object), { recursive: true });
    return object;
  }

  async #compileTest(path, object, more) {
    const args = [
      ...more,
      '-Isrc',
      '-Itests/cpp',
      '-include',
      'prelude.h',
      '-c',
      path,
      '-o',
      object,
    ];
    return compile(args, more.includes('-MD') && path);
  }

  async #link(objects, path, isNeeded = true) {
    return compile(
      [...objects, 'library.a', '-lgtest', '-lgtest_main', '-pthread', '-o', path],
      isNeeded && path,
    );
  }

  #run(path, seconds) {
    return execute(path, ['--gtest_fail_fast', '--gtest_brief=1'], seconds);
  }
}
