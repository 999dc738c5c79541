// The raw WebAssembly module, as wasm/bindings.cpp declares it. Emscripten 3.1.6 can't write these
// types itself. Addresses and counts are unsigned 32-bit numbers; 0 is the null address.

/** What a refused build or a reader reports; the items of witnesses are plain numbers. */
export interface RawProblem {
  code: string;
  message: string;
  vertices: number[];
  halfedges: number[];
  edges: number[];
  faces: number[];
}

/** The address of a new mesh, or 0 and what was wrong. */
export interface RawBuild {
  mesh: number;
  problems: RawProblem[];
  /** All problems, listed or not. */
  problemCount: number;
}

export interface RawCore {
  /** Bytes at a multiple of 16; 0 when memory is exhausted. */
  allocate(bytes: number): number;
  free(address: number): void;
  /** Allocated bytes, for tests: without leaks it returns to where it was. */
  bytesInUse(): number;

  /** An empty mesh, or 0. */
  createMesh(): number;
  /** A copy, slot by slot, or 0. */
  cloneMesh(mesh: number): number;
  destroyMesh(mesh: number): void;
  /** Where the arrays of a mesh lie: 15 words, in the order that `Links.refresh` reads them. */
  layout(mesh: number): number;

  /** Counts are numbers of elements; without sizes all faces are triangles. */
  build(
    positions: number,
    positionCount: number,
    sizes: number,
    sizeCount: number,
    corners: number,
    cornerCount: number,
  ): RawBuild;
}

export interface CoreOptions {
  instantiateWasm(
    imports: WebAssembly.Imports,
    receive: (instance: WebAssembly.Instance) => void,
  ): object;
}

export default function createCore(options: CoreOptions): Promise<RawCore>;
