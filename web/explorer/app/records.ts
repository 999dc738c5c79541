import { type HalfedgeMesh, type ItemKind, NONE } from 'halfedge';
import { type Item, itemName, itemSlots, stepOf } from 'halfedge/teaching';
import type { Play } from './explorer.js';

/** The kinds of items that have records of their own: an edge is two halfedges side by side. */
export type RecordKind = 'vertex' | 'halfedge' | 'face';

/** A column of the records of a kind: an array of the mesh. */
export interface Column {
  readonly name: string;
  /** What it holds, in words. */
  readonly meaning: string;
  /** What it leads to; left out for numbers. */
  readonly to?: ItemKind;
  value(mesh: HalfedgeMesh, row: number): number;
}

/** What a cell shows, and where it leads. */
export interface Cell {
  readonly text: string;
  readonly target: Item | null;
}

const coordinate = (axis: 0 | 1 | 2): Column => ({
  name: 'xyz'[axis],
  meaning: `${'xyz'[axis]} of the position`,
  value: (mesh, row) => mesh.positions[3 * row + axis],
});

/** The columns of a kind, after the one with the index. */
export const columns: Readonly<Record<RecordKind, readonly Column[]>> = {
  vertex: [
    {
      name: 'halfedge',
      meaning: 'vertexHalfedge: the anchor, a halfedge that leaves it',
      to: 'halfedge',
      value: (mesh, row) => mesh.connectivity.vertexHalfedge[row],
    },
    coordinate(0),
    coordinate(1),
    coordinate(2),
  ],
  halfedge: [
    {
      name: 'to',
      meaning: 'toVertex: the vertex it points to',
      to: 'vertex',
      value: (mesh, row) => mesh.connectivity.toVertex[row],
    },
    {
      name: 'next',
      meaning: 'the next one around the face or boundary loop',
      to: 'halfedge',
      value: (mesh, row) => mesh.connectivity.next[row],
    },
    {
      name: 'prev',
      meaning: 'the previous one around the face or boundary loop',
      to: 'halfedge',
      value: (mesh, row) => mesh.prev(row),
    },
    {
      name: 'face',
      meaning: 'the face on its left; ∅ on the boundary',
      to: 'face',
      value: (mesh, row) => mesh.connectivity.face[row],
    },
    {
      name: 'opposite',
      meaning: 'the other side of its edge: its index with the last bit turned, not stored',
      to: 'halfedge',
      value: (_mesh, row) => row ^ 1,
    },
  ],
  face: [
    {
      name: 'halfedge',
      meaning: 'faceHalfedge: a halfedge of it',
      to: 'halfedge',
      value: (mesh, row) => mesh.connectivity.faceHalfedge[row],
    },
  ],
};

/** Live records and deleted ones. */
export function rowCount(mesh: HalfedgeMesh, kind: RecordKind): number {
  return itemSlots(mesh, kind);
}

export function cellOf(mesh: HalfedgeMesh, row: number, { to, value }: Column): Cell {
  const held = value(mesh, row);
  if (to) {
    const target = held === NONE ? null : { kind: to, index: held };
    return { text: itemName(target), target };
  }
  return { text: String(Number(held.toPrecision(5))), target: null };
}

/** The rows that tell of an item: one, or the two halfedges of an edge. */
export function rowsOf(item: Item | null, kind: RecordKind): number[] {
  if (item?.kind === kind) return [item.index];
  if (item?.kind === 'edge' && kind === 'halfedge') return [2 * item.index, 2 * item.index + 1];
  return [];
}

/** A cell by its kind, row and column. */
export function cellKey(kind: RecordKind, row: number, column: string): string {
  return `${kind} ${row} ${column}`;
}

/** The cells that the last step of a circulator has read, and the row where it came to. */
export interface Reading {
  readonly cells: ReadonlySet<string>;
  readonly at: number | null;
}

export function readingOf(mesh: HalfedgeMesh, play: Play | null): Reading {
  const cells = new Set<string>();
  const current = play?.player.current;
  if (!play || !current) return { cells, at: null };
  const { query } = play.player;
  const { around, view } = query.circulator;
  const read = (row: number, column: string) => cells.add(cellKey('halfedge', row, column));
  const before = play.player.visits.at(-2)?.halfedge ?? firstStop();
  for (let h = before; h !== null && h !== current.halfedge; ) h = step(h);
  show(current.halfedge);
  return { cells, at: current.halfedge };

  /** Before the first visit the walk is at the anchor, which may come last. */
  function firstStop(): number | null {
    if (query.start !== undefined) return query.start;
    if (around !== 'vertex' && around !== 'face') return null;
    cells.add(cellKey(around, query.index, 'halfedge'));
    return around === 'vertex' ? mesh.vertexHalfedge(query.index) : mesh.faceHalfedge(query.index);
  }

  function step(h: number): number {
    switch (stepOf(query)) {
      case 'rotateCcw':
        read(h, 'prev');
        read(mesh.prev(h), 'opposite');
        return mesh.rotateCcw(h);
      case 'rotateCw':
        read(h, 'opposite');
        read(mesh.opposite(h), 'next');
        return mesh.rotateCw(h);
      case 'next':
        read(h, 'next');
        return mesh.next(h);
      case 'prev':
        read(h, 'prev');
        return mesh.prev(h);
      case 'across':
        read(h, 'opposite');
        return mesh.opposite(h);
    }
  }

  function show(h: number): void {
    if (view === 'toVertex') read(h, 'to');
    if (view === 'face') read(h, 'face');
    if (view === 'opposite' || view === 'faceAcross') read(h, 'opposite');
    if (view === 'faceAcross') read(mesh.opposite(h), 'face');
  }
}
