import { hasDirection, itemName } from 'halfedge/teaching';
import type { Explorer } from '../app/explorer.js';
import { type Play, SPEEDS } from '../app/walker.js';
import { codeListing } from './code-listing.js';
import { fill, h, type IconName, icon, setAttribute } from './dom.js';
import { segments } from './segments.js';

/** Longer laps are scrubbed, and list only their last visits. */
const LIST_CAP = 60;

/** Chooses a circulator and plays it. */
export function circulatorPanel(explorer: Explorer): HTMLElement {
  const kinds = h('div', { class: 'kinds' });
  const body = h('div', { class: 'circulator' });
  const nothing = h('p', { class: 'empty' });
  const section = h(
    'section',
    { 'aria-labelledby': 'circulator-title' },
    h('h2', { id: 'circulator-title', class: 'visually-hidden' }, 'Circulator'),
    nothing,
    body,
  );
  section.classList.add('circulator');
  const direction = directionControl(explorer);
  const { controls, visited } = player(explorer, direction);
  // What grows comes last, so that nothing else moves.
  body.append(kinds, ...controls, codeListing(explorer), visited);
  const show = () => {
    const choice = explorer.walker.choice.value;
    body.hidden = choice === null;
    nothing.hidden = choice !== null;
    if (!choice) return;
    const focused = (document.activeElement as HTMLInputElement | null)?.value;
    const inKinds = kinds.contains(document.activeElement);
    fill(kinds, ...kindControls(explorer));
    if (inKinds) kinds.querySelector<HTMLInputElement>(`input[value="${focused}"]`)?.focus();
    direction.hidden = !hasDirection(choice.circulator);
  };
  explorer.walker.choice.subscribe(show);
  const tell = () => {
    nothing.textContent = emptyWords(explorer);
  };
  explorer.document.subscribe(tell);
  explorer.showsFile.subscribe(tell);
  return section;
}

/** What to do while nothing is selected. */
function emptyWords(explorer: Explorer): string {
  if (explorer.showsFile.value)
    return 'Switch to Repaired (R) to walk around the items of the mesh.';
  if (explorer.document.value?.mesh.vertexCount === 0) return 'There is nothing to walk around.';
  return 'Pick an item to walk around it.';
}

/** Which item to go around, where there is a choice, and what to list there. */
function kindControls(explorer: Explorer): HTMLElement[] {
  const { value: groups } = explorer.walker.groups;
  const chosen = explorer.walker.choice.value;
  const group = groups[chosen?.group ?? 0];
  const around = segments(
    'around',
    { 'aria-label': 'Around' },
    groups.map(({ caption }, i) => ({ value: String(i), content: [caption] })),
    (i) =>
      explorer.walker.choose({ group: Number(i), circulator: groups[Number(i)].circulators[0] }),
  );
  const chips = segments(
    'circulator',
    { class: 'chips', 'aria-label': 'Circulator' },
    group.circulators.map(({ name, label }) => ({ value: name, content: [label] })),
    (name) => {
      const circulator = group.circulators.find((each) => each.name === name);
      if (circulator) explorer.walker.choose({ group: chosen?.group ?? 0, circulator });
    },
  );
  if (chosen) {
    around.mark(String(chosen.group));
    chips.mark(chosen.circulator.name);
  }
  if (groups.length === 1) return [h('p', { class: 'caption' }, group.caption), chips.element];
  return [around.element, ...(group.circulators.length > 1 ? [chips.element] : [])];
}

function directionControl(explorer: Explorer): HTMLElement {
  const choice = (value: 'ccw' | 'cw', label: string) => ({
    ...{ value, label, title: `${label} (C)` },
    content: [icon(value), value],
  });
  const choices = segments(
    'direction',
    { 'aria-label': 'Direction' },
    [choice('ccw', 'counter-clockwise'), choice('cw', 'clockwise')],
    (direction) => explorer.walker.setDirection(direction),
  );
  explorer.walker.direction.subscribe((direction) => choices.mark(direction));
  return choices.element;
}

/** The controls of the player, and the list of what was visited. */
function player(explorer: Explorer, direction: HTMLElement) {
  const hop = h('p', { class: 'hop', 'aria-live': 'polite' });
  explorer.walker.play.subscribe((play) => {
    if (!play) return;
    hop.classList.toggle('idle', play.position === 0);
    // A step is code; what is told before the first one is a sentence.
    setAttribute(hop, 'translate', play.position === 0 ? null : 'no');
    hop.textContent = play.position === 0 ? idleWords(play) : unbroken(play.player.words);
  });
  const controls = [
    h(
      'div',
      { class: 'transport', role: 'group', 'aria-label': 'Player' },
      transportButtons(explorer),
      direction,
    ),
    h('div', { class: 'scrub' }, ...scrubber(explorer), speed(explorer)),
    hop,
  ];
  return { controls, visited: visitedList(explorer) };
}

