import { Color } from 'three';
import type { ConnectivityViews } from '../api.js';
import {
  arrowSizes,
  dashCount,
  HalfedgeGlyphs,
  placeDashes,
  SEGMENT_FLOATS,
} from '../three/index.js';
import { KeptLines } from './kept-lines.js';
import { pixelOfStep, stepOfPixel } from './pixel-steps.js';
import type { Surface } from './surface.js';

const DASH_PX = 5;
/** How much of a dash is drawn. */
const DUTY = 0.4;

/** The arrows of the boundary halfedges across the edges of faces: dotted, and of the size of those of the face. */
export class BoundaryArrows extends KeptLines {
  #glyphs: HalfedgeGlyphs | null = null;
  readonly #color = new Color();
  /** The arrows of the face that was measured, one after the other as segments: the dashes of its shaft, then its barb. */
  #segments = new Float32Array(64 * SEGMENT_FLOATS);
  #count = 0;

  constructor() {
    super(2);
  }

  override reset(surface: Surface): void {
    this.#glyphs = new HalfedgeGlyphs(surface);
    super.reset(surface);
  }

  setColor(color: Color): void {
    this.#color.copy(color);
    this.clear();
  }

  /** Shows those across the edges of a face where a CSS pixel is `pixel` long. pre: there are some */
  show(face: number, pixel: number): void {
    this.keep(face, stepOfPixel(pixel));
  }

  protected override measure(face: number, look: number): number {
    const links = this.links as ConnectivityViews;
    const pixel = pixelOfStep(look);
    const first = links.faceHalfedge[face];
    this.#count = 0;
    let before = -1;
    let h = first;
    do {
      if (links.face[h ^ 1] < 0) {
        this.#trace(h ^ 1, pixel, before);
        before = h ^ 1;
      }
      h = links.next[h];
    } while (h !== first);
    return this.#count;
  }

  protected override write(first: number, _look: number, former: number): void {
    const { positions, colors } = this.lines;
    const end = SEGMENT_FLOATS * this.#count;
    const offset = SEGMENT_FLOATS * first;
    for (let k = 0; k < end; k++) positions[offset + k] = this.#segments[k];
    if (former >= 0) return;
    for (let s = first; s < first + this.#count; s++) this.#color.toArray(colors, 3 * s);
  }

  /** Adds the arrow of a boundary halfedge, after that of another one beside the same face. */
  #trace(h: number, pixel: number, before: number): void {
    const glyphs = this.#glyphs as HalfedgeGlyphs;
    glyphs.boundary(h, arrowSizes(pixel), before);
    const { arrows } = glyphs;
    const dashes = dashCount(arrows, 0, 3, DASH_PX * pixel, DUTY);
    this.#reserve(this.#count + dashes + 1);
    const barb = SEGMENT_FLOATS * (this.#count + dashes);
    placeDashes(arrows, 0, 3, dashes, DUTY, this.#segments, SEGMENT_FLOATS * this.#count);
    for (let k = 0; k < SEGMENT_FLOATS; k++) this.#segments[barb + k] = arrows[3 + k];
    this.#count += dashes + 1;
  }

  #reserve(count: number): void {
    if (count * SEGMENT_FLOATS <= this.#segments.length) return;
    const segments = new Float32Array(2 * count * SEGMENT_FLOATS);
    segments.set(this.#segments);
    this.#segments = segments;
  }
}
