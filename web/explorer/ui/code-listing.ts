import { type DialectId, dialects, queryCode } from 'halfedge/teaching';
import type { Explorer } from '../app/explorer.js';
import type { Play } from '../app/walker.js';
import { fill, h } from './dom.js';

const WORDS = /\b(function\*|const|let|do|while|if|return|yield)|(\/\/.*)$/g;

/** The code of the circulator, in the names of a library; what ran last is lit. */
export function codeListing(explorer: Explorer): HTMLElement {
  const call = h('code', {
    class: 'code',
    translate: 'no',
    'aria-label': 'Call of this circulator',
  });
  const listing = h('ol', { class: 'listing', 'aria-label': 'Code of this circulator' });
  let shown = '';
  explorer.walker.play.subscribe((play) => {
    if (!play) return;
    const [name, parameters] = queryCode(play.player.query).split(/(?<=\()/);
    fill(call, name, h('wbr'), parameters);
    const { lines } = play.player.program;
    if (shown !== lines.join('\n')) {
      shown = lines.join('\n');
      fill(listing, ...lines.map(line));
    }
    light(listing, play);
  });
  return h(
    'div',
    { class: 'code-box' },
    h('div', { class: 'code-head' }, call, names(explorer)),
    // Long lines scroll, also by keys.
    h(
      'div',
      { class: 'listing-box', translate: 'no', tabindex: 0, role: 'group', 'aria-label': 'Code' },
      listing,
    ),
  );
}

/** The line that yielded what is shown, and those that ran before it. */
function light(listing: HTMLElement, { player }: Play): void {
  const ran = player.current?.ran ?? [];
  [...listing.children].forEach((element, i) => {
    element.classList.toggle('ran', ran.includes(i));
    if (i === ran.at(-1)) element.setAttribute('aria-current', 'step');
    else element.removeAttribute('aria-current');
  });
}

function line(text: string): HTMLElement {
  const parts: (string | HTMLElement)[] = [];
  let from = 0;
  for (const match of text.matchAll(WORDS)) {
    const look = match[2] ? 'comment' : 'keyword';
    parts.push(text.slice(from, match.index), h('span', { class: look }, match[0]));
    from = match.index + match[0].length;
  }
  return h('li', {}, h('code', {}, ...parts, text.slice(from)));
}

/** Whose names the code has. */
function names(explorer: Explorer): HTMLElement {
  const select = h(
    'select',
    {
      class: 'dialect',
      translate: 'no',
      name: 'dialect',
      'aria-label': 'Names of',
      title: 'Whose names code and links have',
      onchange: () => explorer.walker.setDialect(select.value as DialectId),
    },
    ...dialects.map(({ id, label }) => h('option', { value: id }, label)),
  );
  explorer.walker.dialect.subscribe((id) => {
    select.value = id;
  });
  return select;
}
