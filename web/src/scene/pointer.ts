import type { Item } from '../teaching/items.js';

/** A press that moves further than this many pixels turns the camera instead of picking. */
const CLICK_SLOP = 5;
/** A finger is that much less exact than a mouse. */
const FINGER = 1.9;

/** Who is told what a pointer does over a picture. */
export interface PointerListener {
  /** The item at (x, y) in CSS pixels of the canvas; `reach` is 1 for a mouse, larger for a finger. */
  itemAt(x: number, y: number, reach: number): Item | null;
  /** What a click would pick here; nothing under a finger, and while a button is held. */
  hovers(item: Item | null): void;
  /** A click, or a tap with one finger, has picked this; null where nothing is. */
  picks(item: Item | null): void;
  doubleClicked(): void;
}

/** Tells what is pointed at and picked on a canvas: to turn the camera is not to pick. */
export function listenToPointer(
  canvas: HTMLElement,
  listener: PointerListener,
  signal?: AbortSignal,
): void {
  let pressed: { x: number; y: number; moved: boolean } | null = null;
  let pending: PointerEvent | null = null;
  const on = <Name extends keyof HTMLElementEventMap>(
    name: Name,
    act: (event: HTMLElementEventMap[Name]) => void,
  ) => canvas.addEventListener(name, act, signal ? { signal } : {});
  const itemAt = (event: PointerEvent) => {
    const { left, top, width, height } = canvas.getBoundingClientRect();
    const reach = event.pointerType === 'touch' ? FINGER : 1;
    // The page may show the canvas larger or smaller than it is: a deck does so with its slides.
    const x = ((event.clientX - left) * canvas.clientWidth) / width;
    const y = ((event.clientY - top) * canvas.clientHeight) / height;
    return listener.itemAt(x, y, reach);
  };
  // Once a frame is enough: a mouse may tell of more moves than that.
  const hover = () => {
    const event = pending;
    pending = null;
    if (event && !pressed && !signal?.aborted) listener.hovers(itemAt(event));
  };
  on('pointermove', (event) => {
    if (pressed) {
      const distance = Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y);
      if (distance > CLICK_SLOP) pressed.moved = true;
      return;
    }
    if (event.pointerType === 'touch') return;
    if (!pending) requestAnimationFrame(hover);
    pending = event;
  });
  on('pointerleave', () => {
    pending = null;
    listener.hovers(null);
  });
  on('pointerdown', (event) => {
    // A second finger zooms or pans: then neither picks.
    if (pressed && !event.isPrimary) pressed.moved = true;
    if (!event.isPrimary || event.button !== 0) return;
    pressed = { x: event.clientX, y: event.clientY, moved: false };
    listener.hovers(null);
  });
  on('pointerup', (event) => {
    if (!event.isPrimary) return;
    const click = pressed && !pressed.moved && event.button === 0;
    pressed = null;
    if (click) listener.picks(itemAt(event));
  });
  on('pointercancel', () => {
    pressed = null;
  });
  on('dblclick', () => listener.doubleClicked());
}
