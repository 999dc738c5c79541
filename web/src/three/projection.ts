import { type Camera, Matrix4, Ray, Raycaster, Vector2, Vector3 } from 'three';

/** A camera, and the size in CSS pixels of the canvas that shows what it sees. */
export interface PickView {
  readonly camera: Camera;
  readonly width: number;
  readonly height: number;
}

/** A place on the canvas: CSS pixels from its top left. */
export type ScreenPoint = readonly [x: number, y: number];

/** What is seen in one direction. */
export interface Sight {
  /** Of the object's space, from where the camera begins to see. */
  readonly ray: Ray;
  /** Where in the world the camera sees it from: its place, or with a parallel projection one in its plane. */
  readonly origin: Vector3;
}

/** Takes points of an object to the canvas, and places on the canvas to rays through the object. */
export class Projection {
  readonly #view: PickView;
  /** Takes points of the object to clip space. */
  readonly #clip: readonly number[];
  /** Takes points of the object to what lies before the camera, along the negative z axis. */
  readonly #eye: readonly number[];
  readonly #toObject: Matrix4;
  /** How long a unit of the object is in the world. */
  readonly #scale: number;

  constructor(view: PickView, matrixWorld: Matrix4) {
    const { camera } = view;
    camera.updateWorldMatrix(true, false);
    this.#view = view;
    this.#toObject = matrixWorld.clone().invert();
    this.#scale = matrixWorld.getMaxScaleOnAxis();
    const eye = new Matrix4().multiplyMatrices(camera.matrixWorldInverse, matrixWorld);
    this.#eye = eye.elements;
    this.#clip = new Matrix4().multiplyMatrices(camera.projectionMatrix, eye).elements;
  }

  /** Where the point appears that is at `at` of an array; NaN where the camera sees nothing yet, or behind it. */
  project(points: ArrayLike<number>, at: number): ScreenPoint {
    return this.#beyondNear(points, at) >= 0 ? this.#place(points, at) : UNSEEN;
  }

  /** The part of the line between two points that the camera can see; NaN if there is none. */
  projectLine(
    points: ArrayLike<number>,
    a: number,
    b: number,
  ): readonly [from: ScreenPoint, to: ScreenPoint] {
    const [before, after] = [this.#beyondNear(points, a), this.#beyondNear(points, b)];
    if (!(before >= 0 || after >= 0)) return [UNSEEN, UNSEEN];
    if (before >= 0 && after >= 0) return [this.#place(points, a), this.#place(points, b)];
    const t = before / (before - after);
    for (let k = 0; k < 3; k++) cut[k] = points[a + k] + t * (points[b + k] - points[a + k]);
    return before >= 0
      ? [this.#place(points, a), this.#place(cut, 0)]
      : [this.#place(cut, 0), this.#place(points, b)];
  }

  #place(points: ArrayLike<number>, at: number): ScreenPoint {
    const [x, y, z] = [points[at], points[at + 1], points[at + 2]];
    const m = this.#clip;
    const w = this.#depth(x, y, z);
    const scale = w > 0 ? 0.5 / w : Number.NaN;
    const right = (m[0] * x + m[4] * y + m[8] * z + m[12]) * scale;
    const up = (m[1] * x + m[5] * y + m[9] * z + m[13]) * scale;
    return [(0.5 + right) * this.#view.width, (0.5 - up) * this.#view.height];
  }

  /** The length of a CSS pixel at a point, in units of the object. */
  pixelAt(x: number, y: number, z: number): number {
    const focal = this.#view.camera.projectionMatrix.elements[5];
    const depth = Math.max(1e-6, this.#depth(x, y, z));
    return (2 * depth) / (focal * this.#view.height * this.#scale);
  }

  /** What is seen at a place on the canvas. */
  sight(x: number, y: number): Sight {
    const { width, height, camera } = this.#view;
    const at = new Vector2((2 * x) / width - 1, 1 - (2 * y) / height);
    const raycaster = new Raycaster();
    raycaster.setFromCamera(at, camera);
    const { origin } = raycaster.ray;
    return { ray: fromNear(raycaster.ray, camera).applyMatrix4(this.#toObject), origin };
  }

  /** How far behind the plane from which on the camera sees; negative before it. */
  #beyondNear(points: ArrayLike<number>, at: number): number {
    const m = this.#eye;
    const z = m[2] * points[at] + m[6] * points[at + 1] + m[10] * points[at + 2] + m[14];
    return -z - nearOf(this.#view.camera);
  }

  /** How far in front of a camera with perspective; 1 otherwise. */
  #depth(x: number, y: number, z: number): number {
    const m = this.#clip;
    return m[3] * x + m[7] * y + m[11] * z + m[15];
  }
}

/** Of what is seen, how far before a point the surface must be to hide it: what lies on it isn't hidden. */
const CLEARLY_BEFORE = 0.008;
const UNSEEN: ScreenPoint = [Number.NaN, Number.NaN];
/** Where a line goes through the plane from which on a camera sees. */
const cut = new Float64Array(3);

/** Of a camera of three.js that can be looked through. */
const nearOf = (camera: Camera) => (camera as { near?: number }).near ?? 0;
const directionOf = ({ matrixWorld }: Camera) =>
  new Vector3(0, 0, -1).transformDirection(matrixWorld);

/** The part of a ray that a camera sees along. */
export function fromNear({ origin, direction }: Ray, camera: Camera): Ray {
  const near = nearOf(camera) / direction.dot(directionOf(camera));
  return new Ray(origin.clone().addScaledVector(direction, near), direction);
}

/** The ray along which a camera sees a point of the world. */
export function sightTo(point: Vector3, camera: Camera): Ray {
  if (!isOrthographic(camera)) {
    const origin = new Vector3().setFromMatrixPosition(camera.matrixWorld);
    return new Ray(origin, point.clone().sub(origin).normalize());
  }
  const forward = directionOf(camera);
  return new Ray(point.clone().addScaledVector(forward, -depthOf(point, camera)), forward);
}

/** Whether a point of the world lies clearly before another one that a camera sees at about the same place. */
export function isClearlyBefore(point: Vector3, other: Vector3, camera: Camera): boolean {
  const depth = depthOf(other, camera);
  // Along parallel rays it doesn't tell how large things look, as the height of the picture does.
  const span = isOrthographic(camera) ? 2 / camera.projectionMatrix.elements[5] : depth;
  return depthOf(point, camera) < depth - CLEARLY_BEFORE * span;
}

/** How far a point is from where a camera stands; along its parallel rays, where it is negative behind. */
function depthOf(point: Vector3, camera: Camera): number {
  const way = point.clone().sub(new Vector3().setFromMatrixPosition(camera.matrixWorld));
  return isOrthographic(camera) ? way.dot(directionOf(camera)) : way.length();
}

function isOrthographic(camera: Camera): boolean {
  return 'isOrthographicCamera' in camera;
}

/** The distance of a place from a line; NaN where that isn't seen. */
export function distanceToLine([x, y]: ScreenPoint, a: ScreenPoint, b: ScreenPoint): number {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const length = dx * dx + dy * dy;
  const t = length > 0 ? ((x - a[0]) * dx + (y - a[1]) * dy) / length : 0;
  const clamped = Math.min(1, Math.max(0, t));
  return Math.hypot(a[0] + clamped * dx - x, a[1] + clamped * dy - y);
}
