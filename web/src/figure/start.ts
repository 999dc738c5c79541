/** Loads the WebAssembly module; each entry of the package has its own way. */
let init: (() => Promise<void>) | null = null;

/** To be called by the entry, before any figure is shown. */
export function startWith(start: () => Promise<void>): void {
  init ??= start;
}

export function started(): Promise<void> {
  if (!init) throw new Error('No entry of the package was imported.');
  return init();
}
