import type { HalfedgeMesh } from '../../api.js';
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
    return { kind: 'returned', value: links ?? sendable(result), reads };
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
