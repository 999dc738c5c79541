import type { Explorer } from '../app/explorer.js';
import { h } from './dom.js';

/** What the picture says of a mesh that has nothing in it. */
export function emptyState(explorer: Explorer): HTMLElement {
  const title = h('h2');
  const element = h(
    'div',
    { class: 'empty-state', role: 'status', hidden: true },
    title,
    h('p', {}, 'Choose another mesh above, open or drop a file, or paste the text of one.'),
  );
  const show = () => {
    const opened = explorer.document.value;
    element.hidden = opened?.mesh.vertexCount !== 0 || explorer.busy.value !== null;
    title.textContent = element.hidden ? '' : `${opened?.name} has no vertices`;
  };
  explorer.document.subscribe(show);
  explorer.facts.subscribe(show);
  explorer.busy.subscribe(show);
  return element;
}
