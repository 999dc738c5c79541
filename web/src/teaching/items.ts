import { type HalfedgeMesh, type ItemKind, NONE } from '../api.js';
import { LETTERS } from '../items.js';

/** A vertex, halfedge, edge or face of the mesh on show. */
export interface Item {
  readonly kind: ItemKind;
  readonly index: number;
}

/** The item, or null where a link is empty. */
export function item(kind: ItemKind, index: number): Item | null {
  return index === NONE ? null : { kind, index };
}

/** `v12`, `h31`, …; `∅` for an empty link. */
export function itemName(of: Item | null): string {
  return of ? LETTERS[of.kind] + of.index : '∅';
}

/** Whether both are the same item, or both none. */
export function sameItem(a: Item | null, b: Item | null): boolean {
  return a === b || (a?.kind === b?.kind && a?.index === b?.index);
}

/** Reads `v12`, `h 31`, `Edge 4`; null if it is no name of an item. */
export function parseItemName(text: string): Item | null {
  const match = /^\s*(v|vertex|h|halfedge|e|edge|f|face)\s*(\d{1,10})\s*$/i.exec(text);
  if (!match) return null;
  const letter = match[1][0].toLowerCase();
  const kinds = Object.keys(LETTERS) as ItemKind[];
  const kind = kinds.find((candidate) => LETTERS[candidate] === letter);
  return kind ? { kind, index: Number(match[2]) } : null;
}

/** The range of the indices of that kind: live items and deleted ones. */
export function itemSlots(mesh: HalfedgeMesh, kind: ItemKind): number {
  return mesh[`${kind}Slots` as const];
}

/** Whether the mesh has the item: its index is in range, and it was not deleted. */
export function isLive(mesh: HalfedgeMesh, { kind, index }: Item): boolean {
  if (!(index < itemSlots(mesh, kind))) return false;
  const { next, vertexHalfedge, faceHalfedge } = mesh.connectivity;
  switch (kind) {
    case 'vertex':
      return vertexHalfedge[index] >= NONE;
    case 'halfedge':
      return next[index] >= NONE;
    case 'edge':
      return next[2 * index] >= NONE;
    case 'face':
      return faceHalfedge[index] >= NONE;
  }
}

/** The vertices that an item has: one, two, or the corners of a face. */
export function verticesOf(mesh: HalfedgeMesh, { kind, index }: Item): number[] {
  switch (kind) {
    case 'vertex':
      return [index];
    case 'halfedge':
      return [...mesh.edgeVertices(mesh.edge(index))];
    case 'edge':
      return [...mesh.edgeVertices(index)];
    case 'face':
      return [...mesh.faceVertices(index)];
  }
}

/** What is worth knowing of an item besides its links: boundary, valence, degree. */
export function factsOf(mesh: HalfedgeMesh, of: Item): string[] {
  const i = of.index;
  switch (of.kind) {
    case 'vertex': {
      if (mesh.isIsolatedVertex(i)) return ['isolated', 'valence 0'];
      const facts = [
        mesh.isBoundaryVertex(i) ? 'boundary' : 'interior',
        `valence ${mesh.valence(i)}`,
      ];
      if (!mesh.isManifoldVertex(i)) facts.push('pinched');
      return facts;
    }
    case 'halfedge':
      return [mesh.isBoundaryHalfedge(i) ? 'boundary' : 'interior'];
    case 'edge':
      return [mesh.isBoundaryEdge(i) ? 'boundary' : 'interior'];
    case 'face':
      return [mesh.isBoundaryFace(i) ? 'at the boundary' : 'interior', `degree ${mesh.degree(i)}`];
  }
}
