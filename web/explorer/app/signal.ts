/** Listeners that wait for the end of `together`, by the signal they belong to. */
let waiting: Set<{ tell(): void }> | null = null;

/**
 * Sets several signals as one change: their listeners are told after all of them are set, in the
 * order in which the signals were. What a listener reads is never half old and half new.
 */
export function together(change: () => void): void {
  if (waiting) {
    change();
    return;
  }
  const changed = new Set<{ tell(): void }>();
  waiting = changed;
  try {
    change();
  } finally {
    waiting = null;
    for (const signal of changed) signal.tell();
  }
}

/** A value that tells its listeners when it changes. */
export class Signal<T> {
  #value: T;
  readonly #listeners = new Set<(value: T) => void>();

  constructor(value: T) {
    this.#value = value;
  }

  get value(): T {
    return this.#value;
  }

  set value(value: T) {
    if (Object.is(value, this.#value)) return;
    this.#value = value;
    if (waiting) waiting.add(this);
    else this.tell();
  }

  /** Calls `listener` now and after every change. Returns how to stop that. */
  subscribe(listener: (value: T) => void): () => void {
    this.#listeners.add(listener);
    listener(this.#value);
    return () => this.#listeners.delete(listener);
  }

  /** Calls the listeners with the value as it is. */
  tell(): void {
    for (const listener of this.#listeners) listener(this.#value);
  }
}
