// Consumers whose own `lib` has no Symbol.dispose need this; the emitted types keep it.
/// <reference lib="esnext.disposable" preserve="true" />

import {
  type BuildOptions,
  type FaceOptions,
  faceLinks,
  type Polygons,
  polygonLinks,
  STORAGE_OPTIONS,
  type StorageOptions,
  storesPrev,
  triangleLinks,
} from './build.js';
import { refuse } from './checks.js';
import { answer, type Refusal } from './edit.js';
import type { Problem } from './errors.js';
import { type FileSoup, type FileSoupOptions, parseSoup } from './file-soup.js';
import { printed } from './inspect.js';
import type { Halfedge } from './items.js';
import { Links } from './links.js';
import { core } from './loader.js';
import { outOfMemory } from './memory.js';
import { linksOf } from './navigation.js';
import { checkOptions } from './options.js';
import { type FileFormat, type ParseOptions, type ParseReport, parseFile } from './parse.js';
import { type RepairReport, type SoupOptions, soupLinks } from './repair.js';
import { unwrap } from './reports.js';
import { makeMeshesWith, Shapes } from './shapes.js';
import {
  boundaryLoopsOf,
  type Component,
  componentsOf,
  polygonsOf,
  problemsOf,
  trianglesOf,
  type ValidationLevel,
} from './topology.js';
import { type AppendMaps, appendLinks, bytesOfLinks, dualLinks, linksOfBytes } from './transfer.js';
import { warmUp } from './warm-up.js';
import { type OwnBytes, type WriteOptions, writeFile } from './write.js';

/** Where the platform has no `Symbol.dispose` yet, polyfills register theirs under this name. */
const disposeSymbol: typeof Symbol.dispose = Symbol.dispose ?? Symbol.for('Symbol.dispose');

/**
 * A halfedge mesh: vertices, halfedges, edges and faces of any number of corners, with positions.
 *
 * Items are plain integers. The mesh lives in WebAssembly memory; `dispose()` frees it, as does `using`. The
 * garbage collector does so, too, but late: it doesn't know of that memory. Who makes many meshes disposes of
 * them.
 *
 * ```ts
 * await init();
 * using mesh = HalfedgeMesh.fromTriangles([0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 2]);
 * for (const w of mesh.vertexVertices(0)) console.log(w);
 * ```
 */
export class HalfedgeMesh extends Shapes {
  /** An empty mesh. */
  constructor(options?: StorageOptions);
  /** @internal */
  constructor(links: Links);
  constructor(given: unknown = {}) {
    super(given instanceof Links ? given : emptyLinks(given));
    warmUp();
  }

  static {
    makeMeshesWith((links) => new HalfedgeMesh(links));
  }

  /**
   * The mesh of a triangle soup over shared vertices: an index buffer. Vertex i and face j of the mesh
   * are vertex i and face j of the input, in any order of the faces. The input is copied, and not changed.
   * Typed arrays are the fastest: one copy, and linear time.
   *
   * Strict: it must be an oriented 2-manifold, with or without boundary.
   *
   * @param positions x, y, z of each vertex
   * @param indices three vertices of each face, counter-clockwise
   * @throws HalfedgeError with the `problems` found, up to a thousand: `edge-with-many-faces`, `opposite-orientation`,
   * `duplicate-face`, `repeated-vertex`, `pinched-vertex`, `index-out-of-range`,
   * `non-finite-position`, `out-of-memory`; TypeError or RangeError for what is no such array.
   */
  static fromTriangles(
    positions: ArrayLike<number>,
    indices: ArrayLike<number>,
    options: BuildOptions = {},
  ): HalfedgeMesh {
    return new HalfedgeMesh(triangleLinks(positions, indices, options));
  }

  /**
   * As {@link fromTriangles}, with faces of any number of corners.
   *
   * @param faces an array of vertices for each face, or, without an array for each face, all
   * `sizes` and all `corners` in a row
   * @throws HalfedgeError also `degree-below-three`
   */
  static fromPolygons(
    positions: ArrayLike<number>,
    faces: ArrayLike<ArrayLike<number>> | Polygons,
    options: BuildOptions = {},
  ): HalfedgeMesh {
    return new HalfedgeMesh(polygonLinks(positions, faces, options));
  }

