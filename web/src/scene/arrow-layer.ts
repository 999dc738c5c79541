import type { Color } from 'three';
import type { ConnectivityViews } from '../api.js';
import { ARROWS_FROM, lineMaterial, lines } from '../three/index.js';
import { roomFor } from '../three/rows.js';
import { BoundaryArrows } from './boundary-arrows.js';
import { FaceArrows } from './face-arrows.js';
import { FaceSight } from './face-sight.js';
import type { FaceFrames } from './faces.js';
import type { Stage } from './stage.js';
import type { Surface } from './surface.js';

/** Faces whose edges are as long as this have room for the names of their items. */
const LABELS_FROM_PX = 56;
/** Away from the selection and the pointer they fade in from here to there. */
const FADE_PX = [33, 52] as const;
/** How many rings of faces around the selection and the pointer show full arrows. */
const NEAR_RINGS = 3;
/** No more faces than this show arrows. */
const FACE_CAP = 8000;

/** The half-arrows of all faces that are seen large enough, and of the boundary beside them. */
export class ArrowLayer {
  readonly #stage: Stage;
  readonly #arrows = new FaceArrows();
  readonly #boundaryArrows = new BoundaryArrows();
  readonly #material = lineMaterial(1.5, 2);
  readonly #sight = new FaceSight();
  #surface: Surface | null = null;
  #frames: FaceFrames | null = null;
  /** The links of the mesh, in the frame that is drawn. */
  #links: ConnectivityViews | null = null;
  /** By face: 1 if a boundary halfedge is across one of its edges. */
  #isBeside = new Uint8Array(0);
  #stamp = 0;
  #seen = new Uint32Array(0);
  /** The faces that may be drawn, in their order, and how many these are. */
  #queue = new Int32Array(0);
  #end = 0;
  /** Whether any arrows are drawn. */
  visible = true;
  /** Faces that show no arrows, while they are changing. */
  hidden: ReadonlySet<number> = new Set();
  /** Boundary halfedges that have an arrow in the picture: what can be picked beside the surface. */
  readonly boundary: number[] = [];
  /** Faces in sight that are large enough for names, the nearest to what matters first. */
  readonly large: number[] = [];

