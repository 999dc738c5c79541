/** Code that a browser keeps; nothing is kept without a name, or where the page may not keep anything. */
export class Memory {
  readonly #key: string | null;

  constructor(name: string | null) {
    this.#key = name ? `halfedge-exercise:${name}` : null;
  }

  get code(): string | null {
    return this.#try((store, key) => store.getItem(key));
  }

  set code(code: string) {
    this.#try((store, key) => store.setItem(key, code));
  }

  forget(): void {
    this.#try((store, key) => store.removeItem(key));
  }

  #try<Result>(use: (store: Storage, key: string) => Result): Result | null {
    if (this.#key === null) return null;
    try {
      return use(localStorage, this.#key);
    } catch {
      return null; // It is forbidden here, or full.
    }
  }
}