  /**
   * Connectivity alone, for what has no geometry or keeps it elsewhere: a planar map, a dual, an
   * abstract complex. As {@link fromPolygons}; all positions are zero.
   *
   * @throws HalfedgeError as {@link fromPolygons}
   */
  static fromFaces(
    faces: ArrayLike<ArrayLike<number>> | Polygons,
    options: FaceOptions = {},
  ): HalfedgeMesh {
    return new HalfedgeMesh(faceLinks(faces, options));
  }

  /**
   * The mesh of any polygons at all: what {@link fromPolygons} would refuse is mended, and reported.
   * Polygons that need no repair give the same mesh. Faces and vertices keep their order; copies of
   * vertices come last. The mesh is valid at level 4, and its shape does not depend on the order of
   * the faces.
   *
   * Faces that are none are left out, duplicates kept once; faces are turned to agree with most of
   * their component, and one-sided surfaces cut; edges with more than two faces and pinched vertices
   * are doubled; vertices are welded if asked for.
   *
   * ```ts
   * const { mesh, report } = HalfedgeMesh.fromSoup(positions, faces, { weld: true });
   * console.log(report.summary); // 3 duplicate faces left out, 12 faces turned over.
   * ```
   *
   * @param faces as `fromPolygons` takes them, or an index buffer of triangles
   * @throws HalfedgeError `bad-size`, `too-large`, `out-of-memory`; TypeError or RangeError for what
   * is no such array
   */
  static fromSoup(
    positions: ArrayLike<number>,
    faces: ArrayLike<number> | ArrayLike<ArrayLike<number>> | Polygons,
    options: SoupOptions = {},
  ): { mesh: HalfedgeMesh; report: RepairReport } {
    const { links, report } = soupLinks(positions, faces, options);
    return { mesh: new HalfedgeMesh(links), report };
  }

  /**
   * The mesh in a file, whose content tells the format: Wavefront OBJ, or Geomview OFF, PLY or STL in
   * text or binary form. Vertex i and face j of the mesh are the i-th vertex and the j-th face of the
   * file. STL repeats its vertices: there, vertex i is the i-th position that differs from those before
   * it. Text, or its bytes.
   *
   * What the file says beside that becomes {@link attributes}: `normal`, `color` and `uv`, and what
   * else it has a name for; texture coordinates and normals of corners are attributes of halfedges.
   *
   * Faces that make no manifold are mended as {@link fromSoup} does, and the report says so, with the
   * lines of the faces; with `repair: false` they are an error. A file that needs no repair gives the
   * same mesh in both ways.
   *
   * @throws HalfedgeError with the line, or the byte of a binary file, and what was expected there
   * (`parse-error`, `truncated`, `unknown-format`, `unsupported-format`, `not-text`, ...), or with
   * `repair: false` as {@link fromPolygons}, with the lines of the faces; `cancelled` by `onProgress`
   */
  static parse(
    data: string | ArrayBuffer | Uint8Array,
    options: ParseOptions = {},
  ): { mesh: HalfedgeMesh; report: ParseReport } {
    const { links, report } = parseFile(data, options);
    return { mesh: new HalfedgeMesh(links), report };
  }

  /**
   * What a file holds, before a mesh is made of it: positions and faces as they stand there, good or bad.
   * They are numbered as the problems of {@link parse} name them, and {@link fromSoup} takes them, with
   * options that `parse` has not:
   *
   * ```ts
   * const { positions, faces } = HalfedgeMesh.parseSoup(bytes);
   * const { mesh, report } = HalfedgeMesh.fromSoup(positions, faces, { weld: 1e-6 });
   * ```
   *
   * Who only reads files, to draw them for example, needs no more: `attributes` has what else the file
   * says of vertices, corners and faces, and `weld: false` leaves the triangles of STL apart.
   *
   * @throws HalfedgeError as {@link parse}, where the file itself can't be read
   */
  static parseSoup(
    data: string | ArrayBuffer | Uint8Array,
    options: FileSoupOptions = {},
  ): FileSoup {
    return parseSoup(data, options);
  }

