import type { Explorer } from '../app/explorer.js';
import { appearance, hideByEscape } from './appear.js';
import { h, icon } from './dom.js';

/** How long it is shown. */
const SHOWN_MS = 8000;

/** Says that the mesh which was on show has edits that no file has, and leads back to them. */
export function leftNotice(explorer: Explorer): HTMLElement {
  const { editor } = explorer;
  const said = h('p');
  const notice = h(
    'div',
    { class: 'toast card', role: 'status', 'data-left': true, hidden: true },
    said,
    h(
      'button',
      { type: 'button', class: 'button', onclick: () => editor.undo() },
      icon('undo'),
      'Back to it',
    ),
  );
  const appear = appearance(notice);
  hideByEscape(notice, () => appear(false));
  editor.left.subscribe((name) => {
    if (name === null) return appear(false);
    said.textContent = `${name} has edits that were not saved. It stays.`;
    appear(true, SHOWN_MS);
  });
  return notice;
}
