import type { AttributeNames, HalfedgeMesh, ParseStage, Problem } from 'halfedge';
import type { UpAxis } from 'halfedge/scene';
import {
  type Item,
  isLive,
  itemName,
  itemSlots,
  linksOf,
  sameItem,
  type WalkKey,
} from 'halfedge/teaching';
import type { PickMode } from 'halfedge/three/picking';
import { samples } from '../samples/index.js';
import { type LabelChoice, NO_LABELS } from './captions.js';
import {
  failureOf,
  fileOfText,
  type MeshDocument,
  newDocument,
  type OpenFailure,
  openSource,
  type Source,
  stemOfMade,
} from './documents.js';
import { Editor } from './editor.js';
import { factsOfMesh, type MeshFacts, type Problems } from './facts.js';
import { Signal } from './signal.js';
import type { Tab } from './tabs.js';
import { Walker } from './walker.js';

/** What the meshes that undo leads back to may have: about 256 MiB. */
const KEPT_HALFEDGES = 12_000_000;

/** Checking a mesh with more faces than this stops the picture for a noticeable moment. */
export const LARGE = 200_000;

/** Where the vertices lie takes longer to check than all else: it is done when edits pause, in milliseconds. */
const PAUSE = 300;

/** How much of a stage of opening is done, from 0 to 1. */
export interface Progress {
  readonly fraction: number;
  readonly stage: ParseStage;
}

/** The state of the page, and everything that can be done to it. Knows nothing of the DOM. */
export class Explorer {
  readonly document = new Signal<MeshDocument | null>(null);
  readonly facts = new Signal<MeshFacts | null>(null);
  /** All that validation found, where the vertices lie included, unless the mesh is large; null until then. */
  readonly problems = new Signal<Problems | null>(null);
  readonly selected = new Signal<Item | null>(null);
  readonly hovered = new Signal<Item | null>(null);
  readonly tab = new Signal<Tab>('circulate');
  readonly pickMode = new Signal<PickMode>('auto');
  /** What is being opened, while it is. */
  readonly busy = new Signal<string | null>(null);
  /** How far it is, where that is known. */
  readonly progress = new Signal<Progress | null>(null);
  readonly failure = new Signal<OpenFailure | null>(null);
  /** The names of meshes that were chosen together with the one on show, which alone was opened. */
  readonly passedOver = new Signal<readonly string[]>([]);
  /** Whether the picture shows the polygons of the file as they stand there. */
  readonly showsFile = new Signal(false);
  /** The problem of the file that is lit. */
  readonly problem = new Signal<Problem | null>(null);
  /** Which items have their names beside them. */
  readonly labels = new Signal<LabelChoice>(NO_LABELS);
  /** Whether the links (1)–(7) of the selected item are drawn as arrows. */
  readonly pointers = new Signal(false);
  /** Which axis of the mesh points up in the picture. */
  readonly up = new Signal<UpAxis>('y');
  /** A remark on the last key or entry that led nowhere; read out by screen readers. */
  readonly remark = new Signal('');
  readonly walker = new Walker();
  readonly editor: Editor;

  /** What was chosen for a mesh, or for the one that it was made of. */
  readonly #ups = new WeakMap<HalfedgeMesh, UpAxis>();
  /** What was chosen for a file last: files don't tell, and those of one program have the same. */
  #upOfFiles: UpAxis = 'y';
  #measuring: ReturnType<typeof setTimeout> | undefined;
  #abort = new AbortController();

  constructor(keptHalfedges = KEPT_HALFEDGES) {
    this.editor = new Editor(this, keptHalfedges);
  }

