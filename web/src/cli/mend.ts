import type { HalfedgeMesh, Problem } from '../index.js';
import type { Arguments, Options } from './arguments.js';
import { Complaint } from './complaint.js';
import { counted } from './output.js';

/** What a step did, in a sentence, and what it had to leave. */
interface Done {
  readonly summary: string;
  readonly problems: readonly Problem[];
}

/** The repairs of a mesh that can be asked for, in the order in which they are done. */
export const MENDING: Options = {
  stitch: {
    value: 'distance',
    help: 'glues boundary edges no further apart; 0: that lie together',
  },
  'remove-degenerate': { help: 'removes faces without area and edges without length' },
  'drop-small': { value: 'n', help: 'drops components of fewer than n faces' },
  'keep-largest': { value: 'n', help: 'keeps the n largest components alone' },
  'fill-holes': { value: 'n', help: 'fills holes of up to n edges with triangles' },
  orient: { help: 'turns closed components so that their faces look outward' },
  'drop-isolated': { help: 'leaves out the vertices without faces' },
};

const STEPS: Record<string, (mesh: HalfedgeMesh, number: number) => Done> = {
  stitch: (mesh, tolerance) => {
    // Pinched vertices are in the way.
    const { problems } = mesh.splitPinchedVertices();
    const stitched = mesh.stitchBoundaries({ tolerance });
    return { summary: stitched.summary, problems: [...problems, ...stitched.problems] };
  },
  'remove-degenerate': (mesh) => mesh.removeDegenerateFaces(),
  'drop-small': (mesh, faces) => mesh.dropSmallComponents({ faces }),
  'keep-largest': (mesh, count) => {
    const dropped = mesh.keepLargestComponents(count);
    return { summary: `${counted(dropped, 'smaller component')} dropped.`, problems: [] };
  },
  'fill-holes': (mesh, maxEdges) => mesh.fillHoles({ maxEdges }),
  orient: (mesh) => mesh.orientOutward(),
  'drop-isolated': (mesh) => {
    const dropped = mesh.deleteIsolatedVertices();
    const vertices = counted(dropped, 'vertex', 'vertices');
    return { summary: `${vertices} without faces dropped.`, problems: [] };
  },
};

/** The steps that are asked for, their numbers checked. */
export function plan(args: Arguments): ((mesh: HalfedgeMesh) => Done)[] {
  return Object.entries(MENDING)
    .filter(([name]) => args.has(name))
    .map(([name, { value }]) => {
      const number = value === undefined ? 0 : numberOf(args, name, value);
      return (mesh) => STEPS[name](mesh, number);
    });
}

function numberOf(args: Arguments, name: string, value: string): number {
  const isCount = value === 'n';
  const number = args.number(name, isCount ? 1 : 0) as number;
  if (isCount && !Number.isInteger(number)) {
    throw new Complaint(`--${name} is ${number}; expected a whole number from 1.`);
  }
  return number;
}
