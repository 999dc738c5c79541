import { HalfedgeMesh, type MendReport } from 'halfedge';
import {
  checkOperation,
  type Deed,
  deedName,
  deedTitle,
  type Edit,
  type Item,
  isLive,
  itemName,
  motionOf,
  type Operands,
  type Operation,
  operandsOf,
  operationsFor,
  type Refusal,
  refusalOf,
  renumbering,
  reversed,
  runOperation,
  selectionAfter,
  stateBefore,
  witnessItems,
} from 'halfedge/teaching';
import type { PickMode } from 'halfedge/three/picking';
import type { MeshDocument } from './documents.js';
import type { Explorer } from './explorer.js';
import { Signal, together } from './signal.js';

/** An operation as it stands for the selection: possible, or refused. */
export interface Offer {
  readonly operation: Operation;
  readonly refusal: Refusal | null;
}

/** A refusal on show. */
export interface Refused {
  readonly title: string;
  readonly refusal: Refusal;
  readonly witness: readonly Item[];
}

/** An operation that waits for its second item. */
export interface Pending {
  readonly operation: Operation;
  readonly first: Item;
}

/** A step of history: what it is called, how it moved, and what was selected around it. */
interface Step {
  readonly title: string;
  /** What was done to what, by the names in the API: `insertEdge h3 h9`. */
  readonly deed: string;
  readonly edit: Edit;
  readonly before: Item | null;
  readonly after: Item | null;
}

/** What was done to one mesh. */
interface Log {
  /** What led here from the mesh before it, if there is one: `dual`, `open Suzanne`. */
  ledBy: string;
  readonly done: Step[];
  undone: Step[];
  /** What a file or link has: the mesh up to this step, or as it was opened, or nothing that is known here. */
  saved: Step | 'as opened' | 'nothing';
  /** Whether there were steps that are forgotten. */
  forgot: boolean;
}

/** A mesh that isn't on show but can be brought back, as it was left. */
interface Kept {
  readonly document: MeshDocument;
  readonly selected: Item | null;
  readonly log: Log;
}

/** The names of the next steps back and forth, and how many there are. */
export interface Past {
  readonly undo: string | null;
  readonly redo: string | null;
  readonly undoCount: number;
  readonly redoCount: number;
}

const NO_PAST: Past = { undo: null, redo: null, undoCount: 0, redoCount: 0 };

/** What the steps that can be undone may take: the oldest are forgotten first. */
const HISTORY_BYTES = 2 ** 28;

/** Operations on the selection, their refusals, and the way back. */
export class Editor {
  readonly offers = new Signal<readonly Offer[]>([]);
  readonly refused = new Signal<Refused | null>(null);
  readonly pending = new Signal<Pending | null>(null);
  readonly past = new Signal<Past>(NO_PAST);
  /** The change that the picture has to show next; a new object for each. */
  readonly edit = new Signal<Edit | null>(null);
  /** What the last key or button did, in words; read out by screen readers. */
  readonly outcome = new Signal('');
  /** What the last repair did and had to leave, or that there was nothing to do; empty after anything else. */
  readonly report = new Signal('');

  /** The name of the mesh with unsaved edits that another one was opened over; null after anything else. */
  readonly left = new Signal<string | null>(null);

  readonly #explorer: Explorer;
  readonly #keptHalfedges: number;
  #log = newLog();
  /** The meshes that led to this one, which undo brings back, the last at the end. */
  #earlier: Kept[] = [];
  /** Those that redo brings back, the next at the end. */
  #later: Kept[] = [];
  #keepsRefusal = false;
  #pickModeBefore: PickMode = 'auto';

