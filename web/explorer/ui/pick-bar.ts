import { factsOf, itemName } from 'halfedge/teaching';
import type { PickMode } from 'halfedge/three/picking';
import type { Explorer } from '../app/explorer.js';
import { captionsButton } from './captions-menu.js';
import { fill, h, icon } from './dom.js';
import { type Segment, segments } from './segments.js';

const MODES: readonly Segment<PickMode>[] = [
  { value: 'auto', content: ['Auto'], title: 'Pick whatever is nearest' },
  { value: 'vertex', content: ['Vertex'], title: 'Pick vertices' },
  { value: 'edge', content: ['Edge'], title: 'Pick edges' },
  { value: 'halfedge', content: ['Halfedge'], title: 'Pick halfedges' },
  { value: 'face', content: ['Face'], title: 'Pick faces' },
];

/** What the pointer picks, a button that flies to the selection, and what is under the pointer. */
export function pickBar(explorer: Explorer, focus: () => void): HTMLElement {
  const modes = segments(
    'pick-mode',
    { class: 'segments card', 'aria-label': 'What to pick' },
    MODES,
    (mode) => {
      explorer.pickMode.value = mode;
    },
  );
  explorer.pickMode.subscribe((mode) => modes.mark(mode));
  // Of the file as it was nothing can be picked.
  explorer.showsFile.subscribe((shows) => modes.disable(shows));
  const readout = h('p', { class: 'readout card' });
  explorer.hovered.subscribe((item) => {
    const mesh = explorer.document.value?.mesh;
    if (!item || !mesh) return fill(readout);
    fill(readout, h('b', {}, itemName(item)), ` ${[item.kind, ...factsOf(mesh, item)].join(', ')}`);
  });
  return h(
    'div',
    { class: 'pick-bar', role: 'region', 'aria-label': 'Picking' },
    modes.element,
    h(
      'button',
      {
        type: 'button',
        class: 'button square card',
        'aria-label': 'Zoom to the selection',
        title: 'Zoom to the selection (Z)',
        onclick: focus,
      },
      icon('focus'),
    ),
    captionsButton(explorer),
    readout,
  );
}
