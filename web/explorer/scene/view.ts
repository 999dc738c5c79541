import type { Problem } from 'halfedge';
import {
  type Anchors,
  type Captions,
  FILE_LAYER,
  type Label,
  MESH_LAYER,
  MeshPicture,
  type Overlay,
  OwnScreen,
  overlayOf,
  type Palette,
  type PictureSource,
  readPalette,
  Stage,
  type Travel,
} from 'halfedge/scene';
import type { Item } from 'halfedge/teaching';
import { newPickingWorker } from 'halfedge/three/picking';
import { Vector3 } from 'three';
import type { MeshDocument, OpenFailure } from '../app/documents.js';
import type { Explorer } from '../app/explorer.js';
import { Signal } from '../app/signal.js';
import { pngOf, svgOf } from './export.js';
import type { Place } from './soup-shape.js';
import { SoupView } from './soup-view.js';
import { WitnessView } from './witness-view.js';

/** What the bar at the top takes of the height, and the switch below it where a file has problems. */
const TOP_BAR = 64;
const PICTURE_SWITCH = 44;

const LOSS: OpenFailure = {
  title: 'The picture cannot be drawn',
  message: 'The browser has taken the graphics card away. The picture comes back with it.',
  lesson: null,
};

/** The picture of the explorer's state: follows its signals, draws when something changed. */
export class View {
  readonly stage: Stage;
  readonly travel: Travel;
  /** Whether names of all items are asked for, and there is no room for any. */
  readonly lacksRoomForNames = new Signal(false);
  readonly #explorer: Explorer;
  readonly #picture: MeshPicture;
  readonly #labelHost: HTMLElement;
  readonly #soup: SoupView;
  readonly #witness: WitnessView;
  #palette: Palette = readPalette();
  /** Where the problem is that is lit. */
  #place: Place | null = null;
  #panel: HTMLElement | null = null;
  #cards: readonly HTMLElement[] = [];

