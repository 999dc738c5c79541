import type { HalfedgeMesh } from '../../api.js';
import type { Item } from '../../teaching/items.js';
import type { MeshName } from './meshes.js';

/** What a student's function is called with, besides the mesh: items, which it gets as their indices, or words. */
export type Argument = Item | 'ccw' | 'cw' | number;

/** What a student's function has to give back. */
export type Answer =
  /** Items in their order around something; the reference begins where a walk from the anchor begins. */
  | {
      readonly kind: 'cycle';
      readonly of: Item['kind'];
      /** Whether both ways round are right. */
      readonly eitherWay?: boolean;
      /** Whether it may begin anywhere. */
      readonly anyStart?: boolean;
    }
  | { readonly kind: 'item'; readonly of: Item['kind'] }
  | { readonly kind: 'number' }
  | { readonly kind: 'boolean' }
  /** Nothing: the arrays of links are changed in place. */
  | { readonly kind: 'links' };

/** A wrong answer that many give, and what to say to it. */
export interface Mistake {
  /** A name for it, such as `counts-faces`. */
  readonly code: string;
  /** What the function gives back then. */
  readonly answer: (mesh: HalfedgeMesh, ...parameters: Argument[]) => unknown;
  /** What it does, as a sentence. */
  readonly says: string;
  /** How to think on. */
  readonly hint?: string;
}

/** An exercise: what is asked, on which meshes, and what is right. */
export interface ExerciseTask {
  readonly name: string;
  readonly title: string;
  /** What is to be done. Words between backticks are code. */
  readonly statement: string;
  /** The name of the function that is to be written. */
  readonly call: string;
  /** What the editor holds at first. */
  readonly starter: string;
  /** One right answer. */
  readonly solution: string;
  /** What the function gets: a mesh that can be asked, or copies of the arrays of its links. */
  readonly gets: 'mesh' | 'links';
  /** What the mesh can be asked for, by the names in the API. */
  readonly uses: readonly string[];
  /** The meshes it is tried on. Default: all. */
  readonly meshes?: readonly MeshName[];
  /** With what the function is called on a mesh, call by call. */
  readonly asks: (mesh: HalfedgeMesh) => Iterable<readonly Argument[]>;
  readonly answer: Answer;
  /** The right answer, of the mesh itself; of `links` it is what the mesh has to be like, see {@link Answer}. */
  readonly reference: (mesh: HalfedgeMesh, ...parameters: Argument[]) => unknown;
  /** Wrong answers of this task that deserve words of their own. */
  readonly mistakes?: readonly Mistake[];
  /**
   * Replaces the comparison with the reference: a sentence about what is wrong, or null. `got` is what the
   * function gave back; of `links`, the arrays.
   */
  readonly check?: (mesh: HalfedgeMesh, got: unknown, ...parameters: Argument[]) => string | null;
}

/** The index of the item that a parameter is. */
export function indexOf(parameter: Argument): number {
  if (typeof parameter === 'object') return parameter.index;
  throw new TypeError(`A parameter is ${parameter}; expected an item.`);
}

/** What the student's function is given for a parameter. */
export function plain(parameter: Argument): number | string {
  return typeof parameter === 'object' ? parameter.index : parameter;
}
