import {
  type Color,
  DirectionalLight,
  HemisphereLight,
  type Mesh,
  type Object3D,
  PerspectiveCamera,
  type Quaternion,
  Scene,
  Vector2,
  Vector3,
} from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import type { PickView } from '../three/projection.js';
import { drawCapture, newCapture, type PictureFrame } from './capture.js';
import { Flight, type Pose } from './flight.js';
import { FrameLoop } from './frame-loop.js';
import { type Framing, framingOf, type Slopes } from './framing.js';
import { setPointRatio } from './points.js';
import { prefersReducedMotion } from './reduced-motion.js';
import { pixelRatio, type Screen } from './screen.js';
import { UP, type UpAxis, uprightOf } from './up.js';

/** Space that panels cover, in CSS pixels: the picture is centred in what is left. */
export interface Insets {
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
  readonly left: number;
}

/** What a card covers for a while, in CSS pixels from the canvas's top left: the picture stays where it is. */
export type Covered = Pick<DOMRectReadOnly, keyof Insets>;

/** The layer of what shows the mesh. */
export const MESH_LAYER = 0;
/** The layer of what shows the file that the mesh was made of: the camera sees one of both. */
export const FILE_LAYER = 1;

const FIELD_OF_VIEW = 32;
/** How far from the axis is in sight at depth 1. */
const SLOPE = Math.tan((FIELD_OF_VIEW * Math.PI) / 360);
/** How much of the free part of the canvas is filled with what is looked at. */
const SHARE = 0.86;
/** So far from a card, or from the edge, an item with its mark is in sight. */
const MARGIN = 12;

/**
 * Canvas, camera and orbit controls. Nothing runs while nothing changes: a frame is drawn when
 * `invalidate` asked for one, and as long as the camera moves.
 */
