import { type Camera, type Scene, WebGLRenderer } from 'three';
import type { Screen } from './screen.js';

/**
 * A canvas among many that share one WebGL context: each picture is rendered out of sight and
 * copied. Browsers allow a page some sixteen contexts, and drop the oldest without a word.
 */
export class SharedScreen implements Screen {
  readonly canvas: HTMLCanvasElement;
  readonly #context: CanvasRenderingContext2D;
  readonly #ended = new AbortController();
  #width = 1;
  #height = 1;
  #ratio = 1;

  /** Throws where there is no WebGL. */
  constructor(canvas: HTMLCanvasElement) {
    this.canvas = canvas;
    this.#context = canvas.getContext('2d') as CanvasRenderingContext2D;
    renderer ??= start();
  }

  get isLost(): boolean {
    return (renderer as WebGLRenderer).getContext().isContextLost();
  }

  onLoss(lost: () => void, restored: () => void): void {
    const { domElement } = renderer as WebGLRenderer;
    const { signal } = this.#ended;
    domElement.addEventListener('webglcontextlost', lost, { signal });
    domElement.addEventListener('webglcontextrestored', restored, { signal });
  }

  resize(width: number, height: number, ratio: number): void {
    this.#width = width;
    this.#height = height;
    this.#ratio = ratio;
    const [columns, rows] = [Math.floor(width * ratio), Math.floor(height * ratio)];
    // Setting a size clears the canvas, even where it is the same.
    if (this.canvas.width !== columns) this.canvas.width = columns;
    if (this.canvas.height !== rows) this.canvas.height = rows;
  }

  render(scene: Scene, camera: Camera): void {
    const shared = renderer as WebGLRenderer;
    const { width, height } = this.canvas;
    const { domElement } = shared;
    if (shared.getPixelRatio() !== this.#ratio) shared.setPixelRatio(this.#ratio);
    // As large as the largest picture: changing its size costs more than drawing.
    if (domElement.width < width || domElement.height < height) {
      shared.setSize(
        Math.ceil(Math.max(domElement.width, width) / this.#ratio),
        Math.ceil(Math.max(domElement.height, height) / this.#ratio),
        false,
      );
    }
    shared.setViewport(0, 0, this.#width, this.#height);
    shared.setScissor(0, 0, this.#width, this.#height);
    shared.setScissorTest(true);
    shared.render(scene, camera);
    this.#context.clearRect(0, 0, width, height);
    const top = domElement.height - height;
    this.#context.drawImage(domElement, 0, top, width, height, 0, 0, width, height);
  }

  dispose(): void {
    this.#ended.abort();
  }
}

/** One for the page, made when the first picture needs it, and kept: pages rarely lose all figures. */
let renderer: WebGLRenderer | undefined;

function start(): WebGLRenderer {
  const made = new WebGLRenderer({
    canvas: document.createElement('canvas'),
    antialias: true,
    alpha: true,
  });
  made.setClearAlpha(0);
  return made;
}
