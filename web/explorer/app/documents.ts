import { HalfedgeMesh } from 'halfedge';
import type { BrokenSample } from '../samples/broken.js';
import type { Sample } from '../samples/index.js';
import { type Diagnosis, diagnose } from './diagnosis.js';

/** A mesh on show, and where it came from. */
export interface MeshDocument {
  readonly name: string;
  /** What a file of it is called, without an extension. */
  readonly stem: string;
  readonly mesh: HalfedgeMesh;
  /** The id of the sample, or null for a file of the user. */
  readonly sample: string | null;
  /** The vertex that is selected first; null for one in the middle of the picture. */
  readonly start: number | null;
  /** What was found wrong in the file; null if nothing was, or there is no file. */
  readonly diagnosis: Diagnosis | null;
  /** Of a broken sample: what is wrong with it, and what to look at. */
  readonly lesson: string | null;
  /** From where the mesh is first seen. */
  readonly view: readonly [number, number, number];
}

/** A sentence for somebody whose file or sample could not be opened. */
export interface OpenFailure {
  readonly title: string;
  readonly message: string;
  /** Of a broken sample that can't be read: why it is there. */
  readonly lesson: string | null;
}

/** What can be opened. */
export type Source = Sample | BrokenSample | File;

const FORMATS = ['obj', 'off', 'ply', 'stl'] as const;

export async function openSource(source: Source): Promise<MeshDocument> {
  if (source instanceof File) return openFile(source);
  return 'load' in source ? openSample(source) : openBrokenSample(source);
}

async function openSample({ id, name, start, view, load }: Sample): Promise<MeshDocument> {
  const mesh = await load();
  return { name, stem: id, mesh, sample: id, start, diagnosis: null, lesson: null, view };
}

function openBrokenSample({ id, name, view, lesson, file }: BrokenSample): MeshDocument {
  const { extension, content } = file();
  const bytes = typeof content === 'string' ? new TextEncoder().encode(content) : content;
  const opened = openContent(`${id}.${extension}`, bytes);
  return { ...opened, name, sample: id, lesson, view };
}

/** Reads an OBJ, OFF, PLY or STL file; throws what `HalfedgeMesh.parse` throws. */
async function openFile(file: File): Promise<MeshDocument> {
  return openContent(file.name, new Uint8Array(await file.arrayBuffer()));
}

/** Mends what makes no manifold. */
function openContent(name: string, content: Uint8Array): MeshDocument {
  const dot = name.lastIndexOf('.');
  const extension = name.slice(dot + 1).toLowerCase();
  const format = FORMATS.find((known) => known === extension);
  const { mesh, report } = HalfedgeMesh.parse(content, format ? { format } : {});
  return {
    name,
    stem: dot > 0 ? name.slice(0, dot) : name,
    mesh,
    sample: null,
    start: null,
    diagnosis: diagnose(content, format, report),
    lesson: null,
    view: [0.35, 0.3, 1],
  };
}

export function failureOf(error: unknown, source: Source): OpenFailure {
  const message = error instanceof Error ? error.message : String(error);
  const lesson = 'lesson' in source ? source.lesson : null;
  return { title: `“${source.name}” was not opened`, message, lesson };
}
