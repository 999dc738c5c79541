import type { Explorer } from '../app/explorer.js';
import { brokenSamples } from '../samples/broken.js';
import { samples } from '../samples/index.js';
import { h, icon } from './dom.js';

/** The button with the name of what is open, and the menu of samples that it opens. */
export function meshMenu(explorer: Explorer): HTMLElement[] {
  const name = h('span', {}, '…');
  const button = h(
    'button',
    { type: 'button', class: 'button quiet mesh-button', popovertarget: 'mesh-menu' },
    name,
    icon('chevron'),
  );
  explorer.document.subscribe((opened) => {
    name.textContent = opened?.name ?? 'Choose a mesh';
    button.setAttribute('aria-label', opened ? `${opened.name}: choose a mesh` : 'Choose a mesh');
  });
  return [button, menuBelow(button, explorer)];
}

function menuBelow(button: HTMLElement, explorer: Explorer): HTMLElement {
  const menu = h('div', { id: 'mesh-menu', class: 'mesh-menu card', popover: 'auto' });
  const group = (title: string, ids: readonly string[]) => [
    h('h2', {}, title),
    ...ids.map((id) => entry(id, menu, explorer)),
  ];
  menu.append(
    ...group('Models', ['bunny', 'suzanne']),
    ...group('Closed', ['icosahedron', 'icosphere', 'cube', 'torus', 'football', 'star']),
    ...group('With a boundary', ['grid', 'annulus', 'pinched']),
    ...group(
      'Broken files, repaired',
      brokenSamples.map(({ id }) => id),
    ),
  );
  menu.addEventListener('beforetoggle', (event) => {
    if ((event as ToggleEvent).newState !== 'open') return;
    const { bottom, left } = button.getBoundingClientRect();
    menu.style.inset = `${bottom + 6}px auto auto ${left}px`;
  });
  return menu;
}

function entry(id: string, menu: HTMLElement, explorer: Explorer): HTMLElement {
  const good = samples.find((candidate) => candidate.id === id);
  const sample = good ?? brokenSamples.find((candidate) => candidate.id === id);
  if (!sample) throw new Error(`There is no sample ${id}.`);
  const button = h(
    'button',
    {
      type: 'button',
      [good ? 'data-sample' : 'data-broken']: id,
      onclick: (event) => {
        menu.hidePopover();
        // The menu hands the focus back to its button: right for the keyboard, odd for a mouse.
        const byMouse = (event as MouseEvent).detail > 0;
        if (byMouse) (document.activeElement as HTMLElement | null)?.blur();
        void explorer.open(sample);
      },
    },
    h('b', {}, sample.name),
    h('small', {}, sample.note),
  );
  explorer.document.subscribe((opened) => {
    button.setAttribute('aria-current', String(opened?.sample === id));
  });
  return button;
}
