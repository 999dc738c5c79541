import { BufferGeometry, DoubleSide, Mesh, MeshLambertMaterial } from 'three';
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

  /** Shows a surface, but for some of its faces. */
  show(surface: Surface, hidden: ReadonlySet<number> = new Set()): void {
    surface.triangles.hide(hidden);
    const { geometry } = this.object;
    const { index, count } = surface.triangles;
    if (geometry.index !== index || geometry.attributes.position !== surface.position) {
      // What it had on the graphics card is freed; but points that stay are those of the wire, too.
      if (geometry.attributes.position === surface.position) geometry.deleteAttribute('position');
      geometry.dispose();
      geometry.setAttribute('position', surface.position);
      geometry.setIndex(index);
    }
    geometry.setDrawRange(0, 3 * count);
  }
}
