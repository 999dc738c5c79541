import type { Palette } from 'halfedge/scene';
import { Discs, FILE_LAYER, type Stage, triangulateRing } from 'halfedge/scene';
import { ghostOf, LineBatch, lineMaterial, lines } from 'halfedge/three';
import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshBasicMaterial } from 'three';
import type { Place, SoupShape } from './soup-shape.js';

/** Once so many corners of triangles are lit, no more faces are filled: their outlines show them. */
const MOST_LIT = 300_000;

/** Lights a problem of the file: outlines of faces, edges, vertices; over the file and over the mesh. */
export class WitnessView {
  readonly #stage: Stage;
  readonly #lines = new LineBatch();
  readonly #halo = lineMaterial(7, 4);
  readonly #discs: Discs;
  readonly #fill: Mesh<BufferGeometry, MeshBasicMaterial>;

  constructor(stage: Stage) {
    this.#stage = stage;
    const main = lineMaterial(3.5, 5);
    main.transparent = true;
    this.#halo.vertexColors = false;
    this.#halo.transparent = true;
    this.#halo.depthWrite = false;
    const fill = new MeshBasicMaterial({
      transparent: true,
      opacity: 0.3,
      side: DoubleSide,
      depthWrite: false,
    });
    fill.polygonOffset = true;
    fill.polygonOffsetFactor = fill.polygonOffsetUnits = -2;
    this.#fill = new Mesh(new BufferGeometry(), fill);
    this.#fill.frustumCulled = false;
    this.#fill.renderOrder = 10;
    this.#discs = new Discs(stage.scene, 14);
    const objects = [
      this.#fill,
      lines(this.#lines, ghostOf(main, 0.45), 11),
      lines(this.#lines, this.#halo, 12),
      lines(this.#lines, main, 13),
    ];
    stage.scene.add(...objects);
    for (const object of [...objects, ...this.#discs.objects]) object.layers.enable(FILE_LAYER);
    this.#upload();
  }

  /** Lights what is at a place, or nothing. */
  show(shape: SoupShape | null, place: Place | null, palette: Palette): void {
    this.#lines.clear();
    this.#discs.clear();
    this.#halo.color.copy(palette.surface);
    this.#discs.setRim(palette.background);
    this.#fill.material.color.copy(palette.self);
    const pieces: number[] = [];
    if (shape && place) {
      const { points } = shape;
      for (const ring of place.rings) {
        if (ring.length === 1) this.#discs.add(points, 3 * ring[0], 15, palette.self);
        ring.forEach((v, i) => {
          this.#lines.add(points, 3 * v, 3 * ring[(i + 1) % ring.length], palette.self);
        });
        if (ring.length >= 3 && pieces.length < MOST_LIT) {
          for (const v of triangulateRing([...ring], points)) pieces.push(v);
        }
      }
      const { vertices } = place;
      if (vertices.length === 2) {
        this.#lines.add(points, 3 * vertices[0], 3 * vertices[1], palette.self);
      }
      for (const v of vertices) this.#discs.add(points, 3 * v, 15, palette.self);
    }
    const positions = new Float32Array(3 * pieces.length);
    pieces.forEach((v, i) => {
      if (shape) positions.set(shape.points.subarray(3 * v, 3 * v + 3), 3 * i);
    });
    this.#fill.geometry.dispose();
    this.#fill.geometry = new BufferGeometry();
    this.#fill.geometry.setAttribute('position', new BufferAttribute(positions, 3));
    this.#fill.visible = positions.length > 0;
    this.#upload();
    this.#stage.invalidate();
  }

  #upload(): void {
    this.#lines.upload();
    this.#discs.upload();
  }
}
