import { itemName, sameItem } from 'halfedge/teaching';
import type { Explorer } from '../app/explorer.js';
import { appearance, focusPicture } from './appear.js';
import { fill, h, icon } from './dom.js';

/** The sentence of a refusal, and the items that show why, which are lit in the picture. */
export function refusalNotice(explorer: Explorer): HTMLElement {
  const { editor } = explorer;
  const title = h('h2');
  const message = h('p', { 'data-message': true });
  const witness = h('div', { class: 'witness', role: 'group', 'aria-label': 'Why' });
  const notice = h(
    'div',
    { class: 'notice edit-notice refusal card', role: 'alert', hidden: true },
    icon('refused'),
    title,
    message,
    witness,
    dismissButton(() => editor.cancel()),
  );
  const appear = appearance(notice);
  editor.refused.subscribe((refused) => {
    appear(refused !== null);
    if (!refused) return;
    title.textContent = `Refused: ${refused.title}`;
    message.textContent = refused.refusal.message;
    fill(
      witness,
      refused.witness.length > 0 && h('span', {}, 'Lit in the picture:'),
      ...refused.witness.map((item) =>
        h(
          'button',
          {
            type: 'button',
            'data-item': itemName(item),
            title: `Select this ${item.kind}`,
            onclick: () => editor.selectWitness(item),
          },
          itemName(item),
        ),
      ),
    );
  });
  return notice;
}

/** Asks for the second item of an operation that takes two. */
export function pendingNotice(explorer: Explorer): HTMLElement {
  const { editor } = explorer;
  const title = h('h2');
  const message = h('p');
  const confirm = h(
    'button',
    {
      type: 'button',
      class: 'button',
      onclick: () => {
        const { value: selected } = explorer.selected;
        if (selected) editor.complete(selected);
      },
    },
    'Take the selected one',
  );
  const notice = h(
    'div',
    { class: 'notice edit-notice pending card', role: 'status', hidden: true },
    icon('target'),
    title,
    message,
    h('div', { class: 'witness' }, confirm),
    dismissButton(() => editor.cancel()),
  );
  const appear = appearance(notice);
  const show = () => {
    const pending = editor.pending.value;
    appear(pending !== null);
    if (!pending) return;
    const { operation, first } = pending;
    title.textContent = `${operation.label}: from ${itemName(first)} to …`;
    message.textContent = `Pick ${operation.second?.ask}, or walk to it and press Enter.`;
    const { value: selected } = explorer.selected;
    const usable = selected?.kind === operation.second?.kind && !sameItem(selected, first);
    confirm.disabled = !usable;
    confirm.textContent = usable ? `Take ${itemName(selected)}` : `Take the selected one`;
  };
  editor.pending.subscribe((pending) => {
    show();
    // From the button of the operation, Enter would begin it again instead of taking the second item.
    if (pending && document.activeElement?.closest('[data-operation]')) focusPicture();
  });
  explorer.selected.subscribe(show);
  return notice;
}

function dismissButton(dismiss: () => void): HTMLElement {
  return h(
    'button',
    {
      type: 'button',
      class: 'button square quiet dismiss',
      'aria-label': 'Dismiss',
      title: 'Dismiss (Esc)',
      onclick: dismiss,
    },
    icon('close'),
  );
}
