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
import type { FaceLike, Halfedge, ItemList } from './items.js';
import { Links, wasDisposed } from './links.js';
import { core } from './loader.js';
import { outOfMemory } from './memory.js';
import { linksOf } from './navigation.js';
import type { ItemSet } from './neighbourhoods.js';
import { checkOptions } from './options.js';
import { type FileFormat, type ParseOptions, type ParseReport, parseFile } from './parse.js';
import { type RepairReport, type SoupOptions, soupLinks } from './repair.js';
import { unwrap } from './reports.js';
import { makeMeshesWith, Shapes } from './shapes.js';
import {
  boundaryLoopsOf,
  type Component,
  type Computed,
  componentsOf,
  polygonsOf,
  problemsOf,
  trianglesOf,
  type ValidationLevel,
} from './topology.js';
import {
  type AppendMaps,
  appendLinks,
  bytesOfLinks,
  dualLinks,
  extractLinks,
  linksOfBytes,
} from './transfer.js';
import { warmUp } from './warm-up.js';
import { type OwnBytes, type WriteOptions, writeFile } from './write.js';

/** Where the platform has no `Symbol.dispose` yet, polyfills register theirs under this name. */
const disposeSymbol: typeof Symbol.dispose = Symbol.dispose ?? Symbol.for('Symbol.dispose');

/**
 * A mesh of some faces of another, and the items that it has copies of, in ascending order: vertex i of `mesh`
 * is a copy of `vertices[i]`, edge i of `edges[i]`, face i of `faces[i]`, and halfedge h of
 * `2 * edges[h >> 1] + (h & 1)`.
 */
export interface MeshPart extends ItemSet {
  readonly mesh: HalfedgeMesh;
}

