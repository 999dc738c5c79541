import { ARROW_FLOATS, type ArrowSizes, ArrowTracer, arrowSizes } from 'halfedge/three';
import type { FaceFrames } from './faces.js';
import type { Stage } from './stage.js';
import type { Surface } from './surface.js';

/** Where the arrow of a single halfedge lies on the screen's scale; for highlights and picking. */
export class Glyphs {
  /** xyz of start, end and tip of the barb, after `halfedge` or `face`. */
  arrows = new Float32Array(16 * ARROW_FLOATS);
  readonly #surface: Surface;
  readonly #frames: FaceFrames;
  readonly #stage: Stage;
  readonly #tracer = new ArrowTracer();
  readonly #corners: number[] = [];
  readonly #path = new Float64Array(12);

  constructor(surface: Surface, frames: FaceFrames, stage: Stage) {
    this.#surface = surface;
    this.#frames = frames;
    this.#stage = stage;
  }

  /** The sizes of arrows at a point of the surface, for the camera as it stands. */
  sizesAt(x: number, y: number, z: number): ArrowSizes {
    return arrowSizes(this.#stage.pixelAt(Math.max(1e-6, this.#stage.depthOf(x, y, z))));
  }

  /** The arrows of a face, one for each halfedge from `faceHalfedge`'s next on. Returns the degree. */
  face(face: number, sizes?: ArrowSizes): number {
    const degree = this.#surface.corners(face, this.#corners);
    if (this.arrows.length < degree * ARROW_FLOATS) {
      this.arrows = new Float32Array(2 * degree * ARROW_FLOATS);
    }
    const at = this.#frames.at(face);
    const { data } = this.#frames;
    const chosen = sizes ?? this.sizesAt(data[at], data[at + 1], data[at + 2]);
    this.#tracer.traceFace(this.#corners, degree, chosen, this.arrows, 0);
    return degree;
  }

  /** The arrow of a boundary halfedge, drawn outside the face across its edge. */
  boundary(h: number, sizes?: ArrowSizes): void {
    const { toVertex, next, prev, face } = this.#surface.mesh.connectivity;
    const { points } = this.#surface;
    const path = [toVertex[prev[h] ^ 1], toVertex[h ^ 1], toVertex[h], toVertex[next[h]]];
    path.forEach((v, i) => {
      for (let k = 0; k < 3; k++) this.#path[3 * i + k] = points[3 * v + k];
    });
    const at = this.#frames.at(face[h ^ 1]);
    const { data } = this.#frames;
    const normal = [data[at + 3], data[at + 4], data[at + 5]];
    const chosen = sizes ?? this.sizesAt(this.#path[3], this.#path[4], this.#path[5]);
    this.#tracer.traceBoundary(this.#path, normal, chosen, this.arrows, 0);
  }

  /** The arrow of any halfedge; returns its offset in `arrows`. */
  halfedge(h: number, sizes?: ArrowSizes): number {
    const { face, next, faceHalfedge } = this.#surface.mesh.connectivity;
    if (face[h] < 0) {
      this.boundary(h, sizes);
      return 0;
    }
    this.face(face[h], sizes);
    // Corner i is the to-vertex of the i-th halfedge, so arrow i belongs to the one after it.
    let place = 0;
    for (let at = next[faceHalfedge[face[h]]]; at !== h; at = next[at]) place += 1;
    return place * ARROW_FLOATS;
  }
}