function transportButtons({ walker }: Explorer): HTMLElement {
  const restart = transportButton('restart', 'Back to the start', 'Home', () => walker.seek(0));
  const back = transportButton('back', 'Step back', ',', () => walker.step(-1));
  const toggle = transportButton('play', 'Play', 'space', () => walker.toggle());
  const forward = transportButton('forward', 'Step forward', '.', () => walker.step(1));
  toggle.classList.add('play');
  walker.play.subscribe((play) => {
    if (!play) return;
    const { position, playing, player } = play;
    setAttribute(toggle, 'aria-label', playing ? 'Pause' : 'Play');
    toggle.title = `${playing ? 'Pause' : 'Play'} (space)`;
    fill(toggle, icon(playing ? 'pause' : 'play'));
    toggle.disabled = player.count === 0;
    // For `aria` only: the button that led to an end keeps the focus there.
    setAttribute(forward, 'aria-disabled', player.done ? 'true' : null);
    for (const button of [back, restart]) {
      setAttribute(button, 'aria-disabled', position === 0 ? 'true' : null);
    }
  });
  return h('div', { class: 'buttons' }, restart, back, toggle, forward);
}

function transportButton(name: IconName, label: string, key: string, act: () => void) {
  return h(
    'button',
    {
      type: 'button',
      class: 'button square',
      'aria-label': label,
      title: `${label} (${key})`,
      onclick: act,
    },
    icon(name),
  );
}

/** A slider along the visits, and where it is in words. */
function scrubber({ walker }: Explorer): HTMLElement[] {
  const scrub = h('input', {
    type: 'range',
    min: 0,
    step: 1,
    'aria-label': 'Visited items',
    oninput: () => walker.seek(Number(scrub.value)),
  });
  const place = h('output', {});
  walker.play.subscribe((play) => {
    if (!play) return;
    const { position, player } = play;
    scrub.max = String(player.count);
    scrub.value = String(position);
    scrub.disabled = player.count === 0;
    scrub.style.setProperty('--filled', `${(100 * position) / Math.max(1, player.count)}%`);
    setAttribute(scrub, 'aria-valuetext', `${position} of ${player.count}`);
    place.textContent = `${position} of ${player.count}`;
  });
  return [scrub, place];
}

function visitedList(explorer: Explorer): HTMLElement {
  const visited = h('ol', {
    class: 'visited',
    translate: 'no',
    tabindex: -1,
    'aria-label': 'Visited, in order',
  });
  explorer.walker.play.subscribe((play) => {
    if (!play) return;
    // A button that goes tells of no mouse that leaves it.
    if (visited.matches(':hover')) explorer.hovered.value = null;
    keepFocus(visited, () => fill(visited, ...visits(explorer, play)));
    scrollTo(visited, visited.querySelector<HTMLElement>('[aria-current]'));
  });
  return visited;
}

/** Rebuilds a list of visits; the focus stays on the same visit, or goes to the last one that is left, or to the list. */
function keepFocus(list: HTMLElement, rebuild: () => void): void {
  const focused = document.activeElement;
  const had = focused instanceof HTMLElement && list.contains(focused);
  const same = had ? focused.dataset.ordinal : undefined;
  rebuild();
  if (!had) return;
  const visits = [...list.querySelectorAll('button')];
  const visit = visits.find(({ dataset }) => dataset.ordinal === same) ?? visits.at(-1);
  (visit ?? list).focus({ preventScroll: true });
}

/** Brings an entry of a list into sight, and leaves alone what the list lies in. */
function scrollTo(list: HTMLElement, entry: HTMLElement | null): void {
  if (!entry) return;
  const { top, bottom } = list.getBoundingClientRect();
  const seen = entry.getBoundingClientRect();
  if (seen.bottom > bottom) list.scrollTop += seen.bottom - bottom;
  else if (seen.top < top) list.scrollTop -= top - seen.top;
}

/** Keeps `→ vertex 7` on one line. */
function unbroken(words: string): string {
  return words.replaceAll(/(→|vertex|edge|face) (?=\S)/g, '$1\u00a0');
}

function idleWords({ player }: Play): string {
  if (player.count === 0) return 'There is nothing to visit here: the range is empty.';
  const things = player.count === 1 ? 'one item' : `${player.count} items`;
  return `${things[0].toUpperCase()}${things.slice(1)} to visit. Press play, or step.`;
}

function visits(explorer: Explorer, { player, position }: Play): HTMLElement[] {
  const first = Math.max(0, position - LIST_CAP);
  const shown = player.visits.slice(first).map(({ item }, i) => {
    const ordinal = first + i + 1;
    const name = itemName(item);
    return h(
      'li',
      {},
      h(
        'button',
        {
          type: 'button',
          'data-item': name,
          'data-ordinal': ordinal,
          'aria-current': ordinal === position ? 'step' : null,
          onclick: () => explorer.walker.seek(ordinal),
          onmouseenter: () => {
            explorer.hovered.value = item;
          },
          onmouseleave: () => {
            explorer.hovered.value = null;
          },
        },
        h('i', {}, String(ordinal)),
        ' ',
        name,
      ),
    );
  });
  const waiting = Math.min(player.count - position, Math.max(0, 16 - shown.length));
  for (let i = 0; i < waiting; i++) {
    shown.push(h('li', { class: 'waiting', 'aria-hidden': 'true' }));
  }
  return shown;
}

function speed(explorer: Explorer): HTMLElement {
  const options = SPEEDS.map((value, i) => h('option', { value: i }, `${value} a second`));
  const select = h(
    'select',
    {
      class: 'speed',
      'aria-label': 'Speed, in steps a second',
      title: 'Speed',
      onchange: () => {
        explorer.walker.speed.value = Number(select.value);
      },
    },
    ...options,
  );
  explorer.walker.speed.subscribe((value) => {
    select.value = String(value);
  });
  return select;
}
