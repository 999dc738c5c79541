import type { FileFormat } from 'halfedge';
import type { Explorer } from '../app/explorer.js';
import { fileOf, sizeWords } from '../app/files.js';
import { h, icon } from './dom.js';

const FORMATS: readonly [FileFormat, string][] = [
  ['obj', 'Wavefront OBJ, text'],
  ['ply', 'PLY, binary'],
  ['off', 'Geomview OFF, text'],
  ['stl', 'STL, binary: triangles only'],
];

/** Buttons that hand the mesh on show to the browser as a file. */
export function downloads(explorer: Explorer): HTMLElement {
  const outcome = h('p', { class: 'outcome', role: 'status' });
  const save = (format: FileFormat) => {
    const opened = explorer.document.value;
    if (!opened) return;
    try {
      const { name, content, notes } = fileOf(opened, format);
      offer(name, content);
      outcome.textContent = [`Saved ${name}, ${sizeWords(content.size)}.`, ...notes].join(' ');
    } catch (error) {
      outcome.textContent = `Not saved: ${error instanceof Error ? error.message : error}`;
    }
  };
  const buttons = FORMATS.map(([format, title]) =>
    h(
      'button',
      {
        type: 'button',
        class: 'button',
        title,
        'data-download': format,
        'aria-label': `Download as ${format.toUpperCase()}`,
        onclick: () => save(format),
      },
      format.toUpperCase(),
    ),
  );
  explorer.document.subscribe(() => {
    outcome.textContent = '';
  });
  const label = h('span', { class: 'caption' }, icon('download'), 'Download');
  explorer.document.subscribe((opened) => {
    const isRepaired = opened?.diagnosis?.isRepaired;
    label.lastChild?.replaceWith(isRepaired ? 'Download repaired' : 'Download');
  });
  return h(
    'div',
    { class: 'downloads' },
    label,
    h('div', { role: 'group', 'aria-label': 'Download the mesh' }, ...buttons),
    outcome,
  );
}

/** Lets the browser save it, as a click on a link would. */
function offer(name: string, content: Blob): void {
  const url = URL.createObjectURL(content);
  h('a', { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}
