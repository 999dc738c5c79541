// Running other programs, and finding them.

import { spawn } from 'node:child_process';
import { accessSync, constants, realpathSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { fileURLToPath } from 'node:url';

/** The project's folder. */
export const root = fileURLToPath(new URL('../..', import.meta.url)).replace(/\/$/, '');

/** A failure that is told to the user as one sentence, without a stack trace. */
export class Failure extends Error {}

/**
 * Runs a program in the project's folder, its output shown. Throws a Failure if it fails.
 * It can't read from the terminal, unless `input` is 'inherit'.
 */
export async function run(command, args, { env = {}, cwd = root, input = 'ignore' } = {}) {
  const { ended } = start(command, args, { env, cwd, stdio: [input, 'inherit', 'inherit'] });
  const status = await ended;
  if (status !== 0) throw new Failure(`${[command, ...args].join(' ')} failed (${status}).`);
}

/**
 * Runs a program in the project's folder and returns what it wrote: `{ ok, output, printed }`. `printed` is
 * without its notices and errors, as npm may tell of a newer npm wherever it is.
 */
export async function capture(command, args, { env = {}, cwd = root } = {}) {
  const { child, ended } = start(command, args, { env, cwd, stdio: ['ignore', 'pipe', 'pipe'] });
  let output = '';
  let printed = '';
  for (const stream of [child.stdout, child.stderr]) {
    stream.setEncoding('utf8').on('data', (text) => {
      output += text;
      if (stream === child.stdout) printed += text;
    });
  }
  const status = await ended;
  return { ok: status === 0, output, printed };
}

/** A child process, and the promise of its exit code, or of the signal that ended it. */
function start(command, args, { env, cwd, stdio }) {
  const child = spawn(command, args, { cwd, env: { ...process.env, ...env }, stdio });
  const ended = new Promise((resolve, reject) => {
    child.on('error', (error) =>
      reject(new Failure(`${command} did not start: ${error.message}.`)),
    );
    child.on('close', (code, signal) => resolve(code ?? signal));
  });
  return { child, ended };
}

/** The path of a program on PATH, or undefined. */
export function which(name) {
  for (const folder of (process.env.PATH ?? '').split(delimiter)) {
    const path = join(folder, name);
    try {
      accessSync(path, constants.X_OK);
      return path;
    } catch {
      // Not in this folder: try the next.
    }
  }
  return undefined;
}

/** Whether a module is what Node was started with, were it by a link. */
export function isProgram(url) {
  const [, started] = process.argv;
  return started !== undefined && realpathSync(started) === fileURLToPath(url);
}

/** Runs `main` and turns a Failure, or an option that there is not, into one printed sentence and exit code 1. */
export async function asProgram(main) {
  try {
    await main();
  } catch (error) {
    const isOfArguments = String(error.code).startsWith('ERR_PARSE_ARGS_');
    if (!(error instanceof Failure || isOfArguments)) throw error;
    console.error(`\n${error.message}`);
    process.exitCode = 1;
  }
}
