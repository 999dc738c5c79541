// `npm test`: installs what is missing, then checks, builds and tests everything, and ends with one
// line that sums up what the runners counted. `test.mjs cpp web` runs only the parts that are named.

import { argv } from 'node:process';
import { buildPreset, buildWasm, buildWeb } from './build.mjs';
import { check } from './check.mjs';
import { guard } from './guard.mjs';
import { asProgram, Failure } from './lib/run.mjs';
import { runCtest, runJest } from './lib/runners.mjs';
import { counts, Steps } from './lib/steps.mjs';
import { setup } from './setup.mjs';

const parts = {
  async build(steps) {
    await steps.run('Build of the WebAssembly module', buildWasm);
    await steps.run('Build of the package', buildWeb);
  },

  check,

  async cpp(steps) {
    await steps.run('Build with g++, release', () => buildPreset('release'));
    await steps.run('C++ tests of memory, OpenMesh, CGAL, examples', () => runCtest('release'));
    await steps.run('Instructions of the main loops (callgrind)', guard);
    await steps.run('Build with clang++, ASan + UBSan', () => buildPreset('asan'));
    await steps.run('C++ tests under ASan + UBSan', () => runCtest('asan'));
  },

  async web(steps) {
    await steps.run('Tests of the package (Jest)', () => runJest('web'));
    await steps.run('... with the oldest three.js', () => runJest('three-oldest'));
  },

  async browser(steps) {
    await steps.run('Explorer (Chromium, Firefox, WebKit)', () => runJest('browser'));
  },

  async package(steps) {
    await steps.run('Tests of the packed tarball, examples', () => runJest('package'));
  },
};

await asProgram(async () => {
  const names = argv.length > 2 ? argv.slice(2) : Object.keys(parts);
  const unknown = names.filter((name) => !(name in parts));
  if (unknown.length > 0) {
    throw new Failure(
      `There is no part ${unknown}: the parts are ${Object.keys(parts).join(', ')}.`,
    );
  }
  const steps = new Steps();
  const isReady = await steps.run('Set-up', async () => {
    await setup(['build', 'tests']);
    return counts(0);
  });
  // Without what is missing all else fails, and the sentence that names it is out of sight.
  if (isReady) for (const name of names) await parts[name](steps);
  if (!steps.close()) process.exitCode = 1;
});
