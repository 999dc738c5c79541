import type { Explorer } from '../app/explorer.js';
import { circulatorPanel } from './circulator-panel.js';
import { h } from './dom.js';
import { inspector } from './inspector.js';
import { meshPanel } from './mesh-panel.js';

const TABS = { inspect: 'Inspect', circulate: 'Circulate', mesh: 'Mesh' } as const;
const SHEETS = ['low', 'half', 'tall'] as const;

/**
 * Inspector, circulator and mesh, one below the other; in narrow windows a sheet at the bottom
 * that shows one of them at a time and can be pulled up or down.
 */
export function panel(explorer: Explorer): HTMLElement {
  const tab = (id: keyof typeof TABS) =>
    h('button', { type: 'button', 'data-tab-button': id, onclick: () => choose(id) }, TABS[id]);
  const tabs = h('nav', { class: 'tabs', 'aria-label': 'Panel' });
  const element = h(
    'aside',
    { class: 'panel card', 'aria-label': 'Panel', 'data-sheet': 'half' },
    grip(),
    tabs,
    h(
      'div',
      { class: 'sections' },
      inspector(explorer),
      circulatorPanel(explorer),
      meshPanel(explorer),
    ),
  );
  tabs.append(tab('inspect'), tab('circulate'), tab('mesh'));
  const choose = (id: keyof typeof TABS) => {
    element.dataset.tab = id;
    for (const button of tabs.querySelectorAll('button')) {
      button.setAttribute('aria-current', String(button.dataset.tabButton === id));
    }
    if (element.dataset.sheet === 'low') element.dataset.sheet = 'half';
  };
  choose('circulate');

  function grip(): HTMLElement {
    let from: number | null = null;
    const move = (by: 1 | -1) => {
      const at = SHEETS.indexOf(element.dataset.sheet as (typeof SHEETS)[number]);
      element.dataset.sheet = SHEETS[Math.max(0, Math.min(SHEETS.length - 1, at + by))];
    };
    return h('button', {
      type: 'button',
      class: 'grip',
      'aria-label': 'Resize the panel',
      onpointerdown: (event) => {
        from = (event as PointerEvent).clientY;
        (event.currentTarget as HTMLElement).setPointerCapture((event as PointerEvent).pointerId);
      },
      onpointerup: (event) => {
        const by = (from ?? 0) - (event as PointerEvent).clientY;
        from = null;
        if (Math.abs(by) > 12) move(by > 0 ? 1 : -1);
        else element.dataset.sheet = element.dataset.sheet === 'half' ? 'tall' : 'half';
      },
      onkeydown: (event) => {
        const { key } = event as KeyboardEvent;
        if (key === 'ArrowUp') move(1);
        else if (key === 'ArrowDown') move(-1);
      },
    });
  }
  return element;
}
