import type { Operation } from 'halfedge/teaching';
import type { Offer } from '../app/editor.js';
import type { Explorer } from '../app/explorer.js';
import { fill, h, icon } from './dom.js';
import { itemTitle } from './inspector.js';

/** The operations on the selected item and on the whole mesh. */
export function editPanel(explorer: Explorer): HTMLElement {
  const title = h('h2', { id: 'edit-title', class: 'caption', tabindex: -1 });
  const onItem = h('ul', { class: 'operations', 'aria-labelledby': 'edit-title' });
  const onMesh = h('ul', { class: 'operations', 'aria-labelledby': 'edit-mesh-title' });
  const repairs = h('ul', { class: 'operations', 'aria-labelledby': 'edit-repairs-title' });
  const report = h('p', { class: 'report' });
  const nothing = h('p', { class: 'empty' });
  const section = h(
    'section',
    { class: 'edit', 'aria-label': 'Operations' },
    title,
    onItem,
    nothing,
    h('h3', { id: 'edit-mesh-title', class: 'caption' }, 'Whole mesh'),
    onMesh,
    h('h3', { id: 'edit-repairs-title', class: 'caption' }, 'Repairs'),
    repairs,
    report,
  );
  // Screen readers hear it as the outcome of the step.
  explorer.editor.report.subscribe((text) => {
    report.textContent = text;
  });
  const tell = () => {
    nothing.textContent = emptyWords(explorer);
  };
  explorer.showsFile.subscribe(tell);
  explorer.editor.offers.subscribe((offers) => {
    const selected = explorer.selected.value;
    title.textContent = selected ? itemTitle(selected) : 'Selection';
    nothing.hidden = selected !== null;
    tell();
    keepFocus(section, title, () => {
      const buttons = (belongs: (operation: Operation) => boolean) =>
        offers
          .filter(({ operation }) => belongs(operation))
          .map((offer) => h('li', {}, operationButton(explorer, offer)));
      fill(onItem, ...buttons(({ on }) => on !== 'mesh'));
      fill(onMesh, ...buttons(({ on, reports }) => on === 'mesh' && !reports));
      fill(repairs, ...buttons(({ reports }) => reports === true));
    });
  });
  return section;
}

/** What to do while nothing is selected. */
function emptyWords(explorer: Explorer): string {
  if (explorer.showsFile.value) return 'Switch to Repaired (R) to edit the items of the mesh.';
  if (explorer.document.value?.mesh.vertexCount === 0) return 'There is nothing to edit.';
  return 'Pick a vertex, edge, halfedge or face to edit it.';
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
  const shortcut = key && key !== 'Delete' ? `Shift+${key}` : key;
  return h(
    'button',
    {
      type: 'button',
      'data-operation': stem,
      'data-refused': refusal?.code,
      'aria-keyshortcuts': shortcut,
      title: refusal ? `Refused: ${refusal.message}` : `mesh.${stem}()`,
      onclick: () => explorer.editor.run(operation),
    },
    h('span', { class: 'name' }, second ? `${label} …` : label),
    h('span', { class: 'hint' }, meaning),
    refusal && h('span', { class: 'refused' }, icon('refused'), 'refused'),
    key && h('kbd', { class: 'kbd', 'aria-hidden': 'true' }, key === 'Delete' ? 'Del' : `⇧${key}`),
  );
}
