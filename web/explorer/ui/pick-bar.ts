import { factsOf, itemName } from 'halfedge/teaching';
import type { PickMode } from 'halfedge/three/picking';
import type { Explorer } from '../app/explorer.js';
import { captionsButton } from './captions-menu.js';
import { fill, h, icon } from './dom.js';

const MODES: readonly [PickMode, string, string][] = [
  ['auto', 'Auto', 'Pick whatever is nearest'],
  ['vertex', 'Vertex', 'Pick vertices'],
  ['edge', 'Edge', 'Pick edges'],
  ['halfedge', 'Halfedge', 'Pick halfedges'],
  ['face', 'Face', 'Pick faces'],
];

/** What the pointer picks, a button that flies to the selection, and what is under the pointer. */
export function pickBar(explorer: Explorer, focus: () => void): HTMLElement {
  const modes = h('div', {
    class: 'segments card',
    role: 'radiogroup',
    'aria-label': 'What to pick',
  });
  for (const [mode, text, title] of MODES) {
    const input = h('input', {
      type: 'radio',
      name: 'pick-mode',
      value: mode,
      onchange: () => {
        explorer.pickMode.value = mode;
      },
    });
    explorer.pickMode.subscribe((current) => {
      input.checked = current === mode;
    });
    // Of the file as it was nothing can be picked.
    explorer.showsFile.subscribe((shows) => {
      input.disabled = shows;
    });
    modes.append(h('label', { title }, input, text));
  }
  const readout = h('p', { class: 'readout card' });
  explorer.hovered.subscribe((item) => {
    const mesh = explorer.document.value?.mesh;
    if (!item || !mesh) return fill(readout);
    fill(readout, h('b', {}, itemName(item)), ` ${[item.kind, ...factsOf(mesh, item)].join(', ')}`);
  });
  return h(
    'div',
    { class: 'pick-bar', role: 'region', 'aria-label': 'Picking' },
    modes,
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
