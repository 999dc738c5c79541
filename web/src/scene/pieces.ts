import type { MeshLambertMaterial } from 'three';
import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Mesh } from 'three';
import type { Path } from './paths.js';
import type { Stage } from './stage.js';

/** Triangles in motion: each corner goes along a path of its own, and all fade together. */
export class Pieces {
  readonly #mesh: Mesh<BufferGeometry, MeshLambertMaterial>;
  #corners: readonly Path[] = [];

  constructor(stage: Stage, material: MeshLambertMaterial) {
    material.transparent = true;
    this.#mesh = new Mesh(new BufferGeometry(), material);
    this.#mesh.frustumCulled = false;
    this.#mesh.visible = false;
    stage.scene.add(this.#mesh);
  }

  /** Takes over triangles, three vertices each, and the paths of these. */
  set(triangles: readonly number[], path: (vertex: number) => Path): void {
    this.#corners = triangles.map(path);
    const position = new BufferAttribute(new Float32Array(3 * this.#corners.length), 3);
    this.#mesh.geometry.dispose();
    this.#mesh.geometry = new BufferGeometry();
    this.#mesh.geometry.setAttribute('position', position.setUsage(DynamicDrawUsage));
  }

  clear(): void {
    this.#corners = [];
    this.#mesh.visible = false;
  }

  /** Shows the pieces as they are at `t` from 0 to 1. */
  show(t: number, opacity: number): void {
    this.#mesh.visible = this.#corners.length > 0 && opacity > 0;
    if (!this.#mesh.visible) return;
    const { material } = this.#mesh;
    material.opacity = opacity;
    // What is solid comes first; what fades, over it, hides nothing that is behind.
    material.depthWrite = opacity === 1;
    this.#mesh.renderOrder = opacity === 1 ? 0.2 : 0.4;
    const position = this.#mesh.geometry.getAttribute('position');
    this.#corners.forEach(([from, to], i) => {
      const [x, y, z] = from.map((start, k) => start + t * (to[k] - start));
      position.setXYZ(i, x, y, z);
    });
    position.needsUpdate = true;
  }
}
