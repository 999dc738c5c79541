import { h, icon } from './dom.js';

const KEYS: readonly [string[], string][] = [
  [['N', 'P', 'O'], 'walk to next, prev, opposite'],
  [['V', 'U'], 'walk to the to-vertex, from-vertex'],
  [['E', 'F', 'H'], 'walk to the edge, the face, a halfedge'],
  [['Space'], 'play or pause the circulator'],
  [[',', '.'], 'step back, step forward'],
  [['Home', 'End'], 'to the start of the lap, to its end'],
  [['C'], 'change the direction'],
  [['Z', '0'], 'zoom to the selection, to the mesh'],
  [['←', '→', '↑', '↓'], 'orbit'],
  [['+', '−'], 'zoom'],
  [['Y'], 'y or z points up'],
  [['K'], 'draw the links (1)–(7) of the selected item as arrows'],
  [['L'], 'names of items: at the selection, at the pointer, of all, none'],
  [['G'], 'go to an item by name'],
  [['⇧ F', '⇧ S', '…'], 'flip, split, …: operations as the Edit panel lists them'],
  [['Del'], 'delete the selected vertex, edge or face'],
  [['Ctrl Z', 'Ctrl Y'], 'undo, redo'],
  [['Ctrl V'], 'open the mesh that was copied: a file, its text or a link'],
  [['R'], 'show the original file, or the repaired mesh'],
  [['1', '…', '5'], 'show the circulator, the operations, the mesh, its records, the problems'],
  [['Esc'], 'close, or select nothing'],
];

/** The list of keys. */
export function helpDialog(): HTMLDialogElement {
  const dialog = h(
    'dialog',
    { class: 'help card', 'aria-labelledby': 'help-title' },
    h(
      'header',
      {},
      h('h2', { id: 'help-title' }, 'Keys'),
      h(
        'button',
        {
          type: 'button',
          class: 'button square quiet',
          'aria-label': 'Close',
          onclick: () => dialog.close(),
        },
        icon('close'),
      ),
    ),
    h('dl', {}),
  );
  const list = dialog.querySelector('dl') as HTMLElement;
  for (const [keys, text] of KEYS) {
    const caps = keys.map((key) => h('kbd', { class: 'kbd' }, key));
    list.append(h('dt', {}, ...caps), h('dd', {}, text));
  }
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) dialog.close();
  });
  return dialog;
}
