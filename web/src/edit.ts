import { describe, lengthOfArrayLike } from './arguments.js';
import { HalfedgeError, type Witness } from './errors.js';
import type { Links } from './links.js';
import type { Core } from './loader.js';
import { outOfMemory } from './memory.js';
import { problemOf } from './reports.js';

// How an operation crosses into the core, and back. The functions of the core are plain exports:
// numbers in, a number out.

/** Why an operation can't be done. */
export interface Refusal {
  /** A stable name for programs, in kebab-case. */
  readonly code: string;
  /** One sentence that names the items, what they are and what was expected. */
  readonly message: string;
  /** The items that make it impossible. */
  readonly witness: Witness;
}

/** The bits of a mode, as in wasm/operation_bindings.h. */
export const CHECK_ONLY = 1;
const KEEP_STEP_OPEN = 2;
const AT = 4;
export const OPTION = 8;

/** What the core returns for a refusal; and if there is no memory even for its sentence. */
const REFUSED = -1;
const NO_ROOM = -2;

/** A place for a vertex: x, y, z. */
export type Position = ArrayLike<number>;

/** The mode of an edit: whether it ends a step of history. */
export function modeOf(links: Links): number {
  return links.groups === 0 ? 0 : KEEP_STEP_OPEN;
}

/** The mode of an edit or a check, if a position is given. */
export function withPosition(mode: number, position: Position | undefined): number {
  return position === undefined ? mode : mode | AT;
}

/** What an edit returned, after which the links are those of the changed mesh. Throws if refused. */
export function done(links: Links, result: number): number {
  if (result === NO_ROOM) throw noRoom();
  links.update();
  if (result !== REFUSED) return result;
  const { code, message, witness } = lastRefusal(links.core);
  throw new HalfedgeError(code, message, { witness });
}

/** What a check returned: null if the operation can be done, else why not. */
export function answer(links: Links, result: number): Refusal | null {
  if (result === NO_ROOM) throw noRoom();
  return result === REFUSED ? lastRefusal(links.core) : null;
}

function lastRefusal(core: Core): Refusal {
  const { code, message, witness } = problemOf(core.lastRefusal(), 'error');
  return Object.freeze({ code, message, witness: witness as Witness });
}

const noRoom = () => outOfMemory('The change');

const ORIGIN = [0, 0, 0];

/** The position, or any if none is given. Throws a sentence for what is none. */
export function checkPosition(position: Position | undefined, argument = 'position'): Position {
  if (position === undefined) return ORIGIN;
  const expected = 'three numbers, x, y and z';
  if (lengthOfArrayLike(argument, position, expected) !== 3) {
    throw new RangeError(`${argument} is ${describe(position)}; expected ${expected}.`);
  }
  for (let i = 0; i < 3; i++) checkCoordinate(position[i], `${argument}[${i}]`);
  return position;
}

function checkCoordinate(value: unknown, argument: string): void {
  if (typeof value !== 'number') {
    throw new TypeError(`${argument} is ${describe(value)}; expected a number.`);
  }
  if (!Number.isFinite(Math.fround(value))) {
    throw new RangeError(
      `${argument} is ${describe(value)}; expected a finite number that fits a 32-bit float.`,
    );
  }
}