export class Stage {
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.001, 100);
  readonly size = new Vector2(1, 1);
  /** Asked before each frame: where it says so, none is drawn any more. */
  isOver: () => boolean = () => false;
  readonly #screen: Screen;
  readonly #observer = new ResizeObserver(() => this.#resize());
  readonly #loop = new FrameLoop({
    isOver: () => this.isOver(),
    draw: (now) => this.#draw(now),
  });
  readonly #listeners: (() => void)[] = [];
  readonly #ended = new AbortController();
  readonly #hemisphere = new HemisphereLight();
  readonly #key = new DirectionalLight();
  #controls: OrbitControls;
  #insets: Insets = { top: 0, right: 0, bottom: 0, left: 0 };
  #covered: Covered | null = null;
  /** What was fitted into the picture last, if nobody has moved the camera since. */
  #fitted: Float32Array | null = null;
  /** See `#refit`. */
  #unit = 0;
  #flight: Flight | null = null;
  #held = false;
  #motion: ((now: number) => boolean) | null = null;

  constructor(screen: Screen) {
    const { canvas } = screen;
    this.#screen = screen;
    this.scene.add(this.#hemisphere, this.camera);
    for (const light of [this.#hemisphere, this.#key]) light.layers.enable(FILE_LAYER);
    this.#key.position.set(-0.5, 0.8, 1.2);
    this.camera.add(this.#key, this.#key.target);
    this.#key.target.position.set(0, 0, -1);
    this.#controls = this.#newControls();
    const takeBack = ({ pointerType }: PointerEvent) => {
      if (pointerType === 'touch') this.#takeBack();
    };
    canvas.addEventListener('pointercancel', takeBack, { signal: this.#ended.signal });
    screen.onLoss(
      () => this.#free(),
      () => this.invalidate(),
    );
    this.#observer.observe(canvas);
    this.#fit();
    this.#followRatio();
  }

  /** Goes along when the window comes to a screen of finer pixels, or is zoomed: in CSS pixels, nothing is resized. */
  #followRatio(): void {
    const { devicePixelRatio } = window;
    const follow = () => {
      // Paper has finer pixels, too, and shows what was drawn for the window.
      if (window.devicePixelRatio !== devicePixelRatio) {
        setPointRatio(this.scene, pixelRatio());
        this.#resize();
      }
      this.#followRatio();
    };
    globalThis
      .matchMedia?.(`(resolution: ${devicePixelRatio}dppx)`)
      .addEventListener('change', follow, { once: true, signal: this.#ended.signal });
  }

  /** What turns the camera by hand; another object once another axis points up. */
  get controls(): OrbitControls {
    return this.#controls;
  }

  #newControls(): OrbitControls {
    const controls = new OrbitControls(this.camera, this.#screen.canvas);
    controls.dampingFactor = 0.12;
    controls.zoomToCursor = true;
    controls.addEventListener('change', () => this.invalidate());
    controls.addEventListener('start', () => {
      this.#flight = null;
      this.#fitted = null;
      this.#held = true;
      // It may have been asked for since.
      controls.enableDamping = !prefersReducedMotion();
      controls.saveState();
    });
    controls.addEventListener('end', () => {
      this.#held = false;
    });
    return controls;
  }

  /** The axis that points up in the picture; y at first. The picture stands up with it. */
  set up(axis: UpAxis) {
    if (this.camera.up[axis] === 1) return;
    const fitted = this.#fitted;
    const { target, position } = this.goal;
    const offset = position.clone().sub(target).applyQuaternion(this.upright);
    this.camera.up.copy(UP[axis]);
    this.#hemisphere.position.copy(UP[axis]);
    // Controls take over the axis when they are made.
    const { enableZoom, enablePan, domElement } = this.#controls;
    const touchAction = domElement?.style.touchAction ?? '';
    this.#controls.dispose();
    this.#controls = Object.assign(this.#newControls(), { enableZoom, enablePan });
    if (domElement) domElement.style.touchAction = touchAction;
    offset.applyQuaternion(this.upright.invert());
    if (fitted) this.lookAtAll(fitted, offset);
    else this.look(target, offset, offset.length());
  }

  /** What turns the axis that points up into y. */
  get upright(): Quaternion {
    return uprightOf(this.camera.up);
  }

  /** Whether nobody sees the picture: then no frame is drawn, until it is seen again. */
  set asleep(asleep: boolean) {
    this.#loop.asleep = asleep;
  }

  /** Frees what it has on the graphics card, and lets go of the canvas. */
  dispose(): void {
    this.#ended.abort();
    this.#loop.stop();
    this.#observer.disconnect();
    this.controls.dispose();
    this.#free();
    this.#screen.dispose();
  }

  /** Frees what is on the graphics card; what is drawn again is uploaded anew. */
  #free(): void {
    this.scene.traverse((object) => {
      const { geometry, material } = object as Partial<Mesh>;
      geometry?.dispose();
      for (const one of [material].flat()) one?.dispose();
    });
  }

  /** Calls `listener` before each frame is drawn. */
  onFrame(listener: () => void): void {
    this.#listeners.push(listener);
  }

  /** Calls `listener` when the picture begins to change, and when it has come to rest. */
  onChange(begins: () => void, rests: () => void): void {
    this.#loop.onChange(begins, rests);
  }

  /** Fulfilled when the next frame has been drawn, and the browser asks for another one. */
  drawn(): Promise<void> {
    return this.#loop.drawn();
  }

  /** Calls `step` before each frame as long as it says that it goes on; instead of one before. */
  animate(step: (now: number) => boolean): void {
    this.#motion = step;
    this.invalidate();
  }

  /** Asks for one more frame. */
  invalidate(): void {
    this.#loop.request();
  }

  /** Draws at once, also where nobody sees the picture: before it is printed. */
  drawNow(): void {
    this.#loop.drawNow();
  }

  /** Shows the objects of one layer. */
  showLayer(layer: number): void {
    this.camera.layers.set(layer);
    this.invalidate();
  }

  /** The camera as it stands, and the canvas. */
  get view(): PickView {
    return { camera: this.camera, width: this.size.x, height: this.size.y };
  }

  /** The part of the canvas that no panel covers. */
  get freeFrame(): PictureFrame {
    const { left, right, bottom } = this.#insets;
    // Beside a panel the picture reaches down to the edge of the window.
    const height = this.size.y - (right > 0 ? 0 : bottom);
    return { x: left, y: 0, width: Math.max(1, this.size.x - left - right), height };
  }

  /** A part of the picture, two pixels to the CSS pixel, on the colour of the page. Throws while nothing can be drawn. */
  capture(frame: PictureFrame, without: ReadonlySet<Object3D> = new Set()): HTMLCanvasElement {
    const taken = newCapture(this.#screen, frame);
    try {
      drawCapture(taken, this.#screen, this, frame, without);
    } finally {
      this.#resize();
    }
    return taken;
  }

  setLight(sky: Color, ground: Color, ambient: number, key: number): void {
    this.#hemisphere.color.copy(sky);
    this.#hemisphere.groundColor.copy(ground);
    this.#hemisphere.intensity = ambient;
    this.#key.color.set(1, 1, 1);
    this.#key.intensity = key;
    this.invalidate();
  }

  setInsets(insets: Insets): void {
    const sides = ['top', 'right', 'bottom', 'left'] as const;
    // A panel that only got other contents costs no frame.
    if (sides.every((side) => insets[side] === this.#insets[side])) return;
    this.#insets = insets;
    this.#resize();
  }

  /** What a card covers from now on: nothing there is in sight, and flights end clear of it. */
  setCovered(covered: Covered | null): void {
    this.#covered = covered;
  }

  /** The length in the scene of one CSS pixel at this depth in front of the camera. */
  pixelAt(depth: number): number {
    return (2 * depth * SLOPE) / this.size.y;
  }

  /** How far in front of the camera a point lies. */
  depthOf(x: number, y: number, z: number): number {
    const m = this.camera.matrixWorldInverse.elements;
    return -(m[2] * x + m[6] * y + m[10] * z + m[14]);
  }

  /** The distance from which a sphere of this radius fills `share` of the free part of the canvas. */
  distanceFor(radius: number, share = SHARE): number {
    const { x, y } = this.#freeSlopes(share);
    const slope = Math.min(x, y);
    return (radius * Math.hypot(1, slope)) / slope;
  }

  /** Jumps to where all points fill the free part of the canvas, seen from `direction`. */
  lookAtAll(points: Float32Array, direction: Vector3, share = SHARE): void {
    const { target, distance } = this.#framing(points, direction, share);
    this.look(target, direction, distance);
    this.#fitted = points;
  }

  /** As `lookAtAll`, in a short flight. */
  flyToAll(points: Float32Array, direction: Vector3, share = SHARE): void {
    const { target, distance } = this.#framing(points, direction, share);
    this.fly(target, direction, distance);
    this.#fitted = points;
  }

  /** Jumps to look at `target` from `direction`. */
  look(target: Vector3, direction: Vector3, distance: number): void {
    this.#flight = null;
    this.#fitted = null;
    this.controls.target.copy(target);
    this.camera.position.copy(direction).setLength(distance).add(target);
    this.controls.update();
    this.invalidate();
  }

  /** Moves there in a short flight; at once where motion is to be reduced. */
  fly(at: Vector3, direction: Vector3, distance: number): void {
    const goal = this.poseFor(at, direction, distance);
    if (prefersReducedMotion()) {
      this.look(goal.target, direction, distance);
      return;
    }
    const { upright } = this;
    const isUnderWay = this.#flight !== null;
    this.#flight = new Flight(this.pose, goal, performance.now(), { upright, isUnderWay });
    this.#fitted = null;
    this.invalidate();
  }

  /** Where the camera is in the end if it flies to look at `at` from there. */
  poseFor(at: Vector3, direction: Vector3, distance: number): Pose {
    const target = this.#besidesCard(at, direction, distance);
    return { target, position: direction.clone().setLength(distance).add(target) };
  }

  /** Where the camera is in the end if it flies to see all points from there. */
  poseForAll(points: Float32Array, direction: Vector3): Pose {
    const { target, distance } = this.#framing(points, direction, SHARE);
    return this.poseFor(target, direction, distance);
  }

  /** Where the camera is. */
  get pose(): Pose {
    return { target: this.controls.target.clone(), position: this.camera.position.clone() };
  }

  /** Where the camera is, or will be when its flight is over. */
  get goal(): Pose {
    return this.#flight?.goal ?? this.pose;
  }

  /** The camera as it is there. */
  cameraAt({ target, position }: Pose): PerspectiveCamera {
    // It has a light, which stays with it.
    const camera = new PerspectiveCamera().copy(this.camera, false);
    camera.position.copy(position);
    camera.lookAt(target);
    camera.updateMatrixWorld();
    return camera;
  }

  /** Whether somebody turns the camera right now. */
  get held(): boolean {
    return this.#held;
  }

  /** Where to look, so that what lies at `at` appears in the middle of the part that no card covers. */
  #besidesCard(at: Vector3, direction: Vector3, distance: number): Vector3 {
    const card = this.#covered;
    if (!card) return at;
    const { top, bottom } = this.#insets;
    const [above, below] = [card.top - top, this.size.y - bottom - card.bottom];
    const middle = above >= below ? top + above / 2 : card.bottom + below / 2;
    const lift = (top + this.size.y - bottom) / 2 - middle;
    const back = direction.clone().normalize();
    const right = new Vector3().crossVectors(this.camera.up, back).normalize();
    const up = new Vector3().crossVectors(back, right);
    return at.clone().addScaledVector(up, -lift * this.pixelAt(distance));
  }

  /** Whether a point is in the part of the picture that no panel or card covers. */
  inSight(point: Vector3, camera: PerspectiveCamera): boolean {
    const { x, y, z } = this.project(point, new Vector3(), camera);
    const card = this.#covered;
    if (card && x > card.left - MARGIN && x < card.right + MARGIN) {
      if (y > card.top - MARGIN && y < card.bottom + MARGIN) return false;
    }
    const { top, right, bottom, left } = this.#insets;
    const { x: width, y: height } = this.size;
    if (x < left + MARGIN || x > width - right - MARGIN) return false;
    return y > top + MARGIN && y < height - bottom - MARGIN && z < 1;
  }

  /** Where a point appears: CSS pixels from the canvas's top left; `z` beyond 1 is out of sight. */
  project(point: Vector3, out: Vector3, camera = this.camera): Vector3 {
    out.copy(point).project(camera);
    out.x = ((out.x + 1) * this.size.x) / 2;
    out.y = ((1 - out.y) * this.size.y) / 2;
    return out;
  }

  /** How far from the axis a point may be at depth 1 to be in the free part of the canvas. */
  #freeSlopes(share: number): Slopes {
    const { top, right, bottom, left } = this.#insets;
    const slope = SLOPE / (this.size.y / 2);
    const x = Math.max(60, this.size.x - left - right) / 2;
    const y = Math.max(60, this.size.y - top - bottom) / 2;
    return { x: share * slope * x, y: share * slope * y };
  }

  /** The nearest place from which all points are in sight in the free part of the canvas. */
  #framing(points: Float32Array, direction: Vector3, share: number): Framing {
    return framingOf(points, direction, this.camera.up, this.#freeSlopes(share));
  }

  /** The browser scrolls the page with the fingers that began to turn the camera: it goes back. */
  #takeBack(): void {
    this.controls.enableDamping = false;
    this.controls.update(); // what has been turned is all done then, and not by and by
    this.controls.reset();
  }

  /** Takes over the size of the canvas. */
  #fit(): void {
    const { clientWidth, clientHeight } = this.#screen.canvas;
    const width = Math.max(1, clientWidth);
    const height = Math.max(1, clientHeight);
    this.#screen.resize(width, height, pixelRatio());
    const isResized = width !== this.size.x || height !== this.size.y;
    this.size.set(width, height);
    this.camera.aspect = width / height;
    const { top, right, bottom, left } = this.#insets;
    const [x, y] = [(right - left) / 2, (bottom - top) / 2];
    this.camera.setViewOffset(width, height, x, y, width, height);
    if (clientWidth > 0 && clientHeight > 0) this.#refit(isResized);
  }

  /**
   * A canvas of another size shows as much as before: all of what fills it, or else what a sphere
   * holds that does. Panels that cover more or less of the same canvas move the picture only.
   */
  #refit(isResized: boolean): void {
    const before = this.#unit;
    this.#unit = this.distanceFor(1);
    if (!isResized) return;
    const fitted = this.#fitted;
    const { target, position } = this.goal;
    const direction = position.clone().sub(target);
    if (direction.lengthSq() === 0) return;
    if (fitted) this.lookAtAll(fitted, direction);
    else if (before > 0) this.look(target, direction, (direction.length() * this.#unit) / before);
  }

  #resize(): void {
    this.#fit();
    this.#loop.redraw(); // a resized canvas is blank until then
  }

  /** Whether another frame has to follow. */
  #draw(now: number): boolean {
    const seat = { target: this.controls.target, position: this.camera.position };
    const flying = this.#flight?.at(now, seat) ?? false;
    if (!flying) this.#flight = null;
    const animated = this.#motion?.(now) ?? false;
    if (!animated) this.#motion = null;
    const moving = this.controls.update();
    const distance = this.camera.position.distanceTo(this.controls.target);
    this.camera.near = Math.max(distance / 500, 1e-5);
    this.camera.far = distance + 20;
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
    for (const listener of this.#listeners) listener();
    this.#screen.render(this.scene, this.camera);
    return flying || animated || moving;
  }
}
