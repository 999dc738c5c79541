import { BufferGeometry, type Color, LineBasicMaterial, LineSegments } from 'three';
import { LineBatch, lineMaterial, lines } from '../three/index.js';
import { RowBuffer, roomFor } from '../three/rows.js';
import type { ChangedEdge } from './change.js';
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
  /** The edges that are to be written, as soon as they are to be seen; null for all of them. */
  #stale: Set<number> | null = new Set();
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

  /** Shows the edges of a surface, but for some. `changed` are those that are others now; null: all may be. */
  show(
    surface: Surface,
    hidden: ReadonlySet<number>,
    changed: readonly ChangedEdge[] | null,
  ): void {
    if (surface !== this.#surface || changed === null) this.#stale = null;
    for (const { edge } of changed ?? []) this.#stale?.add(edge);
    for (const edge of this.#hidden) this.#stale?.add(edge);
    for (const edge of hidden) this.#stale?.add(edge);
    this.#surface = surface;
    this.#hidden = hidden;
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
    if (strength > 0 && this.#stale?.size !== 0) this.#writeEdges(surface);
  }

  /** Each edge has a place of its own, so that after an edit only those are uploaded that changed. */
  #writeEdges(surface: Surface): void {
    const { toVertex, next } = surface.mesh.connectivity;
    const edges = toVertex.length / 2;
    const known = this.#edges.attribute;
    if (2 * edges > known.array.length) this.#edges.reserve(roomFor(edges));
    const write = (e: number) => {
      const isShown = next[2 * e] >= 0 && !this.#hidden.has(e);
      ends[0] = isShown ? toVertex[2 * e + 1] : 0;
      ends[1] = isShown ? toVertex[2 * e] : 0;
      this.#edges.write(e, ends, 0);
    };
    if (this.#stale === null) for (let e = 0; e < edges; e++) write(e);
    else for (const e of this.#stale) if (e < edges) write(e);
    this.#stale = new Set();
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
  }

  #writeBoundary(): void {
    this.#boundary.clear();
    if (this.#surface && this.#colored) {
      const { toVertex } = this.#surface.mesh.connectivity;
      const { points, boundary } = this.#surface;
      for (const h of boundary) {
        if (this.#hidden.has(h >> 1)) continue;
        this.#boundary.add(points, 3 * toVertex[h ^ 1], 3 * toVertex[h], this.#colored);
      }
    }
    this.#boundary.upload();
  }
}

const ends = [0, 0];
