import { counted } from '../counted.js';
import type { Problem } from '../index.js';
import type { Arguments, Options } from './arguments.js';
import { COMMON, type Command, progressMode } from './command.js';
import { orComplain } from './complaint.js';
import { faultsOf } from './faults.js';
import { forEachFile, inputsOf, load, nameOf } from './input.js';
import { print } from './output.js';
import { Progress } from './progress.js';

const OPTIONS: Options = {
  geometry: {
    help: 'also looks for edges without length, faces without area and vertices in one place',
  },
  strict: { help: 'counts warnings as problems, such as fans that touch in a vertex' },
  ...COMMON,
};

export const check: Command = {
  name: 'check',
  summary: 'Tells whether files hold valid meshes, and what is wrong with those that do not.',
  operands: '<file>...',
  details: `A file is valid if its faces make an oriented manifold as they stand, with boundary or without.
Each problem is a line with its code, and with the line of the file where that has lines.
Exit status: 0 if all files are valid, 1 if one has problems, 2 if one can't be read.`,
  options: OPTIONS,
  run,
};

async function run(args: Arguments): Promise<number> {
  const progress = new Progress(progressMode(args));
  return forEachFile(inputsOf(args.operands), args, async (path) =>
    (await checkOne(path, args, progress)) ? 0 : 1,
  );
}

async function checkOne(path: string, args: Arguments, progress: Progress): Promise<boolean> {
  const { mesh, report } = await load(path, args, progress);
  const level = args.has('geometry') ? 'geometry' : 4;
  const faults = orComplain(nameOf(path), () => faultsOf(mesh, report, level));
  mesh.dispose();
  const grave = faults.filter(
    ({ severity }) => severity === 'error' || (severity === 'warning' && args.has('strict')),
  );
  const valid = grave.length === 0;
  if (args.has('json')) {
    const { format, counts } = report;
    const problems = faults.map(withoutMesh);
    print(JSON.stringify({ file: nameOf(path), readable: true, format, valid, counts, problems }));
  } else if (!args.has('quiet')) {
    for (const { severity, code, message } of faults) {
      print(`${nameOf(path)}: ${severity}: ${message} [${code}]`);
    }
    const unlisted = Object.values(report.unlisted).reduce((sum, count) => sum + count, 0);
    if (unlisted > 0) print(`${nameOf(path)}: and ${unlisted} more`);
    print(`${nameOf(path)}: ${valid ? 'valid' : verdict(faults, unlisted)}`);
  }
  return valid;
}

/** Without the fields that say nothing of a file. */
function withoutMesh({ kind, index, ...rest }: Problem) {
  return kind === 'mesh' ? rest : { ...rest, kind, index };
}

function verdict(faults: readonly Problem[], unlisted: number): string {
  const errors = faults.filter(({ severity }) => severity === 'error').length + unlisted;
  const warnings = faults.filter(({ severity }) => severity === 'warning').length;
  const parts = [
    ...(errors > 0 ? [counted(errors, 'problem')] : []),
    ...(warnings > 0 ? [counted(warnings, 'warning')] : []),
  ];
  return parts.join(', ');
}
