import type { FileFormat } from 'halfedge';
import type { MeshDocument } from '../app/documents.js';
import type { Explorer } from '../app/explorer.js';
import { fileName, fileOf, type MeshFile, sizeWords } from '../app/files.js';
import { h, icon } from './dom.js';

const FORMATS: readonly [FileFormat, string][] = [
  ['obj', 'Wavefront OBJ, text'],
  ['ply', 'PLY, binary'],
  ['off', 'Geomview OFF, text'],
  ['stl', 'STL, binary: triangles only'],
];

const PICTURES: readonly ['png' | 'svg', string][] = [
  ['png', 'The picture as pixels'],
  ['svg', 'The picture with arrows as paths and labels as text'],
];

/** Makes a file of the picture. */
export type TakePicture = (format: 'png' | 'svg') => Promise<Blob>;

/** Buttons that hand the mesh on show, or its picture, to the browser as a file. */
export function downloads(explorer: Explorer, takePicture: TakePicture): HTMLElement {
  const outcome = h('p', { class: 'outcome', role: 'status' });
  // What is left out of a file is told at the end of the panel, which may be out of sight.
  const tell = (words: string) => {
    outcome.textContent = words;
    outcome.scrollIntoView({ block: 'nearest' });
  };
  const handOver = ({ name, content, notes }: MeshFile) => {
    offer(name, content);
    tell([`Saved ${name}, ${sizeWords(content.size)}.`, ...notes].join(' '));
  };
  const save = async (act: (opened: MeshDocument) => void | Promise<void>) => {
    const opened = explorer.document.value;
    if (!opened) return;
    try {
      await act(opened);
    } catch (error) {
      tell(`Not saved: ${error instanceof Error ? error.message : error}`);
    }
  };
  const saveMesh = (format: FileFormat) =>
    save((opened) => {
      handOver(fileOf(opened, format));
      explorer.editor.markSaved();
    });
  const savePicture = (format: 'png' | 'svg') =>
    save(async (opened) => {
      const content = await takePicture(format);
      handOver({ name: fileName(opened, format), content, notes: [] });
    });
  const button = (format: string, title: string, act: () => void) =>
    h(
      'button',
      {
        type: 'button',
        class: 'button',
        title,
        'data-download': format,
        'aria-label': `Download as ${format.toUpperCase()}`,
        onclick: act,
      },
      format.toUpperCase(),
    );
  const buttons = FORMATS.map(([format, title]) =>
    button(format, title, () => void saveMesh(format)),
  );
  const pictures = PICTURES.map(([format, title]) =>
    button(format, title, () => void savePicture(format)),
  );
  const label = h('span', { class: 'caption' }, icon('download'), 'Download');
  explorer.document.subscribe((opened) => {
    outcome.textContent = '';
    const isRepaired = opened?.diagnosis?.isRepaired;
    label.lastChild?.replaceWith(isRepaired ? 'Download repaired' : 'Download');
  });
  return h(
    'div',
    { class: 'downloads' },
    label,
    h('div', { role: 'group', 'aria-label': 'Download the mesh' }, ...buttons),
    h('span', { class: 'caption' }, 'Picture'),
    h('div', { role: 'group', 'aria-label': 'Download the picture' }, ...pictures),
    outcome,
  );
}

/** Lets the browser save it, as a click on a link would. */
function offer(name: string, content: Blob): void {
  const url = URL.createObjectURL(content);
  h('a', { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}
