import { type Camera, type Scene, WebGLRenderer } from 'three';

/** How many pixels of a canvas there are to a CSS pixel: more than two cost time, and nobody sees them. */
export function pixelRatio(): number {
  return Math.min(2, window.devicePixelRatio);
}

/** What a stage draws on: a canvas, and something that renders scenes to it. */
export interface Screen {
  readonly canvas: HTMLCanvasElement;
  /** Sets the size in CSS pixels, and how many pixels there are to one of them. */
  resize(width: number, height: number, ratio: number): void;
  render(scene: Scene, camera: Camera): void;
  /** Whether the browser has taken the graphics card away: nothing can be drawn until it gives it back. */
  readonly isLost: boolean;
  /** Calls `lost` when that happens, and `restored` when the picture has to be drawn again. */
  onLoss(lost: () => void, restored: () => void): void;
  dispose(): void;
}

/** A canvas with a WebGL context of its own. Throws where there is no WebGL. */
export class OwnScreen implements Screen {
  readonly canvas: HTMLCanvasElement;
  readonly #renderer: WebGLRenderer;
  readonly #ended = new AbortController();

  constructor(canvas: HTMLCanvasElement) {
    this.canvas = canvas;
    this.#renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.#renderer.setClearAlpha(0);
  }

  resize(width: number, height: number, ratio: number): void {
    this.#renderer.setPixelRatio(ratio);
    this.#renderer.setSize(width, height, false);
  }

  render(scene: Scene, camera: Camera): void {
    this.#renderer.render(scene, camera);
  }

  get isLost(): boolean {
    return this.#renderer.getContext().isContextLost();
  }

  onLoss(lost: () => void, restored: () => void): void {
    const { signal } = this.#ended;
    this.canvas.addEventListener('webglcontextlost', lost, { signal });
    this.canvas.addEventListener('webglcontextrestored', restored, { signal });
  }

  dispose(): void {
    this.#ended.abort();
    this.#renderer.dispose();
  }
}
