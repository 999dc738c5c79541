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
  const { buffer, byteOffset, length } = mesh.positions;
  const bits = new Uint32Array(buffer, byteOffset, length);
  const isAdded = new Uint8Array(mesh.vertexSlots);
  for (const v of corners) {
    if (isAdded[v] === 1) continue;
    isAdded[v] = 1;
    add(bits.subarray(3 * v, 3 * v + 3));
  }
  return (hash >>> 0).toString(16).padStart(8, '0');
}
