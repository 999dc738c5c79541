import type { ItemKind } from 'halfedge';
import type { Explorer } from '../app/explorer.js';
import { readingOf, rowsOf } from '../app/records.js';
import type { Signal } from '../app/signal.js';
import { h } from './dom.js';
import { RecordsGrid } from './records-grid.js';
import { type Segment, segments } from './segments.js';

const KINDS: readonly Segment<ItemKind>[] = [
  { value: 'vertex', content: ['Vertices'] },
  { value: 'halfedge', content: ['Halfedges'] },
  { value: 'edge', content: ['Edges'] },
  { value: 'face', content: ['Faces'] },
];

/**
 * The arrays of the mesh as they are: a grid of links that lead from record to record, and of attributes. It
 * follows the selection and the player, and lights what is pointed at in the picture.
 */
export function recordsPanel(explorer: Explorer): HTMLElement {
  const grid = new RecordsGrid(explorer);
  const kinds = segments('records', { 'aria-label': 'Records of' }, KINDS, (chosen) => {
    show(chosen);
    grid.goTo(0);
  });
  const section = h(
    'section',
    { class: 'records', 'aria-labelledby': 'records-title' },
    h('h2', { id: 'records-title', class: 'visually-hidden' }, 'Records'),
    kinds.element,
    grid.element,
  );
  const isShown = () => explorer.tab.value === 'records';

  function show(kind: ItemKind): void {
    grid.show(kind);
    kinds.mark(grid.kind);
  }

  /** Goes where the player is, or else the selection: to its record, or the first of its two. */
  function follow(): void {
    const mesh = explorer.document.value?.mesh;
    if (!mesh || !isShown()) return;
    const { value: play } = explorer.walker.play;
    const { value: selected } = explorer.selected;
    grid.reading = readingOf(mesh, play);
    const { at } = grid.reading;
    if (at !== null && play?.position) {
      show('halfedge');
      grid.goTo(at);
    } else if (selected) {
      // An edge is two halfedges side by side, unless it is edges that are looked at.
      const isPair = selected.kind === 'edge' && grid.kind !== 'edge';
      const kind = isPair ? 'halfedge' : selected.kind;
      show(kind);
      grid.goTo(rowsOf(selected, kind)[0] ?? 0);
    } else {
      show(grid.kind);
      grid.reveal();
    }
  }

  for (const signal of [explorer.tab, explorer.document, explorer.selected, explorer.walker.play]) {
    (signal as Signal<unknown>).subscribe(follow);
  }
  explorer.editor.edit.subscribe(() => queueMicrotask(follow));
  explorer.hovered.subscribe(() => {
    if (isShown()) grid.render();
  });
  return section;
}
