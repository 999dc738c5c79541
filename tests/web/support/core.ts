// A private door, for tests only: what a user of the package can't and needn't see.
import type { DirectedEdgesMesh, HalfedgeMesh, RepairReport } from 'halfedge';
import { directedLinksOf } from '../../../dist/directed-edges/navigation.js';
import { addAttributes } from '../../../dist/gltf/corners.js';
import { core } from '../../../dist/loader.js';
import { linksOf } from '../../../dist/navigation.js';

/** The bytes that are allocated in WebAssembly memory. */
export const bytesInUse = (): number => core().bytesInUse();

/** The size of WebAssembly memory. */
export const memorySize = (): number => core().memory.buffer.byteLength;

/** Makes WebAssembly memory grow, which detaches all views, without making a mesh. */
export function growMemory(): void {
  const blocks: number[] = [];
  for (const size = memorySize(); size === memorySize(); ) {
    const address = core().allocate(2 ** 22);
    if (address === 0) throw new Error('The memory is as large as it can be.');
    blocks.push(address);
  }
  for (const address of blocks) core().free(address);
}

/** Detaches all views without a word to whoever has some: the case that nobody is prepared for. */
export function growSilently(): void {
  const { memory } = core();
  const { grow } = memory;
  memory.grow = WebAssembly.Memory.prototype.grow;
  growMemory();
  memory.grow = grow;
}

/** Leaves the links of one mesh as silent growth does, but without any, of which there is not enough for all tests. */
export function detach(mesh: DirectedEdgesMesh): void {
  const none = new Int32Array(0);
  Object.assign(directedLinksOf(mesh as never), {
    opposite: none,
    toVertex: none,
    boundaryNext: none,
    boundaryPrev: none,
    vertexHalfedge: none,
  });
}

/** Whether growth of the memory has detached the views through which a mesh is read. */
export const isDetached = (mesh: HalfedgeMesh): boolean => linksOf(mesh as never).detached;

/**
 * Runs `use` with a full heap: what is allocated next, if it is larger than the holes (128 KiB), makes the
 * memory grow and detaches all views. Throws if it did not.
 */
export function withFullHeap<T>(use: () => T): T {
  const piece = 2 ** 16;
  const blocks: number[] = [];
  let address = 0;
  while (address + 2 * piece <= memorySize()) {
    address = core().allocate(piece);
    blocks.push(address);
  }
  const size = memorySize();
  try {
    const result = use();
    if (memorySize() === size) throw new Error('The memory has not grown: nothing was tested.');
    return result;
  } finally {
    for (const block of blocks) core().free(block);
  }
}

/** Runs `use` while blocks of these sizes are taken. They are never written: they cost no memory. */
export function withTaken(sizes: number[], use: () => void): void {
  const blocks = sizes.map((bytes) => core().allocate(bytes));
  if (blocks.includes(0)) throw new Error(`There is no room for blocks of ${sizes} bytes.`);
  try {
    use();
  } finally {
    for (const address of blocks) core().free(address);
  }
}

/** Runs `use` with hardly more left of the 4 GiB than one block of so many bytes. */
export function withLeft(bytes: number, use: () => void): void {
  const left = core().allocate(bytes);
  const blocks: number[] = [];
  for (let size = 2 ** 31; size >= 64; ) {
    const address = core().allocate(size);
    if (address === 0) size /= 2;
    else blocks.push(address);
  }
  core().free(left);
  try {
    use();
  } finally {
    for (const address of blocks) core().free(address);
  }
}

/** Gives attributes by corner to a mesh, as readGltf does. */
export const giveCornerAttributes = addAttributes as unknown as (
  mesh: HalfedgeMesh,
  report: RepairReport,
  indices: Uint32Array,
  attributes: readonly { name: string; components: number; values: Float32Array }[],
) => void;

/** What every change of connectivity does to circulators, without a change. */
export function changeConnectivity(mesh: HalfedgeMesh): void {
  linksOf(mesh as never).version += 1;
}

/** Makes room for so much that the arrays of the mesh move, and overwrites what they leave behind. */
export function moveArrays(mesh: HalfedgeMesh): void {
  const { next } = mesh.connectivity;
  mesh.reserve(3 * mesh.vertexSlots, 3 * mesh.edgeSlots, 3 * mesh.faceSlots);
  // Small blocks, because those are taken from what is free between others.
  const bytes = 512;
  const blocks = Array.from({ length: 2000 }, () => core().allocate(bytes));
  for (const block of blocks) new Uint32Array(core().memory.buffer, block, bytes / 4).fill(0);
  for (const block of blocks) core().free(block);
  if (next.length === 0) throw new Error('The memory has grown, and detached the views.');
  const kept = next.filter((h, i) => h === mesh.connectivity.next[i]).length;
  if (2 * kept > next.length) throw new Error('The arrays were not overwritten.');
}
