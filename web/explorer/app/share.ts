import { type AttributeNames, type Direction, HalfedgeMesh, type Problem } from 'halfedge';
import type { UpAxis } from 'halfedge/scene';
import {
  type Deed,
  type DialectId,
  dialects,
  type Item,
  itemName,
  parseDeed,
  parseItemName,
} from 'halfedge/teaching';
import type { PickMode } from 'halfedge/three/picking';
import { brokenSamples } from '../samples/broken.js';
import { samples } from '../samples/index.js';
import { labelsText, NO_LABELS, parseLabels } from './captions.js';
import type { MeshDocument } from './documents.js';
import type { Explorer } from './explorer.js';
import { packed, unpacked } from './packing.js';
import { firstTab, hasProblems, TABS, type Tab } from './tabs.js';
import { DEFAULT_SPEED, SPEEDS } from './walker.js';

/** Where the camera stands and what it looks at, in the coordinates of the mesh. */
export type Viewpoint = readonly number[];

/** What moves the camera, and tells where it is. */
export interface Sight {
  viewpoint(): Viewpoint | null;
  lookFrom(viewpoint: Viewpoint): void;
  /** Turns the whole mesh so that an item is seen. */
  turnTo(item: Item): void;
}

const PICK_MODES: readonly PickMode[] = ['auto', 'vertex', 'edge', 'halfedge', 'face'];

/** Before the name of an attribute whose numbers stand for words: `words.group=wheel`, once for each. */
const WORDS = 'words.';
/** Longer links break in mails and messengers. */
const MOST_LETTERS = 32_000;
/** Bytes of a mesh that pack to no less than that, however regular it is: more would only take time. */
const MOST_BYTES = 40 * MOST_LETTERS;
/** What is longer is not even tried to be read: it could unfold without end. */
const MOST_LETTERS_READ = 200_000;

/**
 * The state of the page as the part of an address after `#`: sample or mesh, edits, selection,
 * circulator, speed, names, tab, upright axis and camera, each a word that can be read and changed by hand.
 *
 * @throws Error with a sentence where the mesh is too large for a link
 */
export function linkOf(explorer: Explorer, sight: Sight): string {
  const opened = explorer.document.value;
  if (!opened) throw new Error('There is no mesh yet.');
  const link = new URLSearchParams();
  addMesh(link, opened, explorer);
  const { value: selected } = explorer.selected;
  link.set('select', selected ? itemName(selected) : 'nothing');
  addQuery(link, explorer);
  addCaptions(link, explorer);
  if (explorer.showsFile.value) link.set('picture', 'original');
  addProblem(link, explorer);
  addPanel(link, opened, explorer);
  if (explorer.up.value !== 'y') link.set('up', explorer.up.value);
  const viewpoint = sight.viewpoint();
  if (viewpoint) link.set('camera', cameraText(viewpoint));
  // These read better as they are, and are allowed there.
  const text = link.toString().replaceAll('%2C', ',').replaceAll('%3A', ':').replaceAll('+', '%20');
  if (text.length > MOST_LETTERS) {
    throw tooLarge(opened.name, `${kilobytes(text.length)} long`);
  }
  return text;
}

/** A sample by its name, with its edits, as long as all of them are known; otherwise the mesh itself. */
function addMesh(link: URLSearchParams, opened: MeshDocument, explorer: Explorer): void {
  const deeds = opened.sample === null ? null : explorer.editor.deeds;
  if (opened.sample !== null && deeds) {
    link.set('sample', opened.sample);
    if (deeds.length > 0) link.set('edits', deeds.join(','));
    return;
  }
  link.set('name', opened.name);
  const bytes = opened.mesh.toBytes();
  if (bytes.length > MOST_BYTES) throw tooLarge(opened.name, 'far longer');
  for (const [attribute, words] of Object.entries(opened.names)) {
    for (const word of words) link.append(WORDS + attribute, word);
  }
  link.set('mesh', packed(bytes));
}

function addQuery(link: URLSearchParams, explorer: Explorer): void {
  const { value: choice } = explorer.walker.choice;
  const { value: play } = explorer.walker.play;
  if (choice && play) {
    link.set('query', choice.circulator.name);
    if (choice.group > 0) link.set('around', String(choice.group));
    if (explorer.walker.direction.value !== 'ccw')
      link.set('direction', explorer.walker.direction.value);
    if (play.position > 0) link.set('at', String(play.position));
  }
  const { value: speed } = explorer.walker.speed;
  if (speed !== DEFAULT_SPEED) link.set('speed', String(SPEEDS[speed]));
  if (explorer.walker.dialect.value !== 'halfedge')
    link.set('names', explorer.walker.dialect.value);
}

function addCaptions(link: URLSearchParams, explorer: Explorer): void {
  const { value: labels } = explorer.labels;
  if (labels.scope !== 'off') link.set('labels', labelsText(labels));
  if (explorer.pointers.value) link.set('pointers', 'on');
}

