// The raw WebAssembly module, as wasm/bindings.cpp declares it. Emscripten 3.1.6 can't write these
// types itself. Addresses and counts are unsigned 32-bit numbers; 0 is the null address. `mesh` is
// the address of a mesh.

/** What went wrong in a call that returns an object. */
export interface RawFailure {
  problems: RawProblem[];
  /** All problems, listed or not. */
  problemCount: number;
}

/** One error of the core, with its witness. */
export interface RawProblem {
  code: string;
  message: string;
  vertices: Uint32Array;
  halfedges: Uint32Array;
  edges: Uint32Array;
  faces: Uint32Array;
}

/** One finding of a validation. */
export interface RawFinding {
  code: string;
  severity: string;
  kind: string;
  index: number;
  message: string;
}

/** 32-bit words that are JavaScript's to copy and to free. */
export interface RawWords {
  address: number;
  /** Elements; those of a component are four words. */
  count: number;
}

/** A column beside the polygons of a file. */
export interface RawColumn {
  /** With a letter for each byte. */
  name: string;
  /** Values of the enums SoupItem and Scalar. */
  item: number;
  type: number;
  components: number;
  /** Counted in bytes. */
  values: RawWords;
  /** By item its row; empty where row i is that of item i. */
  rows: RawWords;
}

export interface RawRows {
  offsets: RawWords;
  items: RawWords;
}

/** Three corners for each triangle, and its face. */
export interface RawTriangles {
  corners: RawWords;
  faces: RawWords;
}

/** What a repair has done. */
export interface RawRepair {
  repairs: RawProblem[];
  /** By value of the enum RepairCode in C++. */
  counts: number[];
  summary: string;
  /** Each is two words: a face; whether it is kept, and in the upper half a bit for each code. */
  verdicts: RawWords;
  vertexMap: RawWords;
  vertexOrigin: RawWords;
  faceMap: RawWords;
}

/** What a repair of a mesh has done, and not. */
export interface RawMending {
  left: RawProblem[];
  /** By the name of the enum Code in C++. */
  counts: Record<string, number>;
  summary: string;
  vertices: RawWords;
  edges: RawWords;
  faces: RawWords;
}

/** A column of attributes. */
export interface RawAttribute {
  attribute: number;
  kind: number;
  /** With a letter for each byte. */
  name: string;
  type: number;
  components: number;
  onSplit: number;
}

export interface RawCore {
  /** Aligned bytes; 0 when memory is exhausted. */
  allocate(bytes: number): number;
  free(address: number): void;
  /** Allocated bytes, for tests: without leaks it returns to where it was. */
  bytesInUse(): number;

  /** An empty mesh, or 0. */
  createMesh(storesPrev: boolean): number;
  /** A copy, slot by slot, or 0. */
  cloneMesh(mesh: number): number;
  destroyMesh(mesh: number): void;
  /** Where the arrays of a mesh lie: 19 words, in the order that `Links` reads them. */
  layout(mesh: number): number;

  /** Counts are numbers of elements; without sizes all faces are triangles. */
  build(
    positions: number,
    positionCount: number,
    sizes: number,
    sizeCount: number,
    corners: number,
    cornerCount: number,
    storesPrev: boolean,
  ): { mesh: number } | RawFailure;
  /**
   * `format` and `encoding` are values of the enums Format and Encoding in C++;
   * `names` is UTF-8 text of tables, each ended by NUL, of lines, each ended by LF. The bytes are JavaScript's to copy and to free.
   */
  write(
    mesh: number,
    format: number,
    encoding: number,
    attributes: boolean,
    withNotes: boolean,
    names: number,
    nameCount: number,
  ): { bytes: { address: number; count: number }; notes: string[] } | RawFailure;
  /**
   * `claimed` and `format` are values of the enum Format in C++; -1 claims nothing. `progress` gets a
   * value of the enum Stage and a fraction, must not throw, and cancels with false.
   */
  parse(
    bytes: number,
    count: number,
    claimed: number,
    repair: boolean,
    attributes: boolean,
    storesPrev: boolean,
    progress: ((stage: number, fraction: number) => boolean) | null,
  ):
    | ({
        mesh: number;
        format: number;
        notes: string[];
        /** With a letter for each byte. */
        names: Record<string, string[]>;
      } & Partial<RawRepair>)
    | RawFailure;
  /** The faces of a file as they stand there; `sizes` is empty if all are triangles. */
  parseSoup(
    bytes: number,
    count: number,
    claimed: number,
    welds: boolean,
    attributes: boolean,
  ):
    | {
        positions: RawWords;
        sizes: RawWords;
        corners: RawWords;
        attributes: RawColumn[];
        /** With a letter for each byte. */
        names: Record<string, string[]>;
        format: number;
        notes: string[];
      }
    | RawFailure;
  /**
   * A negative tolerance keeps vertices apart. `isSigned`: corners are named as signed numbers; `names`:
   * lines that have a corner and what it is named instead.
   */
  buildFromSoup(
    positions: number,
    positionCount: number,
    sizes: number,
    sizeCount: number,
    corners: number,
    cornerCount: number,
    tolerance: number,
    dropIsolated: boolean,
    isSigned: boolean,
    names: number,
    nameCount: number,
    storesPrev: boolean,
  ): ({ mesh: number } & RawRepair) | RawFailure;

