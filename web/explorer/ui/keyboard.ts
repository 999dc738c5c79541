import type { WalkKey } from 'halfedge/teaching';
import { nextScope } from '../app/captions.js';
import type { Explorer } from '../app/explorer.js';
import { TABS } from '../app/tabs.js';
import type { View } from '../scene/view.js';

const WALKS: ReadonlySet<string> = new Set<WalkKey>(['n', 'p', 'o', 'v', 'e', 'f', 'h', 'u']);
const ORBIT = 0.12;

/** Keys for everything; they leave fields, sliders and open dialogs alone. */
export function listenToKeys(explorer: Explorer, view: View, openHelp: () => void): void {
  const { editor } = explorer;
  const orbit = (dx: number, dy: number) => view.travel.orbit(dx * ORBIT, dy * ORBIT);
  const actions: Record<string, () => void> = {
    ' ': () => explorer.toggle(),
    ',': () => explorer.step(-1),
    '.': () => explorer.step(1),
    Home: () => explorer.seek(0),
    End: () => explorer.seek(Number.MAX_SAFE_INTEGER),
    c: () => explorer.setDirection(explorer.direction.value === 'ccw' ? 'cw' : 'ccw'),
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
    g: () => document.querySelector<HTMLInputElement>('.goto input')?.focus(),
    '?': openHelp,
    ArrowLeft: () => orbit(-1, 0),
    ArrowRight: () => orbit(1, 0),
    ArrowUp: () => orbit(0, -1),
    ArrowDown: () => orbit(0, 1),
    '+': () => view.travel.zoom(1 / 1.2),
    '=': () => view.travel.zoom(1 / 1.2),
    '-': () => view.travel.zoom(1.2),
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
  TABS.forEach((id, key) => {
    if (key === 0) return; // the inspector is there, as a rule
    actions[key] = () => {
      const button = document.querySelector<HTMLElement>(`[data-tab-button=${id}]`);
      if (!button?.hidden) explorer.tab.value = id;
    };
  });
  window.addEventListener('keydown', (event) => {
    if (event.altKey || belongsToControl(event)) return;
    const action = actionOf(event);
    if (!action) return;
    event.preventDefault();
    if (!event.repeat || goesOn(event)) action();
  });

  /** Capitals are operations; letters walk; control or command with Z and Y goes through history. */
  function actionOf({ key, shiftKey, ctrlKey, metaKey }: KeyboardEvent): (() => void) | undefined {
    const letter = key.length === 1 ? key.toLowerCase() : key;
    if (ctrlKey || metaKey) {
      if (letter === 'y' || (letter === 'z' && shiftKey)) return () => editor.redo();
      return letter === 'z' ? () => editor.undo() : undefined;
    }
    if (shiftKey && /^[a-z]$/.test(letter)) return () => editor.runKey(letter.toUpperCase());
    return WALKS.has(letter) ? () => explorer.walk(letter as WalkKey) : actions[letter];
  }
}

/** Whether a key that is held does it again and again, as steps and turns do; an operation is done once. */
function goesOn({ key, ctrlKey, metaKey }: KeyboardEvent): boolean {
  return ctrlKey || metaKey || WALKS.has(key) || /^([,.+=-]|Arrow\w+)$/.test(key);
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
