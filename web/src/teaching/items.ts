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

/** A link of an item, with its number in the figure of the halfedge structure where it has one. */
export interface Link {
  /** (1) vertex → halfedge, (2) face → halfedge, (3)–(7) the links of a halfedge. */
  readonly number?: 1 | 2 | 3 | 4 | 5 | 6 | 7;
  /** The name in the API. */
  readonly name: string;
  /** What it leads to, in words. */
  readonly hint: string;
  readonly target: Item | null;
  /** The key that walks along it. */
  readonly key: WalkKey;
  /** Which colour of the palette it has in the picture. */
  readonly role: LinkRole;
}

/** Which link it is: a role has one colour, whatever the link begins at. */
export type LinkRole = 'next' | 'prev' | 'opposite' | 'vertex' | 'edge' | 'face' | 'halfedge';
/** The key of the explorer that follows a link. */
export type WalkKey = 'n' | 'p' | 'o' | 'v' | 'e' | 'f' | 'h' | 'u';

function anchorHint(mesh: HalfedgeMesh, v: number): string {
  if (mesh.isIsolatedVertex(v)) return 'none: an isolated vertex';
  return mesh.isBoundaryVertex(v) ? 'a boundary one' : 'an outgoing one';
}

/** All links of an item, in the order of the figure. */
export function linksOf(mesh: HalfedgeMesh, of: Item): Link[] {
  const i = of.index;
  switch (of.kind) {
    case 'vertex':
      return [
        {
          number: 1,
          name: 'vertexHalfedge',
          hint: anchorHint(mesh, i),
          target: item('halfedge', mesh.vertexHalfedge(i)),
          key: 'h',
          role: 'halfedge',
        },
      ];
    case 'face':
      return [
        {
          number: 2,
          name: 'faceHalfedge',
          hint: 'one around it',
          target: item('halfedge', mesh.faceHalfedge(i)),
          key: 'h',
          role: 'halfedge',
        },
      ];
    case 'edge':
      return ([0, 1] as const).map((side) => ({
        name: `edgeHalfedge, side ${side}`,
        hint: side === 0 ? 'even number' : 'odd number',
        target: item('halfedge', mesh.edgeHalfedge(i, side)),
        key: side === 0 ? 'h' : 'o',
        role: side === 0 ? 'halfedge' : 'opposite',
      }));
    case 'halfedge': {
      const face = item('face', mesh.face(i));
      const around = face ? 'in the face' : 'along the boundary';
      return [
        {
          number: 3,
          name: 'toVertex',
          hint: 'the vertex it points to',
          target: item('vertex', mesh.toVertex(i)),
          key: 'v',
          role: 'vertex',
        },
        {
          number: 4,
          name: 'face',
          hint: face ? 'the face on its left' : 'none: a boundary halfedge',
          target: face,
          key: 'f',
          role: 'face',
        },
        {
          number: 5,
          name: 'next',
          hint: `the next one ${around}`,
          target: item('halfedge', mesh.next(i)),
          key: 'n',
          role: 'next',
        },
        {
          number: 6,
          name: 'opposite',
          hint: 'the other side of its edge',
          target: item('halfedge', mesh.opposite(i)),
          key: 'o',
          role: 'opposite',
        },
        {
          number: 7,
          name: 'prev',
          hint: `the previous one ${around}`,
          target: item('halfedge', mesh.prev(i)),
          key: 'p',
          role: 'prev',
        },
        {
          name: 'fromVertex',
          hint: 'the vertex it leaves',
          target: item('vertex', mesh.fromVertex(i)),
          key: 'u',
          role: 'vertex',
        },
        {
          name: 'edge',
          hint: 'both sides together',
          target: item('edge', mesh.edge(i)),
          key: 'e',
          role: 'edge',
        },
      ];
    }
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
