// How meshes come into the page: chosen, dropped or pasted.

import { EXTENSIONS, failureOf } from '../app/documents.js';
import type { Explorer } from '../app/explorer.js';
import { h } from './dom.js';
import { dropped } from './dropped-files.js';

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
