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
  const hide = () => appear(false);
  hideByEscape(notice, hide);
  let hiding: ReturnType<typeof setTimeout> | undefined;
  editor.left.subscribe((name) => {
    clearTimeout(hiding);
    appear(name !== null);
    if (name === null) return;
    said.textContent = `${name} has edits that were not saved. It stays.`;
    hiding = setTimeout(hide, SHOWN_MS);
  });
  return notice;
}
