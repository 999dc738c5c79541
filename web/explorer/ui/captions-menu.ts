import type { ItemKind } from 'halfedge';
import { LABEL_KINDS, LABEL_SCOPES, type LabelScope, withKind } from '../app/captions.js';
import type { Explorer } from '../app/explorer.js';
import { h, icon } from './dom.js';
import { segments } from './segments.js';

const SCOPES: Record<LabelScope, string> = {
  off: 'Off',
  selection: 'Selection',
  pointer: 'Pointer',
  all: 'All',
};
const KINDS: Record<ItemKind, string> = {
  vertex: 'Vertices',
  edge: 'Edges',
  halfedge: 'Halfedges',
  face: 'Faces',
};

/** A button with a menu: which items have their names in the picture, and the links as arrows. */
export function captionsButton(explorer: Explorer): HTMLElement {
  const menu = h(
    'div',
    { id: 'captions-menu', class: 'captions-menu card', popover: 'auto' },
    h('h2', { id: 'captions-title' }, 'Names of items'),
    scopes(explorer),
    kinds(explorer),
    h('hr', {}),
    pointers(explorer),
  );
  const button = h(
    'button',
    {
      type: 'button',
      class: 'button square card',
      popovertarget: 'captions-menu',
      'aria-label': 'Names and links in the picture',
      title: 'Names and links in the picture (L, K)',
    },
    icon('tag'),
  );
  menu.addEventListener('beforetoggle', (event) => {
    if ((event as ToggleEvent).newState !== 'open') return;
    const { left, top } = button.getBoundingClientRect();
    const start = Math.max(8, Math.min(left, window.innerWidth - 300));
    menu.style.inset = `auto auto ${window.innerHeight - top + 8}px ${start}px`;
  });
  return h('div', { class: 'captions' }, button, menu);
}

function scopes(explorer: Explorer): HTMLElement {
  const choices = segments(
    'label-scope',
    { 'aria-labelledby': 'captions-title' },
    LABEL_SCOPES.map((value) => ({ value, content: [SCOPES[value]] })),
    (scope) => {
      explorer.labels.value = { ...explorer.labels.value, scope };
    },
  );
  explorer.labels.subscribe(({ scope }) => choices.mark(scope));
  return choices.element;
}

function kinds(explorer: Explorer): HTMLElement {
  const inputs = LABEL_KINDS.map((kind) => {
    const input = h('input', {
      type: 'checkbox',
      name: 'label-kind',
      value: kind,
      onchange: () => {
        explorer.labels.value = withKind(explorer.labels.value, kind, input.checked);
      },
    });
    return input;
  });
  explorer.labels.subscribe(({ scope, kinds: chosen }) => {
    LABEL_KINDS.forEach((kind, i) => {
      inputs[i].checked = chosen.includes(kind);
      inputs[i].disabled = scope === 'off';
    });
  });
  return h(
    'div',
    { class: 'checks', role: 'group', 'aria-label': 'Kinds of items' },
    ...LABEL_KINDS.map((kind, i) => h('label', {}, inputs[i], KINDS[kind])),
  );
}

function pointers(explorer: Explorer): HTMLElement {
  const input = h('input', {
    type: 'checkbox',
    name: 'pointers',
    onchange: () => {
      explorer.pointers.value = input.checked;
    },
  });
  explorer.pointers.subscribe((shown) => {
    input.checked = shown;
  });
  return h(
    'div',
    { class: 'checks' },
    h('label', {}, input, 'Links (1)–(7) of the selected item as arrows'),
  );
}
