import {
  dialectOf,
  factsOf,
  type Item,
  itemName,
  type Link,
  linksOf,
  parseItemName,
} from 'halfedge/teaching';
import type { Explorer } from '../app/explorer.js';
import { attributesOf, type ShownAttribute } from '../app/item-attributes.js';
import { measuresOf } from '../app/item-measures.js';
import { fill, h } from './dom.js';

const TITLES = { vertex: 'Vertex', halfedge: 'Halfedge', edge: 'Edge', face: 'Face' } as const;

/** `Vertex 12`. */
export function itemTitle({ kind, index }: Item): string {
  return `${TITLES[kind]} ${index}`;
}

/**
 * The selected item: what it is, its links as buttons that walk, its attributes, and what can be measured at it.
 */
export function inspector(explorer: Explorer, bringIntoSight: (item: Item) => void): HTMLElement {
  const title = h('h2', { id: 'inspector-title', tabindex: -1 });
  const facts = h('p', { class: 'facts' });
  const links = h('ul', { class: 'links', 'aria-label': 'Links' });
  const attributes = h('dl', { class: 'attributes', 'aria-label': 'Attributes and measures' });
  const remark = h('p', { class: 'remark', role: 'status' });
  explorer.remark.subscribe((text) => {
    remark.textContent = text;
  });
  const show = () => {
    const selected = explorer.selected.value;
    const mesh = explorer.document.value?.mesh;
    if (!selected || !mesh) {
      title.textContent = 'Nothing selected';
      fill(facts, emptyWords(explorer));
      keepFocus(links, title, () => fill(links));
      fill(attributes);
      return;
    }
    title.textContent = itemTitle(selected);
    fill(facts, ...factsOf(mesh, selected).flatMap((text) => [fact(text), ' ']));
    // A button that goes tells of no mouse that leaves it.
    if (links.matches(':hover')) explorer.hovered.value = null;
    keepFocus(links, title, () =>
      fill(links, ...linksOf(mesh, selected).map((link) => linkButton(explorer, link))),
    );
    const names = explorer.document.value?.names ?? {};
    const listed = [...attributesOf(mesh, selected, names), ...measuresOf(mesh, selected)];
    fill(attributes, ...listed.map(attributeLine));
  };
  explorer.walker.dialect.subscribe(show);
  explorer.document.subscribe(show);
  explorer.selected.subscribe(show);
  explorer.showsFile.subscribe(show);
  return h(
    'section',
    { class: 'inspector', 'aria-labelledby': 'inspector-title' },
    h('div', { class: 'item-head' }, title, goTo(explorer, bringIntoSight), facts),
    links,
    attributes,
    remark,
  );
}

/**
 * Rebuilds the links; the focus stays at the same place in the list. Where that is gone or leads nowhere, which no
 * focus can be on, it goes to the title.
 */
function keepFocus(links: HTMLElement, title: HTMLElement, rebuild: () => void): void {
  const buttons = () => [...links.querySelectorAll('button')];
  const focused = buttons().indexOf(document.activeElement as HTMLButtonElement);
  rebuild();
  if (focused < 0) return;
  const same = buttons()[focused];
  (same && !same.disabled ? same : title).focus();
}

/** What to do while nothing is selected. */
function emptyWords(explorer: Explorer): string {
  if (explorer.showsFile.value)
    return 'This is the file as it was: switch to Repaired (R) to pick.';
  if (explorer.document.value?.mesh.vertexCount === 0) return 'There is nothing to pick.';
  return 'Pick a vertex, edge, halfedge or face.';
}

function fact(text: string): HTMLElement {
  const marked = text === 'boundary' || text === 'pinched' || text === 'at the boundary';
  return h('span', marked ? { class: 'on-boundary' } : {}, text);
}

function attributeLine({ name, type, text }: ShownAttribute): HTMLElement {
  return h(
    'div',
    { 'data-attribute': name },
    h('dt', { title: `${name}: ${type}` }, name),
    h('dd', { title: text, translate: 'no' }, text),
  );
}

function linkButton(explorer: Explorer, { number, name, hint, target, key, role }: Link) {
  const named = dialectOf(explorer.walker.dialect.value).links[name];
  const shown = named === undefined ? name : (named ?? '(has none)');
  return h(
    'li',
    {},
    h(
      'button',
      {
        type: 'button',
        'data-link': name,
        'data-target': itemName(target),
        'aria-keyshortcuts': key,
        title: hint,
        disabled: target === null,
        onclick: () => explorer.select(target),
        onmouseenter: () => {
          explorer.hovered.value = target;
        },
        onmouseleave: () => {
          explorer.hovered.value = null;
        },
      },
      h('span', { class: `number role-${role}` }, number === undefined ? '' : String(number)),
      h('span', { class: named === null ? 'api nameless' : 'api', translate: 'no' }, shown),
      h('span', { class: 'hint' }, hint),
      h('span', { class: 'target', translate: 'no' }, itemName(target)),
      h('kbd', { class: 'kbd', 'aria-hidden': 'true' }, key),
    ),
  );
}

/** A field that takes the name of an item: `v12`, `face 3`. */
function goTo(explorer: Explorer, bringIntoSight: (item: Item) => void): HTMLElement {
  const input = h('input', {
    type: 'text',
    name: 'item',
    placeholder: 'Go to v12',
    'aria-label': 'Go to an item, such as v12, h31, e15 or f7',
    autocomplete: 'off',
    spellcheck: 'false',
    enterkeyhint: 'go',
    onkeydown: (event) => {
      if ((event as KeyboardEvent).key !== 'Escape') return;
      event.stopPropagation(); // the selection stays
      input.value = '';
      input.blur();
    },
  });
  // What was refused doesn't stay beside an item that was chosen in another way.
  explorer.selected.subscribe(() => {
    input.value = '';
  });
  return h(
    'form',
    {
      class: 'goto',
      onsubmit: (event) => {
        event.preventDefault();
        const item = parseItemName(input.value);
        if (!item) {
          explorer.remark.value = `“${input.value}” is no item: write a letter and a number, such as v12, h31, e15 or f7.`;
          return;
        }
        explorer.select(item);
        if (explorer.remark.value !== '') return;
        input.value = '';
        input.blur(); // the next keys walk from there; Tab goes on behind the field
        bringIntoSight(item);
      },
    },
    input,
  );
}
