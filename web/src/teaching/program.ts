import { type HalfedgeMesh, NONE } from '../api.js';
import type { Query } from './circulators.js';
import type { Dialect, Step } from './dialects.js';

/** The code of a query: what the page shows, and what it runs. */
export interface Program {
  readonly lines: readonly string[];
}

/** What the code did from one visit to the next. */
export interface Hop {
  /** Where the walk is, the same in all dialects: around a vertex a halfedge that leaves it. */
  readonly halfedge: number;
  /** Where the cursor of the code stands: in some dialects one that arrives at the vertex. */
  readonly cursor: number;
  /** The item that the code yielded. */
  readonly index: number;
  /** The lines that ran, by their places in the program; the last one yielded. */
  readonly ran: readonly number[];
}

/** Writes the circulator of a query as a generator function, in the names of a dialect. */
export function programOf(query: Query, dialect: Dialect): Program {
  const { circulator, start } = query;
  const { around, name } = circulator;
  const { cursor } = dialect;
  const parameter = dialect.parameters[start === undefined ? around : 'halfedge'];
  const parameters = [dialect.mesh, parameter].filter(Boolean).join(', ');
  const anchor =
    start === undefined
      ? dialect.anchor(around, parameter)
      : arrives(query, dialect)
        ? 'start.opposite()'
        : 'start';
  // A parameter that is the first halfedge needs no second name.
  const first = anchor === parameter ? parameter : 'first';
  const step = dialect.step(stepOf(query));
  const visit = visitOf(query, dialect);
  const lap = stepsFirst(query) ? [...step, ...visit] : [...visit, ...step];
  const lines = [
    `function* ${name}(${parameters}) {`,
    ...(first === 'first' ? [`  const first = ${anchor};`] : []),
    ...(around === 'vertex' && start === undefined
      ? [`  if (${dialect.isEmpty('first')}) return; // isolated`]
      : []),
    `  let ${cursor} = ${first};`,
    '  do {',
    ...lap.map((line) => `    ${line}`),
    `  } while (${cursor} !== ${first});`,
    '}',
  ];
  return { lines };
}

/** Whether the cursor arrives at the vertex of the walk, where ours leaves it. */
export function arrives({ circulator }: Query, dialect: Dialect | undefined): boolean {
  return dialect?.arrives === true && circulator.around === 'vertex';
}

/** How a lap gets from one halfedge to the next. */
export function stepOf({ circulator: { walk }, direction }: Query): Step {
  if (walk === 'across') return 'across';
  if (walk === 'rotate') return direction === 'ccw' ? 'rotateCcw' : 'rotateCw';
  return direction === 'ccw' ? 'next' : 'prev';
}

/** Whether a lap begins by a step: one against the order of the anchor ends there, so that it is the other one reversed. */
export function stepsFirst({ circulator: { around, walk }, direction, start }: Query): boolean {
  if (start !== undefined || around === 'halfedge' || walk === 'across') return false;
  return (around === 'vertex') === (direction === 'ccw');
}

function visitOf({ circulator: { view, around } }: Query, dialect: Dialect): string[] {
  const expression = dialect.view(view, around);
  if (view !== 'face' && view !== 'faceAcross') return [`yield ${expression};`];
  const found = around === 'face' ? 'other' : 'found';
  return [`const ${found} = ${expression};`, `if (${not(dialect.isEmpty(found))}) yield ${found};`];
}

function not(expression: string): string {
  if (expression.startsWith('!')) return expression.slice(1);
  return expression.replace('===', '!==');
}

type Running = (...parameters: unknown[]) => Iterator<unknown, void>;
type Note = (line: number, cursor?: unknown) => void;

/**
 * Runs the code of a query on a mesh. The very text that is shown is compiled, with a note put
 * before each statement: which line runs, and where the cursor stands when it yields.
 */
export function* run(
  { lines }: Program,
  mesh: HalfedgeMesh,
  query: Query,
  dialect: Dialect,
): Generator<Hop, void> {
  const { circulator, index, start } = query;
  const items = dialect.open(mesh);
  let ran: number[] = [];
  let cursor: unknown;
  const note: Note = (line, at) => {
    if (ran.at(-1) !== line) ran.push(line);
    if (at !== undefined) cursor = at;
  };
  const noted = lines.map((line, i) => withNote(line, i, dialect.cursor)).join('\n');
  const code = new Function('NONE', 'note', `'use strict'; return ${noted}`) as (
    none: number,
    note: Note,
  ) => Running;
  const around =
    start === undefined ? items.item(circulator.around, index) : items.item('halfedge', start);
  const parameters = dialect.mesh ? [items.mesh, around] : [around];
  const running = code(NONE, note)(...parameters);
  for (let step = running.next(); !step.done; step = running.next()) {
    const at = items.index(cursor, 'halfedge');
    yield {
      halfedge: arrives(query, dialect) ? mesh.opposite(at) : at,
      cursor: at,
      index: items.index(step.value, circulator.yields),
      ran,
    };
    ran = [];
  }
}

function withNote(line: string, i: number, cursor: string): string {
  if (/^\s*(function\*|do \{|\}$)/.test(line)) return line;
  const told = /\byield\b/.test(line) ? `note(${i}, ${cursor})` : `note(${i})`;
  const end = /^(\s*\} while \()(.*)$/.exec(line);
  return end ? `${end[1]}${told}, ${end[2]}` : `${told}; ${line}`;
}

/**
 * The same visits, without the code: for pages whose policy forbids to compile a text. No lines run.
 */
export function* visit(mesh: HalfedgeMesh, query: Query, dialect?: Dialect): Generator<Hop, void> {
  const { circulator, index, direction, start } = query;
  const options = start === undefined ? { direction } : { direction, start };
  const walk = mesh.circulate(circulator.name, index, options);
  const first = walk.halfedge;
  if (walk.current === NONE) return;
  do {
    const { halfedge } = walk;
    const cursor = arrives(query, dialect) ? mesh.opposite(halfedge) : halfedge;
    yield { halfedge, cursor, index: walk.current, ran: [] };
    walk.next();
  } while (walk.halfedge !== first);
}

let compiles: boolean | undefined;

/** Whether the policy of the page lets code be made of a text. */
export function canRun(): boolean {
  if (compiles === undefined) {
    try {
      new Function('');
      compiles = true;
    } catch {
      compiles = false;
    }
  }
  return compiles;
}
