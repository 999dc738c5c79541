import type { FigureModel } from './model.js';
import { openFaces, openSource, type Source, Unreached } from './source.js';
import { started } from './start.js';

/** How far outside of the window a figure begins to load. */
const NEAR = '300px';

/** A figure that is loaded. */
export interface Loaded {
  /** Where its mesh comes from. */
  source(): Source;
  /** Whether it has the faces of the source, good or bad, instead of a mesh. */
  isBuilt(): boolean;
  /** The model has what the source is; `signal` tells when another one is loaded instead. */
  opened(signal: AbortSignal): Promise<void>;
  /** Nothing came of it; `isUnreached`: for want of a file or of the network, which may come back. */
  failed(error: unknown, isUnreached: boolean): void;
}

/** Loads the mesh of a figure into its model; once another one is loaded, the one before is given up. */
export class Loading {
  readonly #model: FigureModel;
  readonly #figure: Loaded;
  #abort = new AbortController();

  constructor(model: FigureModel, figure: Loaded) {
    this.#model = model;
    this.#figure = figure;
  }

  /** Gives up what is being loaded. */
  giveUp(): void {
    this.#abort.abort();
  }

  async load(): Promise<void> {
    this.giveUp();
    this.#abort = new AbortController();
    const { signal } = this.#abort;
    let hasStarted = false;
    try {
      await started();
      hasStarted = true;
      await this.#take(signal);
      if (!signal.aborted) await this.#figure.opened(signal);
    } catch (error) {
      if (!signal.aborted) this.#figure.failed(error, !hasStarted || error instanceof Unreached);
    }
  }

  async #take(signal: AbortSignal): Promise<void> {
    const source = this.#figure.source();
    if (this.#figure.isBuilt()) {
      const list = await openFaces(source, signal);
      if (!signal.aborted) this.#model.takeList(list);
      return;
    }
    const mesh = await openSource(source, signal);
    if (signal.aborted) mesh.dispose();
    else this.#model.take(mesh);
  }
}

/**
 * Tells whether a figure is near the window. Null in jsdom, where components are tested, which has no such
 * observers and shows nothing: all is in sight there.
 */
export function sightObserver(seen: (isNear: boolean) => void): IntersectionObserver | null {
  if (typeof IntersectionObserver === 'undefined') return null;
  return new IntersectionObserver(
    // The last entry tells how it is now: while the page was busy, there may have been several.
    (entries) => seen(entries[entries.length - 1].isIntersecting),
    { rootMargin: NEAR },
  );
}
