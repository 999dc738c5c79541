import { messageOf } from './loader.js';

/** What `createMeshWorker` can be given: a worker of the browser, or of Node's worker_threads. */
export interface WorkerLike {
  postMessage(message: unknown, transfer?: readonly object[]): void;
  terminate(): unknown;
}

/** What is heard of a thread. */
export interface Listener {
  message(data: unknown): void;
  /** It can't be started, or has ended by itself. The text has no full stop. */
  failure(why: string): void;
}

/** Another thread, the same for browsers and Node. */
export interface Thread {
  post(message: unknown, transfer: readonly object[]): void;
  /** Whether a Node process has to wait for it. */
  keepAlive(on: boolean): void;
  terminate(): void;
}

interface WebWorker extends WorkerLike {
  addEventListener(
    type: string,
    listener: (event: { data?: unknown; message?: string }) => void,
  ): void;
}
interface NodeWorker extends WorkerLike {
  on(type: string, listener: (value: unknown) => void): void;
  ref(): void;
  unref(): void;
}

/** Starts a thread that runs worker-thread.js, or takes one that was made elsewhere. */
export function startThread(listener: Listener, make: () => WorkerLike = newMeshWorker): Thread {
  const worker = make();
  if ('on' in worker) return nodeThread(worker as NodeWorker, listener);
  const web = worker as WebWorker;
  web.addEventListener('message', ({ data }) => listener.message(data));
  web.addEventListener('messageerror', () => listener.failure('a message could not be read'));
  web.addEventListener('error', ({ message }) =>
    listener.failure(message ? messageOf({ message }) : 'its script could not be loaded'),
  );
  return {
    post: (message, transfer) => web.postMessage(message, transfer),
    keepAlive() {}, // a page doesn't end by itself
    terminate: () => void web.terminate(),
  };
}

function nodeThread(worker: NodeWorker, listener: Listener): Thread {
  worker.on('message', (data) => listener.message(data));
  worker.on('messageerror', () => listener.failure('a message could not be read'));
  worker.on('error', (error) => listener.failure(messageOf(error)));
  worker.on('exit', () => listener.failure('it has ended'));
  worker.unref();
  return {
    post: (message, transfer) => worker.postMessage(message, transfer),
    keepAlive: (on) => (on ? worker.ref() : worker.unref()),
    terminate: () => void worker.terminate(),
  };
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
    const start = `import ${JSON.stringify(new URL(script, here).href)};`;
    const address = URL.createObjectURL(new Blob([start], { type: 'text/javascript' }));
    const worker = new Worker(address, { type: 'module' });
    // As soon as it is heard of: not all browsers have read the script before that.
    const revoke = () => URL.revokeObjectURL(address);
    for (const event of ['message', 'error'])
      worker.addEventListener(event, revoke, { once: true });
    return worker;
  }
}

function nodeWorkerClass(): new (script: URL) => WorkerLike {
  const { process } = globalThis as { process?: { getBuiltinModule?(name: string): unknown } };
  const threads = process?.getBuiltinModule?.('node:worker_threads');
  if (threads === undefined) throw new Error('There are no workers here.');
  return (threads as { Worker: new (script: URL) => WorkerLike }).Worker;
}
