import type { Arguments, Options } from './arguments.js';
import type { ProgressMode } from './progress.js';

/** What the program can be asked to do. */
export interface Command {
  readonly name: string;
  /** One sentence. */
  readonly summary: string;
  /** What stands behind the name. */
  readonly operands: string;
  /** The rest of the help. */
  readonly details: string;
  readonly options: Options;
  /** Returns the exit status. */
  run(args: Arguments): Promise<number>;
}

/** Options of all commands. */
export const COMMON: Options = {
  from: {
    value: 'format',
    help: 'obj, off, ply, stl, glb or gltf, where the content leaves that open',
  },
  json: { help: 'prints JSON, a line for each file, also with --quiet' },
  progress: { help: 'tells the progress also where standard error is no terminal' },
  quiet: { short: 'q', help: 'prints neither progress nor reports but those of --json' },
  help: { short: 'h', help: 'prints this' },
};

/** Options of the commands that write a file. */
export const WRITING: Options = {
  output: { value: 'file', short: 'o', help: 'where to, instead of naming it second' },
  to: {
    value: 'format',
    help: 'obj, off, ply, stl, glb or gltf, if the name of the output tells no other',
  },
  encoding: {
    value: 'encoding',
    help: 'text, binary or binary-big-endian (PLY); else text for OBJ and OFF, binary for PLY and STL',
  },
};

export function progressMode(args: Arguments): ProgressMode {
  if (args.has('quiet')) return 'never';
  return args.has('progress') ? 'always' : 'automatic';
}

/** The help of one command. */
export function helpOf({ name, summary, operands, details, options }: Command): string {
  const rows = Object.entries(options).map(([option, { value, short, help }]) => {
    const both = `${short === undefined ? '    ' : `-${short}, `}--${option}`;
    return [value === undefined ? both : `${both} <${value}>`, help] as const;
  });
  const width = Math.max(...rows.map(([option]) => option.length));
  const list = rows.map(([option, help]) => `  ${option.padEnd(width)}  ${help}`).join('\n');
  return `${summary}\n\nUsage: halfedge ${name} [options] ${operands}\n\n${details}\n\nOptions:\n${list}`;
}
