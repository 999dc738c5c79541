import type { AttributeInfo, AttributeView } from '../attributes.js';
import type { Surface } from '../measures.js';
import type { HalfedgeMesh } from '../mesh.js';
import { arrayFor, isNormalized } from './columns.js';
import { ItemSet } from './item-set.js';
import { surfaceOf } from './normals.js';
import { RowBuffer } from './rows.js';
import type { Placement, TriangleIndex } from './triangle-index.js';
import type { FaceTriangles } from './triangulate.js';

/** An attribute as it lies in memory, until something allocates. */
export interface ShownColumn {
  readonly buffer: RowBuffer;
  readonly isOfVertices: boolean;
  readonly values: AttributeView;
}

/** What of a mesh is shown. */
export interface ShownRows {
  readonly mesh: HalfedgeMesh;
  readonly attributes: readonly AttributeInfo[];
  /** Whether normals are computed. */
  readonly normals: boolean;
}

/**
 * The rows that the vertices of a geometry are: positions, normals, attributes. An update comes in this order:
 * `writeVertices`, `TriangleIndex.place`, `writeTriangles`.
 */
export abstract class GeometryRows {
  readonly position = new RowBuffer(new Float32Array(0), 3);
  readonly normal: RowBuffer | undefined;
  protected readonly mesh: HalfedgeMesh;
  protected readonly triangles: TriangleIndex;
  #allNormals: Float32Array | undefined;
  readonly #besideMoved = new ItemSet();
  readonly #shown: readonly { readonly info: AttributeInfo; readonly buffer: RowBuffer }[];

  constructor({ mesh, attributes, normals }: ShownRows, triangles: TriangleIndex) {
    this.mesh = mesh;
    this.triangles = triangles;
    if (normals) this.normal = new RowBuffer(new Float32Array(0), 3);
    this.#shown = attributes.map((info) => {
      const none = arrayFor(mesh, info, 0);
      return { info, buffer: new RowBuffer(none, info.components, isNormalized(info)) };
    });
  }

  /** By name, what three.js draws. */
  get buffers(): [name: string, buffer: RowBuffer][] {
    const shown = this.#shown.map(({ info, buffer }): [string, RowBuffer] => [info.name, buffer]);
    const normal: [string, RowBuffer][] = this.normal ? [['normal', this.normal]] : [];
    return [['position', this.position], ...normal, ...shown];
  }

  /** By vertex, where it is shown. */
  abstract get points(): Float32Array;

  /** Writes all, after the triangles were filled in. */
  abstract fill(triangles: FaceTriangles): void;

  /**
   * Takes up these vertices; adds to `faces` those that are to be written because of them. Returns the
   * vertices that have moved.
   */
  abstract writeVertices(vertices: readonly number[], faces: ItemSet): number[];

  /** Takes up these faces, of which some have got other triangles, and the normals that follow from all. */
  abstract writeTriangles(
    faces: readonly number[],
    triangles: FaceTriangles,
    placement: Placement,
    moved: readonly number[],
  ): void;

  /** Makes room for so many rows. */
  protected reserve(rows: number): void {
    for (const [, buffer] of this.buffers) buffer.reserve(rows);
  }

  /** By vertex, in the same array each time: where most vertices have moved, they will as a rule move again. */
  protected allNormals(): Float32Array {
    this.#allNormals = this.mesh.allVertexNormals(this.#allNormals);
    return this.#allNormals;
  }

  /** The attributes shown, as they lie in memory until something allocates. */
  protected columns(): ShownColumn[] {
    return this.#shown.map(({ info: { kind, name }, buffer }) => ({
      buffer,
      isOfVertices: kind === 'vertex',
      values: this.mesh.attributes.get(kind, name),
    }));
  }

  /** The vertices whose normals may be others: those of triangles that came or went, and around moved ones. */
  protected findStale(
    vertices: readonly number[],
    moved: readonly number[],
    stale: ItemSet,
  ): Surface {
    const surface = surfaceOf(this.mesh);
    const { next, toVertex, face, vertexHalfedge, faceHalfedge } = surface;
    const faces = this.#besideMoved;
    stale.begin(vertexHalfedge.length);
    faces.begin(faceHalfedge.length);
    for (const v of vertices) if (vertexHalfedge[v] >= -1) stale.add(v);
    for (const v of moved) {
      stale.add(v);
      eachOutgoing(next, vertexHalfedge[v], (h) => {
        stale.add(toVertex[h]);
        faces.add(face[h]);
      });
    }
    // Each once, however many of its corners have moved.
    for (const f of faces.items) {
      const first = faceHalfedge[f];
      stale.add(toVertex[first]);
      for (let h = next[first]; h !== first; h = next[h]) stale.add(toVertex[h]);
    }
    return surface;
  }
}

/** Whether these are so many that all of the mesh is written sooner than what is around each of them. */
export function isMost(vertices: readonly number[], mesh: HalfedgeMesh): boolean {
  return 4 * vertices.length > mesh.vertexCount;
}

/** So many corners are looked at in no time. */
const FEW_CORNERS = 10_000;

/**
 * Whether all normals of a mesh are sooner computed than those of some vertices, one by one: the normal at each corner
 * of a large polygon takes all of its corners.
 */
export function isMoreThanAll(vertices: readonly number[], surface: Surface): boolean {
  const { next, face, vertexHalfedge } = surface;
  let left = Math.max(FEW_CORNERS, next.length);
  for (const v of vertices) {
    eachOutgoing(next, vertexHalfedge[v], (h) => {
      if (face[h] < 0) return;
      for (let g = next[h]; g !== h && left > 0; g = next[g]) left -= 1;
    });
    if (left <= 0) return true;
  }
  return false;
}

/** Calls `use` with each halfedge that leaves a vertex, by one of them; none for a negative one. */
export function eachOutgoing(next: Int32Array, first: number, use: (h: number) => void): void {
  if (!(first >= 0)) return;
  let h = first;
  do {
    use(h);
    h = next[h ^ 1];
  } while (h !== first);
}
