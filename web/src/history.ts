import { checkFlag, refuse } from './checks.js';
import { HalfedgeError } from './errors.js';
import { printed } from './inspect.js';
import type { Links } from './links.js';
import { outOfMemory } from './memory.js';
import { checkOptions, type Given, type OptionNames } from './options.js';

/** How far back history reaches. */
export interface HistoryLimits {
  /** The largest number of steps. Default: Infinity. */
  steps?: number | undefined;
  /** The largest number of bytes: 4 to 12 for each word that an edit replaced, mostly 8. Default: Infinity. */
  bytes?: number | undefined;
}

const HISTORY_LIMITS: OptionNames<HistoryLimits> = { steps: true, bytes: true };

/**
 * Undo and redo, exact to the last word of all arrays and attributes. Off by default, and then almost free.
 *
 * Each operation is a step, as are `setPosition` and `attributes.set`; `group` combines several into one.
 * Writing into live views isn't recorded: undoing steps across it restores only single words.
 *
 * ```ts
 * mesh.history.enabled = true;
 * mesh.flipEdge(e);
 * mesh.history.undo();
 * ```
 */
export class History {
  readonly #links: Links;
  #enabled = false;
  #limits: Required<Given<HistoryLimits>> = { steps: Infinity, bytes: Infinity };

  /** @internal */
  constructor(links: Links) {
    this.#links = links;
  }

  /** Whether edits are recorded. Switching it off forgets all steps. */
  get enabled(): boolean {
    this.#links.checkAlive();
    return this.#enabled;
  }

  set enabled(enabled: boolean) {
    checkFlag('enabled', enabled);
    const { core, address } = this.#links;
    if (enabled === this.#enabled) return;
    checkNoGroup(this.#links, 'enabled', 'changed');
    if (!enabled) core._disable_history(address);
    else if (core._enable_history(address, this.#limits.steps, this.#limits.bytes) === 0) {
      throw outOfMemory('history');
    }
    this.#enabled = enabled;
  }

  /** Undoes the last step. Returns false if there is none. */
  undo(): boolean {
    return this.#travel('undo');
  }

  /** Redoes the step that was undone last. Returns false if there is none; any new step forgets those. */
  redo(): boolean {
    return this.#travel('redo');
  }

  /** Whether there is a step that {@link undo} would undo. */
  get canUndo(): boolean {
    return this.undoCount > 0;
  }
  /** Whether there is a step that {@link redo} would redo. */
  get canRedo(): boolean {
    return this.redoCount > 0;
  }
  /** Steps that can be undone. */
  get undoCount(): number {
    return this.#size(0);
  }
  /** Steps that can be redone. */
  get redoCount(): number {
    return this.#size(1);
  }
  /** The memory that all steps take. */
  get bytes(): number {
    return this.#size(2);
  }

  /**
   * Calls `edit`, and makes everything that it changes one step. Nested groups become part of it. If it
   * throws, its changes are undone and the error is passed on; with history off, they stay. A nested group
   * undoes nothing by itself: if its error is caught inside the outer group, its changes stay; if not, the
   * outermost group undoes everything. The first change forgets steps that could be redone, even if it is
   * undone itself. Steps that can be undone stay, whatever the limits are.
   *
   * If memory runs out for what would undo the changes, all steps are forgotten: then the changes stay, also
   * if `edit` throws, and `undoCount` is 0.
   *
   * History does not cover `attributes.add` and `remove`, `generations.enabled`, or the mesh's `clear()`,
   * which is refused in a group.
   *
   * @returns what `edit` returned
   * @throws TypeError if `edit` returned a promise: what comes after an `await` is not part of the group
   */
  group<T>(edit: () => T extends PromiseLike<unknown> ? never : T): T {
    if (typeof edit !== 'function') refuse('edit', edit, 'a function');
    const links = this.#links;
    links.checkAlive();
    links.beginGroup();
    let succeeded = false;
    try {
      const result = edit() as T;
      checkDone(result);
      succeeded = true;
      return result;
    } finally {
      links.endGroup();
      if (links.groups === 0 && this.#enabled && !links.disposed) this.#endGroup(succeeded);
    }
  }

  /**
   * Sets how far back history reaches. The oldest steps are forgotten first; the last one is always kept.
   * Steps that could be redone are forgotten.
   */
  limit(limits: HistoryLimits): void {
    const { steps = Infinity, bytes = Infinity } = checkOptions(limits, HISTORY_LIMITS, 'limits');
    checkLimit('steps', steps);
    checkLimit('bytes', bytes);
    const { core, address } = this.#links;
    checkNoGroup(this.#links, 'limit()', 'called');
    this.#limits = { steps, bytes };
    if (this.#enabled) core._limit_history(address, steps, bytes);
  }

  /** Forgets all steps. */
  clear(): void {
    const { core, address } = this.#links;
    checkNoGroup(this.#links, 'clear()', 'called');
    core._forget_history(address);
  }

  #travel(way: 'undo' | 'redo'): boolean {
    const links = this.#links;
    const { core, address } = links;
    checkNoGroup(links, `${way}()`, 'called');
    const moved = way === 'undo' ? core._undo(address) : core._redo(address);
    links.updateAfterTravel();
    return moved !== 0;
  }

  #size(which: number): number {
    const { core, address } = this.#links;
    return core._history_size(address, which);
  }

  #endGroup(succeeded: boolean): void {
    const { core, address } = this.#links;
    if (succeeded) {
      core._end_step(address);
      return;
    }
    core._abandon_step(address);
    this.#links.updateAfterTravel();
  }
}

printed('History', History, ({ enabled, undoCount, redoCount, bytes }) => ({
  enabled,
  undoCount,
  redoCount,
  bytes,
}));

/** Throws inside of a group: what was `done` ends all steps, or is none. */
export function checkNoGroup(links: Links, what: string, done: string): void {
  if (links.groups === 0) return;
  throw new HalfedgeError(
    'open-group',
    `${what} was ${done} inside of group(); expected it to be ${done} between steps.`,
  );
}

/** Throws if a function that was to be a group goes on later. */
function checkDone(result: unknown): void {
  if (typeof (result as PromiseLike<unknown> | null | undefined)?.then !== 'function') return;
  // Whoever gets the error below has no promise whose rejection could be handled.
  if (result instanceof Promise) result.catch(() => undefined);
  throw new TypeError(
    'edit returned a Promise; expected a function that is done when it returns, because edits after an `await` are no part of the group.',
  );
}

function checkLimit(name: string, limit: number): void {
  if (Number.isInteger(limit) && limit >= 0) return;
  if (limit !== Infinity) refuse(name, limit, 'a whole number from 0, or Infinity', 'number');
}
