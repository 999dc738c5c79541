import { parseArgs } from 'node:util';
import { Complaint } from './complaint.js';

/** An option of a command. */
export interface Option {
  /** What its value is called in the help; without one, the option is on or off. */
  readonly value?: string;
  readonly short?: string;
  readonly help: string;
}

export type Options = Readonly<Record<string, Option>>;

/** What a command was called with. */
export class Arguments {
  /** All that is no option, in order. */
  readonly operands: readonly string[];
  readonly #values: ReadonlyMap<string, string | true>;

  constructor(operands: readonly string[], values: ReadonlyMap<string, string | true>) {
    this.operands = operands;
    this.#values = values;
  }

  has(name: string): boolean {
    return this.#values.has(name);
  }

  /** The value of an option that has one. */
  value(name: string): string | undefined {
    return this.#values.get(name) as string | undefined;
  }

  /** The value of an option that has one of a few. */
  choice<T extends string>(name: string, choices: readonly T[]): T | undefined {
    const value = this.value(name);
    if (value === undefined || choices.includes(value as T)) return value as T | undefined;
    throw new Complaint(
      `--${name} is ${quoted(value)}; expected ${listed(choices)}.${suggestion(value, choices)}`,
    );
  }

  /** The value of an option that is a number from `least` on. */
  number(name: string, least: number): number | undefined {
    const value = this.value(name);
    if (value === undefined) return undefined;
    const number = value.trim() === '' ? Number.NaN : Number(value);
    if (number >= least && number < Infinity) return number;
    throw new Complaint(`--${name} is ${quoted(value)}; expected a number from ${least}.`);
  }
}

/** Takes a command line apart. Throws a Complaint about what is no option of the command. */
export function readArguments(command: string, options: Options, line: string[]): Arguments {
  const { tokens } = parseArgs({
    args: line,
    options: Object.fromEntries(
      Object.entries(options).map(([name, { value, short }]) => {
        const type = value === undefined ? ('boolean' as const) : ('string' as const);
        return [name, short === undefined ? { type } : { type, short }];
      }),
    ),
    allowPositionals: true,
    strict: false, // its sentences name no file, no command and no alternative
    tokens: true,
  });
  const operands: string[] = [];
  const values = new Map<string, string | true>();
  for (const token of tokens) {
    if (token.kind === 'positional') operands.push(token.value);
    if (token.kind !== 'option') continue;
    values.set(token.name, optionValue(command, options, token));
  }
  return new Arguments(operands, values);
}

interface OptionToken {
  readonly name: string;
  readonly rawName: string;
  readonly value?: string | undefined;
  readonly inlineValue?: boolean | undefined;
}

function optionValue(command: string, options: Options, token: OptionToken): string | true {
  const { name, rawName, value, inlineValue } = token;
  const option = Object.hasOwn(options, name) ? options[name] : undefined;
  if (option === undefined) {
    const alike = suggestion(name, Object.keys(options), '--');
    throw new Complaint(
      `${rawName} is no option of \`halfedge ${command}\`.${alike || ` \`halfedge ${command} --help\` lists them.`}`,
    );
  }
  if (option.value === undefined) {
    if (value === undefined) return true;
    throw new Complaint(`${rawName} is ${quoted(value)}; it takes no value.`);
  }
  const isNextOption = !inlineValue && value !== undefined && /^-\D/.test(value);
  if (value !== undefined && !isNextOption) return value;
  throw new Complaint(`${rawName} has no value; expected ${rawName} <${option.value}>.`);
}

/** " Did you mean …?", if something is spelt nearly so; else nothing. */
export function suggestion(word: string, known: readonly string[], prefix = ''): string {
  if (word.length > 40) return ''; // nothing is spelt like that
  const limit = Math.max(1, Math.floor(word.length / 3));
  const [best] = known
    .map((candidate) => ({ candidate, distance: distance(word.toLowerCase(), candidate) }))
    .filter((found) => found.distance <= limit || isBeginning(word, found.candidate))
    .sort((a, b) => a.distance - b.distance);
  return best === undefined ? '' : ` Did you mean ${prefix}${best.candidate}?`;
}

const isBeginning = (word: string, candidate: string) =>
  word.length > 1 && candidate.startsWith(word);

/** How many letters have to be put in, taken out, replaced or exchanged to make one word the other. */
function distance(a: string, b: string): number {
  const rows = [Array.from({ length: b.length + 1 }, (_, j) => j)];
  for (let i = 1; i <= a.length; i++) {
    const row = [i];
    for (let j = 1; j <= b.length; j++) {
      const replaced = rows[i - 1][j - 1] + (a[i - 1] === b[j - 1] ? 0 : 1);
      row.push(Math.min(replaced, rows[i - 1][j] + 1, row[j - 1] + 1));
      const areExchanged = i > 1 && j > 1 && a[i - 1] === b[j - 2] && a[i - 2] === b[j - 1];
      if (areExchanged) row[j] = Math.min(row[j], rows[i - 2][j - 2] + 1);
    }
    rows.push(row);
  }
  return rows[a.length][b.length];
}

/** A word of the command line in a sentence. */
const quoted = (word: string) => JSON.stringify(word);

/** "a, b or c". */
export function listed(words: readonly string[]): string {
  const last = words[words.length - 1];
  return words.length === 1 ? last : `${words.slice(0, -1).join(', ')} or ${last}`;
}
