import { Color } from 'three';
import type { ConnectivityViews } from '../api.js';
import { ARROWS_FROM, LineBatch, lineMaterial, lines } from '../three/index.js';
import { roomFor } from '../three/rows.js';
import { FaceArrows } from './face-arrows.js';
import { FaceRows } from './face-rows.js';
import { FaceSight } from './face-sight.js';
import type { FaceFrames } from './faces.js';
import { Glyphs } from './glyphs.js';
import type { Stage } from './stage.js';
import type { Surface } from './surface.js';

/** Faces whose edges are as long as this have room for the names of their items. */
export const LABELS_FROM_PX = 56;
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
  readonly #batch = new LineBatch();
  readonly #material = lineMaterial(1.5, 2);
  readonly #sight = new FaceSight();
  #surface: Surface | null = null;
  #frames: FaceFrames | null = null;
  #rows: FaceRows | null = null;
  #glyphs: Glyphs | null = null;
  /** The links of the mesh, in the frame that is drawn. */
  #links: ConnectivityViews | null = null;
  #closed = true;
  #stamp = 0;
  #seen = new Uint32Array(0);
  readonly #queue: number[] = [];
  #boundaryColor = new Color();
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
    for (const segments of [this.#arrows.lines, this.#batch]) {
      stage.scene.add(lines(segments, this.#material, 3));
    }
  }

  show(surface: Surface, frames: FaceFrames): void {
    this.#surface = surface;
    this.#frames = frames;
    this.#rows = new FaceRows(surface);
    this.#glyphs = new Glyphs(surface, frames, this.#stage);
    this.#arrows.reset(this.#rows, surface.mesh.faceSlots);
    this.change(null);
  }

  /** Takes over faces of the surface that have changed; null: all of them may have. */
  change(faces: Iterable<number> | null): void {
    const { mesh, boundary } = this.#surface as Surface;
    this.#rows?.forget(faces);
    this.#arrows.forget(faces, mesh.faceSlots);
    if (mesh.faceSlots > this.#seen.length) this.#seen = new Uint32Array(roomFor(mesh.faceSlots));
    this.#closed = boundary.length === 0;
  }

  setColors(faded: Color, arrow: Color, boundary: Color): void {
    this.#arrows.setColors(faded, arrow);
    this.#boundaryColor = boundary;
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
    this.#batch.clear();
    this.boundary.length = 0;
    this.large.length = 0;
    if (this.visible) this.#drawAll(surface, near, middle);
    this.#arrows.end();
    this.#batch.upload();
  }

  #drawAll({ mesh }: Surface, near: readonly number[], middle: number | null): void {
    this.#sight.aim(this.#stage, this.#closed);
    this.#links = mesh.connectivity;
    this.#stamp += 1;
    const queue = this.#queue;
    queue.length = 0;
    const { faceHalfedge } = this.#links;
    for (const f of near) this.#push(f);
    let at = 0;
    for (let ring = 0; ring < NEAR_RINGS; ring++) {
      for (const end = queue.length; at < end && at < FACE_CAP; at++) {
        this.#draw(queue[at], 1);
        this.#pushNeighbours(queue[at]);
      }
    }
    if (faceHalfedge.length > FACE_CAP) {
      if (middle !== null) this.#push(middle);
      for (; at < queue.length && at < FACE_CAP; at++) {
        if (this.#draw(queue[at], 0)) this.#pushNeighbours(queue[at]);
      }
      return;
    }
    for (; at < queue.length; at++) this.#draw(queue[at], 0);
    for (let f = 0; f < faceHalfedge.length; f++) {
      if (faceHalfedge[f] >= 0 && this.#seen[f] !== this.#stamp) this.#draw(f, 0);
    }
  }

  #push(f: number): void {
    if (f < 0 || this.#seen[f] === this.#stamp) return;
    this.#seen[f] = this.#stamp;
    this.#queue.push(f);
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
   * Draws the arrows of a face, at least as strongly as `strength`, unless it is too small or out
   * of sight; says whether it did.
   */
  #draw(f: number, strength: number): boolean {
    if (this.hidden.size > 0 && this.hidden.has(f)) return true;
    const sight = this.#sight;
    const pixels = sight.edgeOf(f, this.#frames as FaceFrames);
    if (pixels < ARROWS_FROM) return false;
    if (pixels >= LABELS_FROM_PX) this.large.push(f);
    const faded = (pixels - FADE_PX[0]) / (FADE_PX[1] - FADE_PX[0]);
    const shown = Math.min(1, Math.max(faded, strength));
    if (shown > 0) this.#arrows.show(f, sight.pixel, shown);
    if (!this.#closed) this.#writeBoundaries(f);
    return true;
  }

  /** The boundary halfedges across the edges of a face: never faded, never hidden. */
  #writeBoundaries(f: number): void {
    const { next, face, faceHalfedge } = this.#links as ConnectivityViews;
    const first = faceHalfedge[f];
    let h = first;
    do {
      if (face[h ^ 1] < 0) this.#writeBoundary(h ^ 1);
      h = next[h];
    } while (h !== first);
  }

  #writeBoundary(h: number): void {
    const glyphs = this.#glyphs as Glyphs;
    glyphs.boundary(h);
    const pixel = this.#stage.pixelAt(
      this.#stage.depthOf(glyphs.arrows[0], glyphs.arrows[1], glyphs.arrows[2]),
    );
    this.#batch.addDashed(glyphs.arrows, 0, 3, this.#boundaryColor, 5 * pixel, 0.4);
    this.#batch.add(glyphs.arrows, 3, 6, this.#boundaryColor);
    this.boundary.push(h);
  }
}
