import type { Explorer } from '../app/explorer.js';
import { grouped } from '../app/facts.js';
import { h } from './dom.js';

/** Over the picture: the file as it is, or the mesh that was made of it; and what the colours mean. */
export function pictureSwitch(explorer: Explorer): HTMLElement {
  const choices = h('div', {
    class: 'segments card',
    role: 'radiogroup',
    'aria-label': 'What the picture shows',
  });
  for (const [shows, text, title] of [
    [true, 'Original', 'The polygons as they stand in the file (R)'],
    [false, 'Repaired', 'The mesh that was made of them (R)'],
  ] as const) {
    const input = h('input', {
      type: 'radio',
      name: 'picture',
      value: text.toLowerCase(),
      onchange: () => explorer.showFile(shows),
    });
    explorer.showsFile.subscribe((current) => {
      input.checked = current === shows;
    });
    choices.append(h('label', { title }, input, text));
  }
  const state = h('p', { class: 'visually-hidden', role: 'status' });
  const legend = h('ul', { class: 'legend card', 'aria-label': 'Colours of the original' });
  const element = h(
    'div',
    { class: 'picture-switch', role: 'region', 'aria-label': 'Picture', hidden: true },
    choices,
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
