import type { ItemKind } from './items.js';

/**
 * The items that show why something failed, such as the edge that three faces share. Indices are
 * those of the input for a build, of the mesh for everything else.
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
  /** The kind of item it is about, and which one; `'mesh'` and -1 where it is about no single one. */
  readonly kind: ItemKind | 'mesh';
  readonly index: number;
  /** One sentence that names the item, its value and what was expected. */
  readonly message: string;
  /** The items that show it, of a build or a repair. */
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
 * Whatever the library refuses that is not simply a wrong argument (those are a `TypeError` or a
 * `RangeError`): `code` is stable, `message` one sentence for people, `witness` the items that show
 * why. A refused build lists what it found in `problems`, up to a thousand.
 */
export class HalfedgeError extends Error {
  readonly code: string;
  readonly witness: Witness;
  /** Not enumerable: an error that nobody caught would be printed with hundreds of them. */
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

  /** What JSON has of it: the sentence as well, which errors leave out by themselves. */
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
