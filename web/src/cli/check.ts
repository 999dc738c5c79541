import type { Problem, RepairReport } from '../index.js';
import type { Arguments, Options } from './arguments.js';
import { COMMON, type Command, progressMode } from './command.js';
import { orComplain } from './complaint.js';
import { faultsOf } from './faults.js';
import { forEachFile, inputsOf, load, nameOf } from './input.js';
import { counted, print } from './output.js';
import { Progress } from './progress.js';

const OPTIONS: Options = {
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
  const faults = orComplain(nameOf(path), () => faultsOf(mesh, report));
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
    const unlisted = unlistedOf(report);
    if (unlisted > 0) print(`${nameOf(path)}: and ${unlisted} more`);
    print(`${nameOf(path)}: ${valid ? 'valid' : verdict(faults, unlisted)}`);
  }
  return valid;
}

/** Without the fields that say nothing of a file. */
function withoutMesh({ kind, index, ...rest }: Problem) {
  return kind === 'mesh' ? rest : { ...rest, kind, index };
}

/** What the report lists of each code at most. */
const LISTED = 100;

function unlistedOf({ counts, problems }: RepairReport): number {
  return Object.entries(counts).reduce((sum, [code, count]) => {
    const listed = problems.filter((problem) => problem.code === code).length;
    return listed < LISTED ? sum : sum + count - listed;
  }, 0);
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
