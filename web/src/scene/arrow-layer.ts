import { Color, Matrix4 } from 'three';
import type { HalfedgeMesh } from '../api.js';
import { ARROWS_FROM, arrowSizes, LineBatch, lineMaterial, lines } from '../three/index.js';
import { roomFor } from '../three/rows.js';
import { FaceRows } from './face-rows.js';
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
  readonly #batch = new LineBatch(4096);
  readonly #material = lineMaterial(1.5, 2);
  readonly #view = new Matrix4();
  readonly #tint = new Color();
  readonly #sizes = { inset: 0, trim: 0, barb: 0 };
  /** The length of a CSS pixel at depth 1. */
  #pixel = 0;
  #surface: Surface | null = null;
  #frames: FaceFrames | null = null;
  #rows: FaceRows | null = null;
  #glyphs: Glyphs | null = null;
  #closed = true;
  #stamp = 0;
  #seen = new Uint32Array(0);
  readonly #queue: number[] = [];
  #colors = { faded: new Color(), arrow: new Color(), boundary: new Color() };
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
    stage.scene.add(lines(this.#batch, this.#material, 3));
  }

  show(surface: Surface, frames: FaceFrames): void {
    this.#surface = surface;
    this.#frames = frames;
    this.#rows = new FaceRows(surface);
    this.#glyphs = new Glyphs(surface, frames, this.#stage);
    this.change(null);
  }

  /** Takes over faces of the surface that have changed; null: all of them may have. */
  change(faces: Iterable<number> | null): void {
    const { mesh, boundary } = this.#surface as Surface;
    this.#rows?.forget(faces);
    if (mesh.faceSlots > this.#seen.length) this.#seen = new Uint32Array(roomFor(mesh.faceSlots));
    this.#closed = boundary.length === 0;
  }

  setColors(faded: Color, arrow: Color, boundary: Color): void {
    this.#colors = { faded, arrow, boundary };
  }

  /**
   * Before each frame: draws what is large enough, boldly within three rings of the faces in
   * `near` (the selection, the pointer). On meshes with more faces than the cap it spreads from
   * them and from `middle`, the face in the middle of the picture, to neighbours in sight.
   */
  update(near: readonly number[], middle: number | null): void {
    const surface = this.#surface;
    if (!surface) return;
    this.#batch.clear();
    this.boundary.length = 0;
    this.large.length = 0;
    if (this.visible) this.#drawAll(surface, near, middle);
    this.#batch.upload();
  }

  #drawAll({ mesh }: Surface, near: readonly number[], middle: number | null): void {
    const { camera } = this.#stage;
    this.#view.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    this.#pixel = this.#stage.pixelAt(1);
    this.#stamp += 1;
    const queue = this.#queue;
    queue.length = 0;
    const { faceHalfedge } = mesh.connectivity;
    for (const f of near) this.#push(f);
    let at = 0;
    for (let ring = 0; ring < NEAR_RINGS; ring++) {
      for (const end = queue.length; at < end && at < FACE_CAP; at++) {
        this.#draw(queue[at], 1);
        this.#pushNeighbours(mesh, queue[at]);
      }
    }
    if (faceHalfedge.length > FACE_CAP) {
      if (middle !== null) this.#push(middle);
      for (; at < queue.length && at < FACE_CAP; at++) {
        if (this.#draw(queue[at], 0)) this.#pushNeighbours(mesh, queue[at]);
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

  #pushNeighbours({ connectivity: { next, face, faceHalfedge } }: HalfedgeMesh, f: number): void {
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
    const frames = this.#frames as FaceFrames;
    const at = frames.at(f);
    const { data } = frames;
    const x = data[at];
    const y = data[at + 1];
    const z = data[at + 2];
    const m = this.#view.elements;
    const w = m[3] * x + m[7] * y + m[11] * z + m[15];
    if (w <= 0) return false;
    const reach = 1.15 * w + data[at + 6] * 4;
    if (Math.abs(m[0] * x + m[4] * y + m[8] * z + m[12]) > reach) return false;
    if (Math.abs(m[1] * x + m[5] * y + m[9] * z + m[13]) > reach) return false;
    const { position } = this.#stage.camera;
    const dx = position.x - x;
    const dy = position.y - y;
    const dz = position.z - z;
    const across = data[at + 3] * dx + data[at + 4] * dy + data[at + 5] * dz;
    const facing = across / Math.sqrt(dx * dx + dy * dy + dz * dz);
    if (this.#closed && facing < 0) return false;
    // Edges of a face seen from the side are foreshortened, on average about this much.
    const pixel = this.#pixel * w;
    const pixels = (data[at + 6] / pixel) * (0.35 + 0.65 * Math.abs(facing));
    if (pixels < ARROWS_FROM) return false;
    if (pixels >= LABELS_FROM_PX) this.large.push(f);
    const faded = (pixels - FADE_PX[0]) / (FADE_PX[1] - FADE_PX[0]);
    if (strength > 0 || faded > 0) {
      const { faded: far, arrow } = this.#colors;
      this.#tint.lerpColors(far, arrow, Math.min(1, Math.max(faded, strength)));
      const rows = this.#rows as FaceRows;
      const count = rows.place(f, arrowSizes(pixel, this.#sizes));
      this.#batch.addArrows(rows.arrows, count, this.#tint);
    }
    if (!this.#closed) this.#writeBoundaries(f);
    return true;
  }

  /** The boundary halfedges across the edges of a face: never faded, never hidden. */
  #writeBoundaries(f: number): void {
    const { next, face, faceHalfedge } = (this.#surface as Surface).mesh.connectivity;
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
    this.#batch.addDashed(glyphs.arrows, 0, 3, this.#colors.boundary, 5 * pixel, 0.4);
    this.#batch.add(glyphs.arrows, 3, 6, this.#colors.boundary);
    this.boundary.push(h);
  }
}
