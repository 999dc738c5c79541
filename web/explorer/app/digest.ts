import type { HalfedgeMesh } from 'halfedge';

/**
 * A short text that is the same for the same faces in the same places: by it, tests and embedding
 * pages can tell whether the mesh on show is one that they know.
 */
export function digestOf(mesh: HalfedgeMesh): string {
  const { sizes, corners } = mesh.toPolygons();
  // FNV-1a, over words instead of bytes.
  let hash = 0x811c9dc5;
  const add = (words: Uint32Array) => {
    for (const word of words) hash = Math.imul(hash ^ word, 0x01000193);
  };
  add(sizes);
  add(corners);
  for (const v of new Set(corners)) add(bits(mesh.positions.subarray(3 * v, 3 * v + 3)));
  return (hash >>> 0).toString(16).padStart(8, '0');
}

function bits(values: Float32Array): Uint32Array {
  return new Uint32Array(values.buffer, values.byteOffset, values.length);
}
