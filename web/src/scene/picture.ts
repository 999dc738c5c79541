import { Color, Matrix4, Object3D, Vector3 } from 'three';
import type { HalfedgeMesh, ItemKind } from '../api.js';
import type { Item } from '../teaching/items.js';
import type { Edit } from '../teaching/motion.js';
import type { FaceTreeOptions } from '../three/face-tree.js';
import { ItemPicker, type PickMode } from '../three/item-picker.js';
import { anchorOf, facesAt, shaftOf, sideOf } from './anchors.js';
import { ArrowLayer } from './arrow-layer.js';
import type { ChangedEdge } from './change.js';
import { FaceFrames } from './faces.js';
import { Glyphs } from './glyphs.js';
import { Highlights } from './highlights.js';
import { indexLabels, type Named } from './index-labels.js';
import { IsolatedVertices } from './isolated.js';
import { type Label, Labels } from './labels.js';
import type { Anchors, Overlay } from './marks.js';
import { AT_REST, type InMotion, Morph } from './morph.js';
import type { Palette } from './palette.js';
import { Pointers } from './pointers.js';
import type { Stage } from './stage.js';
import { Surface } from './surface.js';
import { SurfaceLook, SurfaceView } from './surface-view.js';
import { type Shown, Travel } from './travel.js';
import { Wire } from './wire.js';

/** What is written into a picture besides its marks; where it goes depends on the camera. */
export interface Captions {
  /** The items whose links (1)–(7) are drawn as arrows. */
  readonly pointers: readonly Item[];
  /** The kinds of items that have their names beside them. */
  readonly kinds: readonly ItemKind[];
  /** The items around which they have; all of them if it is 'all', and wherever faces are large if it is 'large'. */
  readonly around: readonly Item[] | 'large' | 'all';
}

/** What a picture asks of who shows something in it. */
export interface PictureSource {
  /** What is drawn over the mesh, as things stand. */
  overlay(anchors: Anchors): Overlay;
  captions?(): Captions;
  /** The items around which arrows are strongest. */
  near(): readonly Item[];
  /** Told before each frame, once the camera stands. */
  beforeFrame?(): void;
}

/** The picture of a mesh: surface, edges, arrows, marks and labels, and the motion of edits. */
export class MeshPicture {
  readonly stage: Stage;
  readonly travel: Travel;
  /** The looks of the surface, for whatever else shows one. */
  readonly look = new SurfaceLook();
  readonly #source: PictureSource;
  readonly #options: FaceTreeOptions;
  readonly #surfaceView = new SurfaceView(this.look);
  readonly #wire: Wire;
  readonly #arrows: ArrowLayer;
  readonly #highlights: Highlights;
  readonly #isolated: IsolatedVertices;
  readonly #labels: Labels;
  readonly #pointers: Pointers;
  /** All that is drawn of the mesh. */
  readonly #objects = new Object3D();
  #palette: Palette | null = null;
  /** The labels of the overlay. */
  #marked: readonly Label[] = [];
  readonly #morph: Morph;
  #shown: Shown | null = null;
  #inMotion: InMotion = AT_REST;
  /** How far away the camera was when labels were placed. */
  #markedFrom = 0;