  /** `kind` is an index into SHAPES, `faces` and `caps` are values of their enums in C++. */
  shape(
    kind: number,
    a: number,
    b: number,
    x: number,
    y: number,
    faces: number,
    caps: number,
    storesPrev: boolean,
  ): { mesh: number } | RawFailure;
  dual(mesh: number): { mesh: number } | RawFailure;
  /** `mode` as of an operation. Maps by slot of `other`. */
  append(
    mesh: number,
    other: number,
    mode: number,
  ): { vertices: RawWords; edges: RawWords; faces: RawWords } | RawFailure;
  /** The mesh of some faces, and the items that it is a copy of. */
  extract(
    mesh: number,
    faces: number,
    count: number,
  ): { mesh: number; vertices: RawWords; edges: RawWords; faces: RawWords } | RawFailure;
  /** The bytes are JavaScript's to copy and to free. */
  toBytes(mesh: number): { bytes: { address: number; count: number } } | RawFailure;
  /** `isOurs`: another thread with this module has made the bytes, which are not checked. */
  fromBytes(bytes: number, count: number, isOurs: boolean): { mesh: number } | RawFailure;

  isClosed(mesh: number): boolean;
  /** Whether all faces have three, or else four, corners. */
  onlyTrianglesOrQuads(mesh: number, triangles: boolean): boolean;
  /** `cornersAs` is a value of the enum CornersAs in C++. Of all faces, if `faces` is 0. */
  toTriangles(
    mesh: number,
    cornersAs: number,
    faces: number,
    count: number,
  ): RawTriangles | RawFailure;
  kRing(mesh: number, vertices: number, count: number, k: number): RawRows | RawFailure;
  /** `which` is a value of the enum Surroundings in C++. */
  surroundings(
    mesh: number,
    which: number,
    vertices: number,
    vertexCount: number,
    edges: number,
    edgeCount: number,
    faces: number,
    faceCount: number,
  ): { vertices: RawWords; edges: RawWords; faces: RawWords } | RawFailure;

  validate(mesh: number, level: number): RawFinding[];
  eulerCharacteristic(mesh: number): number;
  genus(mesh: number): { genus: number } | RawFailure;
  boundaryLoops(mesh: number): { halfedges: RawWords } | RawFailure;
  components(mesh: number): { list: RawWords; ofVertex: RawWords; ofFace: RawWords } | RawFailure;
  /** `ring` and `direction` are values of the enums Ring and Direction in C++. */
  allRings(mesh: number, ring: number, direction: number): RawRows | RawFailure;
  someRings(
    mesh: number,
    ring: number,
    direction: number,
    centres: number,
    count: number,
  ): RawRows | RawFailure;

  // Operations: plain exports, which cost next to nothing to call (operation_bindings.h). `mode` is a sum
  // of bits (edit.ts). They return what was made, -2 for a refusal, or -3 for want of memory.

  // Meshes out of others (making_bindings.cpp).
  _check_append(mesh: number, other: number): number;
  _check_dual(mesh: number): number;

  // One by one (construction_bindings.cpp).
  _add_vertex(mesh: number, mode: number, x: number, y: number, z: number): number;
  _set_position(mesh: number, mode: number, v: number, x: number, y: number, z: number): number;
  _add_face(mesh: number, mode: number, corners: number, count: number): number;
  _delete_vertex(mesh: number, mode: number, v: number): number;
  _delete_edge(mesh: number, mode: number, e: number): number;
  _delete_face(mesh: number, mode: number, f: number): number;
  _delete_isolated_vertices(mesh: number, mode: number): number;
  _delete_component(mesh: number, mode: number, kind: number, item: number): number;
  _keep_largest_components(mesh: number, mode: number, keep: number): number;
  _make_loop(mesh: number, mode: number): number;
  _make_segment(mesh: number, mode: number): number;
  _reserve(mesh: number, vertices: number, edges: number, faces: number): number;
  _clear(mesh: number): void;
  compact(
    mesh: number,
    mode: number,
  ): { vertices: RawWords; edges: RawWords; faces: RawWords } | RawFailure;
  /** `order`: an index into VERTEX_ORDERS. */
  reorder(
    mesh: number,
    mode: number,
    order: number,
  ): { vertices: RawWords; edges: RawWords; faces: RawWords } | RawFailure;
  /** Where a list of up to 64 items can be written. */
  _short_list(): number;

