// The lines of helpers for three.js's WebGPURenderer, from release 0.180 on. An entry of its own: who draws with
// WebGLRenderer, or with an older release, loads none of it.

import {
  attribute,
  cameraNear,
  cameraProjectionMatrix,
  Discard,
  Fn,
  If,
  materialReference,
  mix,
  modelViewMatrix,
  positionGeometry,
  select,
  uniform,
  uv,
  vec2,
  vec3,
  vec4,
  viewport,
} from 'three/tsl';
import { Mesh, type Node, NodeMaterial } from 'three/webgpu';
import { LIFT_PX, LINE_SIDE, type LineKind, offsetBy, onlyAsLines } from './lines.js';

/**
 * The lines of helpers for WebGPURenderer, with WebGPU and with its WebGL 2: as wide, and as near, as those for
 * WebGLRenderer.
 *
 * ```ts
 * object.add(new HalfedgesHelper(mesh, { lines: webgpuLines }));
 * ```
 */
export const webgpuLines: LineKind = {
  make: (geometry, linewidth, bias) =>
    onlyAsLines(new Mesh(geometry, new LineNodeMaterial(linewidth, bias))),
};

/** Fat lines in CSS pixels, coloured by their segments. All share a program. */
class LineNodeMaterial extends NodeMaterial {
  static override get type(): string {
    return 'HalfedgeLineNodeMaterial';
  }

  linewidth: number;
  /** How far it comes nearer to the camera, in CSS pixels. */
  lift: number;

  constructor(linewidth = 1, bias = 0) {
    super();
    this.linewidth = linewidth;
    this.lift = LIFT_PX * bias;
    this.colorNode = color;
    this.fog = false;
    this.side = LINE_SIDE;
    offsetBy(this, bias);
  }

  /** WebGLRenderer calls it before it makes a program, WebGPURenderer never. */
  override onBeforeCompile({ vertexShader }: { readonly vertexShader?: string }): void {
    if (vertexShader !== undefined) return; // it has been taught nodes
    throw new TypeError(
      "WebGLRenderer can't draw the lines of a helper that is made with { lines: webgpuLines }; expected WebGPURenderer, or a helper without this option.",
    );
  }

  override setupPositionView(): Node {
    return positionView;
  }

  override copy(source: this): this {
    super.copy(source);
    this.linewidth = source.linewidth;
    this.lift = source.lift;
    return this;
  }
}

/** A number of the material that is drawn, which three.js's types don't say. */
const ofMaterial = (name: string) => materialReference(name, 'float') as unknown as Node<'float'>;
const linewidth = ofMaterial('linewidth');
const lift = ofMaterial('lift');
const pixelRatio = uniform(1).onRenderUpdate(({ renderer }) => renderer?.getPixelRatio());

/** Where a vertex of the quad of a segment is, as the camera sees it: whatever depths the renderer works with. */
const positionView = Fn(() => {
  const inView = (name: string) =>
    modelViewMatrix.mul(vec4(attribute(name, 'vec3'), 1)).xyz.toVar();
  const start = inView('instanceStart');
  const end = inView('instanceEnd');
  const isPerspective = cameraProjectionMatrix.mul(vec4(0, 0, 1, 0)).w.equal(-1);
  If(isPerspective, () => {
    // What is behind the camera has no place on the screen.
    const near = cameraNear.negate();
    const cut = () => mix(start, end, near.sub(start.z).div(end.z.sub(start.z)));
    If(start.z.lessThan(near).and(end.z.greaterThan(near)), () => {
      end.assign(cut());
    }).ElseIf(end.z.lessThan(near).and(start.z.greaterThan(near)), () => {
      start.assign(cut());
    });
  });

  // The quad reaches from -1 to 2 along the segment, which is from 0 to 1, and from -1 to 1 across.
  const { x, y } = positionGeometry;
  const half = viewport.zw.div(pixelRatio.mul(2));
  const onScreen = (point: typeof start) => {
    const clip = cameraProjectionMatrix.mul(vec4(point, 1));
    return clip.xy.div(clip.w).mul(half);
  };
  const along = onScreen(end).sub(onScreen(start)).normalize().toVar();
  const across = vec2(along.y, along.x.negate()).mul(x);
  const beyond = select(y.lessThan(0), -1, select(y.greaterThan(1), 1, 0));
  const aside = across.add(along.mul(beyond)).mul(linewidth.div(2)).div(half);

  const point = select(y.lessThan(0.5), start, end).toVar();
  const { w } = cameraProjectionMatrix.mul(vec4(point, 1));
  const scale = cameraProjectionMatrix.mul(vec4(1, 1, 0, 0)).xy;
  point.addAssign(vec3(aside.mul(w).div(scale), 0));

  // Towards the camera, and nowhere on the screen: see lines.ts.
  const lifted = lift.div(half.y.mul(scale.y));
  If(isPerspective, () => {
    point.divAssign(lifted.add(1));
  }).Else(() => {
    point.z.addAssign(lifted);
  });
  return point;
})();

/** That of the segment, whose ends are round. */
const color = Fn(() => {
  const { x, y } = uv();
  const beyond = y.abs().sub(1).max(0);
  Discard(x.mul(x).add(beyond.mul(beyond)).greaterThan(1).and(beyond.greaterThan(0)));
  return attribute('instanceColorStart', 'vec3');
})();
