import type { Camera, Object3D, Scene, Vector2 } from 'three';
import { setPointRatio } from './points.js';
import type { Screen } from './screen.js';

/** Pixels of an exported picture to the CSS pixel. */
const CAPTURE_RATIO = 2;

/** A part of the picture, in CSS pixels from the canvas's top left. */
export interface PictureFrame {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** What is drawn, and the size of its canvas in CSS pixels. */
interface Drawn {
  readonly scene: Scene;
  readonly camera: Camera;
  readonly size: Vector2;
}

/** An empty canvas for a part of the picture. Throws while nothing can be drawn. */
export function newCapture({ isLost }: Screen, { width, height }: PictureFrame): HTMLCanvasElement {
  if (isLost) {
    throw new Error('The browser has taken the graphics card away: wait until it is back.');
  }
  const taken = document.createElement('canvas');
  taken.width = Math.round(CAPTURE_RATIO * width);
  taken.height = Math.round(CAPTURE_RATIO * height);
  if (!taken.getContext('2d')) {
    throw new Error('The browser has no room for a picture of that size.');
  }
  return taken;
}

/** Draws that part on the colour of the page. The screen, which is drawn on for it, is left at another size. */
export function drawCapture(
  taken: HTMLCanvasElement,
  screen: Screen,
  { scene, camera, size }: Drawn,
  { x, y }: PictureFrame,
  without: ReadonlySet<Object3D>,
): void {
  for (const object of without) object.visible = false;
  screen.resize(size.x, size.y, CAPTURE_RATIO);
  const sized = setPointRatio(scene, CAPTURE_RATIO);
  try {
    screen.render(scene, camera);
    const { width, height } = taken;
    const context = taken.getContext('2d') as CanvasRenderingContext2D;
    context.fillStyle = getComputedStyle(document.documentElement).getPropertyValue('--page');
    context.fillRect(0, 0, width, height);
    const from = [CAPTURE_RATIO * x, CAPTURE_RATIO * y] as const;
    context.drawImage(screen.canvas, ...from, width, height, 0, 0, width, height);
  } finally {
    for (const object of without) object.visible = true;
    setPointRatio(scene, sized);
  }
}
