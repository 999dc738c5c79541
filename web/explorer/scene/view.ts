import type { Problem } from 'halfedge';
import { Color, Matrix4, Vector3 } from 'three';
import type { MeshDocument } from '../app/documents.js';
import type { Explorer } from '../app/explorer.js';
import type { Item } from '../app/items.js';
import type { Edit } from '../app/motion.js';
import { anchorOf, facesAt, sideOf } from './anchors.js';
import { ArrowLayer } from './arrow-layer.js';
import { pngOf, svgOf } from './export.js';
import { FaceFrames } from './faces.js';
import { Glyphs } from './glyphs.js';
import { Highlights } from './highlights.js';
import { IsolatedVertices } from './isolated.js';
import { type Label, Labels } from './labels.js';
import { overlayOf } from './marks.js';
import { AT_REST, type InMotion, Morph } from './morph.js';
import { type Palette, readPalette } from './palette.js';
import { Picker } from './picking.js';
import type { Place } from './soup-shape.js';
import { SoupView } from './soup-view.js';
import { FILE_LAYER, MESH_LAYER, Stage } from './stage.js';
import { Surface } from './surface.js';
import { SurfaceLook, SurfaceView } from './surface-view.js';
import { type Shown, Travel } from './travel.js';
import { Wire } from './wire.js';
import { WitnessView } from './witness-view.js';

/** The picture of the explorer's state: follows its signals, draws when something changed. */
export class View {
  readonly stage: Stage;
  readonly travel: Travel;
  readonly #explorer: Explorer;
  readonly #look = new SurfaceLook();
  readonly #surfaceView = new SurfaceView(this.#look);
  readonly #wire: Wire;
  readonly #arrows: ArrowLayer;
  readonly #highlights: Highlights;
  readonly #isolated: IsolatedVertices;
  readonly #labels: Labels;
  readonly #labelHost: HTMLElement;
  readonly #morph: Morph;
  readonly #soup: SoupView;
  readonly #witness: WitnessView;
  #palette: Palette = readPalette();
  #shown: Shown | null = null;
  #inMotion: InMotion = AT_REST;
  /** Where the problem is that is lit. */
  #place: Place | null = null;
  /** How far away the camera was when labels were placed. */
  #markedFrom = 0;

