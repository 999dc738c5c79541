// `npm run bench`: the JavaScript benchmark. `npm run bench:native`: the C++ one. Arguments after
// `--` are handed on to the benchmark.

import { join } from 'node:path';
import { argv } from 'node:process';
import { build, buildPreset } from './build.mjs';
import { asProgram, root, run } from './lib/run.mjs';
import { setup } from './setup.mjs';

const benchmarks = {
  async web(args) {
    await setup(['build']);
    await build();
    await run(process.execPath, ['--expose-gc', join(root, 'bench/web/run.mjs'), ...args]);
  },

  async native(args) {
    await setup(['build', 'bench']);
    await buildPreset('bench');
    await run(join(root, 'build/bench/bench/native/halfedge_bench'), args);
  },
};

const [, , kind, ...args] = argv;
await asProgram(() => benchmarks[kind](args));
