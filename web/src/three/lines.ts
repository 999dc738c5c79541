import {
  type Color,
  DoubleSide,
  GreaterDepth,
  type Material,
  type Mesh,
  type Scene,
  Vector4,
} from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import type { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { dashCount, MOST_DASHES, placeDashes } from './dashes.js';
import { LineBuffers, SEGMENT_FLOATS } from './line-buffers.js';

/**
 * Coloured line segments that are written anew again and again; memory grows and is kept. What is written as it was
 * before is not uploaded again.
 */
export class LineBatch {
  readonly #lines: LineBuffers;
  #count = 0;

  constructor(capacity?: number) {
    this.#lines = new LineBuffers(2, capacity);
  }

  /** What three.js draws. */
  get geometry(): LineSegmentsGeometry {
    return this.#lines.geometries[0];
  }

  /** How many segments there are. */
  get count(): number {
    return this.#count;
  }

  /** Begins anew: there are no segments. */
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
    tint[0] = color.r;
    tint[1] = color.g;
    tint[2] = color.b;
    this.#write();
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
    const dashes = dashCount(points, a, b, period, duty);
    placeDashes(points, a, b, dashes, duty, pieces, 0);
    for (let i = 0; i < dashes; i++)
      this.add(pieces, SEGMENT_FLOATS * i, SEGMENT_FLOATS * i + 3, color);
  }

  /** Hands what was added to the graphics card, as far as it has something else there. */
  upload(): void {
    this.#lines.upload(this.#count);
  }

  /** Writes `segment` in the colour `tint`. */
  #write(): void {
    const lines = this.#lines;
    const at = this.#count;
    this.#count += 1;
    lines.reserve(this.#count);
    const { positions, colors } = lines;
    const p = SEGMENT_FLOATS * at;
    const c = 3 * at;
    if (!lines.isStale(at)) {
      let isSame = true;
      for (let k = 0; isSame && k < 3; k++) isSame = colors[c + k] === tint[k];
      for (let k = 0; isSame && k < SEGMENT_FLOATS; k++) isSame = positions[p + k] === segment[k];
      if (isSame) return;
      lines.touch(at, at + 1);
    }
    for (let k = 0; k < SEGMENT_FLOATS; k++) positions[p + k] = segment[k];
    for (let k = 0; k < 3; k++) colors[c + k] = tint[k];
  }
}

/** The dashes of a segment on their way into a batch. */
const pieces = new Float64Array(MOST_DASHES * SEGMENT_FLOATS);
/** One segment and its colour on their way into a batch. */
const segment = new Float32Array(SEGMENT_FLOATS);
const tint = new Float32Array(3);

/** The quad of a line faces the camera, also in an object that is mirrored, whose front sides three.js takes for backs. */
export const LINE_SIDE = DoubleSide;

/** By how many CSS pixels a line comes nearer to the camera for each unit of its bias. */
export const LIFT_PX = 1.5;

/**
 * Moves what is drawn towards the camera, and nowhere on the screen. An arrow lies in the mean plane of its face, of
 * which the triangles of a face that isn't plane stand out: as far as this, they don't hide it. An offset of polygons
 * can't do that: it follows the slope of the line's own quad, which faces the camera and has none.
 */
const LIFT = `
  float lift = 2.0 * lineLift / (projectionMatrix[1][1] * resolution.y);
  if (projectionMatrix[2][3] == 0.0) {
    clip.z += projectionMatrix[2][2] * lift;
  } else {
    clip.z += projectionMatrix[3][2] * lift;
    clip /= 1.0 + lift;
  }
  gl_Position = clip;`;

/**
 * A fat line material in CSS pixels, coloured by its segments, that wins against the surface. The lift is a uniform:
 * all of them share a program, as far as they are coloured and blended alike.
 */
export function lineMaterial(linewidth: number, bias: number): LineMaterial {
  const material = new LineMaterial({ linewidth, vertexColors: true });
  material.uniforms.lineLift = { value: LIFT_PX * bias };
  const { vertexShader } = material;
  material.vertexShader = `uniform float lineLift;\n${vertexShader.replace('gl_Position = clip;', LIFT)}`;
  material.side = LINE_SIDE;
  offsetBy(material, bias);
  return material;
}

/** Lets a material win against what is as near as it is. */
export function offsetBy(material: Material, bias: number): void {
  material.polygonOffset = true;
  material.polygonOffsetFactor = -bias;
  material.polygonOffsetUnits = -bias;
}

/** Segments as an object of the scene, of a material that is as wide as it is told to be. */
export type DrawnLines = Mesh<LineSegmentsGeometry, Material & { linewidth: number }>;

/** What makes the lines of helpers: those of `halfedge/three/webgpu` for WebGPURenderer, others by default. */
export interface LineKind {
  /** Lines so many CSS pixels wide; the greater the bias, the nearer to the camera. */
  make(geometry: LineSegmentsGeometry, linewidth: number, bias: number): DrawnLines;
}

/** The lines of helpers for WebGLRenderer. */
export const webglLines: LineKind = {
  make(geometry, linewidth, bias) {
    const drawn = lines({ geometry }, lineMaterial(linewidth, bias), 0);
    const { onBeforeRender } = drawn;
    drawn.onBeforeRender = (renderer, ...rest) => {
      if (isWebGPU(renderer)) throw cannotDraw();
      onBeforeRender.call(drawn, renderer, ...rest);
    };
    return onlyAsLines(drawn);
  },
};

/**
 * Leaves lines out of what is drawn by a material that knows nothing of segments: `scene.overrideMaterial`, those of
 * passes such as ambient occlusion, and those of shadows would draw the quad of a segment, unplaced, at the origin.
 */
export function onlyAsLines(drawn: DrawnLines): DrawnLines {
  const { onBeforeRender, geometry } = drawn;
  let left: number | undefined;
  const leaveOut = () => {
    // WebGPURenderer does so for a shadow, and once more for its material.
    if (geometry.instanceCount > 0) left = geometry.instanceCount;
    geometry.instanceCount = 0;
  };
  const bringBack = () => {
    if (left !== undefined && geometry.instanceCount === 0) geometry.instanceCount = left;
    left = undefined;
  };
  drawn.onBeforeRender = (...args) => {
    onBeforeRender.apply(drawn, args);
    const [renderer, scene, , , material] = args as unknown as [object, Scene, ...LineMaterial[]];
    // WebGPURenderer tells the material that is overridden, WebGLRenderer the one that is drawn.
    const isOverridden =
      material === drawn.material
        ? isWebGPU(renderer) && Boolean(scene.overrideMaterial)
        : material !== undefined && !material.isLineMaterial;
    if (isOverridden) leaveOut();
  };
  return Object.assign(drawn, {
    onAfterRender: bringBack,
    onBeforeShadow: leaveOut,
    onAfterShadow: bringBack,
  });
}

const isWebGPU = (renderer: object) =>
  (renderer as { isWebGPURenderer?: boolean }).isWebGPURenderer === true;

const cannotDraw = () =>
  new TypeError(
    "WebGPURenderer can't draw the lines of a helper that is made without { lines: webgpuLines }; expected WebGLRenderer, or a helper with this option, of halfedge/three/webgpu.",
  );

/** Line segments as an object of the scene; drawn in `order` among the overlays. */
export function lines(
  { geometry }: { readonly geometry: LineSegmentsGeometry },
  material: LineMaterial,
  order: number,
): LineSegments2 {
  const object = new LineSegments2(geometry, material);
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
