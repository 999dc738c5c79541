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
import { ARROW_FLOATS } from './arrow-rows.js';

/** Segments are uploaded in blocks of so many, those of which one has changed. */
const BLOCK = 64;
/** With more ranges than this, of an object that isn't drawn, the whole buffer waits to be uploaded. */
const MOST_RANGES = 1000;

/**
 * Coloured line segments that are written anew again and again; memory grows and is kept. What is written as it was
 * before is not uploaded again.
 */
export class LineBatch {
  readonly geometry = new LineSegmentsGeometry();
  /** xyz of both ends by segment, and one colour for both. */
  #positions = new Float32Array(0);
  #colors = new Float32Array(0);
  readonly #buffers: InstancedInterleavedBuffer[] = [];
  /** By block: whether a segment of it is other than what was uploaded. */
  #isStale = new Uint8Array(0);
  #capacity = 0;
  #count = 0;

  constructor(capacity = BLOCK) {
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
    segment[0] = points[a];
    segment[1] = points[a + 1];
    segment[2] = points[a + 2];
    segment[3] = points[b];
    segment[4] = points[b + 1];
    segment[5] = points[b + 2];
    this.#reserve(this.#count + 1);
    this.#write(segment, 0, 3, color);
  }

  /** Adds shaft and barb of so many arrows, as `ArrowTracer` writes them. */
  addArrows(arrows: Float32Array, count: number, color: Color): void {
    const { r, g, b } = color;
    this.#reserve(this.#count + 2 * count);
    const positions = this.#positions;
    const colors = this.#colors;
    for (let at = 0; at < count * ARROW_FLOATS; at += ARROW_FLOATS) {
      const shaft = this.#count;
      if (
        this.#isStale[(shaft / BLOCK) | 0] === 0 ||
        this.#isStale[((shaft + 1) / BLOCK) | 0] === 0
      ) {
        this.#write(arrows, at, at + 3, color);
        this.#write(arrows, at + 3, at + 6, color);
        continue;
      }
      // Most arrows, while the camera moves: nothing is left to be compared.
      const p = 6 * shaft;
      for (let k = 0; k < 6; k++) {
        positions[p + k] = arrows[at + k];
        positions[p + 6 + k] = arrows[at + 3 + k];
      }
      const c = 3 * shaft;
      colors[c] = colors[c + 3] = r;
      colors[c + 1] = colors[c + 4] = g;
      colors[c + 2] = colors[c + 5] = b;
      this.#count = shaft + 2;
    }
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

  /** Hands what was added to the graphics card, as far as it has something else there. */
  upload(): void {
    this.geometry.instanceCount = this.#count;
    const blocks = Math.ceil(this.#count / BLOCK);
    for (let from = 0; from < blocks; from++) {
      if (this.#isStale[from] === 0) continue;
      let to = from;
      while (to < blocks && this.#isStale[to] === 1) this.#isStale[to++] = 0;
      const end = Math.min(to * BLOCK, this.#capacity);
      for (const buffer of this.#buffers) {
        if (buffer.updateRanges.length >= MOST_RANGES) {
          // A range all the same: three.js uploads the whole buffer only as long as there is none.
          buffer.clearUpdateRanges();
          buffer.addUpdateRange(0, buffer.array.length);
        } else {
          buffer.addUpdateRange(from * BLOCK * buffer.stride, (end - from * BLOCK) * buffer.stride);
        }
        buffer.needsUpdate = true;
      }
      from = to;
    }
  }

  /** pre: there is room for one more */
  #write(from: Float32Array, a: number, b: number, color: Color): void {
    const block = (this.#count / BLOCK) | 0;
    const p = 6 * this.#count;
    const c = 3 * this.#count;
    this.#count += 1;
    const positions = this.#positions;
    const colors = this.#colors;
    if (this.#isStale[block] === 0) {
      let isSame =
        colors[c] === Math.fround(color.r) &&
        colors[c + 1] === Math.fround(color.g) &&
        colors[c + 2] === Math.fround(color.b);
      for (let k = 0; isSame && k < 3; k++) {
        isSame = positions[p + k] === from[a + k] && positions[p + 3 + k] === from[b + k];
      }
      if (isSame) return;
      this.#isStale[block] = 1;
    }
    for (let k = 0; k < 3; k++) {
      positions[p + k] = from[a + k];
      positions[p + 3 + k] = from[b + k];
    }
    colors[c] = color.r;
    colors[c + 1] = color.g;
    colors[c + 2] = color.b;
  }

  #reserve(count: number): void {
    if (count > this.#capacity) this.#grow(2 * count);
  }

  #grow(capacity: number): void {
    const grown = (from: Float32Array, components: number) => {
      const array = new Float32Array(components * capacity);
      array.set(from.subarray(0, components * this.#count));
      return array;
    };
    this.#positions = grown(this.#positions, 6);
    this.#colors = grown(this.#colors, 3);
    this.#capacity = capacity;
    // Other buffers are uploaded whole.
    this.#isStale = new Uint8Array(Math.ceil(capacity / BLOCK));
    const positions = new InstancedInterleavedBuffer(this.#positions, 6, 1);
    const colors = new InstancedInterleavedBuffer(this.#colors, 3, 1);
    this.#buffers.splice(0, 2, positions, colors);
    for (const buffer of this.#buffers) buffer.setUsage(DynamicDrawUsage);
    const { geometry } = this;
    geometry.dispose();
    const both = new InterleavedBufferAttribute(colors, 3, 0);
    geometry.setAttribute('instanceStart', new InterleavedBufferAttribute(positions, 3, 0));
    geometry.setAttribute('instanceEnd', new InterleavedBufferAttribute(positions, 3, 3));
    geometry.setAttribute('instanceColorStart', both);
    geometry.setAttribute('instanceColorEnd', both);
    geometry.instanceCount = this.#count;
  }
}

/** One segment on its way into a batch. */
const segment = new Float32Array(6);

/** By how many CSS pixels a line comes nearer to the camera for each unit of its bias. */
const LIFT_PX = 1.5;

/**
 * Moves what is drawn towards the camera, and nowhere on the screen. An arrow lies in the mean plane of its face, of
 * which the triangles of a face that isn't plane stand out: as far as this, they don't hide it. An offset of polygons
 * can't do that: it follows the slope of the line's own quad, which faces the camera and has none.
 */
const LIFT = `
  float lift = 2.0 * LIFT / (projectionMatrix[1][1] * resolution.y);
  clip.z += (projectionMatrix[2][3] == 0.0 ? projectionMatrix[2][2] : projectionMatrix[3][2]) * lift;
  gl_Position = clip;`;

/** A fat line material in CSS pixels, coloured by its segments, that wins against the surface. */
export function lineMaterial(linewidth: number, bias: number): LineMaterial {
  const material = new LineMaterial({ linewidth, vertexColors: true });
  material.defines.LIFT = (LIFT_PX * bias).toFixed(2);
  material.vertexShader = material.vertexShader.replace('gl_Position = clip;', LIFT);
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
