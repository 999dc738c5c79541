import type { HalfedgeMesh, ItemKind } from 'halfedge';
import { arrives, type Item, stepOf, stepsFirst } from 'halfedge/teaching';
import type { Play } from './explorer.js';

/** The rows that tell of an item: one, or the two halfedges of an edge, or the edge of a halfedge. */
export function rowsOf(item: Item | null, kind: ItemKind): number[] {
  if (item?.kind === kind) return [item.index];
  if (item?.kind === 'edge' && kind === 'halfedge') return [2 * item.index, 2 * item.index + 1];
  if (item?.kind === 'halfedge' && kind === 'edge') return [item.index >> 1];
  return [];
}

/** A cell by its kind, row and column. */
export function cellKey(kind: ItemKind, row: number, column: string): string {
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
  const { query, dialect } = play.player;
  const { around, view } = query.circulator;
  // Around a vertex, the cursor of such a dialect is the opposite of the halfedge where the walk is.
  const isOpposite = arrives(query, dialect);
  const read = (row: number, column: string) => cells.add(cellKey('halfedge', row, column));
  const end = current.halfedge;
  const last = play.player.visits.at(-2)?.halfedge;
  let h = last ?? firstStop();
  // Of the anchor it is asked what it shows, unless the lap begins by a step; and of all that is passed over.
  const looks = last === undefined && !stepsFirst(query);
  if (looks) show(h);
  if (!looks || h !== end) {
    do {
      h = step(h);
      show(h);
    } while (h !== end);
  }
  return { cells, at: current.cursor };

  /** Before the first visit the walk is at the anchor, which may come last. */
  function firstStop(): number {
    const first = query.start ?? anchor(query.index);
    if (isOpposite) read(first, 'opposite');
    return first;
  }

  function anchor(index: number): number {
    if (around === 'halfedge') return index;
    if (around === 'edge') return mesh.edgeHalfedge(index);
    cells.add(cellKey(around, index, 'halfedge'));
    return around === 'vertex' ? mesh.vertexHalfedge(index) : mesh.faceHalfedge(index);
  }

  function step(h: number): number {
    switch (stepOf(query)) {
      case 'rotateCcw':
        if (isOpposite) read(mesh.opposite(h), 'opposite');
        read(h, 'prev');
        if (!isOpposite) read(mesh.prev(h), 'opposite');
        return mesh.rotateCcw(h);
      case 'rotateCw':
        if (!isOpposite) read(h, 'opposite');
        read(mesh.opposite(h), 'next');
        if (isOpposite) read(mesh.rotateCw(h), 'opposite');
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
    // It has to get to the halfedge that leaves, or is at the one that arrives.
    const leaves = view !== 'opposite' && view !== 'edge';
    if (isOpposite) {
      if (leaves) read(mesh.opposite(h), 'opposite');
    } else if (view === 'opposite' || view === 'faceAcross') {
      read(h, 'opposite');
    }
    if (view === 'toVertex') read(h, 'to');
    if (view === 'face') read(h, 'face');
    if (view === 'faceAcross') read(mesh.opposite(h), 'face');
  }
}
