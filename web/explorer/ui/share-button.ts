import type { Explorer } from '../app/explorer.js';
import { linkOf, type Sight } from '../app/share.js';
import { appearance, hideByEscape } from './appear.js';
import { h, icon } from './dom.js';

/** How long the outcome is shown. */
const SHOWN_MS = 6000;

/** What came of copying a link; the link itself, where it has to be copied by hand. */
interface Outcome {
  readonly text: string;
  readonly link: string | null;
}

/** A button that copies a link to the page as it is, and what came of it. */
export function shareButton(explorer: Explorer, sight: Sight) {
  const { outcome, tell, hide } = outcomeToast();
  const button = h(
    'button',
    {
      type: 'button',
      class: 'button square card',
      'data-share': true,
      'aria-label': 'Copy a link to this state',
      title: 'Copy a link to this state',
      onclick: () => void copyLink(explorer, sight).then(tell),
    },
    icon('link'),
  );
  // The link leads to the mesh that was on show; and what can't be opened is told in the same place.
  explorer.document.subscribe(hide);
  explorer.failure.subscribe(hide);
  hideByEscape(outcome, hide);
  return { button, outcome };
}

/** Puts the link into the address, and copies it where the browser lets the page. */
async function copyLink(explorer: Explorer, sight: Sight): Promise<Outcome> {
  const url = new URL(location.href);
  try {
    url.hash = linkOf(explorer, sight);
  } catch (error) {
    return { text: error instanceof Error ? error.message : String(error), link: null };
  }
  const { href: link } = url;
  history.replaceState(null, '', link);
  try {
    await navigator.clipboard.writeText(link);
  } catch {
    return { text: 'The browser did not let the page copy. Here is the link:', link };
  }
  return {
    text: 'Link copied: it leads to this mesh, selection, circulator and view.',
    link: null,
  };
}

function outcomeToast() {
  const said = h('p');
  const field = h('input', {
    type: 'text',
    readonly: true,
    hidden: true,
    'aria-label': 'Link to this state',
    onfocus: () => field.select(),
  });
  const dismiss = h(
    'button',
    {
      type: 'button',
      class: 'button square quiet',
      'aria-label': 'Dismiss',
      onclick: () => hide(),
    },
    icon('close'),
  );
  const outcome = h(
    'div',
    { class: 'toast card', role: 'status', 'data-toast': true, hidden: true },
    said,
    dismiss,
    field,
  );
  const appear = appearance(outcome);
  const hide = () => appear(false);
  const tell = ({ text, link }: Outcome) => {
    said.textContent = text;
    field.hidden = link === null;
    field.value = link ?? '';
    appear(true, link === null ? SHOWN_MS : undefined);
  };
  return { outcome, tell, hide };
}
