// `npm run bench`: the JavaScript benchmark. `npm run bench:native`: the C++ one. `npm run bench:wasm`:
// WebAssembly against native. `npm run bench:variants`: our own variants. `npm run bench:start`: size and
// start. `npm run bench:files`: readers of files. `npm run bench:explorer`: the explorer in Chromium.
// `npm run bench:scale`: ten million triangles. `npm run bench:growth`: from ten thousand faces to ten million.
// `npm run bench:locality`: what `reorder` costs and gains. `npm run bench:circulators`: circulators of JavaScript.
// Arguments after `--` are handed on to the benchmark.

import { join } from 'node:path';
import { argv } from 'node:process';
import { build, buildPreset } from './build.mjs';
import { emscriptenToolchain } from './lib/emscripten.mjs';
import { asProgram, Failure, root, run } from './lib/run.mjs';
import { setup } from './setup.mjs';

const native = join(root, 'build/bench/bench/native');
const benchmarks = {
  async web(args) {
    await setup(['build']);
    await build();
    await run(process.execPath, [join(root, 'bench/web/run.mjs'), ...args]);
  },

  async start() {
    await setup(['build']);
    await build();
    await run(process.execPath, [join(root, 'bench/web/start.mjs')]);
  },

  async circulators(args) {
    await setup(['build']);
    await build();
    await run(process.execPath, [join(root, 'bench/web/circulators.mjs'), ...args]);
  },

  async files(args) {
    await setup(['build']);
    await build();
    await run(process.execPath, ['--expose-gc', join(root, 'bench/web/files.mjs'), ...args]);
  },

  async explorer(args) {
    await setup(['build', 'tests']);
    await build();
    await run(process.execPath, [join(root, 'bench/web/explorer.mjs'), ...args]);
  },

  async native(args) {
    await setup(['build', 'bench']);
    await buildPreset('bench');
    await run(join(native, 'halfedge_bench'), args);
  },

  async variants(args) {
    await setup(['build', 'bench']);
    await buildPreset('bench');
    await run(join(native, 'halfedge_variants'), args);
  },

  async scale(args) {
    await setup(['build', 'tests']);
    await build();
    await run(process.execPath, [join(root, 'bench/web/scale.mjs'), ...args]);
  },

  async growth(args) {
    await setup(['build', 'bench']);
    await build();
    await buildPreset('bench');
    const program = join(native, 'halfedge_growth');
    await run(process.execPath, [join(root, 'bench/web/growth.mjs'), program, ...args]);
  },

  async locality() {
    await setup(['build', 'bench']);
    await build();
    await buildPreset('bench');
    await buildPreset('wasm-bench', [`-DCMAKE_TOOLCHAIN_FILE=${emscriptenToolchain()}`]);
    await run(process.execPath, [
      join(root, 'bench/web/locality.mjs'),
      join(native, 'halfedge_locality'),
      join(root, 'build/wasm-bench/bench/native/halfedge_locality.cjs'),
    ]);
  },

  async wasm() {
    await setup(['build', 'bench']);
    await build();
    await buildPreset('bench');
    await run(process.execPath, [
      join(root, 'bench/web/wasm.mjs'),
      join(native, 'halfedge_passes'),
    ]);
  },
};

const [, , kind, ...args] = argv;
await asProgram(() => {
  if (kind in benchmarks) return benchmarks[kind](args);
  throw new Failure(`Name a benchmark: ${Object.keys(benchmarks).join(', ')}.`);
});
