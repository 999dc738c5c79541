import { type Node, parse } from 'acorn';
import { NONE } from '../../api.js';
import type { Fault } from './outcome.js';

/** A student's function, ready to be called. */
export type Program = (...parameters: unknown[]) => unknown;

/** Thrown in the student's code when its loops have turned too often. */
export class Endless extends Error {
  constructor(readonly line: number) {
    super(`The loop in line ${line} does not end.`);
  }
}

/** The name of the student's code in stack traces. */
const FILE = 'your-code.js';
/** No honest walk on meshes of this size turns so often. */
export const MOST_TURNS = 20_000;

/** How often loops may still turn, and who is told; one of each for a thread that runs programs. */
let turnsLeft = MOST_TURNS;
let told: (line: number) => void = () => {};

/** To be called before each call of a program; `tell` hears of each turn of its loops. */
export function allowTurns(tell: (line: number) => void = () => {}): void {
  turnsLeft = MOST_TURNS;
  told = tell;
}

function turn(line: number): void {
  turnsLeft -= 1;
  if (turnsLeft < 0) throw new Endless(line);
  told(line);
}

/** Throws for what for … in goes through where that can't give what was meant: lists alone have places by name. */
function named(source: unknown): unknown {
  const isRange = typeof source === 'object' && source !== null && Symbol.iterator in source;
  if (!isRange || Array.isArray(source) || ArrayBuffer.isView(source)) return source;
  throw new TypeError('for … in gives names, and not the items: write for … of.');
}

/**
 * Compiles the code of a student and finds the function of that name in it. Each turn of each loop is
 * counted, so that one that doesn't end is ended, and its line known.
 */
export function compile(code: string, call: string): Program | Fault {
  const fence = FENCE.exec(code);
  if (fence) return fenceFault(fence[0].split('\n').length);
  let tree: Tree;
  try {
    tree = parse(code, { ecmaVersion: 2022, sourceType: 'module', locations: true }) as Tree;
  } catch (error) {
    return syntaxFault(error, code);
  }
  const misplaced = moduleIn(tree, call) ?? waitIn(tree);
  if (misplaced) return misplaced;
  let make: Make;
  try {
    make = makerOf(countTurns(code, tree), call);
  } catch (error) {
    return error instanceof SyntaxError ? syntaxFault(error, code) : { kind: 'forbidden' };
  }
  try {
    allowTurns();
    const found = make(NONE, turn, named);
    if (typeof found === 'function') return found as Program;
    return { kind: 'no-function', found: functionsOf(tree) };
  } catch (error) {
    const line = error instanceof Endless ? error.line : lineOf(error);
    return { kind: 'threw', message: messageOf(error), line };
  }
}

/** What is wrong where the code is written as a module. */
function moduleIn({ body }: Tree, call: string): Fault | undefined {
  const found = body.find(({ type }) => /^(Import|Export)/.test(type));
  if (!found) return undefined;
  const hint = /^Export/.test(found.type)
    ? `Leave the word out: the function ${call} is found by its name.`
    : 'The mesh is given to the function; nothing else is needed.';
  return faultAt(found, 'Import and export have no place here', hint);
}

/** What is wrong where the code waits for something outside of functions. */
function waitIn(tree: Tree): Fault | undefined {
  const found = [...nodesOf(tree, isOutside)].find(
    (node) => node.type === 'AwaitExpression' || ('await' in node && node.await === true),
  );
  const hint = 'Nothing here has to be waited for: leave the word await out.';
  return found && faultAt(found, 'Nothing can be waited for outside of a function', hint);
}

function faultAt(node: Node, message: string, hint: string): Fault {
  const { line, column } = (node as Statement).loc.start;
  return { kind: 'syntax', message, line, column: column + 1, hint };
}

/** Runs the code, and returns its function. */
type Make = (
  none: number,
  count: (line: number) => void,
  look: (source: unknown) => unknown,
) => unknown;

/** Throws a SyntaxError for code that only the browser finds wrong, something else where the page forbids code. */
function makerOf(counted: string, call: string): Make {
  return new Function(
    'NONE',
    '__turn',
    '__named',
    // In a block of its own the code may name a constant of its own NONE.
    `'use strict'; { ${counted}
      ;return typeof ${call} === 'function' ? ${call} : undefined; }
      //# sourceURL=${FILE}`,
  ) as Make;
}

/** The line of the student's code from which an error comes, where the browser tells it. */
export function lineOf(error: unknown): number | null {
  const found = new RegExp(`${FILE}:(\\d+)`).exec(stackOf(error))?.[1];
  if (found === undefined) return null;
  linesBefore ??= measureLinesBefore();
  return Number(found) - linesBefore;
}

/** Browsers put lines before the text of which they make a function. */
let linesBefore: number | undefined;

function measureLinesBefore(): number {
  try {
    new Function(`throw new Error()\n//# sourceURL=probe-${FILE}`)();
  } catch (error) {
    return Number(new RegExp(`probe-${FILE}:(\\d+)`).exec(stackOf(error))?.[1] ?? 1) - 1;
  }
  return 0;
}

