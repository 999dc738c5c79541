import type { HalfedgeMesh, Witness } from '../api.js';

/** What the events of a figure tell, by their names. All bubble, and cross shadow roots. */
export interface FigureEvents {
  /** The mesh is on show. */
  'halfedge-ready': { readonly mesh: HalfedgeMesh };
  /** The reader has selected another item: `v3`, or null for none. */
  'halfedge-select': { readonly item: string | null };
  /** The player has moved on, or back. */
  'halfedge-step': {
    readonly step: number;
    readonly count: number;
    /** What the step did. */
    readonly sentence: string;
    /** The item that it came to, or null. */
    readonly item: string | null;
  };
  /** The next operation can't be done. */
  'halfedge-refused': {
    readonly code: string;
    readonly message: string;
    readonly witness: Witness;
  };
  /** Something can't be shown; the sentence is in the figure, too. */
  'halfedge-error': { readonly message: string; readonly error: unknown };
}

/** Tells an event of a figure. */
export function tell<Name extends keyof FigureEvents>(
  figure: Element,
  name: Name,
  detail: FigureEvents[Name],
): void {
  figure.dispatchEvent(new CustomEvent(name, { detail, bubbles: true, composed: true }));
}
