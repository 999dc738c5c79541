import { connect, NOT_LOADED, type Thread, type WorkerLike } from '../connection.js';
import { compiledModule, messageOf } from '../loader.js';
import { deal, type Trial } from './judge/deal.js';
import { failureIn, meshResult } from './judge/grade.js';
import { judgeFault, judgeSilence } from './judge/judge-trouble.js';
import { type ExerciseTask, plain } from './judge/task.js';
import {
  type Failure,
  failureBefore,
  failureOf,
  type MeshResult,
  type Verdict,
  verdictOf,
} from './judge/verdict.js';
import type { Job, Reply } from './messages.js';

/** How workers are made. */
export interface Workers {
  /** Makes a worker that runs thread.js. */
  readonly worker: () => WorkerLike;
  /** What to do where the script of it isn't found. */
  readonly advice: string | undefined;
}

/** What is to be run, and how. */
export interface RunOptions extends Workers {
  readonly task: ExerciseTask;
  readonly code: string;
  readonly seed: number;
  /** After so many milliseconds without a sign of life a program is ended. */
  readonly limit: number;
  readonly signal: AbortSignal;
}

/** A verdict, and the meshes that it speaks of; the caller disposes of them. */
export interface Ran {
  readonly verdict: Verdict;
  readonly trials: readonly Trial[];
}

/** To start a worker may take longer than any program. */
const START_LIMIT = 30_000;
const GRACE = 50;
/** Timers take no more milliseconds. */
const LONGEST_WAIT = 2 ** 31 - 1;

/** Runs a program in a worker of its own, and judges here what it does there. */
export function runProgram(options: RunOptions): Promise<Ran> {
  return new Promise((resolve, reject) => {
    const run = new Run(options, resolve, reject);
    options.signal.addEventListener('abort', () => run.cancel(), { once: true });
  });
}

class Run {
  readonly #options: RunOptions;
  readonly #trials: readonly Trial[];
  readonly #failures: (Failure | null)[];
  #thread: Thread | undefined;
  readonly #resolve: (ran: Ran) => void;
  readonly #reject: (error: unknown) => void;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #fault: Failure | null = null;
  /** The call that is under way: the one after the last that was heard of. */
  #at = { trial: 0, call: 0 };
  #heard = 0;
  #ended = false;

  constructor(options: RunOptions, resolve: (ran: Ran) => void, reject: (error: unknown) => void) {
    this.#options = options;
    this.#resolve = resolve;
    this.#reject = reject;
    this.#trials = deal(options.task, options.seed);
    this.#failures = this.#trials.map(() => null);
    try {
      const job = this.#job();
      this.#thread = connect(options.worker(), {
        message: (data) => this.#hear(data as Reply),
        failure: (why) =>
          this.#break(new Error(`The worker of the exercise failed: ${this.#advised(why)}.`)),
      });
      this.#thread.keepAlive(true);
      this.#thread.post(job, []);
    } catch (error) {
      this.#break(error);
      return;
    }
    this.#wait(START_LIMIT);
  }

  cancel(): void {
    this.#break(this.#options.signal.reason);
  }

  /** Why there is no worker, with what to do about it. */
  #advised(why: string): string {
    const { advice } = this.#options;
    return why === NOT_LOADED && advice !== undefined ? `${why}. ${advice}` : why;
  }

  #job(): Job {
    const { task, code } = this.#options;
    const { call, gets, uses } = task;
    const trials = this.#trials.map(({ mesh, calls }) => ({
      bytes: mesh.toBytes(),
      calls: calls.map((parameters) => parameters.map(plain)),
    }));
    return { module: compiledModule(), code, call, terms: { gets, uses }, trials };
  }

  #hear(reply: Reply): void {
    if (this.#ended) return;
    try {
      this.#take(reply);
    } catch (error) {
      // What judges it is at fault: an exercise of somebody else's, most likely. No answer is right by that.
      this.#break(
        new Error(`The exercise can't judge this answer: ${messageOf(error)}.`, { cause: error }),
      );
    }
  }

  #take(reply: Reply): void {
    const { task, limit } = this.#options;
    this.#wait(limit);
    if (reply.kind === 'fault') {
      this.#fault = failureBefore(judgeFault(reply.fault, task.call));
    } else if (reply.kind === 'outcome') {
      const { trial, call, outcome } = reply;
      this.#heard += 1;
      this.#failures[trial] ??= failureIn(task, this.#trials, trial, call, outcome);
      const last = call + 1 >= this.#trials[trial].calls.length || outcome.kind !== 'returned';
      this.#at = last ? { trial: trial + 1, call: 0 } : { trial, call: call + 1 };
    } else if (reply.kind === 'done') {
      // A program may say so, too.
      if (!this.#fault && this.#at.trial < this.#trials.length) {
        throw new Error('it is said to be done before all calls were made');
      }
      this.#finish(this.#trials.length);
    }
  }

  /** Ends the program if nothing is heard of it for so long. */
  #wait(limit: number): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(
      () => {
        // Where this thread was busy, what the worker has said in the meantime comes first.
        this.#timer = setTimeout(() => this.#silence(limit), GRACE);
      },
      Math.min(limit, LONGEST_WAIT),
    );
  }

  #silence(limit: number): void {
    const { trial, call } = this.#at;
    const found = judgeSilence(limit);
    const { task } = this.#options;
    if (this.#heard === 0 || trial >= this.#trials.length) this.#fault = failureBefore(found);
    else this.#failures[trial] ??= failureOf(task, this.#trials[trial], trial, call, found);
    this.#finish(trial + 1);
  }

  /** Sums up what was heard of the first trials. */
  #finish(count: number): void {
    this.#end();
    const { task, seed } = this.#options;
    const results: MeshResult[] = this.#fault
      ? []
      : this.#trials.slice(0, count).map((trial, i) => meshResult(trial, this.#failures[i]));
    this.#resolve({
      verdict: verdictOf(task, seed, results, this.#fault),
      trials: this.#trials,
    });
  }

  #break(error: unknown): void {
    if (this.#ended) return;
    this.#end();
    for (const { mesh } of this.#trials) mesh.dispose();
    this.#reject(error);
  }

  #end(): void {
    this.#ended = true;
    clearTimeout(this.#timer);
    this.#thread?.terminate();
  }
}
