import { HalfedgeFigure } from './element.js';
import type { FigureEvents } from './events.js';
import { startWith } from './start.js';

/** The events of figures, as listeners get them. */
export type FigureEventMap = { [Name in keyof FigureEvents]: CustomEvent<FigureEvents[Name]> };

declare global {
  interface HTMLElementTagNameMap {
    'halfedge-figure': HalfedgeFigure;
  }
  interface HTMLElementEventMap extends FigureEventMap {}
}

/** Makes figures of the elements, with a way to load the WebAssembly module. The first call counts. */
export function define(init: () => Promise<void>): void {
  startWith(init);
  // There are no elements where there is no page.
  if (typeof customElements === 'undefined' || customElements.get('halfedge-figure')) return;
  customElements.define('halfedge-figure', HalfedgeFigure);
}
