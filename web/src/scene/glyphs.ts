import { type ArrowSizes, arrowSizes, HalfedgeGlyphs } from '../three/index.js';
import type { FaceFrames } from './faces.js';
import type { Stage } from './stage.js';
import type { Surface } from './surface.js';

/** Where the arrow of a single halfedge lies on the screen's scale; for highlights and picking. */
export class Glyphs extends HalfedgeGlyphs {
  readonly #surface: Surface;
  readonly #frames: FaceFrames;
  readonly #stage: Stage;

  constructor(surface: Surface, frames: FaceFrames, stage: Stage) {
    super(surface);
    this.#surface = surface;
    this.#frames = frames;
    this.#stage = stage;
  }

  /** The sizes of arrows at a point of the surface, for the camera as it stands. */
  sizesAt(x: number, y: number, z: number): ArrowSizes {
    return arrowSizes(this.#stage.pixelAt(Math.max(1e-6, this.#stage.depthOf(x, y, z))));
  }

  override face(face: number, sizes?: ArrowSizes): number {
    const at = this.#frames.at(face);
    const { data } = this.#frames;
    return super.face(face, sizes ?? this.sizesAt(data[at], data[at + 1], data[at + 2]));
  }

  override boundary(h: number, sizes?: ArrowSizes, before?: number): void {
    const { points, mesh } = this.#surface;
    const from = 3 * mesh.connectivity.toVertex[h ^ 1];
    const own = sizes ?? this.sizesAt(points[from], points[from + 1], points[from + 2]);
    super.boundary(h, own, before);
  }

  override halfedge(h: number, sizes?: ArrowSizes, before?: number): number {
    return super.halfedge(h, sizes as ArrowSizes, before);
  }
}
