import { EXTENSIONS } from '../app/documents.js';
import type { Explorer } from '../app/explorer.js';
import { brokenSamples } from '../samples/broken.js';
import { samples } from '../samples/index.js';
import { fill, h, icon } from './dom.js';
import { openFiles } from './notices.js';
import type { Theme } from './theme.js';

/** Brand, the menu of meshes, the buttons for files and links, the theme and the list of keys. */
export function topBar(
  explorer: Explorer,
  theme: Theme,
  share: HTMLElement,
  openHelp: () => void,
): HTMLElement {
  const input = h('input', {
    type: 'file',
    // A glTF file comes with others.
    accept: [...EXTENSIONS.map((extension) => `.${extension}`), '.bin'].join(','),
    multiple: true,
    hidden: true,
    'data-file': true,
    'aria-label': 'Mesh file',
    onchange: () => {
      openFiles(explorer, input.files);
      input.value = '';
    },
  });
  const menu = meshMenu(explorer);
  const name = h('span', {}, '…');
  const menuButton = h(
    'button',
    { type: 'button', class: 'button quiet mesh-button', popovertarget: 'mesh-menu' },
    name,
    icon('chevron'),
  );
  explorer.document.subscribe((opened) => {
    name.textContent = opened?.name ?? 'Choose a mesh';
    menuButton.setAttribute(
      'aria-label',
      opened ? `${opened.name}: choose a mesh` : 'Choose a mesh',
    );
  });
  const themeButton = h('button', {
    type: 'button',
    class: 'button square card',
    onclick: () => theme.toggle(),
  });
  theme.current.subscribe((current) => {
    const label = current === 'dark' ? 'Switch to light theme' : 'Switch to dark theme';
    themeButton.setAttribute('aria-label', label);
    themeButton.title = label;
    fill(themeButton, icon(current === 'dark' ? 'sun' : 'moon'));
  });
  return h(
    'header',
    { class: 'top-bar' },
    h(
      'div',
      { class: 'start card' },
      h(
        'h1',
        { class: 'brand', 'aria-label': 'halfedge explorer' },
        brandMark(),
        h('b', {}, 'halfedge'),
        h('span', {}, 'explorer'),
      ),
      menuButton,
      menu,
      h(
        'button',
        {
          type: 'button',
          class: 'button quiet',
          'data-open': true,
          'aria-label': 'Open file',
          onclick: () => input.click(),
        },
        icon('open'),
        h('span', {}, 'Open file'),
      ),
      input,
    ),
    h(
      'div',
      { class: 'end' },
      share,
      themeButton,
      h(
        'button',
        {
          type: 'button',
          class: 'button square card wide',
          'aria-label': 'Keys',
          title: 'Keys (?)',
          onclick: openHelp,
        },
        icon('help'),
      ),
    ),
  );
}

function meshMenu(explorer: Explorer): HTMLElement {
  const menu = h('div', { id: 'mesh-menu', class: 'mesh-menu card', popover: 'auto' });
  const entry = (id: string) => {
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
  };
  const group = (title: string, ids: readonly string[]) => [h('h2', {}, title), ...ids.map(entry)];
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
    const anchor = document.querySelector('.mesh-button')?.getBoundingClientRect();
    if (!anchor || (event as ToggleEvent).newState !== 'open') return;
    menu.style.inset = `${anchor.bottom + 6}px auto auto ${anchor.left}px`;
  });
  return menu;
}

/** A halfedge and its opposite. */
function brandMark(): SVGSVGElement {
  const svg = icon('arrow');
  svg.setAttribute('viewBox', '0 0 32 32');
  svg.innerHTML =
    '<path d="M6 13h20l-6.5-6.5" stroke="var(--self)"/><path d="M26 19H6l6.5 6.5" stroke="var(--next)"/>';
  return svg;
}
