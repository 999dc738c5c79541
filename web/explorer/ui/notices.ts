import { EXTENSIONS, failureOf } from '../app/documents.js';
import type { Explorer } from '../app/explorer.js';
import type { Signal } from '../app/signal.js';
import { appearance } from './appear.js';
import { h, icon } from './dom.js';
import { dropped } from './dropped-files.js';

/** The sentence about a file that could not be opened. */
export function failureNotice(explorer: Explorer): HTMLElement {
  const { notice, tell } = noticeCard(() => {
    explorer.failure.value = null;
  });
  const appear = appearance(notice);
  explorer.failure.subscribe((failure) => {
    appear(failure !== null);
    if (!failure) return;
    const shown = explorer.document.value?.name;
    const { lesson, advice } = failure;
    const others = advice ? null : 'Choose another mesh above.';
    const still = shown ? `The view shows ${shown}.` : others;
    const calm = [lesson, advice, still].filter(Boolean).join(' ');
    tell(failure.title, failure.message, calm);
  });
  return notice;
}

/** Says why the page can't be shown: it has the window to itself. */
export function startFailure(title: string, message: string, advice: string): HTMLElement {
  const { notice, tell } = noticeCard(null);
  tell(title, message, advice);
  notice.hidden = false;
  return notice;
}

/** `dismiss` hides it; null: it stays. */
function noticeCard(dismiss: (() => void) | null) {
  const title = h('h2');
  const message = h('p', { 'data-message': true });
  const calm = h('p', { class: 'calm' });
  const notice = h(
    'div',
    { class: 'notice card', role: 'alert', hidden: true },
    icon('warning'),
    title,
    message,
    calm,
    dismiss &&
      h(
        'button',
        {
          type: 'button',
          class: 'button square quiet',
          'aria-label': 'Dismiss',
          onclick: dismiss,
        },
        icon('close'),
      ),
  );
  const tell = (...texts: [string, string, string]) => {
    [title, message, calm].forEach((part, i) => {
      part.textContent = texts[i];
    });
  };
  return { notice, tell };
}

const STAGES = { read: 'Reading', repair: 'Repairing', build: 'Building' } as const;

/** What is being opened, how far it is, and a button that gives it up. */
export function busyNotice(explorer: Explorer): HTMLElement {
  const text = h('span', { role: 'status' });
  const bar = h('progress', { max: 1, 'aria-label': 'How much of it is done', hidden: true });
  const cancel = h(
    'button',
    { type: 'button', class: 'button', 'data-cancel': true, onclick: () => explorer.cancel() },
    'Cancel',
  );
  const notice = h('div', { class: 'busy card', hidden: true }, text, cancel, bar);
  explorer.busy.subscribe((name) => {
    notice.hidden = name === null;
    text.textContent = name === null ? '' : `Opening ${name} …`;
  });
  explorer.progress.subscribe((progress) => {
    bar.hidden = progress === null;
    if (!progress) return;
    text.textContent = `${STAGES[progress.stage]} ${explorer.busy.value} …`;
    bar.value = progress.fraction;
  });
  return notice;
}

/** Why there are no names in the picture, where all are asked for and no face is large enough. */
export function namesHint(lacksRoom: Signal<boolean>): HTMLElement {
  const hint = h('div', { class: 'names-hint card', role: 'status' });
  lacksRoom.subscribe((lacks) => {
    hint.textContent = lacks ? 'Zoom in to read the names' : '';
  });
  return hint;
}

/** How long it is shown which meshes were passed over. */
const SHOWN_MS = 8000;

/** Says that of several meshes which were chosen together one was opened. */
export function passedOverNotice(explorer: Explorer): HTMLElement {
  const notice = h('div', {
    class: 'toast card',
    role: 'status',
    'data-passed-over': true,
    hidden: true,
  });
  const appear = appearance(notice);
  explorer.passedOver.subscribe(([first, ...others]) => {
    if (first === undefined) return appear(false);
    const { length } = others;
    const more = length > 0 ? ` and ${length} other ${length > 1 ? 'meshes' : 'mesh'}` : '';
    const verb = length > 0 ? 'were' : 'was';
    notice.textContent = `${first}${more} ${verb} not opened: the page shows one mesh at a time.`;
    appear(true, SHOWN_MS);
  });
  return notice;
}

const KINDS = 'OBJ, OFF, PLY, STL, GLB or glTF';

/** Takes files and folders that are dropped anywhere on the page, and shows that it would. */
export function dropTarget(explorer: Explorer): HTMLElement {
  const target = h('div', { class: 'drop-target', hidden: true }, `Drop an ${KINDS} file`);
  let depth = 0;
  const carriesFile = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false;
  window.addEventListener('dragenter', (event) => {
    if (!carriesFile(event)) return;
    depth += 1;
    target.hidden = false;
  });
  window.addEventListener('dragleave', (event) => {
    if (!carriesFile(event)) return;
    depth = Math.max(0, depth - 1);
    target.hidden = depth === 0;
  });
  window.addEventListener('dragover', (event) => {
    if (carriesFile(event)) event.preventDefault();
  });
  window.addEventListener('drop', (event) => {
    if (!carriesFile(event)) return;
    event.preventDefault();
    depth = 0;
    target.hidden = true;
    if (event.dataTransfer) void openDropped(explorer, event.dataTransfer);
  });
  return target;
}

