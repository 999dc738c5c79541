import type { HalfedgeMesh, ItemKind } from 'halfedge';
import {
  arrives,
  type Dialect,
  type Item,
  type Query,
  stepOf,
  stepsFirst,
} from 'halfedge/teaching';
import type { Play } from './walker.js';

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

/** What the last step of the player has read. */
export function readingOf(mesh: HalfedgeMesh, play: Play | null): Reading {
  const current = play?.player.current;
  if (!play || !current) return { cells: new Set(), at: null };
  const { query, dialect, visits } = play.player;
  const reader = new StepReader(mesh, query, dialect);
  reader.follow(visits.at(-2)?.halfedge, current.halfedge);
  return { cells: reader.cells, at: current.cursor };
}

/** Makes a step of a walk again, and notes the cells that it reads. */
class StepReader {
  readonly cells = new Set<string>();
  readonly #mesh: HalfedgeMesh;
  readonly #query: Query;
  /** Around a vertex, the cursor of such a dialect is the opposite of the halfedge where the walk is. */
  readonly #isOpposite: boolean;

  constructor(mesh: HalfedgeMesh, query: Query, dialect: Dialect) {
    this.#mesh = mesh;
    this.#query = query;
    this.#isOpposite = arrives(query, dialect);
  }

  /** From the visit before, or undefined for the first one, to the next: past what shows nothing. */
  follow(last: number | undefined, end: number): void {
    let h = last ?? this.#firstStop();
    // Of the anchor it is asked what it shows, unless the lap begins by a step; and of all that is passed over.
    const looks = last === undefined && !stepsFirst(this.#query);
    if (looks) this.#show(h);
    if (looks && h === end) return;
    do {
      h = this.#step(h);
      this.#show(h);
    } while (h !== end);
  }

  /** Before the first visit the walk is at the anchor, which may come last. */
  #firstStop(): number {
    const { start, index } = this.#query;
    const first = start ?? this.#anchor(index);
    if (this.#isOpposite) this.#read(first, 'opposite');
    return first;
  }

  #anchor(index: number): number {
    const { around } = this.#query.circulator;
    if (around === 'halfedge') return index;
    if (around === 'edge') return this.#mesh.edgeHalfedge(index);
    this.cells.add(cellKey(around, index, 'halfedge'));
    return around === 'vertex' ? this.#mesh.vertexHalfedge(index) : this.#mesh.faceHalfedge(index);
  }

  #step(h: number): number {
    const mesh = this.#mesh;
    switch (stepOf(this.#query)) {
      case 'rotateCcw':
        if (this.#isOpposite) this.#read(mesh.opposite(h), 'opposite');
        this.#read(h, 'prev');
        if (!this.#isOpposite) this.#read(mesh.prev(h), 'opposite');
        return mesh.rotateCcw(h);
      case 'rotateCw':
        if (!this.#isOpposite) this.#read(h, 'opposite');
        this.#read(mesh.opposite(h), 'next');
        if (this.#isOpposite) this.#read(mesh.rotateCw(h), 'opposite');
        return mesh.rotateCw(h);
      case 'next':
        this.#read(h, 'next');
        return mesh.next(h);
      case 'prev':
        this.#read(h, 'prev');
        return mesh.prev(h);
      case 'across':
        this.#read(h, 'opposite');
        return mesh.opposite(h);
    }
  }

  #show(h: number): void {
    const { view } = this.#query.circulator;
    // It has to get to the halfedge that leaves, or is at the one that arrives.
    const leaves = view !== 'opposite' && view !== 'edge';
    if (this.#isOpposite) {
      if (leaves) this.#read(this.#mesh.opposite(h), 'opposite');
    } else if (view === 'opposite' || view === 'faceAcross') {
      this.#read(h, 'opposite');
    }
    if (view === 'toVertex') this.#read(h, 'to');
    if (view === 'face') this.#read(h, 'face');
    if (view === 'faceAcross') this.#read(this.#mesh.opposite(h), 'face');
  }

  #read(row: number, column: string): void {
    this.cells.add(cellKey('halfedge', row, column));
  }
}
