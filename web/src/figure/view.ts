import { Vector3 } from 'three';
import type { HalfedgeMesh } from '../api.js';
import { type Anchors, type Overlay, OverlayDrawing } from '../scene/marks.js';
import { type Palette, readPalette, samePalette } from '../scene/palette.js';
import { type Captions, MeshPicture } from '../scene/picture.js';
import { listenToPointer } from '../scene/pointer.js';
import { SharedScreen } from '../scene/shared-screen.js';
import { Stage } from '../scene/stage.js';
import type { UpAxis } from '../scene/up.js';
import { linksOf } from '../teaching/item-links.js';
import type { Item } from '../teaching/items.js';
import type { Edit } from '../teaching/motion.js';
import { frontOf } from './front.js';
import { namedKinds, type OverlayName, vertexDiscs } from './overlays.js';
import type { Story } from './story.js';

/** What a figure shows at a moment. */
export interface FigureState {
  readonly mesh: HalfedgeMesh | null;
  readonly selected: Item | null;
  readonly hovered: Item | null;
  readonly story: Story | null;
  readonly overlays: ReadonlySet<OverlayName>;
}

const SPACE = { top: 28, right: 14, bottom: 14, left: 14 };

/** The picture of a figure, on a canvas that shares its WebGL context with all others of the page. */
export class FigureView {
  readonly stage: Stage;
  readonly #picture: MeshPicture;
  readonly #host: Element;
  readonly #state: () => FigureState;
  readonly #ended = new AbortController();
  #palette: Palette;
  /** The size that the labels were told last. */
  #told = { x: 0, y: 0 };

