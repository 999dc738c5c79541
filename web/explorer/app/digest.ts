import type { HalfedgeMesh } from 'halfedge';

/**
 * A short text that is the same for the same faces in the same places: by it, tests and embedding
 * pages can tell whether the mesh on show is one that they know.
 */
export function digestOf(mesh: HalfedgeMesh): string {
  const { sizes, corners } = mesh.toPolygons();
  let hash = added(added(0x811c9dc5, sizes, 0, sizes.length), corners, 0, corners.length);
  const { buffer, byteOffset, length } = mesh.positions;
  const bits = new Uint32Array(buffer, byteOffset, length);
  const isAdded = new Uint8Array(mesh.vertexSlots);
  for (let i = 0; i < corners.length; i++) {
    const v = corners[i];
    if (isAdded[v] === 1) continue;
    isAdded[v] = 1;
    hash = added(hash, bits, 3 * v, 3 * v + 3);
  }
  return (hash >>> 0).toString(16).padStart(8, '0');
}

/** FNV-1a, over words instead of bytes. */
function added(hash: number, words: Uint32Array, from: number, to: number): number {
  let sum = hash;
  for (let i = from; i < to; i++) sum = Math.imul(sum ^ words[i], 0x01000193);
  return sum;
}
