import {
  BufferAttribute,
  BufferGeometry,
  type Color,
  DoubleSide,
  DynamicDrawUsage,
  GreaterDepth,
  Mesh,
  MeshBasicMaterial,
} from 'three';
import type { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import type { Item } from '../teaching/items.js';
import { arrowSizes, ghostOf, LineBatch, lineMaterial, lines } from '../three/index.js';
import type { Glyphs } from './glyphs.js';
import { Discs } from './points.js';
import type { Stage } from './stage.js';
import type { Surface } from './surface.js';

/** An item to be drawn over the mesh. */
export interface Mark {
  readonly item: Item;
  readonly color: Color;
  readonly weight: 'strong' | 'fine' | 'faint';
  readonly dashed?: boolean;
}

/**
 * Marked items over the mesh: halfedges as arrows, edges as lines, vertices as discs, faces as
 * tints. Each mark has a halo that sets it apart, and shows faintly through what is before it.
 */
export class Highlights {
  readonly #stage: Stage;
  readonly #strong = new LineBatch();
  readonly #fine = new LineBatch();
  readonly #discs: Discs;
  readonly #fills = new BufferGeometry();
  readonly #fillMaterials: MeshBasicMaterial[];
  readonly #halos: LineMaterial[];
  #surface: Surface | null = null;
  #glyphs: Glyphs | null = null;
  #marks: readonly Mark[] = [];

  constructor(stage: Stage) {
    this.#stage = stage;
    const strong = lineMaterial(3.5, 4);
    const fine = lineMaterial(2.25, 3);
    // Transparent ones are drawn in their order, so that each line comes after its halo.
    strong.transparent = fine.transparent = true;
    this.#halos = [lineMaterial(7, 3), lineMaterial(4.75, 2.5)];
    for (const halo of this.#halos) {
      halo.vertexColors = false;
      halo.transparent = true;
      halo.opacity = 0.85;
      halo.depthWrite = false;
    }
    this.#fillMaterials = [0.34, 0.08].map((opacity) => {
      const material = new MeshBasicMaterial({
        vertexColors: true,
        transparent: true,
        opacity,
        side: DoubleSide,
        depthWrite: false,
      });
      material.polygonOffset = true;
      material.polygonOffsetFactor = -1;
      material.polygonOffsetUnits = -1;
      return material;
    });
    this.#fillMaterials[1].depthFunc = GreaterDepth;
    const scene = stage.scene;
    for (const material of this.#fillMaterials) {
      const fill = new Mesh(this.#fills, material);
      fill.frustumCulled = false;
      fill.renderOrder = 1.5;
      scene.add(fill);
    }
    for (const [batch, main, halo, order] of [
      [this.#fine, fine, this.#halos[1], 4],
      [this.#strong, strong, this.#halos[0], 6],
    ] as const) {
      scene.add(lines(batch, ghostOf(main), order));
      scene.add(lines(batch, halo, order + 0.5));
      scene.add(lines(batch, main, order + 1));
    }
    this.#discs = new Discs(scene, 9);
  }

  show(surface: Surface, glyphs: Glyphs): void {
    this.#surface = surface;
    this.#glyphs = glyphs;
    this.setMarks([]);
  }

  setColors(halo: Color, rim: Color): void {
    for (const material of this.#halos) material.color.copy(halo);
    this.#discs.setRim(rim);
  }

  setMarks(marks: readonly Mark[]): void {
    this.#marks = marks;
    this.#writeFills();
    this.#stage.invalidate();
  }

  /** Before each frame: the arrows keep their size on the screen. */
  update(): void {
    const surface = this.#surface;
    if (!surface) return;
    this.#strong.clear();
    this.#fine.clear();
    this.#discs.clear();
    for (const mark of this.#marks) this.#write(surface, mark);
    this.#strong.upload();
    this.#fine.upload();
    this.#discs.upload();
  }

  #write(surface: Surface, { item, color, weight, dashed }: Mark): void {
    const batch = weight === 'strong' ? this.#strong : this.#fine;
    const { toVertex } = surface.mesh.connectivity;
    switch (item.kind) {
      case 'vertex':
        this.#discs.add(surface.points, 3 * item.index, weight === 'strong' ? 15 : 11, color);
        break;
      case 'edge': {
        const [a, b] = [toVertex[2 * item.index + 1], toVertex[2 * item.index]];
        batch.add(surface.points, 3 * a, 3 * b, color);
        break;
      }
      case 'halfedge':
        this.#writeArrow(batch, item.index, color, dashed ?? false);
        break;
      case 'face':
        break;
    }
  }

  #writeArrow(batch: LineBatch, h: number, color: Color, dashed: boolean): void {
    const glyphs = this.#glyphs as Glyphs;
    const surface = this.#surface as Surface;
    const p = 3 * surface.mesh.connectivity.toVertex[h];
    const { points } = surface;
    const depth = this.#stage.depthOf(points[p], points[p + 1], points[p + 2]);
    const pixel = this.#stage.pixelAt(Math.max(1e-6, depth));
    const at = glyphs.halfedge(h, { ...arrowSizes(pixel), barb: 12 * pixel });
    const onBoundary = surface.mesh.connectivity.face[h] < 0;
    if (dashed) batch.addDashed(glyphs.arrows, at, at + 3, color, 9 * pixel, 0.6);
    else if (onBoundary) batch.addDashed(glyphs.arrows, at, at + 3, color, 6.5 * pixel, 0.35);
    else batch.add(glyphs.arrows, at, at + 3, color);
    batch.add(glyphs.arrows, at + 3, at + 6, color);
  }

  #writeFills(): void {
    const surface = this.#surface;
    const positions: number[] = [];
    const colors: number[] = [];
    for (const { item, color, weight } of surface ? this.#marks : []) {
      if (item.kind !== 'face' || !surface) continue;
      const share = { strong: 1, fine: 0.62, faint: 0.36 }[weight];
      for (const v of surface.triangleVertices(item.index)) {
        for (let k = 0; k < 3; k++) positions.push(surface.points[3 * v + k]);
        colors.push(color.r, color.g, color.b, share);
      }
    }
    this.#fills.dispose();
    for (const [name, values, size] of [
      ['position', positions, 3],
      ['color', colors, 4],
    ] as const) {
      const attribute = new BufferAttribute(new Float32Array(values), size);
      this.#fills.setAttribute(name, attribute.setUsage(DynamicDrawUsage));
    }
    this.#fills.setDrawRange(0, positions.length / 3);
  }
}