  /** Throws where there is no WebGL. */
  constructor(
    host: Element,
    canvas: HTMLCanvasElement,
    labels: HTMLElement,
    state: () => FigureState,
  ) {
    this.#host = host;
    this.#state = state;
    this.#palette = readPalette(host);
    this.stage = new Stage(new SharedScreen(canvas));
    this.stage.setInsets(SPACE);
    this.#picture = new MeshPicture(this.stage, labels, {
      overlay: (anchors) => this.#overlay(anchors),
      captions: () => captionsOf(state()),
      near: () => [state().selected, state().hovered].filter((item) => item !== null),
    });
    this.focused = false;
    this.#picture.setPalette(this.#palette);
    this.stage.onFrame(() => this.#tellSize(labels));
    const { signal } = this.#ended;
    window.addEventListener('beforeprint', () => this.stage.drawNow(), { signal });
  }

  /** On paper the picture is stretched, without being drawn anew, and its labels have to be, too. */
  #tellSize({ style }: HTMLElement): void {
    const { x, y } = this.stage.size;
    if (this.#told.x === x && this.#told.y === y) return;
    this.#told = { x, y };
    style.setProperty('--drawn-width', `${x}px`);
    style.setProperty('--drawn-height', `${y}px`);
  }

  /** Whether the wheel zooms, and touch turns instead of scrolling the page. */
  set focused(focused: boolean) {
    this.stage.controls.enableZoom = focused;
    this.stage.controls.enablePan = focused;
    const { domElement } = this.stage.controls;
    if (domElement) domElement.style.touchAction = focused ? 'none' : 'pan-y pinch-zoom';
  }

  /** Takes over the colours that the element has now, if they are others. */
  applyTheme(): void {
    const palette = readPalette(this.#host);
    if (samePalette(palette, this.#palette)) return;
    this.#palette = palette;
    this.#picture.setPalette(this.#palette);
  }

  /**
   * Shows the mesh of the figure, seen from `camera`: a direction, or where it stands and what it looks at. `up` points
   * up.
   */
  show(camera: readonly number[] | null, up: UpAxis): void {
    this.#picture.show(this.#state().mesh);
    this.#setLayers();
    this.look(camera, up);
  }

  /** See {@link FigureView.show}; without a camera, a place from which the whole mesh is seen well. */
  look(camera: readonly number[] | null, up: UpAxis): void {
    const surface = this.#picture.shown?.surface;
    if (!surface) return;
    this.stage.up = up;
    const direction = camera ? new Vector3().fromArray(camera) : frontOf(surface.points, up);
    this.stage.lookAtAll(surface.points, direction);
    const { selected } = this.#state();
    if (camera?.length === 6) this.#picture.lookFrom(camera);
    else if (!camera && selected) this.#picture.travel.lookAtAll(selected);
  }

  /** Flies to where the whole mesh is seen. */
  fit(): void {
    this.#picture.travel.fit();
  }

  /** Where the camera stands and what it looks at. */
  viewpoint(): number[] | null {
    return this.#picture.viewpoint();
  }

  /** Draws what has changed of the state; `edit` is a change of the mesh. */
  update(edit: Edit | null = null): void {
    const { story, selected } = this.#state();
    this.#setLayers();
    if (edit) this.#picture.change(edit);
    else this.#picture.mark();
    if (story?.witness) this.#picture.travel.turnTo(story.witness);
    else if (story && story.visits.length > 0 && story.current) {
      this.#picture.travel.turnTo(selected ? [story.current, selected] : [story.current]);
    } else if (story?.missing) {
      this.#picture.travel.turnTo([...story.missing, ...(selected ? [selected] : [])]);
    }
  }

  /** Turns by angles in radians. */
  orbit(horizontal: number, vertical: number): void {
    this.#picture.travel.orbit(horizontal, vertical);
  }

  zoom(factor: number): void {
    this.#picture.travel.zoom(factor);
  }

  focus(item: Item | null): void {
    this.#picture.travel.focus(item);
  }

  dispose(): void {
    this.#ended.abort();
    this.stage.dispose();
  }

  /**
   * Tells what the pointer is over, and what is picked: an item, or null for nothing. `isLost` is asked before each
   * frame whether there is nothing left to draw.
   */
  listen(
    hovers: (item: Item | null) => void,
    picks: (item: Item | null) => void,
    isLost: () => boolean,
  ): void {
    this.stage.isOver = isLost;
    const listener = {
      itemAt: (x: number, y: number, reach: number) =>
        this.#state().mesh?.disposed ? null : this.#picture.pick(x, y, 'auto', reach),
      hovers,
      picks,
      doubleClicked: () => this.focus(this.#state().selected),
    };
    const canvas = this.stage.controls.domElement as HTMLElement;
    listenToPointer(canvas, listener, this.#ended.signal);
  }

  #setLayers(): void {
    const { overlays } = this.#state();
    this.#picture.setLayers({
      arrows: overlays.has('halfedges'),
      boundary: overlays.has('boundary'),
    });
  }

  #overlay(anchors: Anchors): Overlay {
    const { mesh, selected, hovered, story, overlays } = this.#state();
    if (!mesh) return { marks: [], labels: [] };
    const overlay = new OverlayDrawing(this.#palette, anchors).add({
      mesh,
      selected,
      hovered,
      visits: story?.visits ?? [],
      links: story === null && (overlays.has('links') || overlays.has('all-links')),
      numbers: false,
      witness: story?.witness ?? null,
      first: null,
    });
    overlay.addWitness(story?.missing ?? []);
    const { marks, labels } = overlay;
    if (!overlays.has('vertices')) return overlay;
    return { marks: [...vertexDiscs(mesh, this.#palette.arrow), ...marks], labels };
  }
}

function captionsOf(state: FigureState): Captions {
  return { pointers: pointersOf(state), kinds: namedKinds(state.overlays), around: 'all' };
}

/** The items whose links are drawn as arrows: the selected one, or also what its links (3) and (4) lead to. */
function pointersOf({ mesh, selected, story, overlays }: FigureState): Item[] {
  if (!mesh || !selected || story) return [];
  if (!overlays.has('all-links')) return overlays.has('links') ? [selected] : [];
  const beyond = linksOf(mesh, selected)
    .filter(({ number }) => number === 3 || number === 4)
    .map(({ target }) => target)
    .filter((target) => target !== null);
  return [selected, ...beyond];
}
