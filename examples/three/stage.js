// What a page needs to show an object of three.js, whatever it is.

import {
  Box3,
  DirectionalLight,
  HemisphereLight,
  MathUtils,
  PerspectiveCamera,
  Raycaster,
  Scene,
  Sphere,
  Vector2,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

/** How far up and down the camera sees, at a distance of 1; in a narrow window, how far left and right. */
const HALF_VIEW = 0.3;

/** A scene with lights and a camera on a canvas, drawn when `render` is called and when the camera moves. */
export class Stage {
  scene = new Scene();
  #camera = new PerspectiveCamera();
  #renderer;
  #controls;
  #isAsked = false;

  constructor(canvas) {
    this.#renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.#renderer.setPixelRatio(devicePixelRatio);
    this.#controls = new OrbitControls(this.#camera, canvas);
    this.#controls.addEventListener('change', () => this.render());
    const lamp = new DirectionalLight(0xffffff, 2);
    lamp.position.set(-1, 1.5, 1);
    this.#camera.add(lamp); // it goes where the camera goes
    this.scene.add(this.#camera, new HemisphereLight(0xffffff, 0x9aa3b0, 1.6));
    new ResizeObserver(() => this.#fit()).observe(canvas);
    this.#fit();
  }

  /** Draws the scene with the next frame of the browser. */
  render() {
    if (this.#isAsked) return;
    this.#isAsked = true;
    requestAnimationFrame(() => {
      this.#isAsked = false;
      this.#renderer.render(this.scene, this.#camera);
    });
  }

  /** Moves the camera to where it sees the whole object. */
  lookAt(object) {
    const { center, radius } = new Box3().setFromObject(object).getBoundingSphere(new Sphere());
    const away = new Vector3(0.5, 0.55, 1).setLength((1.1 * radius) / HALF_VIEW);
    this.#camera.position.copy(center).add(away);
    this.#controls.target.copy(center);
    this.#controls.update();
  }

  /** Calls `use` with the intersection under each click, or with undefined. To drag is not to click. */
  onClick(object, use) {
    const { domElement } = this.#renderer;
    const ray = new Raycaster();
    let start;
    domElement.addEventListener('pointerdown', ({ clientX: x, clientY: y }) => {
      start = { x, y };
    });
    domElement.addEventListener('pointerup', ({ clientX: x, clientY: y }) => {
      if (Math.hypot(x - start.x, y - start.y) > 4) return;
      const { left, top, width, height } = domElement.getBoundingClientRect();
      const at = new Vector2((2 * (x - left)) / width - 1, 1 - (2 * (y - top)) / height);
      ray.setFromCamera(at, this.#camera);
      use(ray.intersectObject(object, false)[0]);
    });
  }

  #fit() {
    const { clientWidth, clientHeight } = this.#renderer.domElement;
    this.#renderer.setSize(clientWidth, clientHeight, false);
    const aspect = clientWidth / clientHeight;
    this.#camera.aspect = aspect;
    this.#camera.fov = 2 * MathUtils.radToDeg(Math.atan(HALF_VIEW / Math.min(1, aspect)));
    this.#camera.updateProjectionMatrix();
    this.render();
  }
}
