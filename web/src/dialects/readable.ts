import { refuse } from '../checks.js';

/**
 * What the dialects that only read ask of a mesh. `HalfedgeMesh` has it, and every other mesh of this
 * package with the same names.
 */
export interface ReadableMesh {
  readonly vertexCount: number;
  readonly halfedgeCount: number;
  readonly faceCount: number;
  readonly positions: Float32Array;
  next(h: number): number;
  prev(h: number): number;
  opposite(h: number): number;
  face(h: number): number;
  toVertex(h: number): number;
  nextOnVertex(h: number): number;
  prevOnVertex(h: number): number;
  vertexHalfedge(v: number): number;
  faceHalfedge(f: number): number;
  isBoundaryHalfedge(h: number): boolean;
  valence(v: number): number;
  degree(f: number): number;
  vertices(): Iterable<number>;
  halfedges(): Iterable<number>;
  faces(): Iterable<number>;
}

/** Throws a sentence for what is no mesh. */
export function checkReadable(
  mesh: unknown,
  expected = 'a HalfedgeMesh or a DirectedEdgesMesh',
): void {
  const { next, toVertex } = Object(mesh) as Partial<ReadableMesh>;
  if (typeof next === 'function' && typeof toVertex === 'function') return;
  refuse('mesh', mesh, expected);
}
