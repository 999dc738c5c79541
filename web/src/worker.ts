// Consumers whose own `lib` has no Symbol.dispose need this; the emitted types keep it.
/// <reference lib="esnext.disposable" preserve="true" />

import { onAbort } from './abort.js';
import { bytesOf, describe } from './arguments.js';
import type { Polygons } from './build.js';
import { checkCallback, checkFlag, refuse } from './checks.js';
import { HalfedgeError } from './errors.js';
import { checkText } from './file-content.js';
import { named } from './inspect.js';
import { compiledModule } from './loader.js';
import { HalfedgeMesh } from './mesh.js';
import { checkOptions, type OptionNames, takeOptions } from './options.js';
import { owned, transferable } from './ownership.js';
import { checkParseOptions, PARSE_OPTIONS, type ParseOptions, type ParseReport } from './parse.js';
import { cancelled, checkSignal, type ProgressOptions } from './progress.js';
import { type RepairReport, SOUP_OPTIONS, type SoupOptions, soupOptions } from './repair.js';
import { soupArrays } from './soup-arrays.js';
import { startThread, type Thread, type WorkerLike } from './thread.js';
import { linksOfBytes } from './transfer.js';
import { canBeSent, fromSent, isBlob, isReply, type Job, type Reply } from './worker-messages.js';

export type { WorkerLike } from './thread.js';

declare global {
  // As of the browser. A consumer in Node may do without its types, but not without names.
  interface Blob {}
}

/** Where the platform has no `Symbol.dispose` yet, polyfills register theirs under this name. */
const disposeSymbol: typeof Symbol.dispose = Symbol.dispose ?? Symbol.for('Symbol.dispose');

/** How to do a job. */
export interface JobOptions {
  /** Cancels the job; its promise is then rejected with `signal.reason`. */
  signal?: AbortSignal | undefined;
  /**
   * Whether to transfer the buffers that you pass to the worker instead of copying them. They are then
   * detached here. Default: false.
   */
  transfer?: boolean | undefined;
}

/** How to make a worker. */
export interface MeshWorkerOptions {
  /**
   * Makes the worker, which has to run `halfedge/worker-thread`. It is called again after a job was
   * cancelled. By default the worker is made from the script beside this one, in the form that bundlers
   * recognise.
   */
  worker?: (() => WorkerLike) | undefined;
}

const JOB_OPTIONS: OptionNames<JobOptions> = { signal: true, transfer: true };
const PARSE_JOB_OPTIONS: OptionNames<ParseOptions & JobOptions> = {
  ...PARSE_OPTIONS,
  ...JOB_OPTIONS,
};
const SOUP_JOB_OPTIONS: OptionNames<SoupOptions & JobOptions> = { ...SOUP_OPTIONS, ...JOB_OPTIONS };
const WORKER_OPTIONS: OptionNames<MeshWorkerOptions> = { worker: true };

/** As ProgressOptions, with undefined as well. */
type Following = { [Key in keyof ProgressOptions]: ProgressOptions[Key] | undefined };

interface Task {
  readonly job: Job;
  readonly onProgress: ProgressOptions['onProgress'];
  readonly transfer: readonly object[];
  readonly signal: AbortSignal | undefined;
  resolve(reply: Reply & { kind: 'done' }): void;
  reject(error: unknown): void;
}

/**
 * Makes meshes in another thread, one job after the other. A finished mesh arrives as bytes, which are only
 * copied into WebAssembly memory here, without being checked again.
 *
 * It keeps a Node process alive only while it has jobs.
 */
export class MeshWorker {
  readonly #make: (() => WorkerLike) | undefined;
  readonly #queue: Task[] = [];
  #running: Task | undefined;
  #thread: Thread | undefined;
  /** Whether the thread is being made, by a function of others. */
  #isStarting = false;
  #terminated = false;

  /** Like {@link createMeshWorker}. */
  constructor(options: MeshWorkerOptions = {}) {
    const { worker } = checkOptions(options, WORKER_OPTIONS);
    checkCallback('options.worker', worker, 'a function that makes a worker');
    this.#make = worker;
    this.#start();
  }