  // Euler operations (operation_bindings.cpp).
  _flip_edge(mesh: number, mode: number, e: number): number;
  _insert_vertex_on_edge(
    mesh: number,
    mode: number,
    e: number,
    x: number,
    y: number,
    z: number,
  ): number;
  _remove_vertex_on_edge(mesh: number, mode: number, v: number): number;
  _split_edge(mesh: number, mode: number, e: number, x: number, y: number, z: number): number;
  _collapse(mesh: number, mode: number, h: number, x: number, y: number, z: number): number;
  _split_vertex(
    mesh: number,
    mode: number,
    hl: number,
    hr: number,
    x: number,
    y: number,
    z: number,
  ): number;
  _insert_edge(mesh: number, mode: number, h: number, g: number): number;
  _remove_edge(mesh: number, mode: number, e: number): number;
  _dissolve_edge(mesh: number, mode: number, e: number): number;
  _split_face(mesh: number, mode: number, f: number, x: number, y: number, z: number): number;
  _dissolve_vertex(mesh: number, mode: number, v: number): number;
  _make_hole(mesh: number, mode: number, f: number): number;
  _fill_hole(mesh: number, mode: number, h: number): number;

  // Surgery (surgery_bindings.cpp).
  _glue(mesh: number, mode: number, h: number, g: number): number;
  _glue_path(mesh: number, mode: number, h: number, g: number, count: number): number;
  _cut(mesh: number, mode: number, h: number): number;
  _cut_path(mesh: number, mode: number, path: number, count: number): number;
  _cut_edges(mesh: number, mode: number, edges: number, count: number): number;
  _split_loop(mesh: number, mode: number, cycle: number, count: number): number;
  _join_loop(mesh: number, mode: number, h: number, g: number): number;
  _bridge(mesh: number, mode: number, h: number, g: number): number;
  _remove_bridge(mesh: number, mode: number, s: number): number;
  _reverse(mesh: number, mode: number): number;
  _reverse_component(mesh: number, mode: number, h: number): number;

  // Modelling (modelling_bindings.cpp).
  _triangulate(mesh: number, mode: number): number;
  _triangulate_face(mesh: number, mode: number, f: number): number;
  _extrude_face(mesh: number, mode: number, f: number, offset: number): number;
  _inset_face(mesh: number, mode: number, f: number, fraction: number): number;
  _poke(mesh: number, mode: number, f: number, offset: number): number;
  _bevel_edge(mesh: number, mode: number, e: number, amount: number): number;
  _bevel_vertex(mesh: number, mode: number, v: number, amount: number): number;

  /** `repair` is an index into REPAIRS; the numbers are its options. */
  mend(
    mesh: number,
    mode: number,
    repair: number,
    a: number,
    b: number,
    c: number,
  ): RawMending | RawFailure;

  /** Why the last call that returned -2 did so: where the words lie that `takeRefusal` reads. */
  _last_refusal(): number;
  /** Frees what they tell of. */
  _forget_refusal(): void;

  // History (history_bindings.cpp).

  /** 0 when memory is exhausted. */
  _enable_history(mesh: number, steps: number, bytes: number): number;
  _disable_history(mesh: number): void;
  _limit_history(mesh: number, steps: number, bytes: number): void;
  _forget_history(mesh: number): void;
  /** `which`: 0 for the steps that can be undone, 1 redone, 2 for the bytes of all. */
  _history_size(mesh: number, which: number): number;
  _end_step(mesh: number): void;
  _abandon_step(mesh: number): void;
  /** 0 if there is no step. */
  _undo(mesh: number): number;
  _redo(mesh: number): number;

  // Attributes (attribute_bindings.cpp). `attribute` is the address of a column. Enums are values of
  // those in C++.

  addAttribute(
    mesh: number,
    kind: number,
    name: number,
    nameCount: number,
    type: number,
    components: number,
    onSplit: number,
    defaults: number,
    defaultCount: number,
  ): { attribute: number } | RawFailure;
  removeAttribute(mesh: number, attribute: number): void;
  listAttributes(mesh: number): RawAttribute[];
  _attribute_values(attribute: number): number;
  _attribute_default(attribute: number): number;
  _set_attribute(
    mesh: number,
    mode: number,
    attribute: number,
    item: number,
    component: number,
    value: number,
  ): number;
  enableGenerations(mesh: number): object | RawFailure;
  disableGenerations(mesh: number): void;
  _has_generations(mesh: number): number;
  _generation(mesh: number, kind: number, item: number): number;

  // Directed Edges (directed_edges_bindings.cpp): `directed` is the address of such a mesh.

  buildDirectedEdges(
    positions: number,
    positionCount: number,
    corners: number,
    cornerCount: number,
  ): { mesh: number } | RawFailure;
  directedEdgesFromMesh(mesh: number): { mesh: number } | RawFailure;
  directedEdgesToMesh(directed: number): { mesh: number } | RawFailure;
  destroyDirectedEdges(directed: number): void;
  /** Where the arrays lie: 9 words, in the order that `DirectedLinks.refresh` reads them. */
  directedEdgesLayout(directed: number): number;
  validateDirectedEdges(directed: number, level: number): RawFinding[];
}

export interface CoreOptions {
  instantiateWasm(imports: object, receive: (instance: WebAssembly.Instance) => void): object;
}

export default function createCore(options: CoreOptions): Promise<RawCore>;