  /**
   * A file of this mesh: its live vertices and faces, each in the order of their indices. Reading it
   * gives the same polygons and the same bits of each position, also from text, whose numbers have
   * as many digits as that takes; and the same attributes, where the format has a place for them (`normal`,
   * `color` and `uv` by their usual names; PLY has one for most). In STL, which has triangles alone, polygons are
   * cut as `triangulate` does, and isolated vertices are left out.
   *
   * @returns text where the encoding is `'text'`, as by default that of OBJ and OFF; else the bytes
   * @throws HalfedgeError `unsupported-format` (an encoding that the format doesn't have),
   * `non-finite-position` (in STL), `corrupt-connectivity`, `out-of-memory`
   */
  write(format: 'obj', options?: WriteOptions): string;
  write(format: 'off', options?: WriteOptions & { encoding?: 'text' | undefined }): string;
  write(
    format: 'ply' | 'stl',
    options?: WriteOptions & { encoding?: 'binary' | 'binary-big-endian' | undefined },
  ): OwnBytes;
  write(format: FileFormat, options: WriteOptions & { encoding: 'text' }): string;
  write(
    format: FileFormat,
    options: WriteOptions & { encoding: 'binary' | 'binary-big-endian' },
  ): OwnBytes;
  write(format: FileFormat, options?: WriteOptions): string | OwnBytes;
  write(format: FileFormat, options: WriteOptions = {}): string | OwnBytes {
    return writeFile(linksOf(this), format, options);
  }

  /**
   * The mesh to the last word, deleted slots and attributes included, to keep it or to send it to a
   * worker: what {@link fromBytes} reads. History and generations are no part of it. The format is
   * documented in src/halfedge/io/bytes.h, and has a version.
   */
  toBytes(): OwnBytes {
    return bytesOfLinks(linksOf(this));
  }

  /**
   * The mesh that {@link toBytes} was asked of. The bytes may come from anywhere: everything that a
   * mesh needs to be safe is checked, levels 0 to 2 of {@link validate} included.
   *
   * @throws HalfedgeError `unknown-format`, `unsupported-version`, `truncated`, `parse-error` (with what
   * was expected at which byte), `corrupt-connectivity`, `out-of-memory`; TypeError for what are no bytes
   */
  static fromBytes(bytes: ArrayBuffer | ArrayBufferView): HalfedgeMesh {
    return new HalfedgeMesh(linksOfBytes(bytes));
  }

  /**
   * Adds a copy of the live items of `other`, which may be this mesh itself, and returns where they
   * went. The parts are not joined. Deleted slots are taken first; items that are here keep their
   * indices. Attributes that both have (the same kind, name, type and number of components) are
   * copied; what only this mesh has gets its default; what only `other` has is left out, so add it
   * here first if it should be kept. One step of history.
   *
   * @throws HalfedgeError `too-large`, `out-of-memory`, `corrupt-connectivity` (of `other`); then nothing
   * has changed
   */
  append(other: HalfedgeMesh): AppendMaps {
    linksOf(this).checkAlive();
    if (!(other instanceof HalfedgeMesh)) refuse('other', other, 'a HalfedgeMesh');
    return appendLinks(linksOf(this), linksOf(other));
  }

  /** Why {@link append} would be refused, or null. O(slots of `other`). */
  checkAppend(other: HalfedgeMesh): Refusal | null {
    const links = linksOf(this);
    links.checkAlive();
    if (!(other instanceof HalfedgeMesh)) refuse('other', other, 'a HalfedgeMesh');
    const added = linksOf(other);
    added.checkAlive();
    return answer(links, links.core._check_append(links.address, added.address));
  }

  /**
   * The dual: a new mesh with a vertex in the centroid of each face, and a face around each vertex that
   * is not on the boundary. Its vertex i is in the i-th live face, its face j around the j-th live
   * interior vertex. So the dual of the dual of a closed mesh has the same vertices and faces, in the
   * same order. Attributes are not carried over.
   *
   * @throws HalfedgeError where the dual would be no polygon mesh: `degree-below-three` (an interior
   * vertex of valence 1 or 2), `duplicate-edge` (two faces that share two edges), `same-face-twice` (an
   * edge with one face on both sides), `pinched-vertex` (a face whose interior corners are not side by
   * side); or `corrupt-connectivity`, `non-finite-position`, `out-of-memory`
   */
  dual(): HalfedgeMesh {
    return new HalfedgeMesh(dualLinks(linksOf(this)));
  }

