import { describe } from './arguments.js';
import { connect, type Listener, type Thread, type WorkerLike, workerOf } from './connection.js';

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
  connected.add(worker);
  return connect(worker, listener);
}

const newMeshWorker = () =>
  newWorker(
    'worker-thread.js',
    // In this form, bundlers recognise a worker.
    () => new Worker(new URL('./worker-thread.js', import.meta.url), { type: 'module' }),
  );

/** Starts a script of the package; `direct` does so in a browser, as bundlers understand it. */
export function newWorker(script: string, direct: () => WorkerLike): WorkerLike {
  const here = import.meta.url;
  if (typeof Worker === 'undefined') {
    // Not in the form that bundlers recognise: they would make an asset of it.
    return new (nodeWorkerClass())(new URL(script, here));
  }
  // In development, Vite up to 7 serves packages from copies of their JavaScript, without this script.
  if (here.includes('/.vite/deps/')) {
    return new Worker(new URL(`../../halfedge/dist/${script}`, here), { type: 'module' });
  }
  try {
    return direct();
  } catch (error) {
    // From another site, such as a CDN, scripts can be imported but not started.
    if (!here.endsWith('/thread.js')) throw error;
    return workerOf(`import ${JSON.stringify(new URL(script, here).href)};`);
  }
}

function nodeWorkerClass(): new (script: URL) => WorkerLike {
  const { process } = globalThis as { process?: { getBuiltinModule?(name: string): unknown } };
  const threads = process?.getBuiltinModule?.('node:worker_threads');
  if (threads === undefined) throw new Error('There are no workers here.');
  return (threads as { Worker: new (script: URL) => WorkerLike }).Worker;
}
