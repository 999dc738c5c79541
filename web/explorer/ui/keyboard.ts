import type { Explorer } from '../app/explorer.js';
import type { WalkKey } from '../app/items.js';
import type { View } from '../scene/view.js';

const WALKS: ReadonlySet<string> = new Set<WalkKey>(['n', 'p', 'o', 'v', 'e', 'f', 'h', 'u']);
const ORBIT = 0.12;

/** Keys for everything; they leave fields, sliders and open dialogs alone. */
export function listenToKeys(explorer: Explorer, view: View, openHelp: () => void): void {
  const orbit = (dx: number, dy: number) => view.orbit(dx * ORBIT, dy * ORBIT);
  const actions: Record<string, () => void> = {
    ' ': () => explorer.toggle(),
    ',': () => explorer.step(-1),
    '.': () => explorer.step(1),
    Home: () => explorer.seek(0),
    End: () => explorer.seek(Number.MAX_SAFE_INTEGER),
    c: () => explorer.setDirection(explorer.direction.value === 'ccw' ? 'cw' : 'ccw'),
    z: () => view.focus(),
    '0': () => view.fit(),
    g: () => document.querySelector<HTMLInputElement>('.goto input')?.focus(),
    '?': openHelp,
    ArrowLeft: () => orbit(-1, 0),
    ArrowRight: () => orbit(1, 0),
    ArrowUp: () => orbit(0, -1),
    ArrowDown: () => orbit(0, 1),
    '+': () => view.zoom(1 / 1.2),
    '=': () => view.zoom(1 / 1.2),
    '-': () => view.zoom(1.2),
    Escape: () => {
      if (explorer.failure.value) explorer.failure.value = null;
      else explorer.select(null);
    },
  };
  window.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || belongsToControl(event)) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const action = WALKS.has(key) ? () => explorer.walk(key as WalkKey) : actions[key];
    if (!action) return;
    event.preventDefault();
    action();
  });
}

/** Whether the focused control has a use of its own for the key. */
function belongsToControl({ target, key }: KeyboardEvent): boolean {
  if (document.querySelector('dialog[open], :popover-open')) return true;
  if (!(target instanceof HTMLElement)) return false;
  if (target instanceof HTMLSelectElement) return true;
  const arrow = key.startsWith('Arrow');
  if (target instanceof HTMLInputElement) {
    if (target.type === 'text') return key !== 'Escape';
    if (target.type === 'range') return arrow || key === 'Home' || key === 'End';
    return arrow || key === ' ';
  }
  return target.closest('button') !== null && (key === ' ' || key === 'Enter' || arrow);
}
