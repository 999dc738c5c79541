/**
 * Has views of the WebAssembly memory. Growth of the memory detaches them, and V8 never forgets that it has
 * read a detached view: whatever reads views is slower from then on. So they are replaced at once.
 */
export interface Viewer {
  /** Makes the views anew, where they were. Must not call into WebAssembly, which is at work. */
  renewViews(): void;
}

/** A weak reference to a viewer; not by its name, which the types of an older `lib` have not. */
export interface Watch {
  deref(): Viewer | undefined;
}

/** All that there are. Weakly, so that forgotten meshes can be freed. */
const viewers = new Set<Watch>();
const forgotten = new FinalizationRegistry<Watch>(unwatchGrowth);

/**
 * Has `viewer` told of each growth from now on, until `unwatchGrowth` of what this returns, or until it is
 * forgotten.
 */
export function watchGrowth(viewer: Viewer): Watch {
  const watch: Watch = new WeakRef(viewer);
  viewers.add(watch);
  forgotten.register(viewer, watch);
  return watch;
}

export function unwatchGrowth(watch: Watch): void {
  viewers.delete(watch);
}

/** Has `memory` tell all viewers when it has grown. */
export function announceGrowth(memory: WebAssembly.Memory): void {
  const grow = memory.grow.bind(memory);
  memory.grow = (pages) => {
    const before = grow(pages);
    try {
      for (const watch of viewers) watch.deref()?.renewViews();
    } catch {
      // No memory for the views themselves: they are mended when they are used.
    }
    return before;
  };
}
