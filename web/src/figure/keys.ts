import type { WalkKey } from '../teaching/item-links.js';

/** What keys do in a figure. */
export interface KeyActions {
  toggle(): void;
  stepForward(): void;
  stepBack(): void;
  seek(position: number): void;
  walk(key: WalkKey): void;
  orbit(horizontal: number, vertical: number): void;
  zoom(factor: number): void;
  fit(): void;
}

const TURN = Math.PI / 18;
const ZOOM = 1.2;

/** The keys, for a description that is read out. */
export const KEYS =
  'Arrow keys turn it, plus and minus zoom, 0 shows it whole, space plays, comma and full stop step, n p o v u e f h walk along links.';

/** Does what a key of a focused picture means. False for one that means nothing. */
export function actOnKey(event: KeyboardEvent, actions: KeyActions): boolean {
  if (event.ctrlKey || event.metaKey || event.altKey) return false;
  switch (event.key) {
    case ' ':
      actions.toggle();
      return true;
    case '.':
      actions.stepForward();
      return true;
    case ',':
      actions.stepBack();
      return true;
    case 'Home':
      actions.seek(0);
      return true;
    case 'ArrowLeft':
      actions.orbit(-TURN, 0);
      return true;
    case 'ArrowRight':
      actions.orbit(TURN, 0);
      return true;
    case 'ArrowUp':
      actions.orbit(0, -TURN);
      return true;
    case 'ArrowDown':
      actions.orbit(0, TURN);
      return true;
    case '+':
    case '=':
      actions.zoom(1 / ZOOM);
      return true;
    case '-':
      actions.zoom(ZOOM);
      return true;
    case '0':
      actions.fit();
      return true;
  }
  if (!/^[npovefhu]$/.test(event.key)) return false;
  actions.walk(event.key as WalkKey);
  return true;
}

/** The keys of a slider. */
const SLIDES = /^(Arrow.*|Home|End|Page.*)$/;

/**
 * Keeps a key from the page that an element has used: a deck of slides would go on to the next one, too. To be
 * called by the element itself; pages don't see what inside of it has the focus.
 */
export function keepUsedKey(event: KeyboardEvent): void {
  const [inner] = event.composedPath();
  if (event.defaultPrevented || uses(inner, event)) event.stopPropagation();
}

function uses(inner: EventTarget, { key, ctrlKey, metaKey, altKey }: KeyboardEvent): boolean {
  if (!(inner instanceof HTMLElement) || ctrlKey || metaKey) return false;
  if (inner.isContentEditable) return true;
  if (altKey || key === 'Tab' || key === 'Escape') return false;
  if (inner instanceof HTMLInputElement) return SLIDES.test(key);
  if (inner instanceof HTMLButtonElement) return key === ' ' || key === 'Enter';
  return inner instanceof HTMLSelectElement;
}
