// The benchmark in Node.

import { fork } from 'node:child_process';
import { once } from 'node:events';
import { fileURLToPath } from 'node:url';

const PROGRAM = fileURLToPath(new URL('node-program.mjs', import.meta.url));
/** See chromium.mjs. */
const FLAGS = ['--expose-gc', '--no-concurrent-recompilation'];

/** Runs it in a program of its own. */
export async function inNode({ say, ...options }) {
  const program = fork(PROGRAM, { execArgv: FLAGS, serialization: 'advanced' });
  program.send(options);
  let measured;
  program.on('message', ({ name, ...message }) => {
    if (name === undefined) measured = message;
    else say(name);
  });
  // What it has sent is there once it is disconnected.
  const [[code]] = await Promise.all([once(program, 'exit'), once(program, 'disconnect')]);
  if (measured === undefined) throw new Error(`The benchmark in Node ended with code ${code}.`);
  return { engine: `Node ${process.version.slice(1)}`, ...measured };
}
