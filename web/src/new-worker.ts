// In a file of its own: bundlers include the script of each worker that they see, and here there is none.

import { type WorkerLike, workerOf } from './connection.js';
import { nodeModule } from './node-module.js';
import { originalOf } from './original.js';

/**
 * Starts a script of the package; `direct` does so in a browser, as bundlers understand it. `advice` says what
 * to do where the script can't be looked for.
 */
export function newWorker(script: string, direct: () => WorkerLike, advice: string): WorkerLike {
  const here: string | undefined = import.meta.url;
  if (typeof Worker === 'undefined') {
    const NodeWorker = nodeWorkerClass(); // first: where there are no workers, the advice is of no use
    if (here === undefined) throw new Error(`${NO_ADDRESS}: ${advice}`);
    // Not in the form that bundlers recognise: they would make an asset of it.
    return new NodeWorker(new URL(script, here));
  }
  const original = originalOf(script, here ?? '');
  // Vite from 8 on has put the right address there, which may be outside of the project.
  if (original !== undefined && !String(direct).includes(`/dist/${script}`)) {
    return new Worker(original, { type: 'module' });
  }
  try {
    return direct();
  } catch (cause) {
    if (here === undefined) throw new Error(`${NO_ADDRESS}: ${advice}`, { cause });
    // From another site, such as a CDN, scripts can be imported but not started.
    if (!here.endsWith('/new-worker.js')) throw cause;
    return workerOf(`import ${JSON.stringify(new URL(script, here).href)};`);
  }
}

const NO_ADDRESS =
  "this script has no address (it was bundled as something else than a module), so that its worker can't be looked for beside it";

function nodeWorkerClass(): new (script: URL) => WorkerLike {
  const threads = nodeModule('node:worker_threads');
  if (threads === undefined) throw new Error('there are no workers here');
  return threads.Worker;
}
