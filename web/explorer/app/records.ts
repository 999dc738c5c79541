import type { HalfedgeMesh, ItemKind } from 'halfedge';
import { type Item, stepOf, stepsFirst } from 'halfedge/teaching';
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
  const { query } = play.player;
  const { around, view } = query.circulator;
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
  return { cells, at: end };

  /** Before the first visit the walk is at the anchor, which may come last. */
  function firstStop(): number {
    const { index, start } = query;
    if (start !== undefined) return start;
    if (around === 'halfedge') return index;
    if (around === 'edge') return mesh.edgeHalfedge(index);
    cells.add(cellKey(around, index, 'halfedge'));
    return around === 'vertex' ? mesh.vertexHalfedge(index) : mesh.faceHalfedge(index);
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
