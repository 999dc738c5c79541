#!/usr/bin/env node
// The command-line tool. It uses the package as its users do; nothing of the package uses this.

import { readFileSync } from 'node:fs';
import { HalfedgeError, init } from '../index.js';
import { readArguments, suggestion } from './arguments.js';
import { check } from './check.js';
import { type Command, helpOf } from './command.js';
import { Complaint, unwritable } from './complaint.js';
import { convert } from './convert.js';
import { info } from './info.js';
import { print, printError } from './output.js';
import { repair } from './repair.js';

const COMMANDS: readonly Command[] = [info, check, repair, convert];

/** What a shell shows for a program that was ended because its pipe was closed (SIGPIPE). */
const BROKEN_PIPE = 141;

function help(): string {
  const list = COMMANDS.map(({ name, summary }) => `  ${name.padEnd(8)} ${summary}`).join('\n');
  return `halfedge ${version()}: reads, checks, repairs and converts polygon meshes.

Usage: halfedge <command> [options] <file>...

Commands:
${list}

\`halfedge <command> --help\` tells the options of a command, \`halfedge --version\` the version.
Files are OBJ, OFF, PLY, STL, glTF or GLB, told by their content; - is standard input or output.
glTF and GLB need three.js: \`npm install three\`.`;
}

function version(): string {
  const manifest = readFileSync(new URL('../../package.json', import.meta.url), 'utf8');
  return (JSON.parse(manifest) as { version: string }).version;
}

function commandNamed(name: string): Command {
  const command = COMMANDS.find((candidate) => candidate.name === name);
  if (command !== undefined) return command;
  if (isOptionOfACommand(name)) {
    throw new Complaint(`${name} follows the command: \`halfedge <command> ${name}\`.`);
  }
  const what = name.startsWith('-') ? 'option' : 'command';
  const names = COMMANDS.map((candidate) => candidate.name);
  const alike =
    what === 'command' ? suggestion(name, names) : suggestion(name, ['--help', '--version']);
  throw new Complaint(
    `${JSON.stringify(name)} is no ${what} of halfedge.${alike || ' `halfedge --help` lists them.'}`,
  );
}

/** Whether a word is an option of some command, with or without its value. */
function isOptionOfACommand(word: string): boolean {
  const spelt = word.replace(/=.*/s, '');
  return COMMANDS.flatMap(({ options }) => Object.entries(options)).some(
    ([name, { short }]) => spelt === `--${name}` || (short !== undefined && spelt === `-${short}`),
  );
}

/** Runs the program; returns its exit status. */
async function main(line: string[]): Promise<number> {
  const [first, ...rest] = line;
  if (first === undefined) {
    printError(help());
    return 2;
  }
  if (first === '--version' || first === '-v' || first === '-V') {
    print(version());
    return 0;
  }
  if (first === '--help' || first === '-h' || first === 'help') {
    print(rest.length > 0 ? helpOf(commandNamed(rest[0])) : help());
    return 0;
  }
  const command = commandNamed(first);
  const args = readArguments(command.name, command.options, rest);
  if (args.has('help')) {
    print(helpOf(command));
    return 0;
  }
  await init();
  return command.run(args);
}

/** The sentence of what a user can change; of anything else, which is our fault, all that is known. */
function told(error: unknown): string {
  const isOfTheMachine = error instanceof HalfedgeError && error.code === 'init-failed';
  if (error instanceof Complaint || isOfTheMachine) return error.message;
  const all = error instanceof Error ? (error.stack ?? error.message) : String(error);
  return `An unexpected error, which is worth reporting: ${all}`;
}

for (const [name, stream] of [
  ['Standard output', process.stdout],
  ['Standard error', process.stderr],
] as const) {
  stream.on('error', (error: NodeJS.ErrnoException) => {
    // Whoever reads the output may stop doing so, as `head` does: that is no error.
    if (error.code === 'EPIPE') process.exit(BROKEN_PIPE);
    if (stream === process.stdout) printError(`halfedge: ${unwritable(name, error)}`);
    process.exit(2);
  });
}

try {
  process.exitCode = await main(process.argv.slice(2));
} catch (error) {
  printError(`halfedge: ${told(error)}`);
  process.exitCode = 2;
}
