// `npm run fuzz -- gltf --minutes 5`: files that are nearly glTF, for so long, from another seed each time.

import { outcomesNear, sample, smallFiles, watch } from '../web/support/nearly-gltf.js';

const SECONDS = Number(process.env.HALFEDGE_FUZZ_SECONDS ?? 60);
const SEED = Number(process.env.HALFEDGE_FUZZ_SEED ?? 1);

watch();

test(
  `files from seed ${SEED} on, for ${SECONDS} s`,
  async () => {
    const end = performance.now() + 1000 * SECONDS;
    const files = [sample(), sample(), ...smallFiles()];
    const total = new Map<string, number>();
    let seed = SEED;
    while (performance.now() < end) {
      for (const [outcome, count] of await outcomesNear(files, 500, seed++)) {
        total.set(outcome, (total.get(outcome) ?? 0) + count);
      }
    }
    console.log(`seeds ${SEED} to ${seed - 1}:`, Object.fromEntries(total));
  },
  1000 * SECONDS + 120_000,
);
