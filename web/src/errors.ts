import type { ItemKind } from './items.js';

/**
 * The items that show why something failed, such as the edge that three faces share. For a build, indices are
 * those of the input; for everything else, those of the mesh.
 */
export interface Witness {
  readonly vertices: readonly number[];
  readonly halfedges: readonly number[];
  readonly edges: readonly number[];
  readonly faces: readonly number[];
}

/** One thing that is wrong with an input or a mesh. */
export interface Problem {
  /** A stable name for programs, in kebab-case. */
  readonly code: string;
  readonly severity: 'error' | 'warning' | 'info';
  /** The kind of item that it is about, and its index; `'mesh'` and -1 if it isn't about a single item. */
  readonly kind: ItemKind | 'mesh';
  readonly index: number;
  /** One sentence that names the item, its value and what was expected. */
  readonly message: string;
  /** The items that show it, for a build or a repair. */
  readonly witness?: Witness;
}

/** The witness of an error that no item shows. */
export const NO_WITNESS: Witness = Object.freeze({
  vertices: Object.freeze([]),
  halfedges: Object.freeze([]),
  edges: Object.freeze([]),
  faces: Object.freeze([]),
});

/**
 * Thrown for everything that the library refuses, except wrong arguments (those are a `TypeError` or a
 * `RangeError`). `code` is stable, `message` is one sentence for people, and `witness` has the items that
 * show why. A refused build lists all that it found in `problems`, up to a thousand.
 */
export class HalfedgeError extends Error {
  /** What went wrong, in a word that stays the same: docs/errors.md lists them. */
  readonly code: string;
  /** The items that show why. */
  readonly witness: Witness;
  /** Not enumerable: otherwise an uncaught error would be printed with hundreds of them. */
  declare readonly problems: readonly Problem[];

  constructor(
    code: string,
    message: string,
    details: { witness?: Witness; problems?: readonly Problem[]; cause?: unknown } = {},
  ) {
    super(message, 'cause' in details ? { cause: details.cause } : undefined);
    this.code = code;
    this.witness = details.witness ?? NO_WITNESS;
    Object.defineProperty(this, 'problems', { value: details.problems ?? [] });
  }

  /** The error as JSON, including the message, which errors leave out by default. */
  toJSON(): Pick<HalfedgeError, 'name' | 'code' | 'message' | 'witness' | 'problems'> {
    const { name, code, message, witness, problems } = this;
    return { name, code, message, witness, problems };
  }

  static {
    Object.defineProperty(HalfedgeError.prototype, 'name', {
      value: 'HalfedgeError',
      configurable: true,
      writable: true,
    });
  }
}
