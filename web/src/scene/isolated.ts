import type { Color } from 'three';
import { NONE } from '../api.js';
import { Discs } from './points.js';
import type { Stage } from './stage.js';
import type { Surface } from './surface.js';

/** How wide a vertex without edges is, in CSS pixels. */
const SIZE_PX = 7;

/** Vertices without edges: no face shows them, so that they are discs of their own. */
export class IsolatedVertices {
  /** Those of the mesh on show. */
  vertices: readonly number[] = [];
  readonly #stage: Stage;
  readonly #discs: Discs;
  #surface: Surface | null = null;
  #color: Color | null = null;

  constructor(stage: Stage) {
    this.#stage = stage;
    this.#discs = new Discs(stage.scene, 8);
  }

  show(surface: Surface): void {
    this.#surface = surface;
    const vertices: number[] = [];
    const { vertexHalfedge } = surface.mesh.connectivity;
    for (let v = 0; v < vertexHalfedge.length; v++) {
      if (vertexHalfedge[v] === NONE) vertices.push(v);
    }
    this.vertices = vertices;
    this.#draw();
  }

  setColors(color: Color, rim: Color): void {
    this.#color = color.clone();
    this.#discs.setRim(rim);
    this.#draw();
  }

  #draw(): void {
    this.#discs.clear();
    if (this.#surface && this.#color) {
      for (const v of this.vertices) {
        this.#discs.add(this.#surface.points, 3 * v, SIZE_PX, this.#color);
      }
    }
    this.#discs.upload();
    this.#stage.invalidate();
  }
}
