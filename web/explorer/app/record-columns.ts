import {
  type AttributeInfo,
  type AttributeNames,
  type HalfedgeMesh,
  type ItemKind,
  NONE,
} from 'halfedge';
import { type Item, itemName, itemSlots } from 'halfedge/teaching';
import { positionTexts, textOf, typeOf } from './item-attributes.js';

/** What a cell shows, and where it leads. */
export interface Cell {
  readonly text: string;
  readonly target: Item | null;
}

/** A column of the records of a kind: an array of the mesh, or a coordinate of its positions. */
export interface Column {
  readonly name: string;
  /** What it holds, in words. */
  readonly meaning: string;
  /** How many characters wide it has to be, for its name and for what its cells show. */
  readonly room: number;
  /** Whether it is an attribute, and no part of the structure. */
  readonly isAttribute: boolean;
  cell(mesh: HalfedgeMesh, row: number): Cell;
}

/** Links are no narrower, so that the columns of small meshes don't crowd. */
const LEAST_ROOM = 5;
/** A coordinate of six digits, as `-0.123456`. Longer ones are cut short in their cells. */
const COORDINATE_ROOM = 9;
/** Attributes of more components are cut short in their cells. */
const MOST_ROOM = 34;

/** The columns of a kind, after the one with the index. */
export function columnsOf(
  mesh: HalfedgeMesh,
  kind: ItemKind,
  names: AttributeNames,
): readonly Column[] {
  const structure = STRUCTURE[kind].map((column) => ({
    ...column,
    room: Math.max(column.room, roomOfNames(mesh)),
  }));
  const attributes = mesh.attributes.list().filter((info) => info.kind === kind);
  return [...structure, ...attributes.map((info) => attribute(info, names))];
}

/** How many characters wide the first column has to be, which has the index of the record itself. */
export function roomOfIndex(mesh: HalfedgeMesh, kind: ItemKind): number {
  return Math.max(kind.length, roomOfNames(mesh));
}

/** There are more halfedges than of any other kind: the last one has the longest name. */
function roomOfNames(mesh: HalfedgeMesh): number {
  const index = Math.max(0, itemSlots(mesh, 'halfedge') - 1);
  return itemName({ kind: 'halfedge', index }).length;
}

function attribute(info: AttributeInfo, names: AttributeNames): Column {
  const { kind, name, components } = info;
  const wanted = Math.max(name.length + 2, 8 * components + 1);
  return {
    name,
    meaning: `attribute: ${typeOf(info)}`,
    room: Math.min(MOST_ROOM, wanted),
    isAttribute: true,
    cell: (mesh, row) => ({
      text: textOf(mesh.attributes.values(kind, name, row), names[name]),
      target: null,
    }),
  };
}

/** A link, by the kind of item that it leads to. */
function link(
  name: string,
  to: ItemKind,
  meaning: string,
  value: (mesh: HalfedgeMesh, row: number) => number,
): Column {
  return {
    ...{ name, meaning, room: Math.max(LEAST_ROOM, name.length), isAttribute: false },
    cell(mesh, row) {
      const index = value(mesh, row);
      const target = index === NONE ? null : { kind: to, index };
      return { text: itemName(target), target };
    },
  };
}

function coordinate(axis: 0 | 1 | 2): Column {
  const name = 'xyz'[axis];
  return {
    ...{ name, meaning: `${name} of the position`, room: COORDINATE_ROOM, isAttribute: false },
    cell: (mesh, row) => ({
      text: positionTexts(mesh, row)[axis],
      target: null,
    }),
  };
}

const STRUCTURE: Readonly<Record<ItemKind, readonly Column[]>> = {
  vertex: [
    link(
      'halfedge',
      'halfedge',
      'vertexHalfedge: the anchor, a halfedge that leaves it',
      (mesh, row) => mesh.connectivity.vertexHalfedge[row],
    ),
    coordinate(0),
    coordinate(1),
    coordinate(2),
  ],
  halfedge: [
    link(
      'to',
      'vertex',
      'toVertex: the vertex it points to',
      (mesh, row) => mesh.connectivity.toVertex[row],
    ),
    link(
      'next',
      'halfedge',
      'the next one around the face or boundary loop',
      (mesh, row) => mesh.connectivity.next[row],
    ),
    link('prev', 'halfedge', 'the previous one around the face or boundary loop', (mesh, row) =>
      mesh.prev(row),
    ),
    link(
      'face',
      'face',
      'the face on its left; ∅ on the boundary',
      (mesh, row) => mesh.connectivity.face[row],
    ),
    link(
      'opposite',
      'halfedge',
      'the other side of its edge: its index with the last bit turned, not stored',
      (_mesh, row) => row ^ 1,
    ),
  ],
  edge: [
    link(
      'first',
      'halfedge',
      'the first of its halfedges: 2e, not stored',
      (_mesh, row) => 2 * row,
    ),
    link(
      'second',
      'halfedge',
      'the second of its halfedges: 2e + 1, not stored',
      (_mesh, row) => 2 * row + 1,
    ),
  ],
  face: [
    link(
      'halfedge',
      'halfedge',
      'faceHalfedge: a halfedge of it',
      (mesh, row) => mesh.connectivity.faceHalfedge[row],
    ),
  ],
};
