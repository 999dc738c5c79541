import type { Explorer } from '../app/explorer.js';
import { grouped } from '../app/facts.js';
import { h } from './dom.js';
import { type Segment, segments } from './segments.js';

const PICTURES: readonly Segment<'original' | 'repaired'>[] = [
  {
    value: 'original',
    content: ['Original'],
    title: 'The polygons as they stand in the file (R)',
  },
  { value: 'repaired', content: ['Repaired'], title: 'The mesh that was made of them (R)' },
];

/** Over the picture: the file as it is, or the mesh that was made of it; and what the colours mean. */
export function pictureSwitch(explorer: Explorer): HTMLElement {
  const choices = segments(
    'picture',
    { class: 'segments card', 'aria-label': 'What the picture shows' },
    PICTURES,
    (picture) => explorer.showFile(picture === 'original'),
  );
  explorer.showsFile.subscribe((shows) => choices.mark(shows ? 'original' : 'repaired'));
  const state = h('p', { class: 'visually-hidden', role: 'status' });
  const legend = h('ul', { class: 'legend card', 'aria-label': 'Colours of the original' });
  const element = h(
    'div',
    { class: 'picture-switch', role: 'region', 'aria-label': 'Picture', hidden: true },
    choices.element,
    legend,
    state,
  );
  const show = () => {
    const opened = explorer.document.value;
    const diagnosis = opened?.diagnosis;
    element.hidden = !diagnosis;
    if (!diagnosis || !opened) {
      state.textContent = '';
      return;
    }
    const { value: showsFile } = explorer.showsFile;
    const fates = LEGEND.filter(([fate]) =>
      diagnosis.findings.some((found) => found.fate === fate),
    );
    legend.replaceChildren(
      ...fates.map(([fate, text]) =>
        h('li', {}, h('i', { class: `swatch ${fate}`, 'aria-hidden': 'true' }), text),
      ),
    );
    legend.hidden = !showsFile || fates.length === 0;
    const faces = showsFile ? diagnosis.soup.faces.sizes.length : opened.mesh.faceCount;
    const what = showsFile ? 'The original file' : 'The repaired mesh';
    state.textContent = `${what} is shown: ${grouped(faces)} ${faces === 1 ? 'face' : 'faces'}.`;
  };
  explorer.document.subscribe(show);
  explorer.showsFile.subscribe(show);
  return element;
}

const LEGEND = [
  ['dropped', 'left out'],
  ['turned', 'turned over'],
  ['cut', 'cut or doubled'],
  ['mended', 'simplified'],
] as const;
