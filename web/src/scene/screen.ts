import { type Camera, type Scene, WebGLRenderer } from 'three';

/** What a stage draws on: a canvas, and something that renders scenes to it. */
export interface Screen {
  readonly canvas: HTMLCanvasElement;
  /** Sets the size in CSS pixels, and how many pixels there are to one of them. */
  resize(width: number, height: number, ratio: number): void;
  render(scene: Scene, camera: Camera): void;
  dispose(): void;
}

/** A canvas with a WebGL context of its own. Throws where there is no WebGL. */
export class OwnScreen implements Screen {
  readonly canvas: HTMLCanvasElement;
  readonly #renderer: WebGLRenderer;

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

  dispose(): void {
    this.#renderer.dispose();
  }
}
