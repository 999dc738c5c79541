import type { Explorer } from '../app/explorer.js';
import type { Signal } from '../app/signal.js';
import { appearance } from './appear.js';
import { h, icon } from './dom.js';

/** The sentence about a file that could not be opened. */
export function failureNotice(explorer: Explorer): HTMLElement {
  const { notice, tell } = noticeCard(() => {
    explorer.failure.value = null;
  });
  const appear = appearance(notice);
  explorer.failure.subscribe((failure) => {
    appear(failure !== null);
    if (!failure) return;
    const shown = explorer.document.value?.name;
    const { lesson, advice } = failure;
    const others = advice ? null : 'Choose another mesh above.';
    const still = shown ? `The view shows ${shown}.` : others;
    const calm = [lesson, advice, still].filter(Boolean).join(' ');
    tell(failure.title, failure.message, calm);
  });
  return notice;
}

/** Says why the page can't be shown: it has the window to itself. */
export function startFailure(title: string, message: string, advice: string): HTMLElement {
  const { notice, tell } = noticeCard(null);
  tell(title, message, advice);
  notice.hidden = false;
  return notice;
}

/** `dismiss` hides it; null: it stays. */
function noticeCard(dismiss: (() => void) | null) {
  const title = h('h2');
  const message = h('p', { 'data-message': true });
  const calm = h('p', { class: 'calm' });
  const notice = h(
    'div',
    { class: 'notice card', role: 'alert', hidden: true },
    icon('warning'),
    title,
    message,
    calm,
    dismiss &&
      h(
        'button',
        {
          type: 'button',
          class: 'button square quiet',
          'aria-label': 'Dismiss',
          onclick: dismiss,
        },
        icon('close'),
      ),
  );
  const tell = (...texts: [string, string, string]) => {
    [title, message, calm].forEach((part, i) => {
      part.textContent = texts[i];
    });
  };
  return { notice, tell };
}

const STAGES = { read: 'Reading', repair: 'Repairing', build: 'Building' } as const;

/** What is being opened, how far it is, and a button that gives it up. */
export function busyNotice(explorer: Explorer): HTMLElement {
  const text = h('span', { role: 'status' });
  const bar = h('progress', { max: 1, 'aria-label': 'How much of it is done', hidden: true });
  const cancel = h(
    'button',
    { type: 'button', class: 'button', 'data-cancel': true, onclick: () => explorer.cancel() },
    'Cancel',
  );
  const notice = h('div', { class: 'busy card', hidden: true }, text, cancel, bar);
  explorer.busy.subscribe((name) => {
    notice.hidden = name === null;
    text.textContent = name === null ? '' : `Opening ${name} …`;
  });
  explorer.progress.subscribe((progress) => {
    bar.hidden = progress === null;
    if (!progress) return;
    text.textContent = `${STAGES[progress.stage]} ${explorer.busy.value} …`;
    bar.value = progress.fraction;
  });
  return notice;
}

/** Why there are no names in the picture, where all are asked for and no face is large enough. */
export function namesHint(lacksRoom: Signal<boolean>): HTMLElement {
  const hint = h('div', { class: 'names-hint card', role: 'status' });
  lacksRoom.subscribe((lacks) => {
    hint.textContent = lacks ? 'Zoom in to read the names' : '';
  });
  return hint;
}

/** How long it is shown which meshes were passed over. */
const SHOWN_MS = 8000;

/** Says that of several meshes which were chosen together one was opened. */
export function passedOverNotice(explorer: Explorer): HTMLElement {
  const notice = h('div', {
    class: 'toast card',
    role: 'status',
    'data-passed-over': true,
    hidden: true,
  });
  const appear = appearance(notice);
  explorer.passedOver.subscribe(([first, ...others]) => {
    if (first === undefined) return appear(false);
    const { length } = others;
    const more = length > 0 ? ` and ${length} other ${length > 1 ? 'meshes' : 'mesh'}` : '';
    const verb = length > 0 ? 'were' : 'was';
    notice.textContent = `${first}${more} ${verb} not opened: the page shows one mesh at a time.`;
    appear(true, SHOWN_MS);
  });
  return notice;
}
