import { counted } from '../counted.js';
import type { HalfedgeMesh, RepairReport, XYZ } from '../index.js';
import type { Arguments } from './arguments.js';
import { COMMON, type Command, progressMode } from './command.js';
import { orComplain } from './complaint.js';
import { faultsOf, repairCount } from './faults.js';
import { forEachFile, inputsOf, type Loaded, load, nameOf } from './input.js';
import { print, table } from './output.js';
import { Progress } from './progress.js';

export const info: Command = {
  name: 'info',
  summary: 'Tells what is in a file: counts, topology, validity, size.',
  operands: '<file>...',
  details: `Reads OBJ, OFF, PLY, STL, glTF and GLB files, or standard input (-). What can't be part of a mesh as it
stands is repaired first, and the line "valid" says so.
Exit status: 0, or 2 if a file can't be read; the others are told of all the same.`,
  options: COMMON,
  run,
};

async function run(args: Arguments): Promise<number> {
  const progress = new Progress(progressMode(args));
  const inputs = inputsOf(args.operands);
  let printed = 0;
  return forEachFile(inputs, args, async (path) => {
    const loaded = await load(path, args, progress);
    const facts = orComplain(nameOf(path), () => factsOf(path, loaded));
    const repairs = repairCount(loaded.report);
    loaded.mesh.dispose();
    if (args.has('json')) {
      print(JSON.stringify(facts));
    } else if (!args.has('quiet')) {
      if (printed++ > 0) print('');
      if (inputs.length > 1) print(nameOf(path));
      print(asText(facts, repairs));
    }
    return 0;
  });
}

function factsOf(path: string, { mesh, report, size }: Loaded) {
  const { vertexCount, halfedgeCount, edgeCount, faceCount } = mesh;
  const boundaryLoops = mesh.boundaryLoops().length;
  return {
    file: nameOf(path),
    readable: true,
    format: report.format,
    bytes: size,
    vertices: vertexCount,
    halfedges: halfedgeCount,
    edges: edgeCount,
    faces: faceCount,
    facesByDegree: facesByDegree(mesh),
    eulerCharacteristic: mesh.eulerCharacteristic(),
    components: mesh.components().length,
    boundaryLoops,
    closed: boundaryLoops === 0 && faceCount > 0,
    genus: mesh.genus(),
    isolatedVertices: isolatedVertices(mesh),
    boundingBox: mesh.boundingBox(),
    area: mesh.area(),
    volume: boundaryLoops === 0 && faceCount > 0 ? mesh.volume() : null,
    ...validity(mesh, report),
    notes: report.problems.filter(({ code }) => code === 'note').map(({ message }) => message),
  };
}

function validity(mesh: HalfedgeMesh, report: RepairReport) {
  const valid = !faultsOf(mesh, report).some(({ severity }) => severity === 'error');
  return { valid, repairs: report.counts };
}

/** How many faces there are of each number of corners. */
function facesByDegree(mesh: HalfedgeMesh): Record<number, number> {
  const counts: Record<number, number> = {};
  for (const size of mesh.toPolygons().sizes) counts[size] = (counts[size] ?? 0) + 1;
  return counts;
}

function isolatedVertices(mesh: HalfedgeMesh): number {
  const { vertexHalfedge } = mesh.connectivity;
  return vertexHalfedge.reduce((count, h) => count + (h < 0 ? 1 : 0), 0);
}

const NAMES: Record<number, string> = { 3: 'triangle', 4: 'quad', 5: 'pentagon', 6: 'hexagon' };

function asText(facts: ReturnType<typeof factsOf>, repairs: number): string {
  const { boundingBox: box } = facts;
  const byDegree = Object.entries(facts.facesByDegree).map(([degree, count]) =>
    counted(count, NAMES[Number(degree)] ?? `face of ${degree} corners`, many(Number(degree))),
  );
  const few = byDegree.length > 5 ? [...byDegree.slice(0, 4), '...'] : byDegree;
  return table([
    ['format', facts.format.toUpperCase()],
    ['size', `${facts.bytes} bytes`],
    ['vertices', String(facts.vertices)],
    ['halfedges', String(facts.halfedges)],
    ['edges', String(facts.edges)],
    ['faces', `${facts.faces}${few.length > 0 ? ` (${few.join(', ')})` : ''}`],
    ['Euler characteristic', String(facts.eulerCharacteristic)],
    ['components', String(facts.components)],
    ['boundary loops', `${facts.boundaryLoops}${facts.closed ? ' (closed)' : ''}`],
    ['genus', String(facts.genus)],
    ['isolated vertices', String(facts.isolatedVertices)],
    ['bounding box', box === null ? 'none' : `${point(box.min)} to ${point(box.max)}`],
    [
      'extent',
      box === null ? 'none' : point(box.max.map((value, axis) => value - box.min[axis]) as XYZ),
    ],
    ['area', short(facts.area)],
    ['volume', facts.volume === null ? 'none' : short(facts.volume)],
    ['valid', facts.valid ? 'yes' : `no (${counted(repairs, 'repair')}; see halfedge check)`],
    ...facts.notes.map((note) => ['note', note] as [string, string]),
  ]);
}

const many = (degree: number) =>
  degree in NAMES ? `${NAMES[degree]}s` : `faces of ${degree} corners`;
const point = (p: XYZ) => p.map(short).join(' ');
const short = (value: number) => String(Number(value.toPrecision(7)));
