import { describe } from './arguments.js';

/** The names of all options that there are: the compiler finds one that is missing, and one too many. */
export type OptionNames<Options> = { readonly [Name in keyof Options]-?: true };

/**
 * Throws unless `options` is an object that has only options of those names; returns it. A misspelt option
 * would have no effect otherwise, and nobody would know.
 */
export function checkOptions<Options extends object>(
  options: unknown,
  names: OptionNames<Options>,
  argument = 'options',
): Options {
  const given = checkObject(options, argument);
  for (const name in given) {
    if (!Object.hasOwn(names, name)) refuseName(argument, name, Object.keys(names));
  }
  return given as Options;
}

/** Throws unless `value` is an object, and no list; returns it. */
export function checkObject(value: unknown, argument: string): object {
  if (typeof value === 'object' && value !== null) {
    if (!Array.isArray(value) && !ArrayBuffer.isView(value)) return value;
  }
  throw new TypeError(`${argument} is ${describe(value)}; expected an object.`);
}

function refuseName(argument: string, name: string, names: readonly string[]): never {
  const known = names.length > 1 ? `${names.slice(0, -1).join(', ')} or ${names.at(-1)}` : names[0];
  throw new TypeError(`${argument} has the name ${describe(name)}; expected ${known}.`);
}
