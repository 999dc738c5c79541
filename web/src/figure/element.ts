import { html, LitElement, nothing, type PropertyValues, type TemplateResult } from 'lit';
import type { HalfedgeMesh } from '../api.js';
import { prefersReducedMotion } from '../scene/reduced-motion.js';
import type { DialectId } from '../teaching/dialects.js';
import { type Item, itemName, type WalkKey } from '../teaching/items.js';
import type { Edit } from '../teaching/motion.js';
import { tell } from './events.js';
import { actOnKey, KEYS } from './keys.js';
import { FigureModel, type Settings } from './model.js';
import { posterOf } from './poster.js';
import { openFaces, openSource } from './source.js';
import { started } from './start.js';
import { WalkStory } from './story.js';
import { figureStyles } from './styles.js';
import { type Controls, codeListing, icon, playerBar } from './template.js';
import type { Trail } from './trail-story.js';
import { FigureView } from './view.js';

/** How far outside of the window a figure begins to load. */
const NEAR = '300px';

/** What a figure is doing, as its attribute `state` tells. */
export type FigureStateName = 'waiting' | 'loading' | 'ready' | 'failed';

/**
 * An interactive picture of a mesh:
 *
 * ```html
 * <halfedge-figure src="shape:cube" select="v3" query="vertexVertices" controls></halfedge-figure>
 * ```
 */
export class HalfedgeFigure extends LitElement implements Controls {
  static override readonly styles = figureStyles;
  static override readonly properties = {
    src: { reflect: true },
    select: { reflect: true },
    query: { reflect: true },
    direction: { reflect: true },
    step: { type: Number, reflect: true },
    operation: { reflect: true },
    build: { type: Boolean, reflect: true },
    overlays: { reflect: true },
    dialect: { reflect: true },
    controls: { reflect: true },
    camera: { reflect: true },
    theme: { reflect: true },
    speed: { type: Number, reflect: true },
    autoplay: { type: Boolean, reflect: true },
    loading: { reflect: true },
    alt: { reflect: true },
    bytes: { attribute: false },
    trail: { attribute: false },
    state: { reflect: true },
    failure: { state: true },
    hasCaption: { state: true },
  };

  /** Where the mesh comes from: an address, or `shape:` and a shape. */
  declare src: string | null;
  /** The selected item: `v3`, `h12`, `e4` or `f0`. */
  declare select: string | null;
  /** A circulator, by its name in the API. */
  declare query: string | null;
  /** `ccw` or `cw`. */
  declare direction: string;
  /** How many steps the player has made. */
  declare step: number;
  /** Operations, by their names in the API: `flip e3`; several with commas. */
  declare operation: string | null;
  /** Whether the faces are added one by one, instead of a query. */
  declare build: boolean;
  /** What is drawn over the mesh, in words. */
  declare overlays: string | null;
  /** Whose names the code has. */
  declare dialect: string;
  /** Which controls there are, of `player` and `code`: the player where it is empty, none where it is absent. */
  declare controls: string | null;
  /** A direction to look from, or where the camera stands and what it looks at. */
  declare camera: string | null;
  /** `light`, `dark` or `auto`. */
  declare theme: string | null;
  /** Steps a second. */
  declare speed: number;
  /** Whether it plays by itself when it is seen first; never where less motion is asked for. */
  declare autoplay: boolean;
  /** `eager` loads also what is far outside of the window. */
  declare loading: string | null;
  /** What the picture shows, for who can't see it. */
  declare alt: string | null;
  /** A mesh as `toBytes` of a mesh writes it, with all its numbers, instead of `src`. */
  declare bytes: Uint8Array | null;
  /** A walk that is shown instead of a query: see {@link Trail}. */
  declare trail: Trail | null;
  /** What it is doing; to be read only. */
  declare state: FigureStateName;
  /** @internal */
  declare failure: string | null;
  /** @internal */
  declare hasCaption: boolean;

