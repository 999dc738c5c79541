import { BufferGeometry, type Color, LineBasicMaterial, LineSegments } from 'three';
import { LineBatch, lineMaterial, lines } from '../three/index.js';
import { RowBuffer, roomFor } from '../three/rows.js';
import type { Stage } from './stage.js';
import type { Surface } from './surface.js';

/** Edges shorter than this on the screen are not drawn at all. */
const HIDDEN_PX = 6;
const FULL_PX = 16;

/** All edges as hairlines, as far as they can be told apart, and the boundary as a strong line. */
export class Wire {
  readonly #stage: Stage;
  readonly #material = new LineBasicMaterial({ transparent: true });
  readonly #hairlines = new LineSegments(new BufferGeometry(), this.#material);
  readonly #boundary = new LineBatch();
  readonly #boundaryMaterial = lineMaterial(2.25, 1);
  readonly #boundaryLines = lines(this.#boundary, this.#boundaryMaterial, 2);
  readonly #edges = new RowBuffer(new Uint32Array(0), 2, false, 1);
  /** Whether the edges are to be written, as soon as they are to be seen. */
  #isStale = false;
  #surface: Surface | null = null;
  #colored: Color | null = null;
  #hidden: ReadonlySet<number> = new Set();

  constructor(stage: Stage) {
    this.#stage = stage;
    this.#hairlines.frustumCulled = false;
    this.#hairlines.renderOrder = 1;
    stage.scene.add(this.#hairlines, this.#boundaryLines);
  }

  /** Whether the boundary is drawn more strongly than other edges. */
  set showsBoundary(shows: boolean) {
    this.#boundaryLines.visible = shows;
  }

  /** Shows the edges of a surface, but for some. */
  show(surface: Surface, hidden: ReadonlySet<number> = new Set()): void {
    this.#surface = surface;
    this.#hidden = hidden;
    this.#isStale = true;
    this.#writeBoundary();
  }

  setColors(wire: Color, boundary: Color): void {
    this.#material.color.copy(wire);
    this.#colored = boundary.clone();
    this.#writeBoundary();
  }

  /** Before each frame: how strong the hairlines are, at the distance where the surface is seen. */
  update(): void {
    const surface = this.#surface;
    if (!surface) return;
    const depth = this.#stage.camera.position.distanceTo(this.#stage.controls.target);
    const pixels = surface.medianEdge / this.#stage.pixelAt(depth);
    const strength = Math.min(1, Math.max(0, (pixels - HIDDEN_PX) / (FULL_PX - HIDDEN_PX)));
    this.#hairlines.visible = strength > 0;
    this.#material.opacity = 0.15 + 0.85 * strength;
    // The index of all edges is only made for meshes that are seen close enough to need it.
    if (strength > 0 && this.#isStale) this.#writeEdges(surface);
  }

  /** Each edge has a place of its own, so that after an edit only those are uploaded that changed. */
  #writeEdges(surface: Surface): void {
    const { toVertex, next } = surface.mesh.connectivity;
    const edges = toVertex.length / 2;
    const known = this.#edges.attribute;
    if (2 * edges > known.array.length) this.#edges.reserve(roomFor(edges));
    for (let e = 0; e < edges; e++) {
      const isShown = next[2 * e] >= 0 && !this.#hidden.has(e);
      ends[0] = isShown ? toVertex[2 * e + 1] : 0;
      ends[1] = isShown ? toVertex[2 * e] : 0;
      this.#edges.write(e, ends, 0);
    }
    const { geometry } = this.#hairlines;
    const { attribute } = this.#edges;
    if (attribute === known) this.#edges.mark();
    else this.#edges.forget();
    if (geometry.index !== attribute || geometry.attributes.position !== surface.position) {
      geometry.deleteAttribute('position'); // which the surface goes on to use
      geometry.dispose();
      geometry.setAttribute('position', surface.position);
      geometry.setIndex(attribute);
    }
    geometry.setDrawRange(0, 2 * edges);
    this.#isStale = false;
  }

  #writeBoundary(): void {
    this.#boundary.clear();
    if (this.#surface && this.#colored) {
      const { toVertex, face, next } = this.#surface.mesh.connectivity;
      const { points } = this.#surface;
      for (let h = 0; h < face.length; h++) {
        if (face[h] !== -1 || next[h] < 0 || this.#hidden.has(h >> 1)) continue;
        this.#boundary.add(points, 3 * toVertex[h ^ 1], 3 * toVertex[h], this.#colored);
      }
    }
    this.#boundary.upload();
  }
}

const ends = [0, 0];
