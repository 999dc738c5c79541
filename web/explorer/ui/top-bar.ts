import { EXTENSIONS } from '../app/documents.js';
import type { Explorer } from '../app/explorer.js';
import { fill, h, icon } from './dom.js';
import { meshMenu } from './mesh-menu.js';
import type { Theme } from './theme.js';
import { openFiles } from './ways-in.js';

/** Brand, the menu of meshes, the buttons for files and links, the theme and the list of keys. */
export function topBar(
  explorer: Explorer,
  theme: Theme,
  share: HTMLElement,
  openHelp: () => void,
): HTMLElement {
  return h(
    'header',
    { class: 'top-bar' },
    h('div', { class: 'start card' }, brand(), ...meshMenu(explorer), ...fileButton(explorer)),
    h('div', { class: 'end' }, share, themeButton(theme), keysButton(openHelp)),
  );
}

function brand(): HTMLElement {
  return h(
    'h1',
    { class: 'brand', 'aria-label': 'halfedge explorer' },
    brandMark(),
    h('b', {}, 'halfedge'),
    h('span', {}, 'explorer'),
  );
}

/** A halfedge and its opposite. */
function brandMark(): SVGSVGElement {
  const svg = icon('arrow');
  svg.setAttribute('viewBox', '0 0 32 32');
  svg.innerHTML =
    '<path d="M6 13h20l-6.5-6.5" stroke="var(--self)"/><path d="M26 19H6l6.5 6.5" stroke="var(--next)"/>';
  return svg;
}

/** The button that opens a file, and the field by which it asks for one. */
function fileButton(explorer: Explorer): HTMLElement[] {
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
  const button = h(
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
  );
  return [button, input];
}

function themeButton(theme: Theme): HTMLElement {
  const button = h('button', {
    type: 'button',
    class: 'button square card',
    onclick: () => theme.toggle(),
  });
  theme.current.subscribe((current) => {
    const label = current === 'dark' ? 'Switch to light theme' : 'Switch to dark theme';
    button.setAttribute('aria-label', label);
    button.title = label;
    fill(button, icon(current === 'dark' ? 'sun' : 'moon'));
  });
  return button;
}

function keysButton(openHelp: () => void): HTMLElement {
  return h(
    'button',
    {
      type: 'button',
      class: 'button square card wide',
      'aria-label': 'Keys',
      title: 'Keys (?)',
      onclick: openHelp,
    },
    icon('help'),
  );
}