  /** Opens a sample or a file. A failure leaves the mesh on show as it is. Whether it is on show then. */
  async open(source: Source, companions: readonly File[] = []): Promise<boolean> {
    this.#abort.abort();
    const abort = new AbortController();
    this.#abort = abort;
    this.walker.pause();
    this.failure.value = null;
    this.progress.value = null;
    this.busy.value = source.name;
    // Where nothing is on show, there is nothing that could stand still.
    if (this.document.value) await painted();
    const { signal } = abort;
    const onProgress = (fraction: number, stage: ParseStage) => {
      if (!signal.aborted) this.progress.value = { fraction, stage };
    };
    try {
      const opened = await openSource(source, { companions, signal, onProgress });
      if (signal.aborted) opened.mesh.dispose();
      else this.#show(opened);
      return !signal.aborted;
    } catch (error) {
      if (!signal.aborted) this.failure.value = failureOf(error, source);
      return false;
    } finally {
      if (abort === this.#abort) this.#rest();
    }
  }

  /** Gives up what is being opened; the mesh on show stays. */
  cancel(): void {
    this.#abort.abort();
    this.#rest();
  }

  /** Opens what was pasted, if it is the text of a mesh. */
  openText(text: string): void {
    const file = fileOfText(text);
    if (file) {
      void this.open(file);
      return;
    }
    this.failure.value = {
      title: 'What was pasted is no mesh',
      message: `It begins with “${beginningOf(text)}”; expected the text of an OBJ, OFF, PLY, STL or glTF file.`,
      lesson: null,
    };
  }

  /** Shows a mesh that doesn't come from a file, with words for its numbers. Whether there is memory for it. */
  openMesh(name: string, mesh: HalfedgeMesh, names: AttributeNames = {}): boolean {
    return this.#showMade(name, mesh, names, null);
  }

  /**
   * Shows a mesh that was made from the one on show, by what is named, which undo takes back. Whether there
   * is memory for it.
   */
  openNext(name: string, mesh: HalfedgeMesh, madeBy: string): boolean {
    return this.#showMade(name, mesh, this.document.value?.names ?? {}, madeBy);
  }

  /** Shows a mesh that has stayed. */
  bringBack(kept: MeshDocument, selected: Item | null): void {
    this.cancel();
    this.walker.pause();
    this.#put(kept);
    this.select(selected);
  }

  #showMade(
    name: string,
    mesh: HalfedgeMesh,
    names: AttributeNames,
    madeBy: string | null,
  ): boolean {
    this.cancel();
    this.walker.pause();
    try {
      this.#show({ ...newDocument(name, mesh), stem: stemOfMade(name), names }, madeBy);
      return true;
    } catch (error) {
      this.failure.value = failureOf(error, { name });
      return false;
    }
  }