/** Opens the mesh among files; the others may belong to it. */
export function openFiles(explorer: Explorer, files: FileList | null | undefined): void {
  const all = [...(files ?? [])];
  const file = all.find(isMesh) ?? all[0];
  if (file) void openAmong(explorer, file, all);
}

/** Opens one of these files, and tells of the other meshes among them. */
async function openAmong(explorer: Explorer, file: File, all: readonly File[]): Promise<void> {
  if (!(await explorer.open(file, all))) return;
  const others = all.filter((each) => each !== file && isMesh(each));
  explorer.passedOver.value = others.map(({ name }) => name);
}

/** Opens what was dropped: of folders, the first mesh in them. */
async function openDropped(explorer: Explorer, transfer: DataTransfer): Promise<void> {
  const { folder, files } = dropped(transfer);
  if (folder === null) return openFiles(explorer, transfer.files);
  try {
    const all = await files;
    const file = all.find(isMesh);
    if (file) void openAmong(explorer, file, all);
    else throw new Error(`There is no ${KINDS} file in it.`);
  } catch (error) {
    explorer.failure.value = failureOf(error, { name: folder });
  }
}

function isMesh({ name }: File): boolean {
  return EXTENSIONS.some((extension) => name.toLowerCase().endsWith(`.${extension}`));
}

/** Opens the mesh that is pasted, as a file or as text, or follows a link, anywhere but into a field. */
export function listenToPaste(explorer: Explorer): void {
  window.addEventListener('paste', (event) => {
    if (event.target instanceof Element && event.target.matches('input[type=text]')) return;
    const { files } = event.clipboardData ?? {};
    const text = event.clipboardData?.getData('text/plain') ?? '';
    const link = linkIn(text);
    if (files?.length) openFiles(explorer, files);
    else if (link !== null) followLink(link);
    else if (text.trim()) explorer.openText(text);
    else return;
    event.preventDefault();
  });
}

/**
 * What a text leads to, from `#` on, where it is an address with a state of this page, or the end of one; from another
 * place that serves the page, too. Null for all else: lines of a file may begin with `#`, too.
 */
function linkIn(text: string): string | null {
  const link = text.trim();
  const isEnd = /^#.+$/.test(link);
  if (!isEnd && !URL.canParse(link)) return null;
  const { hash } = new URL(link, location.href);
  const state = new URLSearchParams(hash.slice(1));
  return state.has('sample') || state.has('mesh') ? hash : null;
}

function followLink(hash: string): void {
  // What it leads to may have been left: only a change of the address is followed.
  if (hash === location.hash) history.replaceState(null, '', location.pathname + location.search);
  location.hash = hash;
}

const KEYS: readonly [string[], string][] = [
  [['N', 'P', 'O'], 'walk to next, prev, opposite'],
  [['V', 'U'], 'walk to the to-vertex, from-vertex'],
  [['E', 'F', 'H'], 'walk to the edge, the face, a halfedge'],
  [['Space'], 'play or pause the circulator'],
  [[',', '.'], 'step back, step forward'],
  [['Home', 'End'], 'to the start of the lap, to its end'],
  [['C'], 'change the direction'],
  [['Z', '0'], 'zoom to the selection, to the mesh'],
  [['←', '→', '↑', '↓'], 'orbit'],
  [['+', '−'], 'zoom'],
  [['Y'], 'y or z points up'],
  [['K'], 'draw the links (1)–(7) of the selected item as arrows'],
  [['L'], 'names of items: at the selection, at the pointer, of all, none'],
  [['G'], 'go to an item by name'],
  [['⇧ F', '⇧ S', '…'], 'flip, split, …: operations as the Edit panel lists them'],
  [['Del'], 'delete the selected vertex, edge or face'],
  [['Ctrl Z', 'Ctrl Y'], 'undo, redo'],
  [['Ctrl V'], 'open the mesh that was copied: a file, its text or a link'],
  [['R'], 'show the original file, or the repaired mesh'],
  [['1', '…', '5'], 'show the circulator, the operations, the mesh, its records, the problems'],
  [['Esc'], 'close, or select nothing'],
];

/** The list of keys. */
export function helpDialog(): HTMLDialogElement {
  const dialog = h(
    'dialog',
    { class: 'help card', 'aria-labelledby': 'help-title' },
    h(
      'header',
      {},
      h('h2', { id: 'help-title' }, 'Keys'),
      h(
        'button',
        {
          type: 'button',
          class: 'button square quiet',
          'aria-label': 'Close',
          onclick: () => dialog.close(),
        },
        icon('close'),
      ),
    ),
    h('dl', {}),
  );
  const list = dialog.querySelector('dl') as HTMLElement;
  for (const [keys, text] of KEYS) {
    const caps = keys.map((key) => h('kbd', { class: 'kbd' }, key));
    list.append(h('dt', {}, ...caps), h('dd', {}, text));
  }
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) dialog.close();
  });
  return dialog;
}
