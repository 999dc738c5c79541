import type { HalfedgeMesh } from '../../api.js';
import { typedArrayName } from '../../arguments.js';
import { offered } from './offered.js';
import { type LinkArrays, type Outcome, type Read, sendable } from './outcome.js';
import { allowTurns, Endless, lineOf, messageOf, type Program } from './program.js';

/** What a function is called with: a part of a task that can be sent to a worker. */
export interface Terms {
  readonly gets: 'mesh' | 'links';
  readonly uses: readonly string[];
}

/** No more turns than these are noted. */
const MOST_TURNS = 60;

/** Calls a student's function once, and notes what comes of it. Nothing is changed in the mesh. */
export function attempt(
  program: Program,
  { gets, uses }: Terms,
  mesh: HalfedgeMesh,
  parameters: readonly (number | string)[],
): Outcome {
  const reads: Read[] = [];
  const links = gets === 'links' ? copyOf(mesh.connectivity) : null;
  const turns: { line: number; reads: number }[] = [];
  allowTurns((line) => {
    if (turns.length < MOST_TURNS) turns.push({ line, reads: reads.length });
  });
  try {
    const given = links ?? offered(mesh, uses, reads);
    const result = program(given, ...parameters);
    // A generator runs only now.
    return {
      kind: 'returned',
      value: links ? leftOf(links, Object.keys(mesh.connectivity)) : sendable(result),
      reads,
    };
  } catch (error) {
    if (error instanceof Endless) {
      const { line } = error;
      const own = turns.filter((turn) => turn.line === line).map((turn) => turn.reads);
      return { kind: 'endless', line, recursive: false, turns: own, reads };
    }
    if (/call stack|too much recursion/i.test(messageOf(error))) {
      return { kind: 'endless', line: lineOf(error), recursive: true, turns: [], reads };
    }
    return { kind: 'threw', message: messageOf(error), line: lineOf(error), reads };
  }
}

function copyOf(links: LinkArrays): LinkArrays {
  const { next, prev, toVertex, face, vertexHalfedge, faceHalfedge } = links;
  return {
    next: next.slice(),
    prev: prev.slice(),
    toVertex: toVertex.slice(),
    face: face.slice(),
    vertexHalfedge: vertexHalfedge.slice(),
    faceHalfedge: faceHalfedge.slice(),
  };
}

/**
 * Copies of the arrays that a program has left. What it has put in the place of one, or has sent elsewhere,
 * may be nothing that can be sent from a worker.
 */
function leftOf(links: LinkArrays, names: readonly string[]): Partial<LinkArrays> {
  const left: Record<string, Int32Array> = {};
  for (const name of names) {
    const array = links[name as keyof LinkArrays];
    // One that was sent away has no elements, and can't be gone through.
    if (typedArrayName(array) === 'Int32Array') {
      left[name] = array.length === 0 ? new Int32Array() : Int32Array.from(array);
    }
  }
  return left;
}
