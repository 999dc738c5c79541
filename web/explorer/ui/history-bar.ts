import type { Explorer } from '../app/explorer.js';
import { grouped, type MeshFacts, type Numbers, signed } from '../app/facts.js';
import { fill, h, type IconName, icon, setAttribute } from './dom.js';

type Entry = readonly [name: keyof Numbers, symbol: string, meaning: string];

const COUNTS: readonly Entry[] = [
  ['vertices', 'V', 'vertices'],
  ['edges', 'E', 'edges'],
  ['faces', 'F', 'faces'],
];

const TOPOLOGY: readonly Entry[] = [
  ['characteristic', 'χ', 'Euler characteristic V − E + F'],
  ['genus', 'genus', 'handles, over all components'],
  ['loops', 'loops', 'boundary loops'],
  ['components', 'parts', 'connected components'],
];

const onMac = /mac|iphone|ipad/i.test(navigator.userAgent);

/** Undo and redo with the names of the steps, and the numbers of the mesh with what has changed. */
export function historyBar(explorer: Explorer): HTMLElement {
  const { editor } = explorer;
  const undo = stepButton('undo', () => editor.undo());
  const redo = stepButton('redo', () => editor.redo());
  editor.past.subscribe((past) => {
    showStep(undo, 'Undo', past.undo, past.undoCount, onMac ? '⌘Z' : 'Ctrl Z');
    showStep(redo, 'Redo', past.redo, past.redoCount, onMac ? '⇧⌘Z' : 'Ctrl Y');
  });
  const outcome = h('p', { class: 'visually-hidden', role: 'status', 'data-outcome': true });
  editor.outcome.subscribe((text) => {
    outcome.textContent = text;
  });
  const rows = [COUNTS, TOPOLOGY].map((entries) => ({ entries, list: h('dl') }));
  explorer.facts.subscribe((facts) => {
    if (!facts) return;
    for (const { entries, list } of rows) {
      fill(list, ...entries.map((entry) => shortNumber(entry, facts)));
    }
  });
  const numbers = h(
    'div',
    { class: 'numbers', role: 'group', 'aria-label': 'Numbers of the mesh' },
    ...rows.map(({ list }) => list),
  );
  return h(
    'footer',
    { class: 'history' },
    h('div', { class: 'steps', role: 'group', 'aria-label': 'History' }, undo, redo),
    numbers,
    outcome,
  );
}

function stepButton(name: IconName, act: () => void): HTMLButtonElement {
  return h(
    'button',
    { type: 'button', class: 'button', 'data-history': name, onclick: act },
    icon(name),
    h('span'),
  );
}

/** The button keeps the focus when there is nothing left to undo: it is disabled for `aria` only. */
function showStep(
  button: HTMLElement,
  verb: string,
  title: string | null,
  count: number,
  key: string,
): void {
  setAttribute(button, 'aria-disabled', title === null ? 'true' : null);
  const text = button.querySelector('span') as HTMLElement;
  text.textContent = title === null ? verb : `${verb} ${title}`;
  const more = count > 1 ? `, ${count} steps` : '';
  button.title =
    title === null ? `Nothing to ${verb.toLowerCase()}` : `${verb} ${title} (${key})${more}`;
}

function shortNumber([name, symbol, meaning]: Entry, { numbers, changes }: MeshFacts): HTMLElement {
  const change = changes[name];
  return h(
    'div',
    { title: meaning, 'data-number': name },
    h('dt', {}, h('abbr', { title: meaning }, symbol)),
    h('dd', {}, grouped(numbers[name]), change !== undefined && changeBadge(change)),
  );
}

/** `+3`: what the last change added. */
export function changeBadge(change: number): HTMLElement {
  return h('ins', { class: change > 0 ? 'more' : 'less' }, signed(change));
}
