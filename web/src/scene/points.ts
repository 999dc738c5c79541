import {
  BufferAttribute,
  BufferGeometry,
  type Color,
  DynamicDrawUsage,
  GreaterDepth,
  Points,
  type Scene,
  ShaderMaterial,
} from 'three';
import { pixelRatio } from './screen.js';

const vertexShader = /* glsl */ `
  attribute vec3 tint;
  attribute float size;
  uniform float pixelRatio;
  varying vec3 vTint;
  varying float vSize;
  void main() {
    vTint = tint;
    vSize = size * pixelRatio;
    vec4 seen = modelViewMatrix * vec4(position, 1.0);
    // Nearer to the eye on the same ray, so that the surface does not cut the disc in half.
    seen.xyz *= 0.994;
    gl_Position = projectionMatrix * seen;
    gl_PointSize = vSize + 2.0;
  }`;

const fragmentShader = /* glsl */ `
  uniform vec3 rim;
  uniform float opacity;
  uniform float pixelRatio;
  varying vec3 vTint;
  varying float vSize;
  void main() {
    float r = length(gl_PointCoord - 0.5) * (vSize + 2.0);
    float radius = 0.5 * vSize;
    float cover = clamp(radius + 0.5 - r, 0.0, 1.0);
    if (cover <= 0.0) discard;
    float core = clamp(radius - 1.75 * pixelRatio + 0.5 - r, 0.0, 1.0);
    gl_FragColor = vec4(mix(rim, vTint, core), cover * opacity);
    #include <colorspace_fragment>
  }`;

/** Discs of a fixed size on the screen, with a rim; a faint second pass shows the hidden ones. */
export class Discs {
  readonly #geometry = new BufferGeometry();
  readonly #materials: ShaderMaterial[];
  /** What it is made of, for the layers that it is on. */
  readonly objects: readonly Points[];
  #capacity = 0;
  #count = 0;
  /** Whether a disc was written that isn't as it was before. */
  #isStale = false;

  constructor(scene: Scene, order: number) {
    this.#grow(64);
    this.#materials = [1, 0.3].map(
      (opacity) =>
        new ShaderMaterial({
          vertexShader,
          fragmentShader,
          transparent: true,
          depthWrite: false,
          uniforms: {
            rim: { value: [1, 1, 1] },
            opacity: { value: opacity },
            pixelRatio: { value: pixelRatio() },
          },
        }),
    );
    this.#materials[1].depthFunc = GreaterDepth;
    this.objects = this.#materials.map((material) => {
      const object = new Points(this.#geometry, material);
      object.frustumCulled = false;
      object.renderOrder = order;
      scene.add(object);
      return object;
    });
  }

  setRim(color: Color): void {
    for (const { uniforms } of this.#materials) uniforms.rim.value = color.toArray();
  }

  clear(): void {
    this.#count = 0;
  }

  /** Adds a disc `size` CSS pixels wide at xyz of `points`. */
  add(points: ArrayLike<number>, at: number, size: number, color: Color): void {
    if (this.#count === this.#capacity) this.#grow(2 * this.#capacity);
    const { position, tint, size: sizes } = this.#geometry.attributes;
    const i = this.#count++;
    const place = [points[at], points[at + 1], points[at + 2]];
    for (const [{ array }, values] of [
      [position, place],
      [tint, [color.r, color.g, color.b]],
      [sizes, [size]],
    ] as const) {
      values.forEach((value, k) => {
        const to = values.length * i + k;
        if (array[to] === Math.fround(value)) return;
        array[to] = value;
        this.#isStale = true;
      });
    }
  }

  upload(): void {
    this.#geometry.setDrawRange(0, this.#count);
    for (const attribute of Object.values(this.#geometry.attributes)) {
      if (this.#isStale) attribute.needsUpdate = true;
    }
    this.#isStale = false;
    for (const { uniforms } of this.#materials) uniforms.pixelRatio.value = pixelRatio();
  }

  #grow(capacity: number): void {
    const old = this.#geometry.attributes;
    this.#geometry.dispose();
    for (const [name, components] of [
      ['position', 3],
      ['tint', 3],
      ['size', 1],
    ] as const) {
      const array = new Float32Array(components * capacity);
      if (old[name]) array.set(old[name].array as Float32Array);
      const attribute = new BufferAttribute(array, components);
      this.#geometry.setAttribute(name, attribute.setUsage(DynamicDrawUsage));
    }
    this.#capacity = capacity;
  }
}

/** Discs know their size in pixels of the canvas: sets how many there are to a CSS pixel. Returns the ratio before. */
export function setPointRatio(scene: Scene, ratio: number): number {
  let before = ratio;
  scene.traverse((object) => {
    const { uniforms } = (object as { material?: ShaderMaterial }).material ?? {};
    if (!uniforms?.pixelRatio) return;
    before = uniforms.pixelRatio.value;
    uniforms.pixelRatio.value = ratio;
  });
  return before;
}