  /** Like `HalfedgeMesh.parse`. Also accepts a Blob or File, which is read in the worker. */
  async parse(
    source: string | ArrayBuffer | ArrayBufferView | Blob,
    options: ParseOptions & JobOptions = {},
  ): Promise<{ mesh: HalfedgeMesh; report: ParseReport }> {
    this.#checkOpen();
    const given = takeOptions(options, PARSE_JOB_OPTIONS);
    let content = checkParse(source, given);
    const { signal, transfer = false, onProgress, ...rest } = given;
    if (isBlob(content) && !canBeSent(content)) {
      content = new Uint8Array(await content.arrayBuffer());
      this.#checkOpen();
      signal?.throwIfAborted();
    }
    const tells = onProgress !== undefined;
    const [data] = owned([content], transfer);
    const job: Job = { kind: 'parse', data, options: rest, tells };
    const { bytes, report } = await this.#run(job, { signal, onProgress }, [data]);
    return { mesh: meshOf(bytes), report: report as ParseReport };
  }

  /** Like `HalfedgeMesh.fromSoup`. */
  async fromSoup(
    positions: ArrayLike<number>,
    faces: ArrayLike<number> | ArrayLike<ArrayLike<number>> | Polygons,
    options: SoupOptions & JobOptions = {},
  ): Promise<{ mesh: HalfedgeMesh; report: RepairReport }> {
    this.#checkOpen();
    const given = takeOptions(options, SOUP_JOB_OPTIONS);
    checkJobOptions(given);
    soupOptions(given);
    const arrays = soupArrays(positions, faces);
    const { signal, transfer = false, ...rest } = given;
    const data = owned([arrays.points, arrays.sizes, arrays.corners], transfer);
    const [points, sizes, corners] = data;
    const job: Job = {
      kind: 'soup',
      positions: points,
      faces: sizes === undefined ? corners : { sizes, corners },
      options: rest,
    };
    const { bytes, report } = await this.#run(job, { signal }, data);
    return { mesh: meshOf(bytes), report };
  }

