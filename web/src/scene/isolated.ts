import { type Color, Vector3 } from 'three';
import { Discs } from './points.js';
import type { Stage } from './stage.js';
import type { Surface } from './surface.js';

/** How wide a vertex without edges is, in CSS pixels, and how near a pointer means it. */
const SIZE_PX = 7;
const REACH_PX = 10;
/** No more than this can be pointed at: each is looked at whenever the pointer moves. */
const MOST_PICKED = 20_000;

/** Vertices without edges: no face shows them, so that they are discs of their own. */
export class IsolatedVertices {
  readonly #stage: Stage;
  readonly #discs: Discs;
  readonly #seen = new Vector3();
  #vertices: number[] = [];
  #surface: Surface | null = null;
  #color: Color | null = null;

  constructor(stage: Stage) {
    this.#stage = stage;
    this.#discs = new Discs(stage.scene, 8);
  }

  show(surface: Surface): void {
    this.#surface = surface;
    this.#vertices = [];
    surface.mesh.connectivity.vertexHalfedge.forEach((h, v) => {
      if (h === -1) this.#vertices.push(v);
    });
    this.#draw();
  }

  setColors(color: Color, rim: Color): void {
    this.#color = color.clone();
    this.#discs.setRim(rim);
    this.#draw();
  }

  /** The vertex at (x, y), if there is one that nothing hides. */
  at(x: number, y: number, reach: number, hides: (point: Vector3) => boolean): number | null {
    const surface = this.#surface;
    if (!surface) return null;
    let found: number | null = null;
    let least = REACH_PX * reach;
    for (const v of this.#vertices.slice(0, MOST_PICKED)) {
      const seen = this.#stage.project(this.#seen.fromArray(surface.points, 3 * v), this.#seen);
      const distance = Math.hypot(seen.x - x, seen.y - y);
      if (seen.z > 1 || distance >= least) continue;
      if (hides(new Vector3().fromArray(surface.points, 3 * v))) continue;
      least = distance;
      found = v;
    }
    return found;
  }

  #draw(): void {
    this.#discs.clear();
    if (this.#surface && this.#color) {
      for (const v of this.#vertices) {
        this.#discs.add(this.#surface.points, 3 * v, SIZE_PX, this.#color);
      }
    }
    this.#discs.upload();
    this.#stage.invalidate();
  }
}