  /** Of the meshes that led to the one on show, the oldest are forgotten if all have more than `keptHalfedges`. */
  constructor(explorer: Explorer, keptHalfedges: number) {
    this.#explorer = explorer;
    this.#keptHalfedges = keptHalfedges;
    explorer.selected.subscribe(() => this.#select());
  }

  /** Gives a mesh history, before it is shown; throws if there is no memory for that. */
  prepare(mesh: HalfedgeMesh): void {
    mesh.history.limit({ bytes: HISTORY_BYTES });
    mesh.history.enabled = true;
  }

  /** Goes on with a mesh that was prepared and is shown next: undo leads back to the one on show, which is kept. */
  goOn(ledBy: string): void {
    disposeAll(this.#later);
    this.#log.undone = [];
    this.#keepAmong(this.#earlier);
    this.#forgetOldest();
    this.#turnPage(newLog(ledBy));
  }

  /** Goes on with such a mesh instead of the one on show, which isn't kept: undo leads to the one before it. */
  replace(ledBy: string): void {
    disposeAll(this.#later);
    this.#turnPage(newLog(ledBy));
  }

  #turnPage(log: Log): void {
    this.#log = log;
    this.edit.value = null;
    this.#wait(null);
    this.refused.value = null;
    this.outcome.value = '';
    this.report.value = '';
    this.left.value = null;
    this.#publish();
  }

  #keepAmong(others: Kept[]): void {
    const { document, selected } = this.#explorer;
    if (!document.value) return;
    others.push({ document: document.value, selected: selected.value, log: this.#log });
  }

  /** The last of the meshes that were kept stays in any case. */
  #forgetOldest(): void {
    const kept = this.#earlier;
    const halfedges = () =>
      kept.reduce((sum, { document }) => sum + document.mesh.halfedgeSlots, 0);
    while (kept.length > 1 && halfedges() > this.#keptHalfedges) disposeAll(kept, 1);
  }

  #bringBack({ document, selected, log }: Kept): void {
    this.#turnPage(log);
    this.#explorer.bringBack(document, selected);
  }

  /** Does an operation on the selection; one with two operands first waits for the second. */
  run(operation: Operation): void {
    const selected = this.#explorer.selected.value;
    if (operation.on !== 'mesh' && selected?.kind !== operation.on) return;
    if (operation.second && selected) {
      if (this.#refuseFirst(operation, selected)) return;
      this.refused.value = null;
      this.#wait({ operation, first: selected });
      this.outcome.value = `${operation.label}: pick ${operation.second.ask}.`;
      return;
    }
    this.#apply(operation, selected, null);
  }

  /** Whether no second item would do, which is told before one is asked for. */
  #refuseFirst(operation: Operation, first: Item): boolean {
    const mesh = this.#mesh;
    const deed: Deed = { operation, first, second: null };
    const refusal = mesh ? checkOperation(operation, operandsOf(mesh, deed)) : null;
    if (refusal) this.#refuse(deedTitle(deed), refusal);
    return refusal !== null;
  }

  /** The operation on the selection with that key. False if there is none. */
  runKey(key: string): boolean {
    const offer = this.offers.value.find(({ operation }) => operation.key === key);
    if (offer) this.run(offer.operation);
    return offer !== undefined;
  }

  /** Gives the operation that waits its second item. */
  complete(second: Item): void {
    const pending = this.pending.value;
    if (!pending) return;
    const { operation, first } = pending;
    if (second.kind !== operation.second?.kind) {
      this.outcome.value = `${itemName(second)} is no ${operation.second?.kind}: pick ${operation.second?.ask}.`;
      return;
    }
    this.#wait(null);
    this.#apply(operation, first, second);
  }

  cancel(): void {
    this.#wait(null);
    this.refused.value = null;
    this.outcome.value = '';
  }

  /** Selects an item of the witness; the refusal stays on show. */
  selectWitness(witness: Item): void {
    this.#keepsRefusal = true;
    this.#explorer.select(witness);
    this.#keepsRefusal = false;
  }

  undo(): void {
    const kept = this.#log.done.length === 0 ? this.#earlier.pop() : undefined;
    if (!kept) {
      this.#travel('undo', this.#log.done, this.#log.undone);
      return;
    }
    const { ledBy } = this.#log;
    this.#keepAmong(this.#later);
    this.#bringBack(kept);
    this.outcome.value = `Undone: ${ledBy}.`;
  }

  redo(): void {
    const kept = this.#log.undone.length === 0 ? this.#later.pop() : undefined;
    if (!kept) {
      this.#travel('redo', this.#log.undone, this.#log.done);
      return;
    }
    this.#keepAmong(this.#earlier);
    this.#bringBack(kept);
    this.outcome.value = `Redone: ${kept.log.ledBy}.`;
  }

  #travel(way: 'undo' | 'redo', from: Step[], to: Step[]): void {
    const mesh = this.#mesh;
    const step = from.pop();
    if (!mesh || !step) {
      this.outcome.value = `There is nothing to ${way}.`;
    } else if (mesh.history[way]()) {
      to.push(step);
      const back = way === 'undo';
      const edit = back ? reversed(step.edit) : { ...step.edit };
      const verb = back ? 'Undone' : 'Redone';
      this.#finish(`${verb}: ${step.title}.`, edit, back ? step.before : step.after);
    } else {
      this.#forget();
    }
  }

  /** All that was done since the mesh was opened; null if not all of it is known any more. */
  get deeds(): readonly string[] | null {
    return this.#log.forgot ? null : this.#log.done.map(({ deed }) => deed);
  }

  /** Whether the mesh on show has edits that no file has. */
  get isUnsaved(): boolean {
    return hasUnsaved(this.#log);
  }

  /** Whether it has, or one that undo leads back to. */
  get anyUnsaved(): boolean {
    return this.isUnsaved || this.#earlier.some(({ log }) => hasUnsaved(log));
  }

  /** The mesh that the next undo brings back; null where that takes an edit back, or nothing. */
  get previous(): MeshDocument | null {
    return this.#log.done.length === 0 ? (this.#earlier.at(-1)?.document ?? null) : null;
  }

  /** The mesh as it is was saved to a file, or comes from a link. */
  markSaved(): void {
    this.#log.saved = lastStep(this.#log);
  }

  get #mesh(): HalfedgeMesh | undefined {
    return this.#explorer.document.value?.mesh;
  }

  #apply(operation: Operation, first: Item | null, second: Item | null): void {
    const mesh = this.#mesh;
    if (!mesh) return;
    const deed: Deed = { operation, first, second };
    const operands = operandsOf(mesh, deed);
    const refusal = checkOperation(operation, operands);
    if (refusal) this.#refuse(deedTitle(deed), refusal);
    else this.#commit(deed, operands);
  }

