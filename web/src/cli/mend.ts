import { counted } from '../counted.js';
import type { HalfedgeMesh, Problem } from '../index.js';
import type { Arguments, Options } from './arguments.js';
import { Complaint } from './complaint.js';

/** What a step did, in numbers and in a sentence, and what it had to leave. */
export interface Done {
  /** The option that asked for it. */
  readonly name: string;
  readonly counts: Readonly<Record<string, number>>;
  readonly summary: string;
  readonly problems: readonly Problem[];
}

/** The repairs of a mesh that can be asked for, in the order in which they are done. */
export const MENDING: Options = {
  stitch: {
    value: 'distance',
    help: 'splits pinched vertices, then glues boundary edges closer than that; 0: that lie together',
  },
  'remove-degenerate': { help: 'removes faces without area and edges without length' },
  'drop-small': { value: 'n', help: 'drops components of fewer than n faces' },
  'keep-largest': { value: 'n', help: 'keeps the n largest components alone' },
  'fill-holes': { value: 'n', help: 'fills holes of up to n edges with triangles' },
  orient: { help: 'turns closed components so that their faces look outward' },
  'drop-isolated': { help: 'leaves out the vertices without faces' },
};

const STEPS: Record<string, (mesh: HalfedgeMesh, number: number) => Omit<Done, 'name'>> = {
  stitch: (mesh, tolerance) => {
    // Pinched vertices are in the way.
    const split = mesh.splitPinchedVertices();
    const stitched = mesh.stitchBoundaries({ tolerance });
    const told = [split, stitched].filter(({ counts }) => Object.keys(counts).length > 0);
    return {
      counts: { ...split.counts, ...stitched.counts },
      summary: told.map(({ summary }) => summary).join(' ') || stitched.summary,
      problems: [...split.problems, ...stitched.problems],
    };
  },
  'remove-degenerate': (mesh) => mesh.removeDegenerateFaces(),
  'drop-small': (mesh, faces) => mesh.dropSmallComponents({ faces }),
  'keep-largest': (mesh, count) => {
    const dropped = mesh.keepLargestComponents(count);
    return {
      counts: { 'dropped-component': dropped },
      summary: `${counted(dropped, 'smaller component')} dropped.`,
      problems: [],
    };
  },
  'fill-holes': (mesh, maxEdges) => mesh.fillHoles({ maxEdges }),
  orient: (mesh) => mesh.orientOutward(),
  'drop-isolated': (mesh) => {
    const dropped = mesh.deleteIsolatedVertices();
    const vertices = counted(dropped, 'vertex', 'vertices');
    return {
      counts: { 'isolated-vertex': dropped },
      summary: `${vertices} without faces dropped.`,
      problems: [],
    };
  },
};

/** The steps that are asked for, their numbers checked. */
export function plan(args: Arguments): ((mesh: HalfedgeMesh) => Done)[] {
  return Object.entries(MENDING)
    .filter(([name]) => args.has(name))
    .map(([name, { value }]) => {
      const number = value === undefined ? 0 : numberOf(args, name, value);
      return (mesh) => ({ name, ...STEPS[name](mesh, number) });
    });
}

/** No mesh has more of anything. */
const MOST = 2 ** 31 - 1;

function numberOf(args: Arguments, name: string, value: string): number {
  const isCount = value === 'n';
  const number = args.number(name, isCount ? 1 : 0) as number;
  if (isCount && !(Number.isInteger(number) && number <= MOST)) {
    throw new Complaint(`--${name} is ${number}; expected a whole number from 1 to ${MOST}.`);
  }
  return number;
}