  /** Ends the thread. Unfinished jobs are rejected, and so are further ones. */
  terminate(): void {
    this.#terminated = true;
    const error = new HalfedgeError('worker-terminated', 'The worker was terminated.');
    for (const task of [...(this.#running ? [this.#running] : []), ...this.#queue.splice(0)]) {
      task.reject(error);
    }
    this.#stop();
  }

  /** Calls `terminate()` at the end of the block that declares `using worker = ...`. */
  [disposeSymbol](): void {
    this.terminate();
  }

  /** Before anything is taken from a caller. */
  #checkOpen(): void {
    if (!this.#terminated) return;
    throw new HalfedgeError('worker-terminated', 'The worker is terminated: make another one.');
  }

  /** Runs a job when all before it are done. `data`: what may be worth transferring. */
  #run(
    job: Job,
    { signal, onProgress }: Following,
    data: unknown[],
  ): Promise<Reply & { kind: 'done' }> {
    return new Promise((resolve, reject) => {
      const transfer = [
        ...new Set(data.map(transferable).filter((buffer) => buffer !== undefined)),
      ];
      const abort = () => {
        this.#cancel(task);
        task.reject(signal?.reason);
      };
      const task: Task = {
        job,
        onProgress,
        transfer,
        signal,
        resolve: (reply) => {
          done();
          resolve(reply);
        },
        reject: (error) => {
          done();
          reject(error);
        },
      };
      const done = signal === undefined ? () => {} : onAbort(signal, abort);
      this.#queue.push(task);
      this.#next();
    });
  }

  #next(): void {
    if (this.#running !== undefined || this.#isStarting) return;
    let task = this.#queue.shift();
    // A signal cancels its jobs one after the other: no thread is started for the next one of them.
    while (task?.signal?.aborted) {
      task.reject(task.signal.reason);
      task = this.#queue.shift();
    }
    this.#thread?.keepAlive(task !== undefined);
    if (task === undefined) return;
    this.#running = task;
    try {
      const thread = this.#start();
      if (this.#running === task) {
        thread.keepAlive(true);
        thread.post(task.job, task.transfer);
      } else if (this.#terminated) {
        this.#stop(); // by what makes workers
      } else {
        this.#next(); // or the job was cancelled by it
      }
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
    this.#isStarting = true;
    try {
      thread = startThread(
        {
          message: (data) => isCurrent() && this.#receive(data),
          failure: (why) => isCurrent() && this.#fail(why),
        },
        this.#make,
      );
    } catch (cause) {
      throw failed(String(cause), cause);
    } finally {
      this.#isStarting = false;
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

  #receive(data: unknown): void {
    const task = this.#running;
    if (!isReply(data)) {
      if (task !== undefined) this.#fail(`it sent ${describe(data)}; ${WRONG_SCRIPT}`);
      return;
    }
    if (data.kind === 'progress') {
      this.#tell(task, data);
      return;
    }
    this.#running = undefined;
    if (data.kind === 'done') task?.resolve(data);
    else task?.reject(fromSent(data.error));
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

named({ MeshWorker });

/**
 * Makes a worker that makes meshes, for several jobs. `await init()` first: the worker gets the module that
 * is already compiled.
 *
 * @throws HalfedgeError `not-initialised`, `worker-failed`
 */
export function createMeshWorker(options: MeshWorkerOptions = {}): MeshWorker {
  return new MeshWorker(options);
}

/**
 * As `HalfedgeMesh.parse`, in a thread of its own that ends afterwards: the page goes on while a file is
 * read, repaired and built. The errors are the same, with their names and causes; those of other classes than
 * HalfedgeError, RangeError and TypeError come over as an Error. A File or another Blob is read over there; a
 * buffer is copied, unless `transfer` hands it over.
 *
 * ```ts
 * const { mesh, report } = await parseInWorker(input.files[0], { signal });
 * ```
 *
 * @throws also HalfedgeError `worker-failed`, if a worker can't be started or runs out of memory
 */
export async function parseInWorker(
  source: string | ArrayBuffer | ArrayBufferView | Blob,
  options: ParseOptions & JobOptions & MeshWorkerOptions = {},
): Promise<{ mesh: HalfedgeMesh; report: ParseReport }> {
  const names = { ...PARSE_JOB_OPTIONS, ...WORKER_OPTIONS };
  const { worker: make, ...rest } = takeOptions<typeof options>(options, names);
  checkParse(source, rest); // no thread is started in vain
  const worker = createMeshWorker(make === undefined ? {} : { worker: make });
  try {
    return await worker.parse(source, rest);
  } finally {
    worker.terminate();
  }
}

const failed = (why: string, cause?: unknown) =>
  new HalfedgeError('worker-failed', `The worker failed: ${why.replace(/\.\s*$/, '')}.`, { cause });

const WRONG_SCRIPT =
  'expected a worker that runs halfedge/worker-thread, of the same version, and sends nothing else';

const meshOf = (bytes: Uint8Array) => new HalfedgeMesh(linksOfBytes(bytes, true));

/** Throws also if the job is cancelled already. */
function checkJobOptions({ signal, transfer = false }: JobOptions): void {
  checkFlag('options.transfer', transfer);
  checkSignal(signal);
  signal?.throwIfAborted();
}

/** Checks all that is known before the file is read; returns its content. */
function checkParse(source: unknown, options: ParseOptions & JobOptions): unknown {
  checkJobOptions(options);
  checkCallback('options.onProgress', options.onProgress);
  checkParseOptions(options);
  if (typeof source === 'string') checkText('source', source);
  if (typeof source === 'string' || isBlob(source)) return source;
  const bytes = bytesOf('source', source);
  if (bytes !== undefined) return bytes;
  refuse(
    'source',
    source,
    'the content of a file as a string, an ArrayBuffer, a typed array or a Blob',
  );
}
