import { Color, Matrix4, Spherical, Vector3 } from 'three';
import type { MeshDocument } from '../app/documents.js';
import type { Explorer, Play } from '../app/explorer.js';
import type { Item } from '../app/items.js';
import { anchorOf, reachOf, sideOf } from './anchors.js';
import { ArrowLayer } from './arrow-layer.js';
import { FaceFrames } from './faces.js';
import { Glyphs } from './glyphs.js';
import { Highlights } from './highlights.js';
import { Labels } from './labels.js';
import { overlayOf } from './marks.js';
import { type Palette, readPalette } from './palette.js';
import { Picker } from './picking.js';
import { Stage } from './stage.js';
import { Surface, SurfaceView } from './surface.js';
import { Wire } from './wire.js';

/** A walk whose edges are shorter than this on the screen is looked at more closely. */
const TOO_SMALL_PX = 44;
/** Walks longer than this go too far to be looked at from near. */
const LONG_WALK = 40;

/** Everything that belongs to the mesh on show. */
interface Shown {
  readonly surface: Surface;
  readonly frames: FaceFrames;
  readonly glyphs: Glyphs;
  readonly picker: Picker;
}

/** The picture of the explorer's state: follows its signals, draws when something changed. */
export class View {
  readonly stage: Stage;
  readonly #explorer: Explorer;
  readonly #surfaceView = new SurfaceView();
  readonly #wire: Wire;
  readonly #arrows: ArrowLayer;
  readonly #highlights: Highlights;
  readonly #labels: Labels;
  #palette: Palette = readPalette();
  #shown: Shown | null = null;

