import type { RawFailure, RawProblem } from './core.js';
import { counted } from './counted.js';
import { HalfedgeError, NO_WITNESS, type Problem, type Witness } from './errors.js';

/** What the core lists of each code of a repair at most. */
export const LISTED = 100;

/** The result of a call into the core; throws what it failed of. */
export function unwrap<T extends object>(raw: T | RawFailure): T {
  if (!('problems' in raw)) return raw;
  const problems = raw.problems.map((problem) => problemOf(problem, 'error'));
  const first = problems[0];
  const more = raw.problemCount - 1;
  const others = more === 0 ? '' : ` And ${more} more ${more === 1 ? 'problem' : 'problems'}.`;
  throw new HalfedgeError(first.code, first.message + others, {
    witness: first.witness ?? NO_WITNESS,
    problems,
  });
}

/** A problem as the package shows it. */
export function problemOf(
  { code, message, ...items }: RawProblem,
  severity: Problem['severity'],
): Required<Problem> {
  const witness: Witness = {
    vertices: Array.from(items.vertices),
    halfedges: Array.from(items.halfedges),
    edges: Array.from(items.edges),
    faces: Array.from(items.faces),
  };
  return { code, severity, ...subjectOf(witness), message: sentenceOf(code, message), witness };
}

/** The message of a problem as a whole sentence, and advice where the package has some. */
export function sentenceOf(code: string, message: string): string {
  const advice = code === 'out-of-memory' ? ' Dispose of meshes that are no longer needed.' : '';
  return sentence(message) + advice;
}

/**
 * What a problem is about: a face or a vertex if it names one, else its first face, else the one edge or
 * halfedge that it names.
 */
function subjectOf({
  faces,
  vertices,
  edges,
  halfedges,
}: Witness): Pick<Problem, 'kind' | 'index'> {
  if (vertices.length === 1 && faces.length !== 1) return { kind: 'vertex', index: vertices[0] };
  if (faces.length > 0) return { kind: 'face', index: faces[0] };
  if (edges.length === 1) return { kind: 'edge', index: edges[0] };
  if (halfedges.length === 1) return { kind: 'halfedge', index: halfedges[0] };
  return { kind: 'mesh', index: -1 };
}

/** The report of a file: what is in it, what was repaired, and what was ignored. */
export function fileReport<Found extends FoundInFile>(
  name: string,
  mesh: { readonly vertexCount: number; readonly edgeCount: number; readonly faceCount: number },
  found: Found,
  notes: readonly string[],
): Found {
  const ignored = notes.map((message): Problem => {
    return { code: 'note', severity: 'info', kind: 'mesh', index: -1, message };
  });
  const counts = [
    counted(mesh.vertexCount, 'vertex', 'vertices'),
    counted(mesh.edgeCount, 'edge', 'edges'),
    counted(mesh.faceCount, 'face', 'faces'),
  ];
  const repairs = found.problems.length > 0 ? [found.summary] : [];
  return {
    ...found,
    problems: [...found.problems, ...ignored],
    summary: [`${name}: ${counts.join(', ')}.`, ...repairs, ...notes].join(' '),
  };
}

interface FoundInFile {
  readonly problems: readonly Problem[];
  readonly summary: string;
}

/** As a whole sentence: some parts of the core leave out the capital and the full stop. */
export function sentence(text: string): string {
  if (isSentence(text)) return text;
  const readable = text.replace(/(?:\\x[89a-f][0-9a-f])+/g, lettersOf);
  const capital = readable.charAt(0).toUpperCase() + readable.slice(1);
  return /[.!?]( \([^()]*\))?$/.test(capital) ? capital : `${capital}.`;
}

/** Whether it clearly is one: begins with A to Z, and spells no bytes. Quick, as most refusals are never read. */
function isSentence(text: string): boolean {
  return text >= 'A' && text < '[' && text.endsWith('.') && !text.includes('\\');
}

/** Bytes as the core spells them where they aren't ASCII (`\xc3\x9c`) as letters, if they are some in UTF-8. */
function lettersOf(spelt: string): string {
  const bytes = spelt
    .slice(2)
    .split('\\x')
    .map((byte) => Number.parseInt(byte, 16));
  try {
    const decoder = new TextDecoder('utf-8', { fatal: true, ignoreBOM: true });
    const letters = decoder.decode(Uint8Array.from(bytes));
    // What can't be seen, or turns a line around.
    return /[\p{C}\p{Z}]/u.test(letters) ? spelt : letters;
  } catch {
    return spelt;
  }
}