  /**
   * Labels become children of `labels`, which lies over the canvas of the stage. `options` say how the tree that
   * picks is grown.
   */
  constructor(
    stage: Stage,
    labels: HTMLElement,
    source: PictureSource,
    options: FaceTreeOptions = {},
  ) {
    // The picture comes first: growing the tree takes as long as to draw it, and can wait.
    this.#options = { begin: () => stage.drawn(), ...options };
    this.stage = stage;
    this.#source = source;
    this.travel = new Travel(stage);
    const { children } = stage.scene;
    const others = children.length;
    stage.scene.add(this.#surfaceView.object);
    this.#wire = new Wire(stage);
    this.#arrows = new ArrowLayer(stage);
    this.#highlights = new Highlights(stage);
    this.#isolated = new IsolatedVertices(stage);
    this.#labels = new Labels(stage, labels);
    this.#pointers = new Pointers(stage);
    this.#morph = new Morph(stage, this.look);
    this.#objects.add(...children.slice(others));
    stage.scene.add(this.#objects);
    stage.onFrame(() => this.#beforeFrame());
  }

  /** The mesh on show, made ready for the scene. */
  get shown(): Shown | null {
    return this.#shown;
  }

  /** Which of arrows and boundary edges are drawn. */
  setLayers({ arrows, boundary }: { arrows: boolean; boundary: boolean }): void {
    this.#arrows.visible = arrows;
    this.#wire.showsBoundary = boundary;
    this.stage.invalidate();
  }

  setPalette(palette: Palette): void {
    this.#palette = palette;
    this.#pointers.setHalo(palette.surface);
    this.look.setColors(palette.surface.toArray(), palette.back.toArray());
    this.#morph.setColor(palette.self);
    this.#wire.setColors(palette.wire, palette.boundary);
    this.#arrows.setColors(palette.arrowFar, palette.arrow, palette.boundary);
    this.#highlights.setColors(palette.surface, palette.background);
    this.#isolated.setColors(palette.vertex, palette.background);
    // Dark surfaces need more contrast to show their shape.
    const [ambient, key] = palette.dark ? [2, 2.1] : [2.2, 1.15];
    this.stage.setLight(new Color(1, 1, 1), new Color(0.62, 0.66, 0.74), ambient, key);
    this.mark();
  }

  /** Whether a face is large enough in sight for the names of its items, in the frame that was drawn last. */
  get hasRoomForNames(): boolean {
    return this.#arrows.large.length > 0;
  }

  /** Shows another mesh, or none. The camera is for the caller to move. */
  show(mesh: HalfedgeMesh | null): void {
    this.#morph.stop();
    this.#shown?.surface.tree.dispose();
    this.#shown = this.travel.shown = null;
    this.#objects.visible = mesh !== null;
    if (!mesh) {
      this.#labels.set([]);
      this.stage.invalidate();
      return;
    }
    this.#present(new Surface(mesh, this.#options));
    this.#rest(AT_REST, null);
  }

  /** Moves on to the mesh as it is after an edit; the camera stays. */
  change(edit: Edit): void {
    if (!this.#shown) return;
    this.#morph.stop();
    const { surface, frames } = this.#shown;
    const change = surface.update();
    const moved = () => {
      frames.forget(change?.faces ?? null);
      this.#arrows.change(change?.faces ?? null);
      this.mark();
    };
    moved();
    this.#isolated.show(surface);
    this.#awaitTree(surface);
    const ended = () => {
      moved();
      this.#rest(AT_REST, []);
    };
    const inMotion = this.#morph.start(surface, change, edit, moved, ended);
    this.#rest(inMotion, change?.edges ?? null);
  }

  /** Draws marks and labels anew, as the source has them now. */
  mark(): void {
    if (!this.#shown) return;
    this.#markedFrom = this.#distance();
    const { marks, labels } = this.#source.overlay(anchorsOf(this.#shown));
    const { edges } = this.#inMotion;
    const still = marks.filter(({ item: { kind, index } }) => {
      if (kind === 'edge') return !edges.has(index);
      return kind !== 'halfedge' || !edges.has(index >> 1);
    });
    this.#highlights.setMarks(still);
    this.#marked = labels;
  }

  /** The item at (x, y) in CSS pixels of the canvas; `reach` is 1 for a mouse, larger for a finger. */
  pick(x: number, y: number, mode: PickMode, reach: number): Item | null {
    const { boundary } = this.#arrows;
    return this.#shown?.picker.pick(x, y, this.stage.view, { mode, boundary, reach }) ?? null;
  }

  /** Whether the surface hides a point; while the tree over many faces grows, no is the answer. */
  readonly hides = (point: Vector3): boolean => {
    const { surface, picker } = this.#shown ?? {};
    return surface?.tree.isGrown === true && picker?.hides(point, this.stage.camera) === true;
  };

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
    const { placement } = this.#shown.surface;
    const [position, target] = [0, 3].map((at) =>
      new Vector3().fromArray(viewpoint, at).applyMatrix4(placement),
    );
    const offset = position.sub(target);
    if (offset.lengthSq() > 0) this.stage.look(target, offset.clone(), offset.length());
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

  /** The vertex nearest to the middle of the picture. */
  vertexInFront(): Item | null {
    if (!this.#shown) return null;
    this.stage.camera.updateMatrixWorld();
    const { x, y } = this.stage.project(this.stage.controls.target, new Vector3());
    return this.#shown.picker.pick(x, y, this.stage.view, { mode: 'vertex' });
  }

  #present(surface: Surface): void {
    const frames = new FaceFrames(surface);
    const glyphs = new Glyphs(surface, frames, this.stage);
    const picker = new ItemPicker(surface);
    this.#arrows.show(surface, frames);
    this.#highlights.show(surface, glyphs);
    this.#isolated.show(surface);
    this.#shown = { surface, frames, glyphs, picker };
    this.#awaitTree(surface);
    this.travel.shown = this.#shown;
  }

  /** Until the tree has grown, labels may stand before what the surface hides. */
  #awaitTree({ tree }: Surface): void {
    if (!tree.isGrown) void tree.ready.then(() => this.stage.invalidate());
  }

  /** Draws the mesh as it lies, but for what is in motion. `edges` are those that have changed, or null. */
  #rest(inMotion: InMotion, edges: readonly ChangedEdge[] | null): void {
    this.#inMotion = inMotion;
    if (!this.#shown) return;
    const { surface } = this.#shown;
    this.#surfaceView.show(surface, inMotion.faces);
    this.#wire.show(surface, inMotion.edges, edges);
    this.#arrows.hidden = inMotion.faces;
    this.mark();
    this.stage.invalidate();
  }

  #beforeFrame(): void {
    const shown = this.#shown;
    if (!shown) return;
    // Arrows keep their size on the screen, and labels lie beside them.
    if (Math.abs(this.#distance() / this.#markedFrom - 1) > 1e-4) this.mark();
    this.#wire.update();
    this.#source.beforeFrame?.();
    const { x, y } = this.stage.project(this.stage.controls.target, new Vector3());
    const near = this.#source.near().flatMap((item) => facesAt(shown.surface, item));
    this.#arrows.update(near, shown.picker.faceAt(x, y, this.stage.view)?.face ?? null);
    this.#highlights.update();
    this.#labels.set(this.#allLabels(shown));
    this.#labels.update(this.hides);
  }

  /** Those of the overlay, the numbers of links that are drawn as arrows, and the names of items. */
  #allLabels(shown: Shown): readonly Label[] {
    const captions = this.#source.captions?.();
    if (!captions || !this.#palette) return this.#marked;
    const { pointers, kinds, around } = captions;
    const anchors = anchorsOf(shown);
    const isBehind = pointers.length > 0 && this.hides(anchors.point(pointers[0]));
    const numbers = this.#pointers.update(pointers, shown, this.#palette, isBehind);
    const names = indexLabels(shown.surface.mesh, kinds, this.#namedAround(around, shown), anchors);
    const told = new Set(this.#marked.map(({ text }) => text));
    return [...numbers, ...this.#marked, ...names.filter(({ text }) => !told.has(text))];
  }

  #namedAround(around: Captions['around'], { surface }: Shown): Named {
    if (typeof around === 'string') {
      const faces = around === 'all' ? surface.mesh.faces() : this.#arrows.large;
      return { faces, vertices: this.#isolated.vertices };
    }
    return { faces: around.flatMap((item) => facesAt(surface, item)), vertices: [] };
  }

  #distance(): number {
    const { camera, controls } = this.stage;
    return camera.position.distanceTo(controls.target);
  }
}

/** Where labels of the items of a mesh go. */
function anchorsOf({ surface, frames, glyphs }: Shown): Anchors {
  return {
    point: (item) => anchorOf(item, surface, frames, glyphs),
    side: ({ kind, index }) => (kind === 'halfedge' ? sideOf(index, glyphs) : undefined),
    line: ({ kind, index }) => (kind === 'halfedge' ? shaftOf(index, glyphs) : undefined),
  };
}
