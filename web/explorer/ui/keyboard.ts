import type { WalkKey } from 'halfedge/teaching';
import { nextScope } from '../app/captions.js';
import type { Explorer } from '../app/explorer.js';
import { TABS, type Tab } from '../app/tabs.js';
import type { View } from '../scene/view.js';

const WALKS: ReadonlySet<string> = new Set<WalkKey>(['n', 'p', 'o', 'v', 'e', 'f', 'h', 'u']);
const ORBIT = 0.12;

/** What keys do, by the key or its small letter. */
type Actions = Readonly<Record<string, () => void>>;

/** Keys for everything; they leave fields, sliders and open dialogs alone. */
export function listenToKeys(explorer: Explorer, view: View, openHelp: () => void): void {
  const actions: Actions = {
    ...walkerActions(explorer),
    ...pictureActions(explorer, view),
    ...itemActions(explorer),
    ...tabActions(explorer),
    '?': openHelp,
  };
  window.addEventListener('keydown', (event) => {
    if (event.altKey || belongsToControl(event)) return;
    const action = actionOf(event, explorer, actions);
    if (!action) return;
    event.preventDefault();
    if (!event.repeat || goesOn(event)) action();
  });
}

function walkerActions({ walker }: Explorer): Actions {
  return {
    ' ': () => walker.toggle(),
    ',': () => walker.step(-1),
    '.': () => walker.step(1),
    Home: () => walker.seek(0),
    End: () => walker.seek(Number.MAX_SAFE_INTEGER),
    c: () => walker.setDirection(walker.direction.value === 'ccw' ? 'cw' : 'ccw'),
  };
}

function pictureActions(explorer: Explorer, view: View): Actions {
  const orbit = (dx: number, dy: number) => view.travel.orbit(dx * ORBIT, dy * ORBIT);
  return {
    z: () => view.focus(),
    '0': () => view.travel.fit(),
    y: () => explorer.setUp(explorer.up.value === 'y' ? 'z' : 'y'),
    r: () => explorer.showFile(!explorer.showsFile.value),
    k: () => {
      explorer.pointers.value = !explorer.pointers.value;
    },
    l: () => {
      explorer.labels.value = nextScope(explorer.labels.value);
    },
    ArrowLeft: () => orbit(-1, 0),
    ArrowRight: () => orbit(1, 0),
    ArrowUp: () => orbit(0, -1),
    ArrowDown: () => orbit(0, 1),
    '+': () => view.travel.zoom(1 / 1.2),
    '=': () => view.travel.zoom(1 / 1.2),
    '-': () => view.travel.zoom(1.2),
  };
}

/** To go to an item, to do something with it, and to give that up. */
function itemActions(explorer: Explorer): Actions {
  const { editor } = explorer;
  return {
    g: () => document.querySelector<HTMLInputElement>('.goto input')?.focus(),
    Delete: () => editor.runKey('Delete'),
    Backspace: () => editor.runKey('Delete'),
    Enter: () => {
      if (explorer.selected.value) editor.complete(explorer.selected.value);
    },
    Escape: () => {
      if (explorer.busy.value !== null && explorer.document.value) explorer.cancel();
      else if (explorer.failure.value) explorer.failure.value = null;
      else if (editor.pending.value || editor.refused.value) editor.cancel();
      else if (explorer.problem.value) explorer.problem.value = null;
      else explorer.select(null);
    },
  };
}

/** A digit for each tab but the first: the inspector is there, as a rule. */
function tabActions(explorer: Explorer): Actions {
  const show = (id: Tab) => {
    const button = document.querySelector<HTMLElement>(`[data-tab-button=${id}]`);
    if (!button?.hidden) explorer.tab.value = id;
  };
  const keys = TABS.map((id, key) => [key, () => show(id)] as const);
  return Object.fromEntries(keys.slice(1));
}

/** Capitals are operations; letters walk; control or command with Z and Y goes through history. */
function actionOf(
  { key, shiftKey, ctrlKey, metaKey }: KeyboardEvent,
  explorer: Explorer,
  actions: Actions,
): (() => void) | undefined {
  const { editor } = explorer;
  const letter = key.length === 1 ? key.toLowerCase() : key;
  if (ctrlKey || metaKey) {
    if (letter === 'y' || (letter === 'z' && shiftKey)) return () => editor.redo();
    return letter === 'z' ? () => editor.undo() : undefined;
  }
  if (shiftKey && /^[a-z]$/.test(letter)) return () => editor.runKey(letter.toUpperCase());
  return WALKS.has(letter) ? () => explorer.walk(letter as WalkKey) : actions[letter];
}

/** Whether a key that is held does it again and again, as steps and turns do; an operation is done once. */
function goesOn({ key, shiftKey, ctrlKey, metaKey }: KeyboardEvent): boolean {
  if (ctrlKey || metaKey || /^([,.+=-]|Arrow\w+)$/.test(key)) return true;
  return !shiftKey && WALKS.has(key.toLowerCase()); // a capital, where capitals are locked
}

/** Whether the focused control has a use of its own for the key. */
function belongsToControl({ target, key }: KeyboardEvent): boolean {
  if (document.querySelector('dialog[open], :popover-open')) return true;
  if (!(target instanceof HTMLElement)) return false;
  if (target instanceof HTMLSelectElement) return true;
  const arrow = key.startsWith('Arrow');
  if (target.matches('.listing-box')) return arrow;
  if (target instanceof HTMLInputElement) {
    if (target.type === 'text') return key !== 'Escape';
    if (target.type === 'range') return arrow || key === 'Home' || key === 'End';
    return arrow || key === ' ';
  }
  return target.closest('button') !== null && (key === ' ' || key === 'Enter' || arrow);
}
