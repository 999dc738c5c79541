import { counted } from '../counted.js';
import type { Arguments, Options } from './arguments.js';
import { COMMON, type Command, progressMode, WRITING } from './command.js';
import { Complaint, orComplain } from './complaint.js';
import { outputFormat } from './formats.js';
import { inputsOf, loadOrTell, nameOf, refuseEmptyNames } from './input.js';
import { type Done, MENDING, plan } from './mend.js';
import { adaptTextures, nameOfOutput, print, printError, save } from './output.js';
import { Progress } from './progress.js';

const OPTIONS: Options = {
  ...MENDING,
  ...WRITING,
  ...COMMON,
};

export const repair: Command = {
  name: 'repair',
  summary: 'Makes a valid mesh of any file, and tells what it did.',
  operands: '<input> [<output>]',
  details: `Faces that are none are left out and duplicates kept once, faces are turned to agree with their
neighbours, edges with more than two faces and pinched vertices are doubled. Then follows what the
options ask for, in this order. The report goes to standard output, or to standard error if the
mesh goes there: that is so without an output.
Exit status: 0 if the mesh was written, else 2.`,
  options: OPTIONS,
  run,
};

async function run(args: Arguments): Promise<number> {
  const { input, output } = inputAndOutput(args);
  const steps = plan(args);
  const progress = new Progress(progressMode(args));
  outputFormat(args, output, 'obj'); // complain before reading
  const tell = output === '-' ? printError : print;
  const loaded = await loadOrTell(input, args, progress, tell);
  if (loaded === undefined) return 2;
  const { mesh, report } = loaded;
  const format = outputFormat(args, output, report.format);
  adaptTextures(mesh, report.format, format);
  const done = steps.map((step) => orComplain(nameOf(input), () => step(mesh)));
  const summary = summaryOf(report, done);
  const problems = [report, ...done].flatMap((step) => step.problems);
  const { vertexCount: vertices, edgeCount: edges, faceCount: faces } = mesh;
  const notes = await save(loaded, output, format, args);
  mesh.dispose();
  if (args.has('json')) {
    const { format: from, counts, verdicts } = report;
    tell(
      JSON.stringify({
        ...{ input: nameOf(input), output, from, to: format, vertices, edges, faces },
        ...{ counts, steps: done.map(factsOf), verdicts, problems, notes, summary },
      }),
    );
    return 0;
  }
  if (args.has('quiet')) return 0;
  for (const { message } of problems) tell(message);
  const size = `${counted(vertices, 'vertex', 'vertices')}, ${counted(edges, 'edge')}, ${counted(faces, 'face')}`;
  tell(`${nameOf(input)}: ${summary}`);
  tell(`${nameOfOutput(output)}: ${format.toUpperCase()}: ${size}.`);
  for (const note of notes) printError(`${nameOfOutput(output)}: ${note}`);
  return 0;
}

/** What was done, by reading and by the steps that did or left anything; that it is nothing, once. */
function summaryOf(report: Pick<Done, 'counts' | 'summary'>, done: readonly Done[]): string {
  const told = done.filter(isAnything).map(({ summary }) => summary);
  if (told.length === 0 && !isAnything(report)) told.push('Nothing to repair.');
  return [report.summary, ...told].join(' ');
}

const isAnything = ({ counts }: Pick<Done, 'counts'>) => Object.keys(counts).length > 0;

/** What of a step is told in JSON; its problems are with all others. */
const factsOf = ({ name, counts, summary }: Done) => ({ step: name, counts, summary });

/** The two files of a command that reads one and writes one. */
export function inputAndOutput(args: Arguments): { input: string; output: string } {
  const named = args.value('output');
  const [input] = inputsOf(args.operands.slice(0, 1));
  const [, second, ...rest] = args.operands;
  const tooMany = named === undefined ? rest : second === undefined ? [] : [second];
  if (tooMany.length > 0) {
    throw new Complaint(
      `${JSON.stringify(tooMany[0])} is one file too many; expected one to read and one to write.`,
    );
  }
  const output = named ?? second ?? '-';
  refuseEmptyNames([output]);
  return { input, output };
}
