import type { HalfedgeMesh } from '../index.js';
import type { Arguments, Options } from './arguments.js';
import { COMMON, type Command, progressMode, WRITING } from './command.js';
import { Complaint } from './complaint.js';
import { outputFormat } from './formats.js';
import { inputsOf, load, nameOf } from './input.js';
import { adaptTextures, counted, print, printError, save } from './output.js';
import { Progress } from './progress.js';

const OPTIONS: Options = {
  'drop-isolated': { help: 'leaves out the vertices without faces' },
  'keep-largest': { value: 'n', help: 'keeps the n largest components alone' },
  ...WRITING,
  ...COMMON,
};

export const repair: Command = {
  name: 'repair',
  summary: 'Makes a valid mesh of any file, and tells what it did.',
  operands: '<input> [<output>]',
  details: `Faces that are none are left out and duplicates kept once, faces are turned to agree with their
neighbours, edges with more than two faces and pinched vertices are doubled. The report goes to
standard output, or to standard error if the mesh goes there: that is so without an output.
Exit status: 0 if the mesh was written, else 2.`,
  options: OPTIONS,
  run,
};

async function run(args: Arguments): Promise<number> {
  const { input, output } = inputAndOutput(args);
  const keep = args.number('keep-largest', 1);
  const progress = new Progress(progressMode(args));
  outputFormat(args, output, 'obj'); // complain before reading
  const loaded = await load(input, args, progress);
  const { mesh, report } = loaded;
  const format = outputFormat(args, output, report.format);
  adaptTextures(mesh, report.format, format);
  const extra = [...dropIsolated(mesh, args), ...keepLargest(mesh, keep)];
  const { vertexCount: vertices, edgeCount: edges, faceCount: faces } = mesh;
  await save(loaded, output, format, args);
  mesh.dispose();
  if (args.has('quiet')) return 0;
  const tell = output === '-' ? printError : print;
  if (args.has('json')) {
    const { format: from, counts, verdicts, problems } = report;
    const summary = [report.summary, ...extra].join(' ');
    tell(
      JSON.stringify({
        ...{ input: nameOf(input), output, from, to: format, vertices, edges, faces },
        ...{ counts, verdicts, problems, summary },
      }),
    );
    return 0;
  }
  for (const { message } of report.problems) tell(message);
  const size = `${counted(vertices, 'vertex', 'vertices')}, ${counted(edges, 'edge')}, ${counted(faces, 'face')}`;
  tell(`${nameOf(input)}: ${[report.summary, ...extra].join(' ')}`);
  tell(`${output === '-' ? 'standard output' : output}: ${format.toUpperCase()}: ${size}.`);
  return 0;
}

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
  return { input, output: named ?? second ?? '-' };
}

function dropIsolated(mesh: HalfedgeMesh, args: Arguments): string[] {
  const dropped = args.has('drop-isolated') ? mesh.deleteIsolatedVertices() : 0;
  if (dropped === 0) return [];
  return [`${counted(dropped, 'vertex', 'vertices')} without faces dropped.`];
}

function keepLargest(mesh: HalfedgeMesh, keep: number | undefined): string[] {
  if (keep === undefined) return [];
  if (!Number.isInteger(keep)) {
    throw new Complaint(`--keep-largest is ${keep}; expected a whole number from 1.`);
  }
  const deleted = mesh.keepLargestComponents(keep);
  return deleted === 0 ? [] : [`${counted(deleted, 'smaller component')} dropped.`];
}