  constructor(explorer: Explorer, canvas: HTMLCanvasElement, labels: HTMLElement) {
    this.#explorer = explorer;
    this.#labelHost = labels;
    this.stage = new Stage(new OwnScreen(canvas));
    this.stage.asleep = true; // until there is a mesh
    const source: PictureSource = {
      overlay: (anchors) => this.#overlay(anchors),
      captions: () => this.#captions(),
      near: () => [explorer.selected.value, explorer.hovered.value].filter((item) => item !== null),
      beforeFrame: () => {
        if (explorer.showsFile.value) this.#soup.update();
      },
    };
    this.#picture = new MeshPicture(this.stage, labels, source, { worker: newPickingWorker });
    this.travel = this.#picture.travel;
    this.#soup = new SoupView(this.stage, this.#picture.look);
    this.#witness = new WitnessView(this.stage);
    this.applyTheme();
    this.#tellOfLoss(canvas);
    this.stage.onFrame(() => {
      this.lacksRoomForNames.value = this.#namesNeedRoom() && !this.#picture.hasRoomForNames;
    });
    explorer.up.subscribe((axis) => {
      this.stage.up = axis;
      this.travel.fit(); // what was looked at may be out of sight
    });
    explorer.document.subscribe((opened) => this.#show(opened));
    explorer.editor.edit.subscribe((edit) => {
      if (edit) this.#picture.change(edit);
    });
    let before = 0;
    explorer.walker.play.subscribe((play) => {
      const { position = 0 } = play ?? {};
      // Also by a leap, to the end or to where a link is.
      const begins = before === 0 && position > 0;
      before = position;
      const { value: selected } = explorer.selected;
      if (play && selected && position > 0) this.travel.follow(play.player, selected, begins);
    });
    const { refused, pending } = explorer.editor;
    const marking = [explorer.selected, explorer.hovered, explorer.walker.play, refused, pending];
    for (const signal of [...marking, explorer.labels, explorer.pointers]) {
      signal.subscribe(() => this.#picture.mark());
    }
    explorer.showsFile.subscribe((shows) => {
      this.stage.showLayer(shows ? FILE_LAYER : MESH_LAYER);
      this.#picture.mark();
    });
    explorer.problem.subscribe((problem) => {
      this.#light(problem);
      if (this.#place) this.travel.visit(this.#place);
    });
  }

  /** Flies to the problem that is lit, to the selected item, or else back to the whole mesh. */
  focus(): void {
    if (this.#place) this.travel.visit(this.#place);
    else this.travel.focus(this.#explorer.selected.value);
  }

  /** Takes over the colours of the page after a change of theme. */
  applyTheme(): void {
    this.#palette = readPalette();
    this.#soup.setColors(this.#palette);
    this.#picture.setPalette(this.#palette);
    this.#light(this.#explorer.problem.value);
  }

  /** The item at (x, y) in CSS pixels of the canvas, in the mode that is chosen. */
  pick(x: number, y: number, reach: number): Item | null {
    if (this.#explorer.showsFile.value) return null;
    return this.#picture.pick(x, y, this.#explorer.pickMode.value, reach);
  }

  /**
   * Centres the picture in the part of the window that the panel and the bars leave free, and turns it
   * where a card tells of items that can't be seen beside it.
   */
  keepClearOf(panel: HTMLElement, cards: readonly HTMLElement[]): void {
    this.#panel = panel;
    this.#cards = cards;
    const { refused, pending } = this.#explorer.editor;
    const look = () => {
      this.#measureCard();
      const { value: waiting } = pending;
      this.travel.bringIntoSight(refused.value?.witness ?? (waiting ? [waiting.first] : []));
    };
    // The cards listen to them before: they are as large then as they are going to be.
    refused.subscribe(look);
    pending.subscribe(look);
    new ResizeObserver(() => this.#measure()).observe(panel);
    window.addEventListener('resize', () => this.#measure());
    this.#measure();
  }

  #measureCard(): void {
    const card = this.#cards.find((each) => !each.hidden);
    this.stage.setCovered(card?.getBoundingClientRect() ?? null);
  }

  #measure(): void {
    if (!this.#panel) return;
    this.#measureCard();
    const { left, top, width } = this.#panel.getBoundingClientRect();
    const besides = left > 0 && width < window.innerWidth - 1;
    // Beside a panel there is room on both sides of the switch; over a sheet it would hide something.
    const hasSwitch = !besides && this.#explorer.document.value?.diagnosis != null;
    this.stage.setInsets({
      top: TOP_BAR + (hasSwitch ? PICTURE_SWITCH : 0),
      right: besides ? window.innerWidth - left : 0,
      bottom: besides ? 64 : window.innerHeight - top + 52,
      left: 0,
    });
  }

  /** See {@link MeshPicture.cameraState}. */
  cameraState(): string {
    return this.#picture.cameraState();
  }

  /** See {@link MeshPicture.viewpoint}. */
  viewpoint(): number[] | null {
    return this.#picture.viewpoint();
  }

  /** Takes the camera to where `viewpoint` told. */
  lookFrom(viewpoint: readonly number[]): void {
    this.#picture.lookFrom(viewpoint);
  }

  /** See {@link Travel.turnTo}. */
  turnTo(item: Item): void {
    this.travel.turnTo([item]);
  }

  /** The picture as it is, without the panels: a PNG or an SVG file. */
  async picture(format: 'png' | 'svg'): Promise<Blob> {
    const frame = this.stage.freeFrame;
    return format === 'png'
      ? pngOf(this.stage, frame, this.#labelHost)
      : svgOf(this.stage, frame, this.#labelHost, this.#picture.hides);
  }

  /** Says why the picture is empty, as long as the browser keeps it from being drawn. */
  #tellOfLoss(canvas: HTMLCanvasElement): void {
    const { failure } = this.#explorer;
    const { classList } = canvas.parentElement as HTMLElement;
    canvas.addEventListener('webglcontextlost', () => {
      classList.add('lost');
      failure.value = LOSS;
    });
    canvas.addEventListener('webglcontextrestored', () => {
      classList.remove('lost');
      if (failure.value === LOSS) failure.value = null;
    });
  }

  #show(opened: MeshDocument | null): void {
    this.#soup.set(null, null);
    this.#picture.show(opened?.mesh ?? null);
    const { shown } = this.#picture;
    if (!opened || !shown) return;
    const { surface } = shown;
    this.#measure();
    this.#soup.set(opened.diagnosis, surface.placement);
    const view = new Vector3(...opened.view).applyQuaternion(this.stage.upright.invert());
    this.stage.lookAtAll(surface.points, view);
    // The vertex that the sample names, or one in plain sight.
    const { start } = opened;
    const first = start === null ? null : ({ kind: 'vertex', index: start } as const);
    this.#explorer.select(first ?? this.#picture.vertexInFront());
    this.stage.asleep = false;
  }

  #overlay(anchors: Anchors): Overlay {
    const { document, selected, hovered, walker, editor, showsFile } = this.#explorer;
    const mesh = document.value?.mesh;
    if (!mesh) return { marks: [], labels: [] };
    const { marks, labels } = overlayOf(
      {
        mesh,
        selected: selected.value,
        hovered: hovered.value,
        visits: walker.play.value?.player.visits ?? [],
        witness: editor.refused.value?.witness ?? null,
        first: editor.pending.value?.first ?? null,
        numbers: !this.#explorer.pointers.value,
      },
      this.#palette,
      anchors,
    );
    return { marks, labels: [...this.#problemLabels(), ...(showsFile.value ? [] : labels)] };
  }

  /** The links as arrows, unless something else has the picture to itself; the names of items. */
  #captions(): Captions {
    const { selected, hovered, walker, pointers, labels, showsFile, editor } = this.#explorer;
    const isBusy =
      (walker.play.value?.position ?? 0) > 0 || editor.refused.value || editor.pending.value;
    const isShown = pointers.value && !isBusy && !showsFile.value;
    const { scope, kinds } = labels.value;
    const item = { off: null, selection: selected.value, pointer: hovered.value, all: null }[scope];
    return {
      pointers: isShown && selected.value ? [selected.value] : [],
      kinds: scope === 'off' || showsFile.value ? [] : kinds,
      around: scope === 'all' ? 'large' : item ? [item] : [],
    };
  }

  /** Whether the names of items are to be where there is room for them, and there are faces that could have it. */
  #namesNeedRoom(): boolean {
    const { kinds, around } = this.#captions();
    return (
      around === 'large' && kinds.length > 0 && !!this.#explorer.document.value?.mesh.faceCount
    );
  }

  /** Lights a problem of the file, or none. */
  #light(problem: Problem | null): void {
    const { shape } = this.#soup;
    this.#place = (problem && shape?.place(problem)) ?? null;
    this.#witness.show(shape, this.#place, this.#palette);
    this.#picture.mark();
  }

  #problemLabels(): Label[] {
    const { value: problem } = this.#explorer.problem;
    const place = this.#place;
    if (!problem || !place) return [];
    const text = problem.code.replaceAll('-', ' ');
    // Above what is lit, not on it.
    const { x, y, z } = place.centre;
    const pixels = place.radius / this.stage.pixelAt(this.stage.depthOf(x, y, z));
    const lift = place.rings.length === 0 ? 24 : Math.min(110, 16 + 0.9 * pixels);
    return [{ text, look: 'problem', point: place.centre, lift }];
  }
}
