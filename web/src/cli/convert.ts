import type { Arguments, Options } from './arguments.js';
import { COMMON, type Command, progressMode, WRITING } from './command.js';
import { orComplain } from './complaint.js';
import { outputFormat } from './formats.js';
import { loadOrTell, nameOf } from './input.js';
import { adaptTextures, nameOfOutput, print, printError, save } from './output.js';
import { Progress } from './progress.js';
import { inputAndOutput } from './repair.js';

const OPTIONS: Options = {
  triangulate: { help: 'cuts faces with more corners into triangles, concave ones too' },
  ...WRITING,
  ...COMMON,
};

export const convert: Command = {
  name: 'convert',
  summary: 'Writes a file in another format.',
  operands: '<input> [<output>]',
  details: `The format is that which the name of the output ends in, or --to; without an output the file goes
to standard output. What had to be repaired on the way is told on standard error.
Exit status: 0 if the file was written, else 2.`,
  options: OPTIONS,
  run,
};

async function run(args: Arguments): Promise<number> {
  const { input, output } = inputAndOutput(args);
  const format = outputFormat(args, output);
  const progress = new Progress(progressMode(args));
  const tell = output === '-' ? printError : print;
  const loaded = await loadOrTell(input, args, progress, tell);
  if (loaded === undefined) return 2;
  const { mesh, report } = loaded;
  adaptTextures(mesh, report.format, format);
  if (args.has('triangulate')) orComplain(nameOf(input), () => mesh.triangulate());
  const { vertexCount: vertices, edgeCount: edges, faceCount: faces } = mesh;
  const notes = await save(loaded, output, format, args);
  mesh.dispose();
  const { summary } = report;
  if (args.has('json')) {
    const { format: from, counts } = report;
    const told = { input: nameOf(input), output, from, to: format };
    tell(JSON.stringify({ ...told, vertices, edges, faces, counts, notes, summary }));
  } else if (!args.has('quiet')) {
    if (report.problems.some(({ severity, code }) => severity !== 'info' || code === 'note')) {
      printError(`${nameOf(input)}: ${summary}`);
    }
    for (const note of notes) printError(`${nameOfOutput(output)}: ${note}`);
  }
  return 0;
}
