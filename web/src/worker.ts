import { bytesOf, checkOptions, describe, typedArrayName } from './arguments.js';
import type { Polygons } from './build.js';
import { HalfedgeError } from './errors.js';
import { compiledModule } from './loader.js';
import { HalfedgeMesh } from './mesh.js';
import type { ParseOptions, ParseReport } from './parse.js';
import { cancelled, checkSignal, type ProgressOptions } from './progress.js';
import type { RepairReport, SoupOptions } from './repair.js';
import { startThread, type Thread, type WorkerLike } from './thread.js';
import { linksOfBytes } from './transfer.js';
import { fromSent, isBlob, type Job, type Reply } from './worker-messages.js';

export type { WorkerLike } from './thread.js';

declare global {
  // As of the browser. A consumer in Node may do without its types, but not without names.
  interface Blob {}
}

/** How a job is done. */
export interface JobOptions {
  /** Cancels the job: its promise is rejected with `signal.reason`. */
  signal?: AbortSignal;
  /**
   * Hands the buffers that were passed over to the worker instead of copying them: here they are
   * detached then. Default: false.
   */
  transfer?: boolean;
}

/** How to make a worker. */
export interface MeshWorkerOptions {
  /**
   * Makes the worker, which has to run `halfedge/worker-thread`; called again after a job was
   * cancelled. By default one is made of the script beside this one, as all bundlers understand it.
   */
  worker?: () => WorkerLike;
}

/** As ProgressOptions, with undefined as well. */
type Following = { [Key in keyof ProgressOptions]: ProgressOptions[Key] | undefined };

interface Task {
  readonly job: Job;
  readonly onProgress: ProgressOptions['onProgress'];
  readonly transfer: readonly object[];
  resolve(reply: Reply & { kind: 'done' }): void;
  reject(error: unknown): void;
}

/**
 * Makes meshes in another thread, one job after the other. A mesh comes over as bytes: here only they
 * are copied into WebAssembly memory, without being checked again.
 *
 * It keeps no Node process alive but while it has jobs.
 */
export class MeshWorker {
  readonly #make: (() => WorkerLike) | undefined;
  readonly #queue: Task[] = [];
  #running: Task | undefined;
  #thread: Thread | undefined;
  #terminated = false;

  /** @internal */
  constructor({ worker }: MeshWorkerOptions) {
    this.#make = worker;
    this.#start();
  }

  /** As `HalfedgeMesh.parse`, also of a Blob or File, which is read over there. */
  async parse(
    source: string | ArrayBuffer | ArrayBufferView | Blob,
    options: ParseOptions & JobOptions = {},
  ): Promise<{ mesh: HalfedgeMesh; report: ParseReport }> {
    const { signal, transfer = false, onProgress, ...rest } = checkJobOptions(options);
    if (onProgress !== undefined && typeof onProgress !== 'function') {
      throw new TypeError(`options.onProgress is ${describe(onProgress)}; expected a function.`);
    }
    const tells = onProgress !== undefined;
    const data = contentOf(source, transfer);
    const job: Job = { kind: 'parse', data, options: rest, tells };
    const { bytes, report } = await this.#run(job, { signal, onProgress }, [data]);
    return { mesh: meshOf(bytes), report: report as ParseReport };
  }

  /** As `HalfedgeMesh.fromSoup`. */
  async fromSoup(
    positions: ArrayLike<number>,
    faces: ArrayLike<number> | ArrayLike<ArrayLike<number>> | Polygons,
    options: SoupOptions & JobOptions = {},
  ): Promise<{ mesh: HalfedgeMesh; report: RepairReport }> {
    const { signal, transfer = false, ...rest } = checkJobOptions(options);
    const job: Job = {
      kind: 'soup',
      positions: owned(positions, transfer),
      faces:
        Object(faces) === faces && 'corners' in faces
          ? { sizes: owned(faces.sizes, transfer), corners: owned(faces.corners, transfer) }
          : owned(faces, transfer),
      options: rest,
    };
    const lists = job.faces as Partial<Polygons>;
    const { bytes, report } = await this.#run(job, { signal }, [
      job.positions,
      job.faces,
      lists?.sizes,
      lists?.corners,
    ]);
    return { mesh: meshOf(bytes), report };
  }

  /** Ends the thread. Jobs that are not done are rejected; further ones throw. */
  terminate(): void {
    this.#terminated = true;
    const error = new HalfedgeError('worker-terminated', 'The worker was terminated.');
    for (const task of [...(this.#running ? [this.#running] : []), ...this.#queue.splice(0)]) {
      task.reject(error);
    }
    this.#stop();
  }

  /** Runs a job when all before it are done. `data`: what may be worth transferring. */
  #run(
    job: Job,
    { signal, onProgress }: Following,
    data: unknown[],
  ): Promise<Reply & { kind: 'done' }> {
    if (this.#terminated) {
      throw new HalfedgeError('worker-terminated', 'The worker is terminated: make another one.');
    }
    signal?.throwIfAborted();
    return new Promise((resolve, reject) => {
      const transfer = [
        ...new Set(data.map(transferable).filter((buffer) => buffer !== undefined)),
      ];
      const abort = () => {
        this.#cancel(task);
        task.reject(signal?.reason);
      };
      const done = () => signal?.removeEventListener('abort', abort);
      const task: Task = {
        job,
        onProgress,
        transfer,
        resolve: (reply) => {
          done();
          resolve(reply);
        },
        reject: (error) => {
          done();
          reject(error);
        },
      };
      signal?.addEventListener('abort', abort);
      this.#queue.push(task);
      this.#next();
    });
  }

  #next(): void {
    if (this.#running !== undefined) return;
    const task = this.#queue.shift();
    this.#thread?.keepAlive(task !== undefined);
    if (task === undefined) return;
    this.#running = task;
    try {
      const thread = this.#start();
      thread.keepAlive(true);
      thread.post(task.job, task.transfer);
    } catch (error) {
      this.#running = undefined;
      task.reject(error);
      this.#next();
    }
  }

  #cancel(task: Task): void {
    if (task === this.#running) {
      this.#stop(); // nothing else ends a computation
      this.#next();
    } else {
      this.#queue.splice(this.#queue.indexOf(task), 1);
    }
  }

  /** The thread, a new one if there is none. */
  #start(): Thread {
    if (this.#thread !== undefined) return this.#thread;
    const module = compiledModule();
    const isCurrent = () => this.#thread === thread;
    let thread: Thread;
    try {
      thread = startThread(
        {
          message: (reply) => isCurrent() && this.#receive(reply as Reply),
          failure: (why) => isCurrent() && this.#fail(why),
        },
        this.#make,
      );
    } catch (cause) {
      throw failed(String(cause), cause);
    }
    this.#thread = thread;
    thread.post({ kind: 'start', module }, []);
    return thread;
  }

  #stop(): void {
    this.#running = undefined;
    const thread = this.#thread;
    this.#thread = undefined;
    thread?.terminate();
  }

  #receive(reply: Reply): void {
    const task = this.#running;
    if (reply.kind === 'progress') {
      this.#tell(task, reply);
      return;
    }
    this.#running = undefined;
    if (reply.kind === 'done') task?.resolve(reply);
    else task?.reject(fromSent(reply.error));
    this.#next();
  }

  #tell(task: Task | undefined, { fraction, stage }: Reply & { kind: 'progress' }): void {
    try {
      if (task?.onProgress?.(fraction, stage) !== false) return;
      throw cancelled();
    } catch (error) {
      // The callback may have cancelled by itself.
      if (task !== undefined && task === this.#running) this.#cancel(task);
      task?.reject(error);
    }
  }

  #fail(why: string): void {
    const task = this.#running;
    this.#stop();
    task?.reject(failed(why));
    this.#next();
  }
}

