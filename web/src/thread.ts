import { describe } from './arguments.js';
import { connect, type Listener, NOT_LOADED, type Thread, type WorkerLike } from './connection.js';
import { newWorker } from './new-worker.js';

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
    listener.failure(why === NOT_LOADED || MISSING.test(why) ? `${why}. ${LEFT_BEHIND}` : why);
  return { ...listener, failure };
}

/** How Node, Bun and Deno say that the script isn't there. Browsers don't. */
const MISSING = /(cannot find module|module ?not ?found).*\bworker-thread\.js\b/i;

const LEFT_BEHIND =
  'Some bundlers (Angular, Bun, esbuild, Rollup) leave it behind: bundle halfedge/worker-thread by itself, and pass { worker: () => new Worker(...) } with that';

const newMeshWorker = () =>
  newWorker(
    'worker-thread.js',
    // In this form, bundlers recognise a worker.
    () => new Worker(new URL('./worker-thread.js', import.meta.url), { type: 'module' }),
    'pass { worker: () => new Worker(...) } with a bundle of halfedge/worker-thread',
  );
