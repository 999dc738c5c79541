import type { HalfedgeMesh, ItemKind } from '../api.js';
import type { View } from './circulators.js';
import { halfedge, openmesh } from './dialects-of-meshes.js';
import { cgal, mcguire } from './dialects-of-pointers.js';

/** Whose names the page uses: those of this package, or of a library or article that many know. */
export type DialectId = 'halfedge' | 'openmesh' | 'cgal' | 'mcguire';

/** How a circulator gets from one halfedge to the next. */
export type Step = 'rotateCcw' | 'rotateCw' | 'next' | 'prev' | 'across';

/** The names of a library, as pieces of code that run on a mesh of this package. */
export interface Dialect {
  readonly id: DialectId;
  readonly label: string;
  /** The parameter that is the mesh; empty where items lead on by themselves. */
  readonly mesh: string;
  /** The variable that walks. */
  readonly cursor: string;
  /** What vertices, halfedges, edges and faces are called as parameters. */
  readonly parameters: Readonly<Record<ItemKind, string>>;
  /** The halfedge of an item of that name, at which a walk around it begins. */
  anchor(kind: ItemKind, name: string): string;
  /** Whether a link of that name is empty, as an expression. */
  isEmpty(name: string): string;
  /** The lines that take the cursor one step on. */
  step(step: Step): readonly string[];
  /** What the cursor shows, as an expression. */
  view(view: View, around: ItemKind): string;
  /** Around a vertex the cursor is a halfedge that arrives there, instead of one that leaves. */
  readonly arrives?: true;
  /** A step of the halfedge `h` in one expression, for a sentence; `before` is the one before it. */
  stepName(step: Step, h: string, before: string): string;
  /** The names of the links that the inspector shows; null for one that it doesn't have. */
  readonly links: Readonly<Record<string, string | null>>;
  /** What makes its items of indices, and indices of its items. */
  open(mesh: HalfedgeMesh): Items;
}

/** Items of a dialect and those of the mesh. */
export interface Items {
  /** What the code gets as the mesh. */
  readonly mesh: unknown;
  item(kind: ItemKind, index: number): unknown;
  index(item: unknown, kind: ItemKind): number;
}

/** All dialects, our own first. */
export const dialects: readonly Dialect[] = [halfedge, openmesh, cgal, mcguire];

/** The dialect of that name, or our own. */
export function dialectOf(id: DialectId): Dialect {
  return dialects.find((dialect) => dialect.id === id) ?? halfedge;
}
