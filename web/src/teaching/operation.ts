import { HalfedgeError, type HalfedgeMesh, type ItemKind, type Witness } from '../api.js';
import { refuse } from '../checks.js';
import type { Item } from './items.js';

/** What an operation is applied to: one item, the whole mesh, or a first and a second item. */
export interface Operands {
  readonly mesh: HalfedgeMesh;
  /** The selected item; for an operation on the whole mesh, meaningless. */
  readonly item: Item;
  /** The item chosen second, for operations that take two. */
  readonly second: Item | null;
}

/**
 * An operation that the page offers: one record says what it is called, what it takes, what is
 * selected after it and how the picture moves.
 */
export interface Operation {
  /** The method of `HalfedgeMesh`; its check is `check` and this name. */
  readonly stem: string;
  readonly on: ItemKind | 'mesh';
  readonly label: string;
  /** One line that says what it does. */
  readonly meaning: string;
  /** Pressed with shift; `Delete` without. Left out, there is a button alone. */
  readonly key?: string;
  /** The kind of the second item, and how to ask for it. */
  readonly second?: { readonly kind: ItemKind; readonly ask: string };
  /** For one that takes two: why the first item alone makes it impossible, or null. */
  checkFirst?(operands: Operands): Refusal | null;
  /** The arguments of the method; the indices of the items if left out. */
  arguments?(operands: Operands): readonly unknown[];
  /** For an operation that gives items other indices: the new one of an item, or NONE. */
  renumbers?(result: unknown, item: Item): number;
  /** The kind of item that it returns, which is then selected; else what is left, or next to it. */
  readonly returns?: ItemKind;
  /** Vertices that vanish slide into this one before they do. */
  slidesInto?(operands: Operands): number;
  /** It leaves the mesh as it is and returns another one, which is opened. */
  readonly opens?: boolean;
  /** It returns a report, whose summary is shown. */
  readonly reports?: boolean;
  /** New vertices come out of the nearest corner of the item, instead of appearing where they are. */
  readonly grows?: boolean;
}

/** Why an operation cannot be done. */
export interface Refusal {
  readonly code: string;
  readonly message: string;
  readonly witness: Witness;
}

type Method = (...operands: readonly unknown[]) => unknown;

function method(mesh: HalfedgeMesh, name: string): Method | undefined {
  const found = (mesh as unknown as Record<string, unknown>)[name];
  return typeof found === 'function' ? (found.bind(mesh) as Method) : undefined;
}

function argumentsOf(operation: Operation, operands: Operands): readonly unknown[] {
  if (operation.arguments) return operation.arguments(operands);
  if (operation.on === 'mesh') return [];
  const { item, second } = operands;
  return second ? [item.index, second.index] : [item.index];
}

/**
 * Why the operation is refused, or null; without the second item, why it is whatever that will be. Changes nothing. One
 * that leaves the mesh as it is tells when it is run: its check would take as long.
 */
export function checkOperation(operation: Operation, operands: Operands): Refusal | null {
  checkOperands(operation, operands);
  if (operation.opens) return null;
  if (operation.second && !operands.second) return operation.checkFirst?.(operands) ?? null;
  const name = `check${operation.stem[0].toUpperCase()}${operation.stem.slice(1)}`;
  const check = method(operands.mesh, name);
  if (!check) return null;
  try {
    return check(...argumentsOf(operation, operands)) as Refusal | null;
  } catch (error) {
    return refusalOf(error);
  }
}

/** Does the operation; throws what the method throws. */
export function runOperation(operation: Operation, operands: Operands): unknown {
  checkOperands(operation, operands);
  return method(operands.mesh, operation.stem)?.(...argumentsOf(operation, operands));
}

/** Throws unless it is an operation, and there is a mesh that has it. */
function checkOperands(operation: Operation, operands: Operands): void {
  const mesh = operands?.mesh;
  if (typeof mesh !== 'object' || mesh === null) refuse('operands.mesh', mesh, 'a HalfedgeMesh');
  if (typeof operation?.stem !== 'string') refuse('operation', operation, 'one of `operations`');
  if (!method(mesh, operation.stem)) {
    refuse('operation.stem', operation.stem, 'a method of HalfedgeMesh', 'string');
  }
}

/** The refusal that an error of the package is; throws what is none. */
export function refusalOf(error: unknown): Refusal {
  if (error instanceof HalfedgeError) return error;
  if (error instanceof RangeError || error instanceof TypeError) {
    const none = { vertices: [], halfedges: [], edges: [], faces: [] };
    return { code: 'bad-argument', message: error.message, witness: none };
  }
  throw error;
}

/** The items of a witness, in the order in which sentences name them most often. */
export function witnessItems({ edges, faces, vertices, halfedges }: Witness): Item[] {
  const of = (kind: ItemKind, indices: readonly number[]) =>
    indices.map((index) => ({ kind, index }));
  return [
    ...of('edge', edges),
    ...of('face', faces),
    ...of('vertex', vertices),
    ...of('halfedge', halfedges),
  ];
}
