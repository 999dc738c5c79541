import {
  type Color,
  DynamicDrawUsage,
  GreaterDepth,
  InstancedInterleavedBuffer,
  InterleavedBufferAttribute,
  Vector4,
} from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';

/** Coloured line segments that are written anew again and again; memory grows and is kept. */
export class LineBatch {
  readonly geometry = new LineSegmentsGeometry();
  #positions = new InstancedInterleavedBuffer(new Float32Array(0), 6, 1);
  #colors = new InstancedInterleavedBuffer(new Float32Array(0), 6, 1);
  #capacity = 0;
  #count = 0;

  constructor(capacity = 64) {
    this.#grow(capacity);
  }

  get count(): number {
    return this.#count;
  }

  clear(): void {
    this.#count = 0;
  }

  /** Adds the segment from xyz at `a` to xyz at `b` of `points`. */
  add(points: ArrayLike<number>, a: number, b: number, color: Color): void {
    if (this.#count === this.#capacity) this.#grow(2 * this.#capacity);
    const at = 6 * this.#count++;
    const p = this.#positions.array as Float32Array;
    const c = this.#colors.array as Float32Array;
    p[at] = points[a];
    p[at + 1] = points[a + 1];
    p[at + 2] = points[a + 2];
    p[at + 3] = points[b];
    p[at + 4] = points[b + 1];
    p[at + 5] = points[b + 2];
    c[at] = c[at + 3] = color.r;
    c[at + 1] = c[at + 4] = color.g;
    c[at + 2] = c[at + 5] = color.b;
  }

  /** Adds the segment as dashes: `period` long each, the first `duty` of it drawn. */
  addDashed(
    points: ArrayLike<number>,
    a: number,
    b: number,
    color: Color,
    period: number,
    duty: number,
  ): void {
    const length = Math.hypot(
      points[b] - points[a],
      points[b + 1] - points[a + 1],
      points[b + 2] - points[a + 2],
    );
    // The last dash ends where the segment does, so that both ends of it can be seen.
    const dashes = Math.max(1, Math.min(200, Math.round(length / period - duty) + 1));
    const pitch = 1 / (dashes - 1 + duty);
    const part = dashes > 1 ? duty * pitch : 1;
    const piece = [0, 0, 0, 0, 0, 0];
    for (let i = 0; i < dashes; i++) {
      for (let k = 0; k < 3; k++) {
        const span = points[b + k] - points[a + k];
        piece[k] = points[a + k] + span * i * pitch;
        piece[k + 3] = piece[k] + span * part;
      }
      this.add(piece, 0, 3, color);
    }
  }

  /** Hands what was added to the graphics card. */
  upload(): void {
    this.geometry.instanceCount = this.#count;
    for (const buffer of [this.#positions, this.#colors]) {
      buffer.clearUpdateRanges();
      buffer.addUpdateRange(0, 6 * this.#count);
      buffer.needsUpdate = true;
    }
  }

  #grow(capacity: number): void {
    const grown = (from: InstancedInterleavedBuffer) => {
      const array = new Float32Array(6 * capacity);
      array.set(from.array.subarray(0, 6 * this.#count) as Float32Array);
      return new InstancedInterleavedBuffer(array, 6, 1).setUsage(DynamicDrawUsage);
    };
    this.geometry.dispose();
    this.#positions = grown(this.#positions) as InstancedInterleavedBuffer;
    this.#colors = grown(this.#colors) as InstancedInterleavedBuffer;
    this.#capacity = capacity;
    const { geometry } = this;
    geometry.setAttribute('instanceStart', new InterleavedBufferAttribute(this.#positions, 3, 0));
    geometry.setAttribute('instanceEnd', new InterleavedBufferAttribute(this.#positions, 3, 3));
    geometry.setAttribute('instanceColorStart', new InterleavedBufferAttribute(this.#colors, 3, 0));
    geometry.setAttribute('instanceColorEnd', new InterleavedBufferAttribute(this.#colors, 3, 3));
    geometry.instanceCount = this.#count;
  }
}

/** A fat line material in CSS pixels, coloured by its segments, that wins against the surface. */
export function lineMaterial(linewidth: number, bias: number): LineMaterial {
  const material = new LineMaterial({ linewidth, vertexColors: true });
  material.polygonOffset = true;
  material.polygonOffsetFactor = -bias;
  material.polygonOffsetUnits = -bias;
  return material;
}

/** The segments of a batch as an object of the scene; drawn in `order` among the overlays. */
export function lines(batch: LineBatch, material: LineMaterial, order: number): LineSegments2 {
  const object = new LineSegments2(batch.geometry, material);
  object.frustumCulled = false;
  object.renderOrder = order;
  if (!Object.hasOwn(LineSegments2.prototype, 'onBeforeRender')) {
    // Before r162 of three.js, a material doesn't learn by itself how many pixels there are.
    object.onBeforeRender = (renderer) => {
      renderer.getViewport(viewport);
      material.resolution.set(viewport.z, viewport.w);
    };
  }
  return object;
}

const viewport = new Vector4();

/** The same lines where something hides them: faint. */
export function ghostOf(material: LineMaterial, opacity = 0.22): LineMaterial {
  const ghost = material.clone();
  ghost.depthFunc = GreaterDepth;
  ghost.transparent = true;
  ghost.opacity = opacity;
  ghost.depthWrite = false;
  return ghost;
}
