import { sameItem } from 'halfedge/teaching';
import type { Explorer } from '../app/explorer.js';
import type { View } from '../scene/view.js';

/** A press that moves further than this many pixels turns the camera instead of picking. */
const CLICK_SLOP = 5;
const FINGER = 1.9;

/** Hovering shows what a click would pick; a click picks it; a double click flies there. */
export function listenToPointer(explorer: Explorer, view: View, canvas: HTMLCanvasElement): void {
  let pressed: { x: number; y: number; moved: boolean } | null = null;
  let pending: PointerEvent | null = null;
  const pickAt = (event: PointerEvent | MouseEvent) => {
    const { left, top } = canvas.getBoundingClientRect();
    const touch = event instanceof PointerEvent && event.pointerType === 'touch';
    return view.pick(event.clientX - left, event.clientY - top, touch ? FINGER : 1);
  };
  const hover = () => {
    const event = pending;
    pending = null;
    if (!event || pressed) return;
    const item = pickAt(event);
    if (!sameItem(item, explorer.hovered.value)) explorer.hovered.value = item;
  };
  canvas.addEventListener('pointermove', (event) => {
    if (pressed) {
      const distance = Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y);
      if (distance > CLICK_SLOP) pressed.moved = true;
      return;
    }
    if (event.pointerType === 'touch') return;
    if (!pending) requestAnimationFrame(hover);
    pending = event;
  });
  canvas.addEventListener('pointerleave', () => {
    pending = null;
    explorer.hovered.value = null;
  });
  canvas.addEventListener('pointerdown', (event) => {
    if (pressed && !event.isPrimary) pressed.moved = true;
    if (!event.isPrimary || event.button !== 0) return;
    pressed = { x: event.clientX, y: event.clientY, moved: false };
    explorer.hovered.value = null;
  });
  canvas.addEventListener('pointerup', (event) => {
    if (!event.isPrimary) return;
    const click = pressed && !pressed.moved && event.button === 0;
    pressed = null;
    if (click) explorer.pick(pickAt(event));
  });
  canvas.addEventListener('pointercancel', () => {
    pressed = null;
  });
  canvas.addEventListener('dblclick', () => view.focus());
}
