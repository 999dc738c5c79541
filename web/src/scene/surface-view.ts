import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshLambertMaterial } from 'three';
import type { Surface } from './surface.js';

/** The looks of the surface: flat facets, back sides in a tint of their own. */
export class SurfaceLook {
  readonly #materials: MeshLambertMaterial[] = [];
  readonly #back = { value: new Array<number>(3).fill(0) };
  #front: readonly number[] = [1, 1, 1];

  /** A material with these looks; `bias` moves it back in depth, behind lines and other layers. */
  material(bias: number): MeshLambertMaterial {
    const material = new MeshLambertMaterial({ flatShading: true, side: DoubleSide });
    material.polygonOffset = true;
    material.polygonOffsetFactor = bias;
    material.polygonOffsetUnits = bias;
    material.onBeforeCompile = (shader) => {
      shader.uniforms.backColor = this.#back;
      shader.fragmentShader = `uniform vec3 backColor;\n${shader.fragmentShader.replace(
        '#include <color_fragment>',
        '#include <color_fragment>\nif (!gl_FrontFacing) diffuseColor.rgb = backColor;',
      )}`;
    };
    this.#materials.push(material);
    this.setColors(this.#front, this.#back.value);
    return material;
  }

  setColors(front: readonly number[], back: readonly number[]): void {
    this.#front = [...front];
    this.#back.value = [...back];
    for (const { color } of this.#materials) color.setRGB(front[0], front[1], front[2]);
  }
}

/** The surface as an object of the scene. */
export class SurfaceView {
  readonly object: Mesh;

  constructor(look: SurfaceLook) {
    this.object = new Mesh(new BufferGeometry(), look.material(1));
    this.object.frustumCulled = false;
  }

  /** Shows a surface, but for some of its triangles. */
  show(surface: Surface, hidden: readonly number[] = []): void {
    this.object.geometry.dispose();
    const geometry = new BufferGeometry();
    const triangles = hidden.length === 0 ? surface.triangles : without(surface.triangles, hidden);
    geometry.setAttribute('position', surface.position);
    geometry.setIndex(new BufferAttribute(triangles, 1));
    this.object.geometry = geometry;
  }
}

/** The triangles but those at `hidden`, which are in ascending order. */
function without(triangles: Uint32Array, hidden: readonly number[]): Uint32Array {
  const rest = new Uint32Array(triangles.length - 3 * hidden.length);
  let from = 0;
  let to = 0;
  for (const at of [...hidden, triangles.length / 3]) {
    rest.set(triangles.subarray(from, 3 * at), to);
    to += 3 * at - from;
    from = 3 * (at + 1);
  }
  return rest;
}