  constructor(explorer: Explorer, canvas: HTMLCanvasElement, labels: HTMLElement) {
    this.#explorer = explorer;
    this.#labelHost = labels;
    this.stage = new Stage(canvas);
    this.travel = new Travel(this.stage);
    this.stage.scene.add(this.#surfaceView.object);
    this.#wire = new Wire(this.stage);
    this.#arrows = new ArrowLayer(this.stage);
    this.#highlights = new Highlights(this.stage);
    this.#isolated = new IsolatedVertices(this.stage);
    this.#labels = new Labels(this.stage, labels);
    this.#morph = new Morph(this.stage, this.#look);
    this.#soup = new SoupView(this.stage, this.#look);
    this.#witness = new WitnessView(this.stage);
    this.stage.onFrame(() => this.#beforeFrame());
    this.applyTheme();
    explorer.document.subscribe((opened) => this.#show(opened));
    explorer.editor.edit.subscribe((edit) => {
      if (edit) this.#change(edit);
    });
    let before = 0;
    explorer.play.subscribe((play) => {
      const begins = before === 0 && play?.position === 1;
      before = play?.position ?? 0;
      const { value: selected } = explorer.selected;
      if (play && selected && before > 0) this.travel.follow(play.player, selected, begins);
    });
    const { refused, pending } = explorer.editor;
    for (const signal of [explorer.selected, explorer.hovered, explorer.play, refused, pending]) {
      signal.subscribe(() => this.#mark());
    }
    explorer.showsFile.subscribe((shows) => {
      this.stage.showLayer(shows ? FILE_LAYER : MESH_LAYER);
      this.#mark();
    });
    explorer.problem.subscribe((problem) => {
      this.#light(problem);
      if (this.#place) this.travel.visit(this.#place);
    });
    refused.subscribe((refusal) => this.travel.bringIntoSight(refusal?.witness ?? []));
  }

  /** Flies to the problem that is lit, to the selected item, or else back to the whole mesh. */
  focus(): void {
    if (this.#place) this.travel.visit(this.#place);
    else this.travel.focus(this.#explorer.selected.value);
  }

  /** Takes over the colours of the page after a change of theme. */
  applyTheme(): void {
    const palette = readPalette();
    this.#palette = palette;
    this.#look.setColors(palette.surface.toArray(), palette.back.toArray());
    this.#morph.setColor(palette.self);
    this.#wire.setColors(palette.wire, palette.boundary);
    this.#arrows.setColors(palette.arrowFar, palette.arrow, palette.boundary);
    this.#highlights.setColors(palette.surface, palette.background);
    this.#isolated.setColors(palette.vertex, palette.background);
    this.#soup.setColors(palette);
    // Dark surfaces need more contrast to show their shape.
    const [ambient, key] = palette.dark ? [2, 2.1] : [2.2, 1.15];
    this.stage.setLight(new Color(1, 1, 1), new Color(0.62, 0.66, 0.74), ambient, key);
    this.#light(this.#explorer.problem.value);
  }

  /** The item at (x, y) in CSS pixels of the canvas, in the mode that is chosen. */
  pick(x: number, y: number, reach: number): Item | null {
    const { value: mode } = this.#explorer.pickMode;
    if (this.#explorer.showsFile.value) return null;
    if (mode === 'auto' || mode === 'vertex') {
      const hides = (point: Vector3) => this.#shown?.picker.hides(point) ?? false;
      const isolated = this.#isolated.at(x, y, reach, hides);
      if (isolated !== null) return { kind: 'vertex', index: isolated };
    }
    return this.#shown?.picker.pick(x, y, mode, this.#arrows.boundary, reach) ?? null;
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

  /** The picture as it is, without the panels: a PNG or an SVG file. */
  async picture(format: 'png' | 'svg'): Promise<Blob> {
    const frame = this.stage.freeFrame;
    const { picker } = this.#shown ?? {};
    const hides = (point: Vector3) => picker?.hides(point) ?? false;
    return format === 'png'
      ? pngOf(this.stage, frame, this.#labelHost)
      : svgOf(this.stage, frame, this.#labelHost, hides);
  }

  /** Where the camera stands, and the middle of the picture, in the coordinates of the mesh. */
  viewpoint(): number[] | null {
    if (!this.#shown) return null;
    const { camera, controls } = this.stage;
    const toMesh = this.#shown.surface.placement.clone().invert();
    return [camera.position, controls.target].flatMap((point) =>
      point.clone().applyMatrix4(toMesh).toArray(),
    );
  }

  /** Takes the camera to where `viewpoint` told. */
  lookFrom(viewpoint: readonly number[]): void {
    if (!this.#shown) return;
    const [position, target] = [0, 3].map((at) =>
      new Vector3()
        .fromArray(viewpoint, at)
        .applyMatrix4(this.#shown?.surface.placement as Matrix4),
    );
    const offset = position.sub(target);
    if (offset.lengthSq() > 0) this.stage.look(target, offset.clone(), offset.length());
  }

  #show(opened: MeshDocument | null): void {
    this.#morph.stop();
    this.#shown = this.travel.shown = null;
    this.#soup.set(null, null);
    if (!opened) return;
    const { surface, picker } = this.#present(new Surface(opened.mesh));
    this.#soup.set(opened.diagnosis, surface.placement);
    this.#rest();
    this.stage.lookAtAll(surface.points, new Vector3(...opened.view));
    this.#explorer.select(this.#inFront(picker, opened));
  }

  /** Moves on to the mesh after an edit; the camera stays. */
  #change(edit: Edit): void {
    const before = this.#shown;
    if (!before) return;
    this.#morph.stop();
    const { surface, frames } = this.#present(new Surface(before.surface.mesh, before.surface));
    const moved = () => {
      frames.clear();
      this.#mark();
    };
    const inMotion = this.#morph.start(before.surface, surface, edit, moved, () => {
      frames.clear();
      this.#rest();
    });
    this.#rest(inMotion);
  }

  #present(surface: Surface): Shown {
    const frames = new FaceFrames(surface);
    const glyphs = new Glyphs(surface, frames, this.stage);
    const picker = new Picker(this.stage, surface, frames, glyphs);
    this.#arrows.show(surface, frames);
    this.#highlights.show(surface, glyphs);
    this.#isolated.show(surface);
    this.#shown = { surface, frames, glyphs, picker };
    this.travel.shown = this.#shown;
    return this.#shown;
  }

  /** Draws the mesh as it lies, but for what is in motion. */
  #rest(inMotion: InMotion = AT_REST): void {
    this.#inMotion = inMotion;
    if (!this.#shown) return;
    const { surface } = this.#shown;
    this.#surfaceView.show(surface, inMotion.triangles);
    this.#wire.show(surface, inMotion.edges);
    this.#arrows.hidden = inMotion.faces;
    this.#mark();
    this.stage.invalidate();
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
    const { surface, frames, glyphs } = shown;
    this.#markedFrom = this.#distance();
    const { marks, labels } = overlayOf(this.#explorer, this.#palette, {
      point: (item) => anchorOf(item, surface, frames, glyphs),
      side: ({ kind, index }) => (kind === 'halfedge' ? sideOf(index, glyphs) : undefined),
    });
    const { edges } = this.#inMotion;
    const still = marks.filter(({ item: { kind, index } }) => {
      if (kind === 'edge') return !edges.has(index);
      return kind !== 'halfedge' || !edges.has(index >> 1);
    });
    this.#highlights.setMarks(still);
    this.#labels.set([...this.#problemLabels(), ...(this.#explorer.showsFile.value ? [] : labels)]);
  }

  /** Lights a problem of the file, or none. */
  #light(problem: Problem | null): void {
    const { shape } = this.#soup;
    this.#place = (problem && shape?.place(problem)) ?? null;
    this.#witness.show(shape, this.#place, this.#palette);
    this.#mark();
  }

  #problemLabels(): Label[] {
    const { value: problem } = this.#explorer.problem;
    const place = this.#place;
    if (!problem || !place) return [];
    const text = problem.code.replaceAll('-', ' ');
    // Above what is lit, not on it.
    const { x, y, z } = place.centre;
    const pixels = place.radius / this.stage.pixelAt(this.stage.depthOf(x, y, z));
    const lift = place.vertices.length > 0 ? 24 : Math.min(90, 14 + 0.8 * pixels);
    return [{ text, look: 'problem', point: place.centre, lift }];
  }

  #beforeFrame(): void {
    const shown = this.#shown;
    if (!shown) return;
    // Arrows keep their size on the screen, and labels lie beside them.
    if (Math.abs(this.#distance() / this.#markedFrom - 1) > 1e-4) this.#mark();
    this.#wire.update();
    if (this.#explorer.showsFile.value) this.#soup.update();
    const { x, y } = this.stage.project(this.stage.controls.target, new Vector3());
    this.#arrows.update(this.#near(shown), shown.picker.faceAt(x, y));
    this.#highlights.update();
    this.#labels.update((point) => shown.picker.hides(point));
  }

  #distance(): number {
    const { camera, controls } = this.stage;
    return camera.position.distanceTo(controls.target);
  }

  /** The faces at the selection and at the pointer, where arrows are strongest. */
  #near({ surface }: Shown): number[] {
    const items = [this.#explorer.selected.value, this.#explorer.hovered.value];
    return items.flatMap((item) => (item ? facesAt(surface, item) : []));
  }
}
