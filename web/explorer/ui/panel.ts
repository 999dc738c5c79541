import type { Item } from 'halfedge/teaching';
import type { Explorer } from '../app/explorer.js';
import { hasProblems, type Tab } from '../app/tabs.js';
import { circulatorPanel } from './circulator-panel.js';
import { h } from './dom.js';
import type { TakePicture } from './downloads.js';
import { editPanel } from './edit-panel.js';
import { historyBar } from './history-bar.js';
import { inspector } from './inspector.js';
import { type GoTo, meshPanel } from './mesh-panel.js';
import { problemsPanel } from './problems-panel.js';
import { recordsPanel } from './records-panel.js';

const BUTTONS: readonly [Tab, string, string?][] = [
  ['inspect', 'Inspect'],
  ['circulate', 'Circulate', '1'],
  ['edit', 'Edit', '2'],
  ['mesh', 'Mesh', '3'],
  ['records', 'Records', '4'],
  ['problems', 'Problems', '5'],
];
const SHEETS = ['low', 'half', 'tall'] as const;
type Sheet = (typeof SHEETS)[number];

/** What the panel does with the camera. */
export interface Flights {
  readonly takePicture: TakePicture;
  readonly goTo: GoTo;
  /** Turns the picture to an item that is out of sight. */
  readonly bringIntoSight: (item: Item) => void;
  /** Back to the problem that is lit. */
  readonly toProblem: () => void;
}

/**
 * The inspector, and below it one of circulator, operations, mesh, records and problems of the file. In low and in
 * narrow windows the inspector is one more tab; in narrow ones the panel is a sheet at the bottom, that can be pulled
 * up or down.
 */
export function panel(explorer: Explorer, flights: Flights): HTMLElement {
  const { tab } = explorer;
  const tabs = h('nav', { class: 'tabs', 'aria-label': 'Panel' });
  const element = h(
    'aside',
    { class: 'panel card', 'aria-label': 'Panel', 'data-sheet': 'half' },
    inspector(explorer, flights.bringIntoSight),
    tabs,
    h(
      'div',
      { class: 'sections' },
      circulatorPanel(explorer),
      editPanel(explorer),
      meshPanel(explorer, flights.goTo, flights.takePicture),
      recordsPanel(explorer),
      problemsPanel(explorer, flights.toProblem, flights.takePicture),
    ),
    historyBar(explorer),
  );
  const { grip, pull } = sheetGrip(element);
  element.prepend(grip);
  for (const [id, text, key] of BUTTONS) {
    const choose = () => {
      tab.value = id;
      if (element.dataset.sheet === 'low') pull('half');
    };
    const title = key ? `${text} (${key})` : text;
    const button = h(
      'button',
      { type: 'button', 'data-tab-button': id, title, onclick: choose },
      text,
    );
    tabs.append(button);
    if (id === 'problems') offerProblems(explorer, button);
  }
  const mark = () => {
    element.dataset.tab = tab.value;
    const inspect = tabs.querySelector('[data-tab-button=inspect]');
    // The styles show the circulator below the inspector, where that is no tab.
    const isBeside = tab.value === 'inspect' && !inspect?.checkVisibility();
    const shown = isBeside ? 'circulate' : tab.value;
    for (const button of tabs.querySelectorAll<HTMLElement>('button')) {
      button.setAttribute('aria-current', String(button.dataset.tabButton === shown));
    }
  };
  tab.subscribe(mark);
  window.addEventListener('resize', mark);
  return element;
}

/** The grip by which the sheet is pulled up or down in narrow windows, and what pulls it otherwise. */
function sheetGrip(panel: HTMLElement) {
  let from = 0;
  let isPulled = false;
  const pull = (sheet: Sheet) => {
    panel.dataset.sheet = sheet;
    grip.setAttribute('aria-expanded', String(sheet === 'tall'));
  };
  const move = (by: 1 | -1) => {
    const at = SHEETS.indexOf(panel.dataset.sheet as Sheet);
    pull(SHEETS[Math.max(0, Math.min(SHEETS.length - 1, at + by))]);
  };
  const grip = h('button', {
    type: 'button',
    class: 'grip',
    'aria-label': 'Resize the panel',
    'aria-expanded': 'false',
    onpointerdown: (event) => {
      from = (event as PointerEvent).clientY;
      grip.setPointerCapture((event as PointerEvent).pointerId);
    },
    onpointerup: (event) => {
      const by = from - (event as PointerEvent).clientY;
      isPulled = Math.abs(by) > 12;
      if (isPulled) move(by > 0 ? 1 : -1);
    },
    onclick: (event) => {
      // A pull ends in a click of the pointer, too.
      const endsPull = isPulled && (event as MouseEvent).detail > 0;
      if (!endsPull) pull(panel.dataset.sheet === 'half' ? 'tall' : 'half');
    },
    onkeydown: (event) => {
      const { key } = event as KeyboardEvent;
      if (key === 'ArrowUp') move(1);
      else if (key === 'ArrowDown') move(-1);
    },
  });
  return { grip, pull };
}

/** There is such a tab where there is something to tell of a file; it comes to the front then. */
function offerProblems({ document, tab }: Explorer, button: HTMLElement): void {
  let before: Tab = tab.value;
  document.subscribe((opened) => {
    const tells = hasProblems(opened);
    button.hidden = !tells;
    if (tells && tab.value !== 'problems') {
      before = tab.value;
      tab.value = 'problems';
    } else if (!tells && tab.value === 'problems') {
      tab.value = before;
    }
  });
}
