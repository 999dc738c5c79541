import { HalfedgeError, HalfedgeMesh } from 'halfedge';
import type { Sample } from '../samples/index.js';

/** A mesh on show, and where it came from. */
export interface MeshDocument {
  readonly name: string;
  readonly mesh: HalfedgeMesh;
  /** The id of the sample, or null for a file of the user. */
  readonly sample: string | null;
  /** The vertex that is selected first; null for one in the middle of the picture. */
  readonly start: number | null;
  /** What was mended in the file, in one line; null if nothing was. */
  readonly repairs: string | null;
  /** From where the mesh is first seen. */
  readonly view: readonly [number, number, number];
}

/** A sentence for somebody whose file or sample could not be opened. */
export interface OpenFailure {
  readonly title: string;
  readonly message: string;
}

const FORMATS = ['obj', 'off', 'ply', 'stl'] as const;

export async function openSample(sample: Sample): Promise<MeshDocument> {
  const { name, start, view, id } = sample;
  return { name, mesh: await sample.load(), sample: id, start, repairs: null, view };
}

/** Reads an OBJ, OFF, PLY or STL file; mends what makes no manifold; throws what `HalfedgeMesh.parse` throws. */
export async function openFile(file: File): Promise<MeshDocument> {
  const extension = file.name.split('.').at(-1)?.toLowerCase();
  const format = FORMATS.find((known) => known === extension);
  const bytes = new Uint8Array(await file.arrayBuffer());
  const { mesh, report } = HalfedgeMesh.parse(bytes, format ? { format } : {});
  const isMended = report.problems.some(({ severity }) => severity === 'warning');
  return {
    name: file.name,
    mesh,
    sample: null,
    start: null,
    repairs: isMended ? report.summary : null,
    view: [0.35, 0.3, 1],
  };
}

export function failureOf(error: unknown, name: string): OpenFailure {
  const title = `“${name}” was not opened`;
  if (error instanceof HalfedgeError || error instanceof Error) {
    return { title, message: error.message };
  }
  return { title, message: String(error) };
}