  #commit(deed: Deed, operands: Operands): void {
    const { mesh } = operands;
    const { operation, first } = deed;
    const title = deedTitle(deed);
    const state = stateBefore(operation, operands);
    const { version } = mesh;
    let result: unknown;
    try {
      result = runOperation(operation, operands);
    } catch (error) {
      // Where memory runs out in the middle of a repair, a part of it is done.
      if (mesh.version !== version) {
        const part = `a part of ${title}`;
        const after = [first, ...state.neighbours].find((it) => it && isLive(mesh, it)) ?? null;
        const edit = motionOf(operation, state, mesh);
        this.#record({ title: part, deed: operation.stem, edit, before: first, after });
        forgetFirst(this.#log); // nobody could do just that part again
        this.#finish(`Done: ${part}.`, { ...edit }, after);
      }
      this.#refuse(title, refusalOf(error));
      return;
    }
    if (operation.opens && result instanceof HalfedgeMesh) {
      this.#open(operation, result);
      return;
    }
    const report = operation.reports ? reportWords(result as MendReport) : '';
    const told = (verb: string) => [`${verb}: ${title}.`, report].join(' ').trimEnd();
    if (mesh.version === version) {
      this.refused.value = null;
      this.outcome.value = told('Nothing to do');
      this.report.value = report || this.outcome.value;
      return;
    }
    const edit = operation.renumbers ? renumbering : motionOf(operation, state, mesh);
    const after = selectionAfter(operation, result, mesh, [first, ...state.neighbours]);
    this.#record({ title, deed: deedName(deed), edit, before: first, after });
    this.#finish(told('Done'), { ...edit }, after, report);
  }

  /** Shows the mesh that was made; undo leads back to the one that it was made of. */
  #open(operation: Operation, made: HalfedgeMesh): void {
    const { value: before } = this.#explorer.document;
    const ledBy = operation.label.toLowerCase();
    if (!this.#explorer.openNext(`${operation.label} of ${before?.name}`, made, ledBy)) return;
    this.#log.saved = 'nothing';
    this.outcome.value = `Done: ${ledBy}.`;
    if (made.faceCount === 0)
      this.report.value = `The ${ledBy} has no faces: no vertex is interior.`;
  }