/** What was wrong in a file does not go with its mesh. */
function addProblem(link: URLSearchParams, explorer: Explorer): void {
  const { value: problem } = explorer.problem;
  if (!problem || !link.has('sample')) return;
  link.set('problem', String(problemsOf(explorer).indexOf(problem)));
}

function addPanel(link: URLSearchParams, opened: MeshDocument, explorer: Explorer): void {
  if (explorer.tab.value !== firstTab(opened)) link.set('tab', explorer.tab.value);
  if (explorer.pickMode.value !== 'auto') link.set('pick', explorer.pickMode.value);
}

function tooLarge(name: string, length: string): Error {
  return new Error(
    `${name} is too large for a link: it would be ${length}, ${kilobytes(MOST_LETTERS)} are sure to arrive. Download the mesh and send the file.`,
  );
}

/**
 * Shows the state that a link tells of; what it does not name is as it is on a new page. False where its mesh
 * can't be opened, which the page tells of, or another one is opened meanwhile: what is on show stays as it is.
 * Throws a sentence for a link that can't be followed.
 */
export async function follow(text: string, explorer: Explorer, sight: Sight): Promise<boolean> {
  if (text.length > MOST_LETTERS_READ) {
    throw new Error(
      `It is ${kilobytes(text.length)} long; the longest that is made is ${kilobytes(MOST_LETTERS)}.`,
    );
  }
  const link = new URLSearchParams(text);
  if (!(await openMeshOf(link, explorer))) return false;
  repeatEdits(link.get('edits'), explorer);
  explorer.setUpOfMesh(upOf(link.get('up') ?? 'y'));
  const camera = link.get('camera');
  const selected = link.get('select');
  if (selected !== null) selectIn(selected, explorer);
  if (camera === null && explorer.selected.value) sight.turnTo(explorer.selected.value);
  setQuery(link, explorer);
  setCaptions(link, explorer);
  if (link.get('picture') === 'original') explorer.showFile(true);
  setProblem(link.get('problem'), explorer);
  setPanel(link, explorer);
  if (camera !== null) sight.lookFrom(viewpointOf(camera));
  return true;
}

/** Whether the mesh is on show: it may be one that can't be read, or another one is opened meanwhile. */
async function openMeshOf(link: URLSearchParams, explorer: Explorer): Promise<boolean> {
  const id = link.get('sample');
  const mesh = link.get('mesh');
  if (mesh !== null) {
    return explorer.openMesh(link.get('name') ?? 'Shared mesh', meshOf(mesh), wordsOf(link));
  }
  if (id === null) throw new Error('It names no mesh: it has neither “sample” nor “mesh”.');
  const sample = [...samples, ...brokenSamples].find((candidate) => candidate.id === id);
  if (!sample) throw new Error(`It names the sample “${id}”, which this page does not have.`);
  return explorer.open(sample);
}

/** The words for the numbers of attributes, such as the names of groups. */
function wordsOf(link: URLSearchParams): AttributeNames {
  const keys = [...new Set(link.keys())].filter((key) => key.startsWith(WORDS));
  return Object.fromEntries(keys.map((key) => [key.slice(WORDS.length), link.getAll(key)]));
}

function meshOf(text: string): HalfedgeMesh {
  let bytes: Uint8Array;
  try {
    bytes = unpacked(text);
  } catch {
    throw new Error('The mesh in it is cut off or changed: copy the whole link again.');
  }
  return HalfedgeMesh.fromBytes(bytes);
}

/** Does the edits again, so that they can be undone. */
function repeatEdits(text: string | null, explorer: Explorer): void {
  const { editor } = explorer;
  for (const deed of text ? text.split(',') : []) {
    const { operation, first, second } = deedOf(deed);
    const before = editor.past.value.undoCount;
    // The first one last: the edit is done to what is selected, which must not be another item.
    for (const item of [second, first]) {
      if (item && explorer.remark.value === '') explorer.select(item);
    }
    const { value: absence } = explorer.remark;
    if (absence === '') {
      editor.run(operation);
      if (second) editor.complete(second);
    }
    if (editor.past.value.undoCount === before) {
      const why = absence || editor.refused.value?.refusal.message || editor.report.value;
      editor.cancel(); // what is wrong with the link is told as a whole
      throw new Error(`The edit “${deed}” in it could not be done. ${why}`.trim());
    }
  }
  editor.markSaved(); // the link has them
}

function deedOf(text: string): Deed {
  try {
    return parseDeed(text);
  } catch {
    throw new Error(`It has the edit “${text}”, which this page does not know.`);
  }
}

