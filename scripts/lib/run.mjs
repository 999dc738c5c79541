// Running other programs, and finding them.

import { spawn, spawnSync } from 'node:child_process';
import { accessSync, constants } from 'node:fs';
import { delimiter, join } from 'node:path';
import { fileURLToPath } from 'node:url';

/** The project's folder. */
export const root = fileURLToPath(new URL('../..', import.meta.url)).replace(/\/$/, '');

/** A failure that is told to the user as one sentence, without a stack trace. */
export class Failure extends Error {}

/** Runs a program in the project's folder, its output shown. Throws a Failure if it fails. */
export async function run(command, args, { env = {}, cwd = root } = {}) {
  const status = await new Promise((resolve, reject) => {
    const child = spawn(command, args, {
      cwd,
      env: { ...process.env, ...env },
      stdio: ['ignore', 'inherit', 'inherit'],
    });
    child.on('error', (error) =>
      reject(new Failure(`${command} did not start: ${error.message}.`)),
    );
    child.on('close', (code, signal) => resolve(code ?? signal));
  });
  if (status !== 0) throw new Failure(`${[command, ...args].join(' ')} failed (${status}).`);
}

/** Runs a program and returns what it wrote: `{ ok, stdout, stderr }`. */
export function capture(command, args, { env = {}, cwd = root } = {}) {
  const result = spawnSync(command, args, {
    cwd,
    env: { ...process.env, ...env },
    encoding: 'utf8',
    maxBuffer: 2 ** 28,
  });
  return { ok: result.status === 0, stdout: result.stdout ?? '', stderr: result.stderr ?? '' };
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

/** Runs `main` and turns a Failure into one printed sentence and exit code 1. */
export async function asProgram(main) {
  try {
    await main();
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
    console.error(`\n${error.message}`);
    process.exitCode = 1;
  }
}