function stackOf(error: unknown): string {
  return String((Object(error) as { stack?: unknown }).stack ?? '');
}

/** A message that is longer is cut. */
const LONGEST_MESSAGE = 600;

/** The message of whatever was thrown. */
export function messageOf(error: unknown): string {
  try {
    const message = String(error instanceof Error ? error.message : error);
    return message.length > LONGEST_MESSAGE ? `${message.slice(0, LONGEST_MESSAGE)} …` : message;
  } catch {
    return 'Something was thrown that has no text';
  }
}

/** What is used of acorn's nodes. */
interface Tree extends Node {
  readonly body: readonly Statement[];
}
interface Statement extends Node {
  readonly loc: NonNullable<Node['loc']>;
  readonly id?: { readonly name: string } | null;
  readonly declarations?: readonly {
    readonly id: { readonly name?: string };
    readonly init?: Node | null;
  }[];
}
interface Loop extends Statement {
  readonly body: Node;
  readonly right?: Node;
}

function isNode(value: unknown): value is Node {
  return typeof (Object(value) as Node).type === 'string';
}

function* nodesOf(node: Node, enters: (node: Node) => boolean = () => true): Generator<Node> {
  yield node;
  for (const child of Object.values(node).flat()) {
    if (isNode(child) && enters(child)) yield* nodesOf(child, enters);
  }
}

function isOutside({ type }: Node): boolean {
  return !/Function/.test(type);
}

/** The code with a count at the beginning of the body of each loop, and a look at what for … in takes. No line is added. */
function countTurns(code: string, tree: Tree): string {
  const inserted: { at: number; text: string }[] = [];
  for (const node of nodesOf(tree)) {
    if (!/^(For(In|Of)?|While|DoWhile)Statement$/.test(node.type)) continue;
    const { body, loc, right } = node as Loop;
    const count = `__turn(${loc.start.line});`;
    if (node.type === 'ForInStatement' && right) {
      inserted.push({ at: right.start, text: '__named((' }, { at: right.end, text: '))' });
    }
    if (body.type === 'BlockStatement') {
      inserted.push({ at: body.start + 1, text: count });
    } else {
      inserted.push({ at: body.start, text: `{${count}` }, { at: body.end, text: '}' });
    }
  }
  let counted = code;
  for (const { at, text } of inserted.sort((a, b) => b.at - a.at)) {
    counted = counted.slice(0, at) + text + counted.slice(at);
  }
  return counted;
}

/** The names of the functions that the code has on its outermost level. */
function functionsOf({ body }: Tree): string[] {
  return body.flatMap(({ type, id, declarations = [] }) => {
    if (type === 'FunctionDeclaration' && id) return [id.name];
    return declarations
      .filter(({ init }) => /Function/.test(init?.type ?? ''))
      .flatMap(({ id: { name } }) => (name === undefined ? [] : [name]));
  });
}

function syntaxFault(error: unknown, code: string): Fault {
  const { loc } = Object(error) as { loc?: { line: number; column: number } };
  const { line, column } = loc ?? { line: 1, column: 0 };
  const text = code.split('\n')[line - 1] ?? '';
  if (FENCE.test(text)) return fenceFault(line);
  const hint = hintAt(text, column);
  const [seen] = text.slice(column);
  const message =
    hint === UNSEEN
      ? `Unexpected character U+${seen.charCodeAt(0).toString(16).toUpperCase()}, which can’t be seen`
      : messageOf(error).replace(/\s*\(\d+:\d+\)$/, '');
  return { kind: 'syntax', message, line, column: column + 1, ...(hint && { hint }) };
}

/** What stands above and below code in a chat or in notes, and is copied along; JavaScript takes it for a template. */
const FENCE = /^\s*(```|~~~)/;

function fenceFault(line: number): Fault {
  const hint = 'Leave the lines with ``` out.';
  return {
    kind: 'syntax',
    message: 'This marks code in Markdown, and is none',
    line,
    column: 1,
    hint,
  };
}

const UNSEEN = 'It came along with what was pasted: delete it.';
const PRINTED =
  'Code has plain characters: quotes are \' or ", minus is -, comparisons are !=, <= and >=.';
const TYPED = 'It may be a type, which TypeScript has: leave the colon and the type out.';

/** What to do about what comes along where code is pasted from a web page, from slides or from TypeScript. */
function hintAt(text: string, column: number): string | undefined {
  const [before, after] = [text.slice(0, column), text.slice(column)];
  if (/^[\u200b-\u200f\u2028-\u202e\u2060-\u2064]/.test(after)) return UNSEEN;
  if (/^[‘’‚“”„‹›«»‐-―−×≠≤≥…]/.test(after)) return PRINTED;
  const isTyped = /([(,]\s*\w+|\b(let|const|var)\s+\w+|\bfunction\b.*\))\s*$/.test(before);
  return isTyped && /^:/.test(after) ? TYPED : undefined;
}
