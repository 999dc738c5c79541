import type { Offer } from '../app/editor.js';
import type { Explorer } from '../app/explorer.js';
import { fill, h, icon } from './dom.js';
import { itemTitle } from './inspector.js';

/** The operations on the selected item and on the whole mesh. */
export function editPanel(explorer: Explorer): HTMLElement {
  const title = h('h2', { id: 'edit-title', class: 'caption', tabindex: -1 });
  const onItem = h('ul', { class: 'operations', 'aria-labelledby': 'edit-title' });
  const onMesh = h('ul', { class: 'operations', 'aria-labelledby': 'edit-mesh-title' });
  const nothing = h('p', { class: 'empty' });
  const section = h(
    'section',
    { class: 'edit', 'aria-labelledby': 'edit-title' },
    title,
    onItem,
    nothing,
    h('h3', { id: 'edit-mesh-title', class: 'caption' }, 'Whole mesh'),
    onMesh,
  );
  explorer.editor.offers.subscribe((offers) => {
    const selected = explorer.selected.value;
    title.textContent = selected ? itemTitle(selected) : 'Selection';
    nothing.hidden = selected !== null;
    nothing.textContent = 'Pick a vertex, edge, halfedge or face to edit it.';
    keepFocus(section, title, () => {
      const buttons = (of: boolean) =>
        offers
          .filter(({ operation }) => (operation.on === 'mesh') === of)
          .map((offer) => h('li', {}, operationButton(explorer, offer)));
      fill(onItem, ...buttons(false));
      fill(onMesh, ...buttons(true));
    });
  });
  return section;
}

/** Rebuilds the buttons; the focus stays on the same operation, or goes to the title. */
function keepFocus(section: HTMLElement, title: HTMLElement, rebuild: () => void): void {
  const focused = document.activeElement;
  const had = focused instanceof HTMLElement && section.contains(focused);
  const same = had ? focused.dataset.operation : undefined;
  rebuild();
  if (!had || focused.isConnected) return;
  (section.querySelector<HTMLElement>(`[data-operation="${same}"]`) ?? title).focus();
}

function operationButton(explorer: Explorer, { operation, refusal }: Offer): HTMLElement {
  const { stem, label, meaning, key, second } = operation;
  const cap = key === 'Delete' ? 'Del' : `⇧${key}`;
  return h(
    'button',
    {
      type: 'button',
      'data-operation': stem,
      'data-refused': refusal?.code,
      'aria-keyshortcuts': key === 'Delete' ? key : `Shift+${key}`,
      title: refusal ? `Refused: ${refusal.message}` : `mesh.${stem}()`,
      onclick: () => explorer.editor.run(operation),
    },
    h('span', { class: 'name' }, second ? `${label} …` : label),
    h('span', { class: 'hint' }, meaning),
    refusal && h('span', { class: 'refused' }, icon('refused'), 'refused'),
    h('kbd', { class: 'kbd', 'aria-hidden': 'true' }, cap),
  );
}
