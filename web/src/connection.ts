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

/** What is heard of a worker whose script isn't there. */
export const NOT_LOADED = 'its script could not be loaded';

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

/** Listens to a worker, of whichever kind. */
export function connect(worker: WorkerLike, listener: Listener): Thread {
  if ('on' in worker) return nodeThread(worker as NodeWorker, listener);
  const web = worker as WebWorker;
  web.addEventListener('message', ({ data }) => listener.message(data));
  web.addEventListener('messageerror', () => listener.failure('a message could not be read'));
  web.addEventListener('error', ({ message }) =>
    listener.failure(message ? messageOf({ message }) : NOT_LOADED),
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

/** Starts a script that is there as a text: a module. Browsers only. */
export function workerOf(script: string): WorkerLike {
  // In a sandboxed frame or a local file, which have no origin, Chromium starts no module of a blob.
  if (globalThis.origin === 'null') {
    return new Worker(`data:text/javascript;charset=utf-8,${encodeURIComponent(script)}`, {
      type: 'module',
    });
  }
  const address = URL.createObjectURL(new Blob([script], { type: 'text/javascript' }));
  const worker = new Worker(address, { type: 'module' });
  // As soon as it is heard of: not all browsers have read the script before that.
  const revoke = () => URL.revokeObjectURL(address);
  for (const event of ['message', 'error']) worker.addEventListener(event, revoke, { once: true });
  return worker;
}