  /** A step that was done; those that the package has forgotten are forgotten here, too. */
  #record(step: Step): void {
    this.#log.done.push(step);
    this.#log.undone = [];
    disposeAll(this.#later);
    const count = this.#mesh?.history.undoCount ?? 0;
    while (this.#log.done.length > count) {
      this.#log.done.shift();
      forgetFirst(this.#log);
    }
  }

  #finish(outcome: string, edit: Edit, selection: Item | null, report = ''): void {
    const mesh = this.#mesh;
    together(() => {
      this.edit.value = edit;
      this.refused.value = null;
      this.left.value = null;
      this.#wait(null);
      this.outcome.value = outcome;
      this.report.value = report;
      this.#publish();
      this.#explorer.refresh(selection && mesh && isLive(mesh, selection) ? selection : null);
    });
  }

  /** Waits for a second item, or no longer; as long as it does, only items of that kind are picked. */
  #wait(pending: Pending | null): void {
    const { pickMode } = this.#explorer;
    if (pending && !this.pending.value) {
      this.#pickModeBefore = pickMode.value;
      pickMode.value = pending.operation.second?.kind ?? pickMode.value;
    } else if (!pending && this.pending.value) {
      pickMode.value = this.#pickModeBefore;
    }
    this.pending.value = pending;
  }

  #refuse(title: string, refusal: Refusal): void {
    const mesh = this.#mesh;
    const items = witnessItems(refusal.witness);
    const witness = mesh ? items.filter((found) => isLive(mesh, found)) : [];
    this.#wait(null); // its card would lie upon this one
    this.outcome.value = '';
    this.report.value = '';
    this.refused.value = { title, refusal, witness };
  }

  /** Offers the operations on what is selected now. */
  #select(): void {
    if (!this.#keepsRefusal) this.refused.value = null;
    const mesh = this.#mesh;
    const selected = this.#explorer.selected.value;
    if (!mesh) return;
    this.offers.value = operationsFor(selected).map((operation) => ({
      operation,
      // An operation on the whole mesh may have to look at all of it: not before it is asked for.
      refusal:
        selected && operation.on !== 'mesh'
          ? checkOperation(operation, { mesh, item: selected, second: null })
          : null,
    }));
  }

  #publish(): void {
    const earlier = this.#earlier.length > 0 ? this.#log.ledBy : null;
    this.past.value = {
      undo: this.#log.done.at(-1)?.title ?? earlier,
      redo: this.#log.undone.at(-1)?.title ?? this.#later.at(-1)?.log.ledBy ?? null,
      undoCount: this.#log.done.length + stepsOf(this.#earlier, 'done'),
      redoCount: this.#log.undone.length + stepsOf(this.#later, 'undone'),
    };
  }

  /** The package has no such step any more: its memory is limited. */
  #forget(): void {
    const saved = hasUnsaved(this.#log) ? 'nothing' : 'as opened';
    this.#log = { ...newLog(this.#log.ledBy), saved, forgot: true };
    this.outcome.value = 'That step is too far back: it was forgotten.';
    this.#publish();
  }
}

function newLog(ledBy = ''): Log {
  return { ledBy, done: [], undone: [], saved: 'as opened', forgot: false };
}

/** What the mesh was before the steps that are known is no file's any more. */
function forgetFirst(log: Log): void {
  log.forgot = true;
  if (log.saved === 'as opened') log.saved = 'nothing';
}

/** What led to the mesh as it is. */
function lastStep({ done }: Log): Step | 'as opened' {
  return done.at(-1) ?? 'as opened';
}

/** Whether no file has the mesh as it is. */
function hasUnsaved(log: Log): boolean {
  return lastStep(log) !== log.saved;
}

/** Gives the memory of the first of these meshes back, or of all: nothing leads to them any more. */
function disposeAll(others: Kept[], count = others.length): void {
  for (const { document } of others.splice(0, count)) document.mesh.dispose();
}

/** How many steps these meshes have, with those that lead from one to the next. */
function stepsOf(others: readonly Kept[], which: 'done' | 'undone'): number {
  return others.reduce((sum, { log }) => sum + log[which].length + 1, 0);
}

/** What a repair did, and the first of what it could not do. */
function reportWords({ summary, problems }: MendReport): string {
  const [first, ...others] = problems;
  if (!first) return summary;
  const more = others.length > 0 ? ` (and ${others.length} more)` : '';
  return `${summary} ${first.message}${more}`;
}