  /** Why {@link dual} would be refused, or null. Takes as long as that. */
  checkDual(): Refusal | null {
    const links = linksOf(this);
    links.checkAlive();
    return answer(links, links.core._check_dual(links.address));
  }

  /** A copy of this mesh with the same indices, of its own memory. */
  clone(): HalfedgeMesh {
    const links = linksOf(this);
    const address = links.core.cloneMesh(links.address);
    if (address === 0) throw outOfMemory(`a copy of ${this.halfedgeCount} halfedges`);
    return new HalfedgeMesh(new Links(links.core, address));
  }

  /**
   * One halfedge of each boundary loop, in ascending order. `halfedgeLoop(h)` walks the loop.
   * O(halfedges).
   */
  boundaryLoops(): Halfedge[] {
    return boundaryLoopsOf(linksOf(this));
  }

  /**
   * Checks the invariants of the mesh, those of `level` (0 to 4) and below: an empty list means that
   * it is valid. Levels 0 to 3 check the links, level 4 adds the rules of polygon meshes. Isolated
   * and pinched vertices are told, as information and as a warning, but are no error. At most 1000 of
   * each code are listed, and how many more there are. Linear time, whatever the arrays hold.
   *
   * `'geometry'` adds to level 4 where the vertices lie: `non-finite-position`, an error; and as
   * warnings `zero-length-edge`, `degenerate-face` (no wider than 10^-6 of its length, or without area:
   * what {@link removeDegenerateFaces} removes where it can), and `coincident-vertices`, which no edges
   * without length join.
   */
  validate(level: ValidationLevel = 4): Problem[] {
    return problemsOf(linksOf(this), level);
  }

  /** Vertices - edges + faces. */
  eulerCharacteristic(): number {
    const links = linksOf(this);
    return links.core.eulerCharacteristic(links.address);
  }

  /** The number of handles of all components together; boundaries don't change it. O(halfedges). */
  genus(): number {
    const links = linksOf(this);
    return unwrap(links.core.genus(links.address)).genus;
  }

  /**
   * The connected components, in the order of their smallest vertices. Parts that share only a
   * pinched vertex are connected. Isolated vertices belong to no component. O(halfedges).
   */
  components(): Component[] {
    return componentsOf(linksOf(this));
  }

  /**
   * A copy of the live faces, in ascending order: how many corners each has, and the vertices of all
   * corners in a row, as `fromPolygons` takes them.
   */
  toPolygons(): { sizes: Uint32Array; corners: Uint32Array } {
    return polygonsOf(linksOf(this));
  }

  /**
   * A copy of the live faces as an index buffer, for drawing, and for each triangle the face that it
   * is a part of. Faces with more corners become fans around their first: right for convex ones.
   */
  toTriangles(): { indices: Uint32Array; faces: Uint32Array } {
    return trianglesOf(linksOf(this));
  }

  /** Frees the memory of this mesh at once. Any later use throws; disposing twice does nothing. */
  dispose(): void {
    linksOf(this).dispose();
  }

  /** Whether `dispose()` was called. */
  get disposed(): boolean {
    return linksOf(this).disposed;
  }

  /** `dispose()`, at the end of the block that declares `using mesh = ...`. */
  [disposeSymbol](): void {
    this.dispose();
  }
}

printed('HalfedgeMesh', HalfedgeMesh, (mesh) => {
  if (mesh.disposed) return { disposed: true };
  const { vertexCount, edgeCount, faceCount } = mesh;
  return { vertexCount, edgeCount, faceCount };
});

function emptyLinks(options: unknown): Links {
  if (options instanceof HalfedgeMesh) {
    refuse('options', options, 'an object such as { storePrev }: to copy a mesh, use its clone()');
  }
  const withPrev = storesPrev(checkOptions(options, STORAGE_OPTIONS));
  const wasm = core();
  const address = wasm.createMesh(withPrev);
  if (address === 0) throw outOfMemory('a mesh');
  return new Links(wasm, address);
}
