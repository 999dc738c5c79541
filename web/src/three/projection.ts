import {
  type Camera,
  Matrix4,
  type OrthographicCamera,
  Ray,
  Raycaster,
  Vector2,
  Vector3,
} from 'three';

/** A camera, and the size in CSS pixels of the canvas that shows what it sees. */
export interface PickView {
  readonly camera: Camera;
  readonly width: number;
  readonly height: number;
}

/** A place on the canvas: CSS pixels from its top left. */
export type ScreenPoint = readonly [x: number, y: number];

/** Takes points of an object to the canvas, and places on the canvas to rays through the object. */
export class Projection {
  readonly #view: PickView;
  /** Takes points of the object to clip space. */
  readonly #clip: readonly number[];
  /** Takes points of the object to what the camera sees, which lies towards -z. */
  readonly #seen: readonly number[];
  readonly #toObject: Matrix4;
  /** How long a unit of the object is in the world. */
  readonly #scale: number;

  constructor(view: PickView, matrixWorld: Matrix4) {
    const { camera } = view;
    camera.updateWorldMatrix(true, false);
    this.#view = view;
    this.#toObject = matrixWorld.clone().invert();
    this.#scale = matrixWorld.getMaxScaleOnAxis();
    const seen = new Matrix4().multiplyMatrices(camera.matrixWorldInverse, matrixWorld);
    this.#seen = seen.elements;
    this.#clip = seen.clone().premultiply(camera.projectionMatrix).elements;
  }

  /** Where the point appears that is at `at` of an array; NaN behind the camera. */
  project(points: ArrayLike<number>, at: number): ScreenPoint {
    const [x, y, z] = [points[at], points[at + 1], points[at + 2]];
    const m = this.#clip;
    const scale = this.#isAhead(x, y, z) ? 0.5 / this.#depth(x, y, z) : Number.NaN;
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

  /** The ray of the object's space that is seen as a place on the canvas. */
  ray(x: number, y: number): Ray {
    const { width, height, camera } = this.#view;
    const at = new Vector2((2 * x) / width - 1, 1 - (2 * y) / height);
    const raycaster = new Raycaster();
    raycaster.setFromCamera(at, camera);
    const { ray } = raycaster;
    ray.origin.addScaledVector(ray.direction, startOf(camera));
    return ray.applyMatrix4(this.#toObject);
  }

  #isAhead(x: number, y: number, z: number): boolean {
    const m = this.#seen;
    return -(m[2] * x + m[6] * y + m[10] * z + m[14]) > startOf(this.#view.camera);
  }

  /** How far in front of a camera with perspective; 1 otherwise. */
  #depth(x: number, y: number, z: number): number {
    const m = this.#clip;
    return m[3] * x + m[7] * y + m[11] * z + m[15];
  }
}

/** How a camera sees a point of the world. */
export interface Sight {
  /** What it is seen along. */
  readonly ray: Ray;
  /** How far along the ray it is; negative behind the camera. */
  readonly distance: number;
  /** What small distances are measured by: the same, or for a camera without perspective the height of its picture. */
  readonly span: number;
}

/** How a camera sees a point of the world: from where it stands, or along with all others. */
export function sightOf(point: Vector3, camera: Camera): Sight {
  camera.updateWorldMatrix(true, false);
  const origin = new Vector3().setFromMatrixPosition(camera.matrixWorld);
  const direction = point.clone().sub(origin);
  if (!isOrthographic(camera)) {
    const distance = direction.length();
    return { ray: new Ray(origin, direction.divideScalar(distance)), distance, span: distance };
  }
  const ahead = camera.getWorldDirection(new Vector3());
  const distance = direction.dot(ahead) - startOf(camera);
  const ray = new Ray(point.clone().addScaledVector(ahead, -distance), ahead);
  return { ray, distance, span: 2 / camera.projectionMatrix.elements[5] };
}

/** Where a camera begins to see, ahead of where it stands: one without perspective may do so behind. */
function startOf(camera: Camera): number {
  return isOrthographic(camera) ? Math.min(0, camera.near) : 0;
}

function isOrthographic(camera: Camera): camera is OrthographicCamera {
  return (camera as Partial<OrthographicCamera>).isOrthographicCamera === true;
}

/** The distance of a place from a line; NaN where an end of that isn't seen. */
export function distanceToLine([x, y]: ScreenPoint, a: ScreenPoint, b: ScreenPoint): number {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const length = dx * dx + dy * dy;
  const t = length > 0 ? ((x - a[0]) * dx + (y - a[1]) * dy) / length : 0;
  const clamped = Math.min(1, Math.max(0, t));
  return Math.hypot(a[0] + clamped * dx - x, a[1] + clamped * dy - y);
}