  constructor(stage: Stage) {
    this.#stage = stage;
    for (const { lines: drawn } of [this.#arrows, this.#boundaryArrows]) {
      for (const geometry of drawn.geometries) {
        stage.scene.add(lines({ geometry }, this.#material, 3));
      }
    }
  }

  show(surface: Surface, frames: FaceFrames): void {
    this.#surface = surface;
    this.#frames = frames;
    this.#arrows.reset(surface);
    this.#boundaryArrows.reset(surface);
    this.change(null);
  }

  /** Takes over faces of the surface that have changed; null: all of them may have. */
  change(faces: Iterable<number> | null): void {
    const { mesh, boundary } = this.#surface as Surface;
    this.#arrows.forget(faces);
    this.#boundaryArrows.forget(null);
    // Those of the last frame may be gone, or of another mesh.
    this.boundary.length = 0;
    this.large.length = 0;
    if (mesh.faceSlots > this.#seen.length) {
      this.#seen = new Uint32Array(roomFor(mesh.faceSlots));
      this.#queue = new Int32Array(this.#seen.length);
      this.#isBeside = new Uint8Array(this.#seen.length);
    }
    this.#isBeside.fill(0);
    const { face } = mesh.connectivity;
    for (const h of boundary) this.#isBeside[face[h ^ 1]] = 1;
  }

  setColors(faded: Color, arrow: Color, boundary: Color): void {
    this.#arrows.setColors(faded, arrow);
    this.#boundaryArrows.setColor(boundary);
  }

  /**
   * Before each frame: draws what is large enough, boldly within three rings of the faces in
   * `near` (the selection, the pointer). On meshes with more faces than the cap it spreads from
   * them and from `middle`, the face in the middle of the picture, to neighbours in sight.
   */
  update(near: readonly number[], middle: number | null): void {
    const surface = this.#surface;
    if (!surface) return;
    this.#arrows.begin();
    this.#boundaryArrows.begin();
    this.boundary.length = 0;
    this.large.length = 0;
    if (this.visible) this.#drawAll(surface, near, middle);
    this.#arrows.end();
    this.#boundaryArrows.end();
  }

  #drawAll({ mesh, boundary }: Surface, near: readonly number[], middle: number | null): void {
    this.#sight.aim(this.#stage, boundary.length === 0);
    this.#links = mesh.connectivity;
    this.#stamp += 1;
    this.#end = 0;
    const { faceHalfedge } = this.#links;
    for (const f of near) this.#push(f);
    let at = 0;
    for (let ring = 0; ring < NEAR_RINGS; ring++) at = this.#drawQueued(at, 1, 'all');
    if (faceHalfedge.length <= FACE_CAP) {
      this.#pushAll(faceHalfedge);
      this.#drawQueued(at, 0, 'none');
      return;
    }
    if (middle !== null) this.#push(middle);
    while (at < Math.min(this.#end, FACE_CAP)) at = this.#drawQueued(at, 0, 'drawn');
  }

  #pushAll(faceHalfedge: Int32Array): void {
    const queue = this.#queue;
    const seen = this.#seen;
    const stamp = this.#stamp;
    let end = this.#end;
    for (let f = 0; f < faceHalfedge.length; f++) {
      if (faceHalfedge[f] >= 0 && seen[f] !== stamp) queue[end++] = f;
    }
    this.#end = end;
  }

  #push(f: number): void {
    if (f < 0 || this.#seen[f] === this.#stamp) return;
    this.#seen[f] = this.#stamp;
    this.#queue[this.#end++] = f;
  }

  /**
   * Draws the faces of the queue from place `from` on, as far as the cap, and queues the neighbours of all of them, of
   * none, or of those that could be drawn. Returns where those stand.
   */
  #drawQueued(from: number, strength: number, spreading: 'all' | 'none' | 'drawn'): number {
    const end = Math.min(this.#end, FACE_CAP);
    const queue = this.#queue;
    this.#sight.measure(queue, from, end, this.#frames as FaceFrames);
    for (let i = from; i < end; i++) {
      const isDrawn = this.#draw(i, strength);
      if (spreading === 'all' || (isDrawn && spreading === 'drawn')) this.#pushNeighbours(queue[i]);
    }
    return end;
  }

  #pushNeighbours(f: number): void {
    const { next, face, faceHalfedge } = this.#links as ConnectivityViews;
    const first = faceHalfedge[f];
    let h = first;
    do {
      this.#push(face[h ^ 1]);
      h = next[h];
    } while (h !== first);
  }

  /**
   * Draws the arrows of the face at a place of the queue, which was measured, at least as strongly as `strength`, unless
   * it is too small or out of sight; says whether it did.
   */
  #draw(i: number, strength: number): boolean {
    const f = this.#queue[i];
    if (this.hidden.size > 0 && this.hidden.has(f)) return true;
    const edge = this.#sight.edges[i];
    if (edge < ARROWS_FROM) return false;
    if (edge >= LABELS_FROM_PX) this.large.push(f);
    const faded = (edge - FADE_PX[0]) / (FADE_PX[1] - FADE_PX[0]);
    const shown = Math.min(1, Math.max(faded, strength));
    const pixel = this.#sight.pixels[i];
    if (shown > 0) this.#arrows.show(f, pixel, shown);
    if (this.#isBeside[f] === 1) this.#showBoundaries(f, pixel);
    return true;
  }

  /** The boundary halfedges across the edges of a face: never faded, never hidden. */
  #showBoundaries(f: number, pixel: number): void {
    const { next, face, faceHalfedge } = this.#links as ConnectivityViews;
    const first = faceHalfedge[f];
    let h = first;
    do {
      if (face[h ^ 1] < 0) this.boundary.push(h ^ 1);
      h = next[h];
    } while (h !== first);
    this.#boundaryArrows.show(f, pixel);
  }
}
