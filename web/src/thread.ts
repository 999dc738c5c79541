import { describe } from './arguments.js';
import {
  connect,
  type Listener,
  NOT_LOADED,
  type Thread,
  type WorkerLike,
  workerOf,
} from './connection.js';
import { originalOf } from './original.js';

export type { Thread, WorkerLike } from './connection.js';

/** Those that have been connected: each has one listener, who ends it. */
const connected = new WeakSet<WorkerLike>();

/** Starts a thread that runs worker-thread.js, or takes one that was made elsewhere. */
export function startThread(listener: Listener, make: () => WorkerLike = newMeshWorker): Thread {
  const worker: WorkerLike | undefined = make();
  if (typeof worker?.postMessage !== 'function') {
    throw new TypeError(`options.worker returned ${describe(worker)}; expected a worker.`);
  }
  if (connected.has(worker)) {
    throw new TypeError(
      'options.worker returned a worker that it has returned before; expected a new one each time.',
    );
  }
  // Node tells nobody of messages to a worker that isn't there any more.
  if ((worker as { threadId?: unknown }).threadId === -1) {
    throw new TypeError('options.worker returned a worker that has ended; expected one that runs.');
  }
  connected.add(worker);
  return connect(worker, make === newMeshWorker ? advising(listener) : listener);
}

/** Tells what to do about a script that isn't where it was looked for. */
function advising(listener: Listener): Listener {
  const failure = (why: string) =>
    listener.failure(why === NOT_LOADED ? `${why}. ${LEFT_BEHIND}` : why);
  return { ...listener, failure };
}

const LEFT_BEHIND =
  'Some bundlers (Angular, Bun, esbuild, Rollup) leave it behind: bundle halfedge/worker-thread by itself, and pass { worker: () => new Worker(...) } with that';

const newMeshWorker = () =>
  newWorker(
    'worker-thread.js',
    // In this form, bundlers recognise a worker.
    () => new Worker(new URL('./worker-thread.js', import.meta.url), { type: 'module' }),
  );

/** Starts a script of the package; `direct` does so in a browser, as bundlers understand it. */
export function newWorker(script: string, direct: () => WorkerLike): WorkerLike {
  const here: string | undefined = import.meta.url;
  if (typeof Worker === 'undefined') {
    if (here === undefined) throw new Error(NO_ADDRESS);
    // Not in the form that bundlers recognise: they would make an asset of it.
    return new (nodeWorkerClass())(new URL(script, here));
  }
  const original = originalOf(script, here ?? '');
  // Vite from 8 on has put the right address there, which may be outside of the project.
  if (original !== undefined && !String(direct).includes(`/dist/${script}`)) {
    return new Worker(original, { type: 'module' });
  }
  try {
    return direct();
  } catch (cause) {
    if (here === undefined) throw new Error(NO_ADDRESS, { cause });
    // From another site, such as a CDN, scripts can be imported but not started.
    if (!here.endsWith('/thread.js')) throw cause;
    return workerOf(`import ${JSON.stringify(new URL(script, here).href)};`);
  }
}

const NO_ADDRESS =
  "this script has no address (it was bundled as something else than a module), so that its worker can't be looked for beside it: pass { worker: () => new Worker(...) } with a bundle of halfedge/worker-thread";

function nodeWorkerClass(): new (script: URL) => WorkerLike {
  const { process } = globalThis as { process?: { getBuiltinModule?(name: string): unknown } };
  const threads = process?.getBuiltinModule?.('node:worker_threads');
  if (threads === undefined) throw new Error('There are no workers here.');
  return (threads as { Worker: new (script: URL) => WorkerLike }).Worker;
}