  readonly #model = new FigureModel({
    moved: (edit) => this.#moved(edit),
    played: () => this.requestUpdate(),
  });
  #view: FigureView | null = null;
  #abort = new AbortController();
  readonly #watcher = new IntersectionObserver(([entry]) => this.#seen(entry.isIntersecting), {
    rootMargin: NEAR,
  });
  readonly #dark = window.matchMedia('(prefers-color-scheme: dark)');
  readonly #retheme = () => this.#view?.applyTheme();

  constructor() {
    super();
    this.src = this.select = this.query = this.operation = this.overlays = null;
    this.controls = this.camera = this.theme = this.alt = this.loading = null;
    this.bytes = this.trail = null;
    this.direction = 'ccw';
    this.dialect = 'halfedge';
    this.step = 0;
    this.speed = 1.5;
    this.autoplay = this.build = false;
    this.state = 'waiting';
    this.failure = null;
    this.hasCaption = false;
  }

  /** The mesh on show; null before it is loaded. Edit it through `operation`, or call `refresh()` after. */
  get mesh(): HalfedgeMesh | null {
    return this.#model.mesh;
  }

  /** Whether it plays. */
  get playing(): boolean {
    return this.#model.player.playing;
  }

  /** What the last step did, as it is read out. */
  get sentence(): string {
    return this.#model.words;
  }

  /** Loads the mesh, also where it is out of sight, and resolves once it is on show. */
  async ready(): Promise<HalfedgeMesh> {
    if (this.state === 'waiting') await this.#load();
    while (this.state === 'loading') {
      await new Promise((done) => this.addEventListener('halfedge-settled', done, { once: true }));
    }
    if (this.#model.mesh) return this.#model.mesh;
    throw new Error(this.failure ?? 'The figure is not in a page.');
  }

  play(): void {
    this.#model.player.play();
  }

  pause(): void {
    this.#model.player.pause();
  }

  toggle(): void {
    this.#model.player.toggle();
  }

  stepForward(): void {
    this.seek(this.step + 1);
  }

  stepBack(): void {
    this.seek(this.step - 1);
  }

  /** Goes to a step, and rests there. */
  seek(position: number): void {
    this.#model.player.seek(position);
  }

  /** Goes the other way round. */
  turn(): void {
    this.direction = this.direction === 'ccw' ? 'cw' : 'ccw';
  }

  setDialect(id: DialectId): void {
    this.dialect = id;
  }

  /** Shows the whole mesh. */
  fit(): void {
    this.#view?.fit();
  }

  /** Draws the mesh as it is now, after edits by a program. */
  refresh(): void {
    if (!this.mesh) return;
    this.#view?.show(numbersOf(this.camera) ?? this.#view.viewpoint());
    this.requestUpdate();
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.#dark.addEventListener('change', this.#retheme);
    this.#watcher.observe(this);
    if (this.loading === 'eager') void this.#load();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#dark.removeEventListener('change', this.#retheme);
    this.#watcher.disconnect();
    this.#close();
    this.state = 'waiting';
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('speed')) this.#model.player.speed = this.speed > 0 ? this.speed : 1.5;
    const another = changed.has('src') || changed.has('build') || changed.has('bytes');
    if (another && this.state !== 'waiting') void this.#load();
    if (this.state !== 'ready') return;
    const anew = this.#follow(changed.has('camera'));
    // A step that the player has made itself is no reason to rest.
    const { story } = this.#model;
    if ((anew || changed.has('step')) && story && story.position !== this.step) {
      this.#model.player.seek(this.step);
    }
  }

  protected override updated(changed: PropertyValues<this>): void {
    if (changed.has('theme')) this.#view?.applyTheme();
  }

  protected override render(): TemplateResult {
    const { story, player } = this.#model;
    const parts = (this.controls === '' ? 'player' : (this.controls ?? ''))
      .split(/[\s,]+/)
      .filter(Boolean);
    return html`
      <figure part="figure">
        <div class="stage" part="stage">
          <canvas
            part="canvas"
            tabindex="0"
            role="img"
            aria-label=${this.alt ?? `A mesh. ${this.#model.words}`}
            aria-description=${KEYS}
            @keydown=${this.#pressed}
            @focus=${() => this.#focus(true)}
            @blur=${() => this.#focus(false)}
          ></canvas>
          <div class="labels" part="labels" aria-hidden="true"></div>
          ${this.#poster()}
          ${
            this.failure === null
              ? nothing
              : html`<p class="error" part="error" role="alert">${icon('warning')}${this.failure}</p>`
          }
          <button type="button" class="home" part="button home" title="Show it whole" aria-label="Show it whole" @click=${this.fit}>
            ${icon('focus')}
          </button>
        </div>
        ${story && parts.includes('player') ? playerBar(story, player.playing, this) : nothing}
        ${this.#sentence(parts.length > 0)}
        ${story instanceof WalkStory && parts.includes('code') ? codeListing(story.player, this) : nothing}
        <figcaption part="caption" class=${this.hasCaption ? '' : 'empty'}>
          <slot name="caption" @slotchange=${this.#captioned}></slot>
        </figcaption>
      </figure>
      <slot hidden @slotchange=${this.#rewritten}></slot>
    `;
  }

  #poster(): TemplateResult | typeof nothing {
    if (this.#view && this.state === 'ready') return nothing;
    const drawn = this.state === 'ready' ? posterOf(this.#model, numbersOf(this.camera)) : null;
    return html`<div class=${`poster ${this.state}`} part="poster">
      <slot name="poster">${drawn}</slot>
    </div>`;
  }

  #sentence(visible: boolean): TemplateResult {
    const { story } = this.#model;
    const refused = story?.refusal ? icon('refused') : nothing;
    const look = visible && this.mesh ? 'sentence' : 'hidden';
    return html`<p class=${look} part="sentence" aria-live="polite">${refused}<span>${this.#model.words}</span></p>`;
  }

  async #load(): Promise<void> {
    this.#abort.abort();
    const abort = new AbortController();
    this.#abort = abort;
    this.state = 'loading';
    this.failure = null;
    try {
      await started();
      const source = { src: this.src, text: this.#text(), bytes: this.bytes };
      const { signal } = abort;
      if (this.build) {
        const list = await openFaces(source, signal);
        if (!signal.aborted) this.#model.takeList(list);
      } else {
        const mesh = await openSource(source, signal);
        if (signal.aborted) mesh.dispose();
        else this.#model.take(mesh);
      }
      if (!signal.aborted) await this.#open();
    } catch (error) {
      if (!abort.signal.aborted) this.#fail(error, 'failed');
    }
  }

  async #open(): Promise<void> {
    await this.updateComplete;
    const { mesh } = this.#model;
    if (!mesh) return;
    this.#makeView();
    this.state = 'ready';
    this.#model.player.speed = this.speed > 0 ? this.speed : 1.5;
    // The view still has the mesh that was shown before.
    this.#follow(false, false);
    this.#view?.show(numbersOf(this.camera));
    this.#view?.update();
    this.#model.player.seek(this.step);
    this.requestUpdate();
    await this.updateComplete;
    tell(this, 'halfedge-ready', { mesh });
    this.dispatchEvent(new Event('halfedge-settled'));
    if (this.autoplay && !prefersReducedMotion()) this.play();
  }

  #makeView(): void {
    const canvas = this.renderRoot.querySelector('canvas');
    const labels = this.renderRoot.querySelector<HTMLElement>('.labels');
    if (this.#view || !canvas || !labels) return;
    try {
      this.#view = new FigureView(this, canvas, labels, () => this.#model);
    } catch {
      return; // There is no WebGL: the poster stays.
    }
    this.#view.listen(
      (item) => this.#hover(item),
      (item) => this.#choose(item),
    );
  }

  /** Follows the attributes. Whether there is a story that begins anew. */
  #follow(camera: boolean, draws = true): boolean {
    const { story } = this.#model;
    const settings = this.#settings();
    if (!camera && this.#model.follows(settings)) return false;
    this.failure = null;
    try {
      const edit = this.#model.tell(settings);
      if (camera) this.#view?.look(numbersOf(this.camera));
      if (draws) this.#view?.update(edit);
    } catch (error) {
      this.#fail(error, 'ready');
    }
    return this.#model.story !== story;
  }

  #fail(error: unknown, state: FigureStateName): void {
    const message = error instanceof Error ? error.message : String(error);
    this.failure = message;
    this.state = state;
    tell(this, 'halfedge-error', { message, error });
    this.dispatchEvent(new Event('halfedge-settled'));
  }

  #close(): void {
    this.#abort.abort();
    this.#view?.dispose();
    this.#view = null;
    this.renderRoot.querySelector('.labels')?.replaceChildren();
    this.#model.take(null);
  }

  #seen(seen: boolean): void {
    if (seen && this.state === 'waiting') void this.#load();
    if (this.#view) this.#view.stage.asleep = !seen;
  }

  #settings(): Settings {
    const { select, query, direction, operation, dialect, overlays, trail } = this;
    return { select, query, direction, operation, dialect, overlays, trail };
  }

  /** The text of a file in the element. */
  #text(): string | null {
    const holder = this.querySelector(':scope > script, :scope > template, :scope > pre');
    return holder instanceof HTMLTemplateElement
      ? holder.content.textContent
      : (holder?.textContent ?? null);
  }

  #moved(edit: Edit | null): void {
    const { story, words } = this.#model;
    if (!story) return;
    this.step = story.position;
    this.#view?.update(edit);
    this.requestUpdate();
    const item = story.current ? itemName(story.current) : null;
    tell(this, 'halfedge-step', {
      step: story.position,
      count: story.count,
      sentence: words,
      item,
    });
    if (story.refusal) tell(this, 'halfedge-refused', story.refusal);
  }

  #hover(item: Item | null): void {
    if (item?.kind === this.#model.hovered?.kind && item?.index === this.#model.hovered?.index)
      return;
    this.#model.hovered = item;
    this.#view?.update();
  }

  #choose(item: Item | null): void {
    const select = item ? itemName(item) : null;
    if (!this.#model.choose(item, { ...this.#settings(), select })) return;
    this.select = select;
    this.step = this.#model.story?.position ?? 0;
    this.#view?.update();
    this.requestUpdate();
    tell(this, 'halfedge-select', { item: select });
  }

  #pressed(event: KeyboardEvent): void {
    const view = this.#view;
    if (!view) return;
    const known = actOnKey(event, {
      toggle: () => this.toggle(),
      stepForward: () => this.stepForward(),
      stepBack: () => this.stepBack(),
      seek: (position) => this.seek(position),
      walk: (key: WalkKey) => {
        const item = this.#model.walk(key);
        if (item) this.#choose(item);
      },
      orbit: (horizontal, vertical) => view.orbit(horizontal, vertical),
      zoom: (factor) => view.zoom(factor),
      fit: () => this.fit(),
    });
    if (known) event.preventDefault();
  }

  #focus(focused: boolean): void {
    if (this.#view) this.#view.focused = focused;
  }

  #captioned(event: Event): void {
    this.hasCaption = (event.target as HTMLSlotElement).assignedNodes().length > 0;
  }

  #rewritten(): void {
    if (this.src === null && this.state !== 'waiting' && this.state !== 'loading')
      void this.#load();
  }
}

/** The numbers of the attribute `camera`: three, or six. */
function numbersOf(camera: string | null): number[] | null {
  if (camera === null) return null;
  const numbers = camera
    .trim()
    .split(/[\s,]+/)
    .map(Number);
  if ([3, 6].includes(numbers.length) && numbers.every(Number.isFinite)) return numbers;
  throw new Error(
    `camera is “${camera}”; expected three numbers, a direction, or six, where it stands and what it looks at.`,
  );
}