  #rest(): void {
    this.progress.value = null;
    this.busy.value = null;
    this.passedOver.value = [];
  }

  /** Opens the first sample where nothing is on show. The message of a file that couldn't be opened stays. */
  async openSomething(): Promise<void> {
    if (this.document.value) return;
    const { value: failure } = this.failure;
    const isOpen = await this.open(samples[0]);
    if (isOpen || failure) this.failure.value = failure;
  }

  /** Selects an item, or nothing. An index that the mesh does not have is remarked on instead. */
  select(item: Item | null): void {
    const mesh = this.document.value?.mesh;
    if (item && mesh && !isLive(mesh, item)) {
      this.remark.value = absence(mesh, item);
      return;
    }
    this.remark.value = '';
    // Items are those of the mesh: they can't be shown in the file.
    if (item) this.#leaveProblems();
    if (sameItem(item, this.selected.value)) return;
    this.walker.pause();
    this.selected.value = item;
    this.#offerQueries();
  }

  /** Selects what was pointed at, or hands it to the operation that waits for a second item. */
  pick(item: Item | null): void {
    if (item && this.editor.pending.value) this.editor.complete(item);
    else this.select(item);
  }

  /** Shows the polygons of the file, or the mesh that was made of them. */
  showFile(shows: boolean): void {
    if (shows && !this.document.value?.diagnosis) return;
    this.walker.pause();
    if (shows) {
      this.select(null);
      this.editor.cancel(); // a second item can't be picked there
    }
    this.remark.value = '';
    this.showsFile.value = shows;
  }

  /** Lights a problem of the file, in either picture. */
  showProblem(problem: Problem): void {
    this.select(null);
    this.problem.value = problem;
  }

  #leaveProblems(): void {
    this.problem.value = null;
    this.showsFile.value = false;
  }

  /** After a change of the mesh: selects `item` afresh, and looks again at all that it changed. */
  refresh(item: Item | null): void {
    this.remark.value = '';
    this.#leaveProblems();
    this.hovered.value = null;
    this.selected.value = item && { ...item };
    this.#offerQueries();
    this.#measure();
  }

  /** Lets another axis point up, for this mesh and for the files to come. */
  setUp(axis: UpAxis): void {
    this.setUpOfMesh(axis);
    if (this.document.value?.sample === null) this.#upOfFiles = axis;
  }

  /** Lets another axis point up for this mesh alone: whoever made a link knows nothing of the files to come. */
  setUpOfMesh(axis: UpAxis): void {
    this.up.value = axis;
    const { value: opened } = this.document;
    if (opened) this.#ups.set(opened.mesh, axis);
  }

  /** Walks along the link with that key, as the inspector shows it. */
  walk(key: WalkKey): void {
    const { value: selected } = this.selected;
    const mesh = this.document.value?.mesh;
    if (!mesh) return;
    if (!selected) {
      const how = this.showsFile.value
        ? 'switch to Repaired (R) to pick one'
        : 'pick an item first';
      this.remark.value = `Nothing is selected: ${how}.`;
      return;
    }
    const link = linksOf(mesh, selected).find((candidate) => candidate.key === key);
    if (!link && key === 'h') {
      this.remark.value = `${itemName(selected)} is a halfedge already.`;
    } else if (!link) {
      this.remark.value = `${itemName(selected)} has no such link: press H for its halfedge first.`;
    } else if (!link.target) {
      this.remark.value = `${link.name} of ${itemName(selected)} is empty (∅).`;
    } else {
      this.select(link.target);
    }
  }

  /** Throws, with all as it was, if there is no memory for the history of the mesh. */
  #show(opened: MeshDocument, madeBy: string | null = null): void {
    const before = this.document.value;
    try {
      this.editor.prepare(opened.mesh);
    } catch (error) {
      opened.mesh.dispose();
      throw error;
    }
    const { editor } = this;
    const isEdited = madeBy === null && editor.isUnsaved;
    if (madeBy !== null) editor.goOn(madeBy);
    else if (isEdited) editor.goOn(`open ${opened.name}`);
    else editor.replace(`open ${opened.name}`);
    if (madeBy !== null) this.#ups.set(opened.mesh, this.up.value);
    this.#put(opened);
    if (isEdited) editor.left.value = before?.name ?? null;
    else if (madeBy === null) before?.mesh.dispose();
    if (!this.selected.value && opened.mesh.vertexCount > 0) {
      this.select({ kind: 'vertex', index: opened.start ?? 0 });
    }
  }

  /** Lets go of all that is of the mesh on show, and shows another one. */
  #put(opened: MeshDocument): void {
    this.selected.value = null;
    this.hovered.value = null;
    this.facts.value = null;
    this.problems.value = null;
    this.failure.value = null; // it tells which mesh is on show
    this.#leaveProblems();
    this.#offerQueries();
    const usual = opened.sample === null ? this.#upOfFiles : 'y';
    this.up.value = this.#ups.get(opened.mesh) ?? usual;
    this.document.value = opened;
    this.#measure();
  }

  /** Lets the page show the mesh before the whole of it is checked; a large one when edits pause. */
  #measure(): void {
    clearTimeout(this.#measuring);
    const faces = this.document.value?.mesh.faceCount ?? 0;
    const measure = () => {
      const mesh = this.document.value?.mesh;
      if (!mesh) return;
      const facts = factsOfMesh(mesh, this.facts.value);
      this.facts.value = facts;
      if (faces > LARGE) this.problems.value = facts.problems;
      else this.#measuring = setTimeout(() => this.#lookWhereVerticesLie(), PAUSE);
    };
    this.#measuring = setTimeout(measure, faces > LARGE ? 500 : 60);
  }

  #lookWhereVerticesLie(): void {
    const mesh = this.document.value?.mesh;
    if (mesh) this.problems.value = mesh.validate('geometry');
  }

  #offerQueries(): void {
    const selected = this.selected.value;
    const mesh = this.document.value?.mesh;
    if (selected && mesh) this.walker.offer(mesh, selected);
    else this.walker.clear();
  }
}

/** Why there is no such item. */
function absence(mesh: HalfedgeMesh, item: Item): string {
  const slots = itemSlots(mesh, item.kind);
  if (slots === 0) return `This mesh has no ${item.kind}.`;
  if (item.index < slots) return `${itemName(item)} was deleted.`;
  return `There is no ${itemName(item)}: this mesh has ${item.kind} 0 to ${slots - 1}.`;
}

/** The first words of a text, on one line. */
function beginningOf(text: string): string {
  const [line] = text.trim().split(/\r?\n/);
  return line.length > 40 ? `${line.slice(0, 40)}…` : line;
}

/** After the browser has shown what was changed so far; a hidden page shows nothing, so not long. */
function painted(): Promise<void> {
  return new Promise((resolve) => {
    requestAnimationFrame(() => setTimeout(resolve, 0));
    setTimeout(resolve, 250);
  });
}