/**
 * A worker that makes meshes, for several jobs. `init()` must be done; the worker gets the module that
 * is compiled already.
 *
 * @throws HalfedgeError `not-initialised`, `worker-failed`
 */
export function createMeshWorker(options: MeshWorkerOptions = {}): MeshWorker {
  const { worker } = checkOptions(options) as MeshWorkerOptions;
  if (worker !== undefined && typeof worker !== 'function') {
    throw new TypeError(
      `options.worker is ${describe(worker)}; expected a function that makes a worker.`,
    );
  }
  return new MeshWorker(options);
}

/**
 * As `HalfedgeMesh.parse`, in a thread of its own that ends afterwards: the page goes on while a file is
 * read, repaired and built. The errors are the same. A File or another Blob is read over there; a buffer
 * is copied, unless `transfer` hands it over.
 *
 * ```ts
 * const { mesh, report } = await parseInWorker(input.files[0], { signal });
 * ```
 *
 * @throws also HalfedgeError `worker-failed`, where a worker can't be started or runs out of memory
 */
export async function parseInWorker(
  source: string | ArrayBuffer | ArrayBufferView | Blob,
  options: ParseOptions & JobOptions & MeshWorkerOptions = {},
): Promise<{ mesh: HalfedgeMesh; report: ParseReport }> {
  const { worker: make, ...rest } = checkOptions(options) as MeshWorkerOptions;
  const worker = createMeshWorker(make === undefined ? {} : { worker: make });
  try {
    return await worker.parse(source, rest);
  } finally {
    worker.terminate();
  }
}

const failed = (why: string, cause?: unknown) =>
  new HalfedgeError('worker-failed', `The worker failed: ${why.replace(/\.\s*$/, '')}.`, { cause });

const meshOf = (bytes: Uint8Array) => new HalfedgeMesh(linksOfBytes(bytes, true));

function checkJobOptions<T extends JobOptions>(options: T): T {
  const { signal, transfer } = checkOptions(options) as JobOptions;
  if (transfer !== undefined && typeof transfer !== 'boolean') {
    throw new TypeError(`options.transfer is ${describe(transfer)}; expected true or false.`);
  }
  checkSignal(signal);
  return options;
}

/** The content of a file, which is the worker's: later changes here don't matter. */
function contentOf(source: unknown, transfer: boolean): unknown {
  if (typeof source === 'string' || isBlob(source)) return source;
  const bytes = bytesOf('source', source);
  if (bytes !== undefined) return owned(bytes, transfer);
  throw new TypeError(
    `source is ${describe(source)}; expected the content of a file as a string, an ArrayBuffer, a typed array or a Blob.`,
  );
}

/** A typed array with a buffer of its own, taken over or copied; anything else as it is. */
function owned(source: unknown, transfer: boolean): unknown {
  if (typedArrayName(source) === undefined) return source;
  const { buffer } = source as Uint8Array;
  if (transfer && isUnshared(buffer)) {
    try {
      return structuredClone(source, { transfer: [buffer as ArrayBuffer] });
    } catch {
      // Some buffers stay where they are: WebAssembly's memory, Node's pool.
    }
  }
  return Uint8Array.prototype.slice.call(source); // of any typed array; Node's Buffer has another
}

/** The buffer of a typed array that `owned` made. */
function transferable(data: unknown): object | undefined {
  if (typedArrayName(data) === undefined) return undefined;
  const { buffer } = data as Uint8Array;
  return isUnshared(buffer) ? buffer : undefined;
}

const isUnshared = (buffer: object) =>
  Object.prototype.toString.call(buffer) === '[object ArrayBuffer]';
