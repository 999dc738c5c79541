// The checks of options and arguments that are of a plain type. Each throws a sentence that names the
// argument, its value and what was expected.

import { describe } from './arguments.js';

/**
 * Throws what is wrong: a RangeError for a value of the right `type`, else a TypeError. A page with two copies
 * of the package can have what it expects of the wrong one.
 */
export function refuse(
  argument: string,
  value: unknown,
  expected: string,
  type?: 'number' | 'string',
): never {
  const found = describe(value);
  const whose = found === expected ? ' that this copy of the package has made' : '';
  const sentence = `${argument} is ${found}; expected ${expected}${whose}.`;
  throw typeof value === type ? new RangeError(sentence) : new TypeError(sentence);
}

/** Throws unless it is true or false. */
export function checkFlag(argument: string, value: unknown): asserts value is boolean {
  if (typeof value !== 'boolean') refuse(argument, value, 'true or false');
}

/** Throws unless it is a function, or nothing. */
export function checkCallback(argument: string, value: unknown, expected = 'a function'): void {
  if (value !== undefined && typeof value !== 'function') refuse(argument, value, expected);
}

/** Throws unless it is an object to iterate over, or nothing. */
export function checkIterable(argument: string, value: unknown, expected: string): void {
  const isIterable = typeof value === 'object' && value !== null && Symbol.iterator in value;
  if (value !== undefined && !isIterable) refuse(argument, value, expected);
}

/** The place of a word among those that are allowed; throws if it is none of them. */
export function indexOfChoice(
  argument: string,
  value: unknown,
  choices: readonly string[],
): number {
  const index = choices.indexOf(value as string);
  if (index >= 0) return index;
  const words = choices.map((choice) => `'${choice}'`);
  refuse(argument, value, `${words.slice(0, -1).join(', ')} or ${words.at(-1)}`, 'string');
}

/** More than any count, index or number of bits of the core: 2^31. */
const TOO_MANY = 2 ** 31;

/** Throws unless it is an integer from `least` on that the core can count. */
export function checkCount(argument: string, count: unknown, least = 0): void {
  const isCount = Number.isInteger(count) && (count as number) >= least;
  if (isCount && (count as number) < TOO_MANY) return;
  const most = isCount ? ` to ${TOO_MANY - 1}` : '';
  refuse(argument, count, `an integer from ${least}${most}`, 'number');
}
