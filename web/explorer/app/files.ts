import type { FileFormat } from 'halfedge';
import type { MeshDocument } from './documents.js';

/** A file of the mesh on show. */
export interface MeshFile {
  readonly name: string;
  readonly content: Blob;
  /** What of the mesh isn't in it. */
  readonly notes: readonly string[];
}

/** The mesh as a file; throws what `HalfedgeMesh.write` throws. */
export function fileOf(opened: MeshDocument, format: FileFormat): MeshFile {
  const notes: string[] = [];
  const content = opened.mesh.write(format, {
    names: opened.names,
    onNote: (note) => notes.push(note),
  });
  return { name: fileName(opened, format), content: new Blob([content]), notes };
}

/** `scan-repaired.stl`: of letters that every system takes in the name of a file. */
export function fileName(
  { stem, diagnosis }: MeshDocument,
  format: FileFormat | 'png' | 'svg',
): string {
  const plain = stem
    .replace(/[^\p{L}\p{N}._-]+/gu, '-')
    .replace(/^[-.]+|[-.]+$/g, '')
    .slice(0, 100);
  return `${plain || 'mesh'}${diagnosis?.isRepaired ? '-repaired' : ''}.${format}`;
}

/** `1.4 MB`. */
export function sizeWords(bytes: number): string {
  if (bytes < 1000) return `${bytes} bytes`;
  const [unit, name] = bytes < 1e6 ? [1e3, 'kB'] : [1e6, 'MB'];
  return `${(bytes / unit).toPrecision(bytes / unit < 100 ? 2 : 3)} ${name}`;
}
