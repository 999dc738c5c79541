// Runs the tests against mutants.
//
// Each test file is a program of its own. A mutant is tried by the programs that include the mutated
// file, until one fails: first those named after it, then those that noticed most of the mutants
// before. The mutated file lies in a folder that comes before the copy on the include path, so that
// nothing but that one file differs.

import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { performance } from 'node:perf_hooks';
import { Failure } from '../lib/run.mjs';
import {
  archive,
  compileUnchanged,
  compileWith,
  copySources,
  execute,
  folder,
  inParallel,
  link,
  sourcesBelow,
  tree,
} from './workshop.mjs';

const tests = 'tests/cpp';
/** What is mutated by default is tested together. */
const together = ['operations', 'decorator', 'history', 'attributes'];
/** A test file of what is mutated, by what it includes or by its name. */
function isAbout(folders, name, text) {
  const includes = [...text.matchAll(/<halfedge\/(\w+)\//g)].map(([, folder]) => folder);
  if ([...includes, name.replace(/_.*/, '')].some((folder) => folders.has(folder))) return true;
  const isOfFile = [...folders].some((folder) => existsSync(sourceOf(folder, name)));
  return isOfFile || (folders.has('operations') && /"random\//.test(text));
}
/** The header in `folder` that a test file is named after, if there is one: reorder_test.cpp. */
const sourceOf = (folder, name) =>
  join(tree, 'src/halfedge', folder, name.replace('_test.cpp', '.h'));
/** The sources beside the headers in `support` that a test includes, where there are any. */
const supportOf = (text) =>
  [...text.matchAll(/"(support\/\w+)\.h"/g)]
    .map(([, header]) => `${tests}/${header}.cpp`)
    .filter((path) => existsSync(join(tree, path)));
/** They take long, and are about something else. */
const leftOut = /_(?:scale|data)_test\.cpp$/;

const run = (program, seconds) =>
  execute(program, ['--gtest_fail_fast', '--gtest_brief=1'], seconds);

export class Laboratory {
  #jobs;
  /** name -> { sources: [{ path, object, depends }], seconds, noticed } */
  #programs = new Map();
  /** The sources of the library. */
  #library = [];

  constructor(jobs) {
    this.#jobs = jobs;
  }

  /** Builds the library and all programs, and sees them pass. Each of `files` has to be tested. */
  async prepare(files, log) {
    await copySources();
    const sources = sourcesBelow('src');
    log(`building the library (${sources.length} files)`);
    await inParallel(sources, this.#jobs, async (path) => {
      this.#library.push(await compileUnchanged(path));
    });
    await archive(this.#library.map(({ object }) => object));
    this.#findPrograms(files);
    log(`building ${this.#programs.size} test programs`);
    const parts = [...this.#programs.values()].flatMap((program) => program.sources);
    await inParallel(parts, this.#jobs, async (part) => {
      Object.assign(part, await compileUnchanged(part.path));
    });
    log('running them unchanged');
    await inParallel([...this.#programs], this.#jobs, async ([name, program]) => {
      const path = join(tree, name);
      await link(
        program.sources.map(({ object }) => object),
        path,
        name,
      );
      const start = performance.now();
      const { status, output } = await run(path, 300);
      program.seconds = (performance.now() - start) / 1000;
      if (status !== 0) throw new Failure(`${name} fails without a mutant:\n${output}`);
    });
    for (const file of files) {
      if (this.#programsFor(file).length === 0) throw new Failure(`No test includes ${file}.`);
    }
  }

  #findPrograms(files) {
    const folders = new Set([...files].map((file) => basename(dirname(file))));
    if (together.some((folder) => folders.has(folder))) {
      for (const folder of together) folders.add(folder);
    }
    const shared = existsSync(join(tree, tests, 'random')) ? sourcesBelow(`${tests}/random`) : [];
    for (const name of readdirSync(join(tree, tests))) {
      if (!name.endsWith('_test.cpp') || leftOut.test(name)) continue;
      const text = readFileSync(join(tree, tests, name), 'utf8');
      if (!isAbout(folders, name, text)) continue;
      const paths = [
        `${tests}/${name}`,
        ...(text.includes('"random/') ? shared : []),
        ...supportOf(text),
      ];
      const sources = paths.map((path) => ({ path }));
      this.#programs.set(basename(name, '_test.cpp'), { sources, noticed: 0 });
    }
  }

  /**
   * What becomes of a mutant of `file` whose text is `text`: `{ outcome, by }`. The outcome is
   * 'noticed' by the program `by`, 'timeout' which is noticed as well, 'survived', or 'invalid' if
   * it doesn't compile.
   */
  async try(file, text, worker) {
    const place = join(folder, `worker-${worker}`);
    rmSync(place, { recursive: true, force: true });
    mkdirSync(dirname(join(place, file)), { recursive: true });
    writeFileSync(join(place, file), text);

    const compiled = new Map(); // path -> object
    const compileOnce = async (path) => {
      const object = join(place, `${path.replaceAll('/', '.')}.o`);
      if (!compiled.has(path)) compiled.set(path, await compileWith(place, path, object));
      return compiled.get(path) && object;
    };
    const changed = [];
    for (const path of this.#librarySourcesOf(file)) {
      const object = await compileOnce(path);
      if (!object) return { outcome: 'invalid' };
      changed.push(object);
    }
    for (const [name, program] of this.#programsFor(file)) {
      const objects = [...changed];
      for (const source of program.sources) {
        const object = source.depends.has(file) ? await compileOnce(source.path) : source.object;
        if (!object) return { outcome: 'invalid' };
        objects.unshift(object);
      }
      const executable = join(place, 'test');
      if (!(await link(objects, executable))) return { outcome: 'invalid' };
      const { status } = await run(executable, Math.max(10, 10 * program.seconds));
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
    const likely = ([name, program]) =>
      (name.endsWith('_memory') ? -1000 : 0) + // seldom what is missing
      (name.includes(stem) ? 1000 : 0) +
      (name.startsWith(part) ? 500 : 0) +
      program.noticed;
    const isSource = file.endsWith('.cpp');
    return [...this.#programs]
      .filter(([, { sources }]) => isSource || sources.some(({ depends }) => depends.has(file)))
      .sort((a, b) => likely(b) - likely(a) || a[1].seconds - b[1].seconds);
  }

  /**
   * The sources of the library that are compiled anew. Where many include a header, those beside it, and
   * what the tests instantiate of it: that comes first when they are linked.
   */
  #librarySourcesOf(file) {
    const found = this.#library.filter(({ depends }) => depends.has(file));
    const beside = found.filter(({ path }) => dirname(path) === dirname(file));
    return (found.length <= 3 ? found : beside).map(({ path }) => path);
  }
}