function setQuery(link: URLSearchParams, explorer: Explorer): void {
  const names = link.get('names') ?? 'halfedge';
  if (!dialects.some(({ id }) => id === names)) {
    throw new Error(`It asks for the names of “${names}”, which this page does not know.`);
  }
  explorer.walker.setDialect(names as DialectId);
  const direction = link.get('direction') ?? 'ccw';
  if (direction !== 'ccw' && direction !== 'cw') {
    throw new Error(`It has the direction “${direction}”; there are ccw and cw.`);
  }
  explorer.walker.setDirection(direction satisfies Direction);
  explorer.walker.speed.value = speedOf(link.get('speed'));
  const { value: selected } = explorer.selected;
  if (!['query', 'around', 'at'].some((word) => link.has(word)) || !selected) return;
  const around = link.get('around') ?? '0';
  const group = Number(around);
  const offered = explorer.walker.groups.value[group]?.circulators;
  if (!offered) {
    const last = explorer.walker.groups.value.length - 1;
    throw new Error(
      `It has around=${around}; of ${itemName(selected)} ${last > 0 ? `0 to ${last} are known` : 'only 0 is known'}.`,
    );
  }
  const query = link.get('query');
  const circulator = query === null ? offered[0] : offered.find(({ name }) => name === query);
  if (!circulator) {
    throw new Error(`${itemName(selected)} has no circulator “${query}”.`);
  }
  explorer.walker.choose({ group, circulator });
  setPosition(link.get('at') ?? '0', explorer);
}

/** The position among the speeds. */
function speedOf(text: string | null): number {
  if (text === null) return DEFAULT_SPEED;
  const position = (SPEEDS as readonly number[]).indexOf(Number(text));
  if (position < 0) {
    throw new Error(`It has speed=${text}; expected one of ${SPEEDS.join(', ')}.`);
  }
  return position;
}

function setPosition(text: string, explorer: Explorer): void {
  const at = Number(text);
  const count = explorer.walker.play.value?.player.count ?? 0;
  if (!(Number.isInteger(at) && at >= 0 && at <= count)) {
    throw new Error(`It has at=${text}; expected 0 to ${count}, as many as that walk visits.`);
  }
  if (at > 0) explorer.walker.seek(at);
}

function setCaptions(link: URLSearchParams, explorer: Explorer): void {
  const text = link.get('labels');
  const labels = text === null ? NO_LABELS : parseLabels(text);
  if (!labels) {
    throw new Error(`The labels in it are “${text}”; expected such as all:vehf or selection:vf.`);
  }
  explorer.labels.value = labels;
  explorer.pointers.value = link.get('pointers') === 'on';
}

/** The problems of the file that have a place in the picture, as they are listed. */
function problemsOf({ document }: Explorer): readonly Problem[] {
  const { diagnosis } = document.value ?? {};
  const listed = diagnosis?.findings.flatMap(({ problems }) => problems) ?? [];
  return listed.filter((problem) => diagnosis?.placed.has(problem));
}

function setProblem(text: string | null, explorer: Explorer): void {
  if (text === null) return;
  const problems = problemsOf(explorer);
  const problem = problems[Number(text)];
  if (!problem) {
    const there =
      problems.length > 0 ? `expected 0 to ${problems.length - 1}` : 'its mesh has no problems';
    throw new Error(`It has problem=${text}; ${there}.`);
  }
  explorer.showProblem(problem);
}

function setPanel(link: URLSearchParams, explorer: Explorer): void {
  const opened = explorer.document.value;
  const tab = link.get('tab') ?? firstTab(opened);
  const offered = TABS.filter((each) => each !== 'problems' || hasProblems(opened));
  if (!offered.includes(tab as Tab)) {
    throw new Error(`It asks for the tab “${tab}”; expected one of ${offered.join(', ')}.`);
  }
  explorer.tab.value = tab as Tab;
  const pick = link.get('pick') ?? 'auto';
  if (!PICK_MODES.includes(pick as PickMode)) {
    throw new Error(`It picks “${pick}”; expected one of ${PICK_MODES.join(', ')}.`);
  }
  explorer.pickMode.value = pick as PickMode;
}

function selectIn(name: string, explorer: Explorer): void {
  explorer.select(name === 'nothing' ? null : itemOf(name));
  if (explorer.remark.value !== '') throw new Error(explorer.remark.value);
}

function itemOf(name: string): Item {
  const item = parseItemName(name);
  if (!item) throw new Error(`“${name}” in it is no item: expected such as v12, h31, e15 or f7.`);
  return item;
}

/** With digits enough for where the camera stands, beside what it looks at. */
function cameraText(viewpoint: Viewpoint): string {
  const distance = Math.hypot(...[0, 1, 2].map((k) => viewpoint[k] - viewpoint[k + 3]));
  const decimals = Math.ceil(4 - Math.log10(distance));
  if (!(Math.abs(decimals) <= 100)) return viewpoint.join(',');
  return viewpoint.map((x) => Number(x.toFixed(Math.max(0, decimals)))).join(',');
}

function upOf(text: string): UpAxis {
  if (text !== 'y' && text !== 'z') throw new Error(`It has up=${text}; expected y or z.`);
  return text;
}

function viewpointOf(text: string): Viewpoint {
  const numbers = text.split(',').map(Number);
  // Of what the graphics card has no number for, a picture would never come to rest.
  if (numbers.length !== 6 || !numbers.every((x) => Number.isFinite(Math.fround(x)))) {
    throw new Error(`The camera in it is “${text}”; expected six numbers.`);
  }
  return numbers;
}

const kilobytes = (letters: number) => `${Math.ceil(letters / 1000)} kB`;
