import { describe } from './arguments.js';

/** The names of all options that there are: the compiler finds one that is missing, and one too many. */
export type OptionNames<Options> = { readonly [Name in keyof Options]-?: true };

/**
 * Throws unless `options` is an object that has only options of those names; returns it. A misspelt option
 * would have no effect otherwise, and nobody would know.
 *
 * As short as it can be, for the loops that make circulators: see laps.ts. So an empty list passes.
 */
export function checkOptions<Options extends object>(
  options: unknown,
  names: OptionNames<Options>,
  argument?: string,
): Options {
  for (const name in options as Options) {
    if (names[name] !== true) checkName(options, name, names, argument);
  }
  if (typeof options !== 'object' || options === null || Symbol.toStringTag in options) {
    checkObject(options, argument);
  }
  return options as Options;
}

/** Options without those that are undefined, which count as not given. */
export type Given<Options> = { [Name in keyof Options]: Exclude<Options[Name], undefined> };

/**
 * As `checkOptions`, and returns a copy for later: with what the object inherits, and without what is undefined.
 */
export function takeOptions<Options extends object>(
  options: Options,
  names: OptionNames<Options>,
): Given<Options> {
  checkOptions(options, names);
  const taken: Partial<Options> = {};
  for (const name in names) if (options[name] !== undefined) taken[name] = options[name];
  return taken as Given<Options>;
}

/** Throws unless `value` is an object with names, and nothing else; returns it. */
export function checkObject(value: unknown, argument = 'options'): object {
  if (isPlain(value)) return value;
  const isObject = typeof value === 'object' && value !== null;
  const expected = isObject ? 'a plain object' : 'an object';
  throw new TypeError(`${argument} is ${describe(value)}; expected ${expected}.`);
}

/** Whether it is an object (or a module, whose exports are its names), but no list, mesh, promise or buffer. */
export function isPlain(value: unknown): value is object {
  return /^\[object (Object|Module)\]$/.test(Object.prototype.toString.call(value));
}

/** Throws for a name that isn't among the names, unless all objects of the page have got it. */
function checkName(options: unknown, name: string, names: object, argument = 'options'): void {
  if (name in Object.prototype) return;
  checkObject(options, argument); // a list has names, too: 0, 1, 2
  const all = Object.keys(names);
  const known = all.length > 1 ? `${all.slice(0, -1).join(', ')} or ${all.at(-1)}` : all[0];
  throw new TypeError(`${argument} has the name ${describe(name)}; expected ${known}.`);
}
