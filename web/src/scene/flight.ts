import { Quaternion, Spherical, type Vector3 } from 'three';

/** Where a camera stands, and what it looks at. */
export interface Pose {
  readonly target: Vector3;
  readonly position: Vector3;
}

export interface FlightOptions {
  /** What turns the upright axis into y. */
  readonly upright?: Quaternion | undefined;
  /** Whether the camera is moving already, and need not get going first. */
  readonly isUnderWay?: boolean | undefined;
}

const FLIGHT_MS = 420;

/**
 * A way of a camera from one place to another. It turns as the mouse turns it, around the upright axis
 * and the shorter way, so that it neither rolls nor flips where it has to go half around.
 */
export class Flight {
  readonly goal: Pose;
  readonly #from: Pose;
  readonly #began: number;
  readonly #isUnderWay: boolean;
  readonly #upright: Quaternion;
  readonly #start: Spherical;
  readonly #end: Spherical;

  constructor(
    from: Pose,
    goal: Pose,
    began: number,
    { upright = new Quaternion(), isUnderWay = false }: FlightOptions = {},
  ) {
    this.#from = from;
    this.goal = goal;
    this.#began = began;
    this.#isUnderWay = isUnderWay;
    this.#upright = upright.clone();
    this.#start = around(from, upright);
    this.#end = around(goal, upright);
    // Straight above, nothing tells how far around it stands: it comes as it was.
    if (Math.sin(this.#end.phi) < 1e-4) this.#end.theta = this.#start.theta;
    const turn = this.#end.theta - this.#start.theta;
    if (turn > Math.PI) this.#end.theta -= 2 * Math.PI;
    if (turn < -Math.PI) this.#end.theta += 2 * Math.PI;
  }

  /** Takes the camera to where it is at a time; returns whether it goes on. */
  at(now: number, { target, position }: Pose): boolean {
    const x = Math.min(1, Math.max(0, (now - this.#began) / FLIGHT_MS));
    const t = this.#isUnderWay ? x * (2 - x) : x * x * (3 - 2 * x);
    const [a, b] = [this.#start, this.#end];
    const mix = (p: number, q: number) => p + t * (q - p);
    const radius = a.radius * (b.radius / a.radius) ** t;
    target.lerpVectors(this.#from.target, this.goal.target, t);
    position.setFromSphericalCoords(radius, mix(a.phi, b.phi), mix(a.theta, b.theta));
    position.applyQuaternion(this.#upright.clone().invert()).add(target);
    return x < 1;
  }
}

function around({ target, position }: Pose, upright: Quaternion): Spherical {
  const offset = position.clone().sub(target).applyQuaternion(upright);
  return new Spherical().setFromVector3(offset).makeSafe();
}
