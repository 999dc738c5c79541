import type { Color } from 'three';
import type { ConnectivityViews } from '../api.js';
import { cornersAcross } from '../three/across.js';
import { ARROW_FLOATS, arrowSizes, CappedMitre } from '../three/index.js';
import { KeptLines } from './kept-lines.js';
import { pixelOfStep, stepOfPixel } from './pixel-steps.js';
import type { Surface } from './surface.js';

/** How many shades there are from the faintest to the strongest, besides the former. */
const SHADES = 31;
/** A look is the shade of arrows, in its lowest bits, and the step of their size. */
const SHADE_BITS = 5;

/** The arrows of faces: lines of three points, from the start over the end to the tip of the barb. */
export class FaceArrows extends KeptLines {
  readonly #mitre = new CappedMitre();
  readonly #corners: number[] = [];
  readonly #vertices: number[] = [];
  readonly #shades = new Float32Array(3 * (SHADES + 1));
  readonly #sizes = { inset: 0, trim: 0, barb: 0 };

  constructor() {
    super(3);
  }

  /** The colours of the faintest and of the strongest arrows. */
  setColors(faint: Color, strong: Color): void {
    for (let shade = 0; shade <= SHADES; shade++) {
      faint
        .clone()
        .lerp(strong, shade / SHADES)
        .toArray(this.#shades, 3 * shade);
    }
    this.clear();
  }

  /** Shows the arrows of a face where a CSS pixel is `pixel` long; from `strength` 0 to 1 they are stronger. */
  show(face: number, pixel: number, strength: number): void {
    this.keep(face, (stepOfPixel(pixel) << SHADE_BITS) | (strength * SHADES + 0.5));
  }

  protected override measure(face: number): number {
    const { next, toVertex, faceHalfedge } = this.links as ConnectivityViews;
    const surface = this.surface as Surface;
    const mitre = this.#mitre;
    const a = faceHalfedge[face];
    const b = next[a];
    const c = next[b];
    if (next[c] === a) {
      mitre.measureTriangle(surface.points, 3 * toVertex[a], 3 * toVertex[b], 3 * toVertex[c]);
    } else {
      const degree = surface.corners(face, this.#corners);
      mitre.measurePolygon(this.#corners, degree, this.#across(face, degree));
    }
    return mitre.degree;
  }

  /** By edge, the corner across it in the triangle that is drawn there. */
  #across(face: number, degree: number): readonly number[] {
    const { next, toVertex, faceHalfedge } = this.links as ConnectivityViews;
    const vertices = this.#vertices;
    for (let i = 0, h = faceHalfedge[face]; i < degree; i++, h = next[h]) vertices[i] = toVertex[h];
    return cornersAcross(vertices, degree, (this.surface as Surface).triangleVertices(face));
  }

  protected override write(first: number, look: number, former: number): void {
    const sizes = arrowSizes(pixelOfStep(look >> SHADE_BITS), this.#sizes);
    this.#mitre.place(sizes, this.lines.positions, ARROW_FLOATS * first);
    const shade = look & SHADES;
    if (former < 0 || (former & SHADES) !== shade) this.#paint(first, shade);
  }

  #paint(first: number, shade: number): void {
    const { colors } = this.lines;
    const r = this.#shades[3 * shade];
    const g = this.#shades[3 * shade + 1];
    const b = this.#shades[3 * shade + 2];
    const end = 3 * (first + this.#mitre.degree);
    for (let c = 3 * first; c < end; c += 3) {
      colors[c] = r;
      colors[c + 1] = g;
      colors[c + 2] = b;
    }
  }
}