/**
 * A halfedge mesh: vertices with positions, halfedges, edges, and faces with any number of corners.
 *
 * Items are plain integers. The mesh lives in WebAssembly memory, which `dispose()` or `using` frees. The
 * garbage collector frees it too, but late, because it doesn't know about that memory. If you make many
 * meshes, dispose of them.
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
   * Makes a mesh from an index buffer: triangles over shared vertices. Vertex i and face j of the mesh are
   * vertex i and face j of the input. The faces may come in any order. The input is copied, and not changed.
   * Typed arrays are the fastest: one copy, and linear time.
   *
   * Strict: the triangles must form an oriented 2-manifold, with or without boundary.
   *
   * @param positions x, y, z of each vertex
   * @param indices three vertices of each face, counter-clockwise
   * @throws HalfedgeError with the `problems` found, up to a thousand: `edge-with-many-faces`,
   * `opposite-orientation`, `duplicate-face`, `repeated-vertex`, `pinched-vertex`, `index-out-of-range`,
   * `non-finite-position`, `out-of-memory`; TypeError or RangeError for unsuitable arrays
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
   * @param faces an array of vertices for each face; or two arrays for all faces, `sizes` and `corners`
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
   * Makes connectivity alone, for something that has no geometry or keeps it elsewhere: a planar map, a dual,
   * an abstract complex. Like {@link fromPolygons}; all positions are zero.
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
   * Makes a mesh from any polygons at all. Whatever {@link fromPolygons} would refuse is repaired, and
   * reported. Polygons that need no repair give the same mesh. Faces and vertices keep their order; copies of
   * vertices come last. The mesh is valid at level 4, and its shape does not depend on the order of the
   * faces.
   *
   * Invalid faces are left out, and of duplicates one is kept. Faces are turned over to agree with the
   * majority of their component, and one-sided surfaces are cut. Edges with more than two faces are split
   * into copies, and so are vertices at which a closed fan of faces meets others. A vertex at which only open
   * fans meet stays pinched, as in `fromPolygons`; {@link splitPinchedVertices} splits it. Vertices are welded
   * on request.
   *
   * ```ts
   * const { mesh, report } = HalfedgeMesh.fromSoup(positions, faces, { weld: true });
   * console.log(report.summary); // 3 duplicate faces left out, 12 faces turned over.
   * ```
   *
   * @param faces as `fromPolygons` takes them, or an index buffer of triangles
   * @throws HalfedgeError `bad-size`, `too-large`, `out-of-memory`; TypeError or RangeError for unsuitable
   * arrays
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
   * Reads a mesh from the content of a file, as text or bytes. The format is recognised from the content:
   * Wavefront OBJ, or Geomview OFF, PLY or STL in text or binary form. Vertex i and face j of the mesh are
   * the i-th vertex and the j-th face of the file. STL repeats its vertices: there, vertex i is the i-th
   * position that differs from all before it.
   *
   * Everything else in the file becomes {@link attributes}: `normal`, `color`, `uv`, and whatever else it has
   * a name for. Texture coordinates and normals of corners become attributes of halfedges.
   *
   * Faces that don't form a manifold are repaired as by {@link fromSoup}, and the report says so, with the
   * lines of the faces; with `repair: false` they are an error. A file that needs no repair gives the same
   * mesh either way.
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
   * Reads what a file holds, before a mesh is made of it: positions and faces as they are, good or bad. Their
   * numbers are those that the problems of {@link parse} use. You can pass them to {@link fromSoup}, with
   * options that `parse` doesn't have:
   *
   * ```ts
   * const { positions, faces } = HalfedgeMesh.parseSoup(bytes);
   * const { mesh, report } = HalfedgeMesh.fromSoup(positions, faces, { weld: 1e-6 });
   * ```
   *
   * To only read a file, for example to draw it, you need nothing else: `attributes` has everything that the
   * file says about vertices, corners and faces, and `weld: false` leaves the triangles of STL apart.
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
   * Writes this mesh to a file: its live vertices and faces, each in the order of their indices. Reading the
   * file gives the same polygons and the same bits of each position; in text, numbers have as many digits as
   * that takes. It also gives the same attributes, if the format has a place for them (`normal`, `color` and
   * `uv` by their usual names; PLY has a place for most). STL has only triangles: there, polygons are cut as
   * by `triangulate`, and isolated vertices are left out.
   *
   * @returns text if the encoding is `'text'`, the default of OBJ and OFF; otherwise bytes
   * @throws HalfedgeError `unsupported-format` (an encoding that the format doesn't have),
   * `non-finite-position` (in STL), `corrupt-connectivity`, `out-of-memory`
   */
  write(format: 'obj' | 'off', options?: WriteOptions<'obj'>): string;
  write<Format extends 'ply' | 'stl'>(
    format: Format,
    options?: WriteOptions<Format> & { encoding?: 'binary' | 'binary-big-endian' | undefined },
  ): OwnBytes;
  write(format: FileFormat, options: WriteOptions & { encoding: 'text' }): string;
  write<Format extends FileFormat>(
    format: Format,
    options: WriteOptions<Format> & { encoding: 'binary' | 'binary-big-endian' },
  ): OwnBytes;
  write<Format extends FileFormat>(
    format: Format,
    options?: WriteOptions<Format>,
  ): string | OwnBytes;
  write(format: FileFormat, options: WriteOptions = {}): string | OwnBytes {
    return writeFile(linksOf(this), format, options);
  }

  /**
   * Writes the mesh to the last word, deleted slots and attributes included, to store it or to send it to a
   * worker. {@link fromBytes} reads it. History and generations are not part of it. The format is documented
   * in src/halfedge/io/bytes.h, and has a version.
   */
  toBytes(): OwnBytes {
    return bytesOfLinks(linksOf(this));
  }

  /**
   * Restores a mesh from what {@link toBytes} returned. The bytes may come from anywhere: everything that a
   * mesh needs to be safe is checked, including levels 0 to 2 of {@link validate}.
   *
   * @throws HalfedgeError `unknown-format`, `unsupported-version`, `truncated`, `parse-error` (with what was
   * expected at which byte), `corrupt-connectivity`, `attribute-exists`, `bad-attribute`, `out-of-memory`;
   * TypeError for anything but bytes
   */
  static fromBytes(bytes: ArrayBuffer | ArrayBufferView): HalfedgeMesh {
    return new HalfedgeMesh(linksOfBytes(bytes));
  }

  /**
   * Adds a copy of the live items of `other`, which may be this mesh itself, and returns where they went. The
   * parts are not joined. Deleted slots are used first; existing items keep their indices. Attributes that
   * both meshes have (the same kind, name, type and number of components) are copied. Attributes that only
   * this mesh has get their default. Attributes that only `other` has are left out; to keep them, add them to
   * this mesh first. One step of history.
   *
   * @throws HalfedgeError `too-large`, `out-of-memory`, `corrupt-connectivity` (of `other`); then nothing has
   * changed
   */
  append(other: HalfedgeMesh): AppendMaps {
    const links = linksOf(this);
    links.checkAlive();
    return appendLinks(links, linksToAppend(other));
  }

  /** Why {@link append} would be refused, or null. O(slots of `other`). */
  checkAppend(other: HalfedgeMesh): Refusal | null {
    const links = linksOf(this);
    links.checkAlive();
    const added = linksToAppend(other);
    return answer(links, links.core._check_append(links.address, added.address));
  }

  /**
   * Makes a mesh of its own out of some faces, in any order and with repetitions, with their edges and vertices,
   * positions and attributes. Where a face is left out there is a gap. This mesh doesn't change; the new one
   * stores `prev` if this one does, and has its history off. Linear in the size of the part, plus 4 bytes for each
   * item of this mesh while it runs.
   *
   * ```ts
   * const parts = mesh.components().map(({ faces }) => mesh.extract(faces).mesh);
   * const { mesh: patch, vertices } = mesh.extract(mesh.vertexFaces(v));
   * // ... edit or solve on `patch`, then bring it back:
   * for (const w of patch.vertices()) mesh.setPosition(vertices[w], patch.position(w));
   * ```
   *
   * @throws HalfedgeError `corrupt-connectivity`, `out-of-memory`
   */
  extract(faces: ItemList<FaceLike>): MeshPart {
    const { part, items } = extractLinks(linksOf(this), faces);
    return { mesh: new HalfedgeMesh(part), ...items };
  }

  /**
   * Makes the dual: a new mesh with a vertex at the centroid of each face, and a face around each vertex that
   * is not on the boundary. Its vertex i lies in the i-th live face, and its face j surrounds the j-th live
   * interior vertex. So the dual of the dual of a closed mesh has the same vertices and faces, in the same
   * order, though a face may begin at another corner. Attributes are not carried over.
   *
   * @throws HalfedgeError if the dual would not be a polygon mesh: `degree-below-three` (an interior vertex
   * of valence 1 or 2), `duplicate-edge` (two faces that share two edges), `same-face-twice` (an edge with
   * one face on both sides), `pinched-vertex` (a face whose interior corners are not side by side); or
   * `corrupt-connectivity`, `non-finite-position`, `out-of-memory`
   */
  dual(): HalfedgeMesh {
    return new HalfedgeMesh(dualLinks(linksOf(this)));
  }

  /** Why {@link dual} would be refused, or null. It takes as long as making the dual. */
  checkDual(): Refusal | null {
    const links = linksOf(this);
    links.checkAlive();
    return answer(links, links.core._check_dual(links.address));
  }

  /** A copy of this mesh with the same indices and attributes, in memory of its own, with history off. */
  clone(): HalfedgeMesh {
    const links = linksOf(this);
    const address = links.core.cloneMesh(links.address);
    if (address === 0) throw outOfMemory(`a copy of ${this.halfedgeCount} halfedges`);
    return new HalfedgeMesh(new Links(links.core, address));
  }

  /**
   * One halfedge of each boundary loop, in ascending order. `halfedgeLoop(h)` walks the loop, with the gap on
   * its left: clockwise around a disk. O(halfedges).
   */
  boundaryLoops(): Halfedge[] {
    return boundaryLoopsOf(linksOf(this));
  }

  /**
   * Checks the invariants of the mesh, those of `level` (0 to 4) and below: an empty list means that it is
   * valid. Levels 0 to 3 check the links, level 4 adds the rules of polygon meshes. Isolated vertices are
   * reported as information and pinched vertices as a warning; neither is an error. At most 1000 problems of
   * each code are listed, and how many more there are. Linear time, whatever the arrays hold.
   *
   * `'geometry'` is level 4 plus checks of where the vertices lie. It reports `non-finite-position` as an
   * error and, as warnings, `zero-length-edge`, `degenerate-face` (no wider than 10^-6 of its length, or
   * without area; {@link removeDegenerateFaces} removes these where it can), and `coincident-vertices` (in
   * the same place, without being joined by edges of zero length).
   */
  validate<Level extends number>(level: ValidationLevel | Computed<Level> = 4): Problem[] {
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
   * A copy of the live faces, in ascending order: how many corners each has, and the vertices of all corners
   * in one array, as `fromPolygons` takes them.
   */
  toPolygons(): { sizes: Uint32Array; corners: Uint32Array } {
    return polygonsOf(linksOf(this));
  }

  /**
   * A copy of the live faces as an index buffer, for drawing, and for each triangle the face that it belongs
   * to: n - 2 triangles of a face of degree n, none of the faces of loops and segments, faces in ascending
   * order. Larger faces may be concave, and nearly planar only: none of their triangles folds over, and a quad
   * is cut along its shorter diagonal. They are cut as by {@link triangulate}, but each for itself, so that no
   * mesh is refused; the mesh is not changed. O(slots), and what `triangulate` takes for larger faces. Throws
   * `corrupt-connectivity` where links are broken, which live views allow to write; `out-of-memory`.
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

  /** Calls `dispose()` at the end of the block that declares `using mesh = ...`. */
  [disposeSymbol](): void {
    this.dispose();
  }
}

printed('HalfedgeMesh', HalfedgeMesh, (mesh) => {
  if (mesh.disposed) return { disposed: true };
  const { vertexCount, edgeCount, faceCount } = mesh;
  return { vertexCount, edgeCount, faceCount };
});

/** The links of the mesh that is to be appended to another one. */
function linksToAppend(other: HalfedgeMesh): Links {
  if (!(other instanceof HalfedgeMesh)) refuse('other', other, 'a HalfedgeMesh');
  const links = linksOf(other);
  if (links.disposed) throw wasDisposed('other');
  return links;
}

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