  constructor(explorer: Explorer, canvas: HTMLCanvasElement, labels: HTMLElement) {
    this.#explorer = explorer;
    this.stage = new Stage(canvas);
    this.stage.scene.add(this.#surfaceView.object);
    this.#wire = new Wire(this.stage);
    this.#arrows = new ArrowLayer(this.stage);
    this.#highlights = new Highlights(this.stage);
    this.#labels = new Labels(this.stage, labels);
    this.stage.onFrame(() => this.#beforeFrame());
    this.applyTheme();
    explorer.document.subscribe((opened) => this.#show(opened));
    let before = 0;
    explorer.play.subscribe((play) => {
      const begins = before === 0 && play?.position === 1;
      before = play?.position ?? 0;
      if (play && before > 0) this.#follow(play, begins);
    });
    for (const signal of [explorer.selected, explorer.hovered, explorer.play]) {
      signal.subscribe(() => this.#mark());
    }
  }

  /** Takes over the colours of the page after a change of theme. */
  applyTheme(): void {
    const palette = readPalette();
    this.#palette = palette;
    this.#surfaceView.setColors(palette.surface.toArray(), palette.back.toArray());
    this.#wire.setColors(palette.wire, palette.boundary);
    this.#arrows.setColors(palette.arrowFar, palette.arrow, palette.boundary);
    this.#highlights.setColors(palette.surface, palette.background);
    // Dark surfaces need more contrast to show their shape.
    const [ambient, key] = palette.dark ? [2, 2.1] : [2.2, 1.15];
    this.stage.setLight(new Color(1, 1, 1), new Color(0.62, 0.66, 0.74), ambient, key);
    this.#mark();
  }

  /** The item at (x, y) in CSS pixels of the canvas, in the mode that is chosen. */
  pick(x: number, y: number, reach: number): Item | null {
    const { value: mode } = this.#explorer.pickMode;
    return this.#shown?.picker.pick(x, y, mode, this.#arrows.boundary, reach) ?? null;
  }

  /** Flies to the selected item, near enough to see its arrows; to the whole mesh if there is none. */
  focus(): void {
    const shown = this.#shown;
    const item = this.#explorer.selected.value;
    if (!shown || !item) {
      this.fit();
      return;
    }
    const target = this.#anchor(item, shown);
    const distance = this.stage.distanceFor(1.8 * reachOf(item, shown.surface));
    this.stage.fly(target, this.#towards(item, shown), distance);
  }

  /** Flies back to where the whole mesh is seen. */
  fit(): void {
    const { camera, controls } = this.stage;
    const direction = camera.position.clone().sub(controls.target);
    if (this.#shown) this.stage.flyToAll(this.#shown.surface.points, direction);
  }

  /** Turns the camera around the middle of the picture, by angles in radians. */
  orbit(horizontal: number, vertical: number): void {
    const { camera, controls } = this.stage;
    const offset = new Spherical().setFromVector3(camera.position.clone().sub(controls.target));
    offset.theta += horizontal;
    offset.phi += vertical;
    offset.makeSafe();
    const direction = new Vector3().setFromSpherical(offset);
    this.stage.look(controls.target.clone(), direction, offset.radius);
  }

  /** Moves the camera to `factor` times its distance. */
  zoom(factor: number): void {
    const { camera, controls } = this.stage;
    const direction = camera.position.clone().sub(controls.target);
    this.stage.look(controls.target.clone(), direction, factor * direction.length());
  }

  /** Centres the picture in the part of the window that the panel leaves free. */
  keepClearOf(panel: HTMLElement): void {
    const measure = () => {
      const { left, top, width } = panel.getBoundingClientRect();
      const besides = left > 0 && width < window.innerWidth - 1;
      this.stage.setInsets({
        top: 64,
        right: besides ? window.innerWidth - left : 0,
        bottom: besides ? 64 : window.innerHeight - top + 52,
        left: 0,
      });
    };
    new ResizeObserver(measure).observe(panel);
    window.addEventListener('resize', measure);
    measure();
  }

  /**
   * The sixteen numbers, column by column, of the matrix that takes a position of the file to clip
   * space.
   */
  cameraState(): string {
    const { camera } = this.stage;
    const matrix = new Matrix4().multiplyMatrices(
      camera.projectionMatrix,
      camera.matrixWorldInverse,
    );
    if (this.#shown) matrix.multiply(this.#shown.surface.placement);
    return matrix.elements.map((x) => Number(x.toPrecision(8))).join(' ');
  }

  /**
   * Keeps the player in sight: comes near when a walk begins that is too small to be seen, and
   * turns to the current item when it has left the picture.
   */
  #follow({ player }: Play, begins: boolean): void {
    const shown = this.#shown;
    const item = player.current?.item;
    const selected = this.#explorer.selected.value;
    if (!shown || !item || !selected) return;
    const point = this.#anchor(item, shown);
    const { x, y, z } = point;
    const pixels =
      reachOf(selected, shown.surface) / this.stage.pixelAt(this.stage.depthOf(x, y, z));
    if (begins && pixels < TOO_SMALL_PX && player.count < LONG_WALK) {
      this.focus();
    } else if (!this.stage.inSight(point)) {
      const { camera, controls } = this.stage;
      const distance = camera.position.distanceTo(controls.target);
      this.stage.fly(point, this.#towards(item, shown), distance);
    }
  }

  #anchor(item: Item, { surface, frames, glyphs }: Shown): Vector3 {
    return anchorOf(item, surface, frames, glyphs);
  }

  /** The direction to look from: the present one, turned to the front of the item if it is behind. */
  #towards(item: Item, { surface, frames }: Shown): Vector3 {
    const { camera, controls } = this.stage;
    const direction = camera.position.clone().sub(controls.target).normalize();
    const normal = new Vector3();
    for (const f of facesAt(surface, item)) {
      const at = frames.at(f) + 3;
      normal.add(new Vector3().fromArray(frames.data, at));
    }
    if (normal.lengthSq() < 1e-9) return direction;
    normal.normalize();
    if (direction.dot(normal) > 0.55) return direction;
    return direction.lerp(normal, 0.7).normalize();
  }

  #show(opened: MeshDocument | null): void {
    this.#shown?.surface.dispose();
    this.#shown = null;
    if (!opened) return;
    const surface = new Surface(opened.mesh);
    const frames = new FaceFrames(surface);
    const glyphs = new Glyphs(surface, frames, this.stage);
    const picker = new Picker(this.stage, surface, frames, glyphs);
    this.#surfaceView.show(surface);
    this.#wire.show(surface);
    this.#arrows.show(surface, frames);
    this.#highlights.show(surface, glyphs);
    this.#shown = { surface, frames, glyphs, picker };
    this.stage.lookAtAll(surface.points, new Vector3(...opened.view));
    this.#mark();
    this.#explorer.select(this.#inFront(picker, opened));
  }

  /** The vertex that is selected first: the one that the sample names, or one in plain sight. */
  #inFront(picker: Picker, opened: MeshDocument): Item | null {
    if (opened.start !== null) return { kind: 'vertex', index: opened.start };
    this.stage.camera.updateMatrixWorld();
    const { x, y } = this.stage.project(this.stage.controls.target, new Vector3());
    return picker.pick(x, y, 'vertex', []);
  }

  #mark(): void {
    const shown = this.#shown;
    if (!shown) return;
    const { glyphs } = shown;
    const { marks, labels } = overlayOf(this.#explorer, this.#palette, {
      point: (item) => this.#anchor(item, shown),
      side: ({ kind, index }) => (kind === 'halfedge' ? sideOf(index, glyphs) : undefined),
    });
    this.#highlights.setMarks(marks);
    this.#labels.set(labels);
  }

  #beforeFrame(): void {
    const shown = this.#shown;
    if (!shown) return;
    this.#wire.update();
    const { x, y } = this.stage.project(this.stage.controls.target, new Vector3());
    this.#arrows.update(this.#near(shown), shown.picker.faceAt(x, y));
    this.#highlights.update();
    this.#labels.update((point) => shown.picker.hides(point));
  }

  /** The faces at the selection and at the pointer, where arrows are strongest. */
  #near({ surface }: Shown): number[] {
    const items = [this.#explorer.selected.value, this.#explorer.hovered.value];
    return items.flatMap((item) => (item ? facesAt(surface, item) : []));
  }
}

/** The faces that an item touches. */
function facesAt({ mesh }: Surface, { kind, index }: Item): number[] {
  switch (kind) {
    case 'vertex':
      return [...mesh.vertexFaces(index)];
    case 'edge':
      return [...mesh.edgeFaces(index)];
    case 'halfedge':
      return [...mesh.edgeFaces(mesh.edge(index))];
    case 'face':
      return [index];
  }
}
