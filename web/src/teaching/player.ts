import type { HalfedgeMesh } from '../api.js';
import { named } from '../inspect.js';
import type { Query } from './circulators.js';
import { type Dialect, dialectOf } from './dialects.js';
import type { Item } from './items.js';
import { canRun, type Hop, type Program, programOf, run, visit } from './program.js';
import { hopWords, startWords } from './words.js';

/** One visit: where the circulator stood, and the item it showed. */
export interface Visit {
  /** The halfedge where the walk was, the same in all dialects; -1 where none is known. */
  readonly halfedge: number;
  /** The halfedge where the code was, as its dialect has it. */
  readonly cursor: number;
  readonly item: Item;
  /** The lines of the program that ran since the visit before, by their places; the last yielded. */
  readonly ran: readonly number[];
}

/**
 * Runs the code of a query through one lap, and remembers what it visited: back is where it was. Position 0 is before
 * the first visit; `count` is the length of the lap.
 */
export class CirculatorPlayer {
  readonly query: Query;
  readonly count: number;
  readonly dialect: Dialect;
  /** The code that runs. */
  readonly program: Program;
  readonly #mesh: HalfedgeMesh;
  readonly #visits: Visit[] = [];
  /** What the code has visited; it does not run back. */
  readonly #known: Visit[] = [];
  readonly #running: Iterator<Hop, void>;

  constructor(mesh: HalfedgeMesh, query: Query, dialect = dialectOf('halfedge')) {
    this.#mesh = mesh;
    this.query = query;
    this.dialect = dialect;
    this.program = programOf(query, dialect);
    this.count = lengthOf(lapOf(mesh, query));
    this.#running = canRun()
      ? run(this.program, mesh, query, dialect)
      : visit(mesh, query, dialect);
  }

  /** How many items are visited; the last of them is the current one. */
  get position(): number {
    return this.#visits.length;
  }

  /** The items visited so far, in order. */
  get visits(): readonly Visit[] {
    return this.#visits;
  }

  get current(): Visit | null {
    return this.#visits.at(-1) ?? null;
  }

  get done(): boolean {
    return this.position === this.count;
  }

  /** The items of one lap, in order, whether they were visited or not; walks around as far as it is read. */
  *lap(): Iterable<Item> {
    const kind = this.query.circulator.yields;
    for (const index of lapOf(this.#mesh, this.query)) yield { kind, index };
  }

  /** Visits one more item. False at the end of the lap. */
  forward(): boolean {
    if (this.done) return false;
    const visit = this.#known[this.position] ?? this.#look();
    if (!visit) return false;
    this.#visits.push(visit);
    return true;
  }

  /** Takes the last visit back. False at the beginning. */
  back(): boolean {
    if (this.position === 0) return false;
    this.#visits.pop();
    return true;
  }

  /** Steps until `position` items are visited. */
  seek(position: number): void {
    const target = Math.max(0, Math.min(this.count, Math.round(position)));
    while (this.position < target && this.forward());
    while (this.position > target) this.back();
  }

  /** What the last step did, in words; empty before the first. */
  get words(): string {
    const last = this.current;
    if (!last) return '';
    const before = this.#visits.at(-2);
    return before
      ? hopWords(this.#mesh, this.query, before.halfedge, last.halfedge, this.dialect)
      : startWords(this.#mesh, this.query, last.halfedge, this.dialect);
  }

  #look(): Visit | null {
    const step = this.#running.next();
    if (step.done) return null;
    const { halfedge, cursor, index, ran } = step.value;
    const visit = { halfedge, cursor, item: { kind: this.query.circulator.yields, index }, ran };
    this.#known.push(visit);
    return visit;
  }
}

named({ CirculatorPlayer });

/** The indices that a query visits. */
function lapOf(
  mesh: HalfedgeMesh,
  { circulator, index, direction, start }: Query,
): Iterable<number> {
  return (mesh[circulator.name] as (i: number, d?: string, s?: number) => Iterable<number>).call(
    mesh,
    index,
    direction,
    start,
  );
}

function lengthOf(range: Iterable<number>): number {
  let length = 0;
  for (const _ of range) length += 1;
  return length;
}
