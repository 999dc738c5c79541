import type { AttributeInfo } from '../attributes.js';
import type { HalfedgeMesh } from '../mesh.js';
import { linksOf } from '../navigation.js';
import { Digest } from './digest.js';
import { ItemSet } from './item-set.js';

/** Takes a range of an array, such as one that has changed. */
type Range = (from: number, to: number) => void;

/**
 * Finds the faces, edges and vertices of a mesh at which something may have changed, among its links, positions and
 * some of its attributes. It keeps no copy of them, only digests: of a million triangles, to look takes
 * some 5 ms after an edit, and 1 ms while the links are as they were.
 */
export class MeshChanges {
  /** What `find` has found; more than has changed, because it tells blocks apart and not numbers. */
  readonly faces = new ItemSet();
  readonly edges = new ItemSet();
  readonly vertices = new ItemSet();
  /** `mesh.version` as the digests of links know it. */
  #version = -1;
  readonly #next = new Digest();
  readonly #toVertex = new Digest();
  readonly #faceHalfedge = new Digest();
  readonly #vertexHalfedge = new Digest();
  readonly #positions = new Digest();
  readonly #attributes: readonly { readonly info: AttributeInfo; readonly digest: Digest }[];

  constructor(attributes: readonly AttributeInfo[]) {
    this.#attributes = attributes.map((info) => ({ info, digest: new Digest() }));
  }

  /** Takes note of how the mesh is now; all of that is taken for known. */
  skip(mesh: HalfedgeMesh): void {
    this.#begin(mesh);
    const ignore = () => {};
    this.#look(mesh, { ofHalfedges: ignore, ends: ignore, faces: ignore, vertices: ignore });
  }

  /** Fills `faces`, `edges` and `vertices`; the first time with all that there are. */
  find(mesh: HalfedgeMesh): void {
    this.#begin(mesh);
    const { next, face } = mesh.connectivity;
    const { faces, edges, vertices } = this;
    const ofHalfedges = (from: number, to: number) => {
      for (let h = from; h < to; h++) if (next[h] >= 0) faces.add(face[h]);
    };
    this.#look(mesh, {
      ofHalfedges,
      ends: (from, to) => {
        ofHalfedges(from, to);
        for (let h = from; h < to; h += 2) edges.add(h >> 1);
      },
      faces: (from, to) => {
        for (let f = from; f < to; f++) faces.add(f);
      },
      vertices: (from, to) => {
        for (let v = from; v < to; v++) vertices.add(v);
      },
    });
  }

  #begin(mesh: HalfedgeMesh): void {
    this.faces.begin(mesh.faceSlots);
    this.edges.begin(mesh.edgeSlots);
    this.vertices.begin(mesh.vertexSlots);
  }

  #look(
    mesh: HalfedgeMesh,
    found: Readonly<Record<'ofHalfedges' | 'ends' | 'faces' | 'vertices', Range>>,
  ): void {
    const { core } = linksOf(mesh);
    if (mesh.version !== this.#version) {
      const { next, toVertex, faceHalfedge, vertexHalfedge } = mesh.connectivity;
      this.#next.update(core, next, found.ofHalfedges);
      this.#toVertex.update(core, toVertex, found.ends);
      this.#faceHalfedge.update(core, faceHalfedge, found.faces);
      this.#vertexHalfedge.update(core, vertexHalfedge, found.vertices);
      this.#version = mesh.version;
    }
    this.#positions.update(core, mesh.positions, rows(found.vertices, 3));
    for (const { info, digest } of this.#attributes) {
      const range = info.kind === 'vertex' ? found.vertices : found.ofHalfedges;
      const view = mesh.attributes.get(info.kind, info.name);
      digest.update(core, view, rows(range, info.components));
    }
  }
}

/** Of a range of numbers, the range of the items that have them. */
function rows(found: Range, components: number): Range {
  return (from, to) => found(Math.floor(from / components), Math.ceil(to / components));
}
