import { html, nothing, type PropertyValues, type TemplateResult } from 'lit';
import type { HalfedgeMesh } from '../api.js';
import { prefersReducedMotion } from '../scene/reduced-motion.js';
import type { DialectId } from '../teaching/dialects.js';
import type { WalkKey } from '../teaching/item-links.js';
import { type Item, isLive, itemName, parseItemName, sameItem } from '../teaching/items.js';
import type { Edit } from '../teaching/motion.js';
import { FigureAttributes, type FigureStateName } from './attributes.js';
import { tell } from './events.js';
import { actOnKey, KEYS, keepUsedKey } from './keys.js';
import { Loading, sightObserver } from './loading.js';
import { FigureModel } from './model.js';
import { Poster } from './poster.js';
import { WalkStory } from './story.js';
import { figureStyles } from './styles.js';
import { type Controls, codeListing, icon, playerBar } from './template.js';
import { FigureView } from './view.js';

const LOST =
  'A program has disposed of the mesh, which belongs to the figure: set src or bytes to show another one.';

/**
 * An interactive picture of a mesh:
 *
 * ```html
 * <halfedge-figure src="shape:cube" select="v3" query="vertexVertices" controls></halfedge-figure>
 * ```
 */
export class HalfedgeFigure extends FigureAttributes implements Controls {
  static override readonly styles = figureStyles;

  readonly #model = new FigureModel({
    moved: (edit) => this.#moved(edit),
    played: () => this.requestUpdate(),
    isLost: () => this.#isLost(),
  });
  #view: FigureView | null = null;
  /** The last walk, whose controls stay where something is picked that it does not go around. */
  #walk: WalkStory | null = null;
  /** The line of code that was at work when it was last scrolled to. */
  #line: Element | null = null;
  readonly #drawing = new Poster(() => this.requestUpdate());
  readonly #loading = new Loading(this.#model, {
    source: () => this.source,
    isBuilt: () => this.build,
    opened: (signal) => this.#open(signal),
    failed: (error, isUnreached) => {
      this.#isUnreached = isUnreached;
      this.#fail(error, 'failed');
    },
  });
  /** Whether it failed for want of a file or of the network: then it can be tried again. */
  #isUnreached = false;
  /** Null in jsdom, which doesn't have `matchMedia` either. */
  readonly #watcher = sightObserver((seen) => this.#seen(seen));
  readonly #dark = globalThis.matchMedia?.('(prefers-color-scheme: dark)');
  readonly #retheme = () => {
    if (!this.#isLost()) this.#view?.applyTheme();
  };
  /** Each colour that is set tells of itself: they are read once for all, in the same frame. */
  readonly #recolour = () => {
    cancelAnimationFrame(this.#recolouring);
    this.#recolouring = requestAnimationFrame(this.#retheme);
  };
  #recolouring = 0;
  readonly #online = () => {
    if (this.#isUnreached) void this.#load();
  };

  constructor() {
    super();
    this.addEventListener('keydown', keepUsedKey);
  }

  /**
   * The mesh on show; null before it is loaded. Edit it through `operation`, or call `refresh()` after. It is disposed
   * of when the figure shows another one, and when the figure leaves its place in the page.
   */
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
    do {
      if (this.isConnected && this.isUpdatePending) {
        await this.updateComplete; // which begins to load
        if (!this.isConnected) break;
      }
      if (this.state === 'waiting') await this.#load();
      while (this.state === 'loading') {
        await new Promise((done) =>
          this.addEventListener('halfedge-settled', done, { once: true }),
        );
      }
    } while (this.state === 'waiting' && this.isConnected); // it was moved meanwhile
    if (this.#model.mesh && this.state !== 'failed') return this.#model.mesh;
    throw new Error(this.failure ?? 'The figure is not in a page.');
  }

  /** Loads the mesh anew, such as where it could not be reached, and resolves once it is on show. */
  reload(): Promise<HalfedgeMesh> {
    if (this.isConnected) void this.#load();
    return this.ready();
  }

  /** Plays on; from the beginning, where the end is reached. */
  play(): void {
    this.#model.player.play();
  }

  /** Rests at the current step. */
  pause(): void {
    this.#model.player.pause();
  }

  /** Plays if it rests, and rests if it plays. */
  toggle(): void {
    this.#model.player.toggle();
  }

  /** Goes to the next step, and rests there. */
  stepForward(): void {
    this.seek(this.#reached + 1);
  }

  /** Goes to the step before, and rests there. */
  stepBack(): void {
    this.seek(this.#reached - 1);
  }

  /** Goes to a step, and rests there. */
  seek(position: number): void {
    this.#model.player.seek(position);
  }

  /** Goes the other way round. */
  turn(): void {
    this.direction = this.direction === 'ccw' ? 'cw' : 'ccw';
  }

  /** Shows the code in the words of another library. */
  setDialect(id: DialectId): void {
    this.dialect = id;
  }

  /** Shows the whole mesh. */
  fit(): void {
    if (!this.#isLost()) this.#picture.fit();
  }

  /** Draws the mesh as it is now, after edits by a program; what is gone is not selected any more. */
  refresh(): void {
    const { mesh, selected, story } = this.#model;
    if (!mesh || this.#isLost()) return;
    const isGone = selected !== null && !isLive(mesh, selected);
    if (isGone && sameItem(parseItemName(this.select ?? ''), selected)) this.select = null;
    this.#model.refresh(this.settings);
    this.#view?.show(this.viewpoint ?? this.#view.viewpoint(), this.upAxis);
    this.#drawing.forget();
    if (this.#model.story !== story) this.#resume();
    this.requestUpdate();
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.state = 'waiting'; // whatever a copied attribute says
    this.#dark?.addEventListener('change', this.#retheme);
    window.addEventListener('online', this.#online);
    this.#watcher?.observe(this);
    if (this.loading === 'eager' || this.#watcher === null) void this.#load();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#dark?.removeEventListener('change', this.#retheme);
    window.removeEventListener('online', this.#online);
    this.#watcher?.disconnect();
    this.#close();
    this.state = 'waiting';
    this.dispatchEvent(new Event('halfedge-settled'));
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    if (changed.has('speed')) this.#model.player.speed = this.pace;
    const another = changed.has('src') || changed.has('build') || changed.has('bytes');
    if (another && this.state !== 'waiting') void this.#load();
    if (this.state !== 'ready' || this.#isLost()) return;
    const anew = this.#follow(changed.has('camera') || changed.has('up'));
    // A step that the player has made itself is no reason to rest.
    const { story } = this.#model;
    if ((anew || changed.has('step')) && story && story.position !== this.step) {
      this.#model.player.seek(this.position);
    }
    this.#complain();
  }

  protected override updated(changed: PropertyValues<this>): void {
    if (changed.has('theme')) this.#retheme();
    this.#showLine();
  }

  /** Scrolls the code to the line that is at work, once it is another; the page stays where it is. */
  #showLine(): void {
    const lines = this.renderRoot.querySelector('.lines');
    const current = lines?.querySelector('[aria-current]') ?? null;
    const wasShown = current === this.#line; // and may have been scrolled away by hand
    this.#line = current;
    if (!lines || !current || wasShown) return;
    const [seen, line] = [lines.getBoundingClientRect(), current.getBoundingClientRect()];
    if (line.bottom > seen.bottom) lines.scrollTop += line.bottom - seen.bottom;
    else if (line.top < seen.top) lines.scrollTop -= seen.top - line.top;
  }

  protected override render(): TemplateResult {
    const { story, player } = this.#model;
    const parts = this.controlNames;
    if (story instanceof WalkStory) this.#walk = story;
    const walk = story === null && this.query !== null ? this.#walk : story;
    return html`
      <figure part="figure">
        <div class="stage" part="stage">
          <canvas
            part="canvas"
            tabindex="0"
            role="img"
            lang=${this.alt === null ? this.#lang : nothing}
            aria-label=${this.alt ?? `A mesh. ${this.#model.words}`}
            aria-description=${KEYS}
            @keydown=${this.#pressed}
            @focus=${() => this.#focus(true)}
            @blur=${() => this.#focus(false)}
            @transitionrun=${this.#recolour}
          ></canvas>
          <div class="labels" part="labels" aria-hidden="true"></div>
          ${this.#poster()}
          ${this.#error()}
          <button type="button" class="home" part="button home" lang="en" title="Show it whole" aria-label="Show it whole" @click=${this.fit}>
            ${icon('focus')}
          </button>
        </div>
        ${walk && parts.includes('player') ? playerBar(walk, player.playing, this, story === null) : nothing}
        ${this.#sentence(parts.length > 0)}
        ${walk instanceof WalkStory && parts.includes('code') ? codeListing(walk.player, this, story === null) : nothing}
        <figcaption part="caption" class=${this.hasCaption ? '' : 'empty'}>
          <slot name="caption" @slotchange=${this.#captioned}></slot>
        </figcaption>
      </figure>
      <slot hidden @slotchange=${this.#rewritten}></slot>
    `;
  }

  /** The step that the story is at, whatever `step` was set to. */
  get #reached(): number {
    return this.#model.story?.position ?? this.position;
  }

  /** What can be turned: the drawing, where there is no WebGL. */
  get #picture(): Pick<FigureView, 'orbit' | 'zoom' | 'fit'> {
    return this.#view ?? this.#drawing;
  }

  /** Sentences are English, but for those that a page gives. */
  get #lang(): string | typeof nothing {
    return this.trail ? nothing : 'en';
  }

  #poster(): TemplateResult | typeof nothing {
    if (this.#view && this.state === 'ready') return nothing;
    const drawn =
      this.state === 'ready' ? this.#drawing.draw(this.#model, this.viewpoint, this.upAxis) : null;
    return html`<div class=${`poster ${this.state}`} part="poster">
      <slot name="poster">${drawn}</slot>
    </div>`;
  }

  #error(): TemplateResult | typeof nothing {
    if (this.failure === null) return nothing;
    const again = html`<button type="button" part="button again" lang="en" @click=${this.#again}>Try again</button>`;
    return html`<p class="error" part="error" role="alert" lang="en" dir="auto">${icon('warning')}<span>${this.failure}</span>${this.#isUnreached ? again : nothing}</p>`;
  }

  #sentence(visible: boolean): TemplateResult {
    const { story } = this.#model;
    const refused = story?.refusal ? icon('refused') : nothing;
    const look = visible && this.mesh ? 'sentence' : 'hidden';
    return html`<p class=${look} part="sentence" aria-live="polite" lang=${this.#lang} dir="auto">${refused}<span>${this.#model.words}</span></p>`;
  }

  #again(): void {
    this.renderRoot.querySelector('canvas')?.focus(); // the button goes
    void this.#load();
  }

  async #load(): Promise<void> {
    this.state = 'loading';
    this.failure = this.#walk = null;
    this.#isUnreached = false;
    await this.#loading.load();
  }

  async #open(signal: AbortSignal): Promise<void> {
    await this.updateComplete;
    if (signal.aborted) return; // another source is being loaded
    const { mesh } = this.#model;
    if (!mesh) return;
    this.#makeView();
    this.state = 'ready';
    this.#model.player.speed = this.pace;
    // The view still has the mesh that was shown before.
    this.#follow(false, false);
    this.#view?.show(this.viewpoint, this.upAxis);
    this.#view?.update();
    this.#model.player.seek(this.position);
    this.#complain();
    this.requestUpdate();
    await this.updateComplete;
    if (signal.aborted) return;
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
      () => this.#isLost(),
    );
  }

  /** Follows the attributes. Whether there is a story that begins anew. */
  #follow(camera: boolean, draws = true): boolean {
    const { story } = this.#model;
    const settings = this.settings;
    if (!camera && this.#model.follows(settings)) return false;
    const edit = this.#model.tell(settings);
    if (camera) this.#view?.look(this.viewpoint, this.upAxis);
    if (draws) this.#view?.update(edit);
    return this.#model.story !== story;
  }

  /** Goes on where it was with a walk that has begun anew. */
  #resume(): void {
    const { player } = this.#model;
    player.seek(this.position);
    this.step = player.story?.position ?? 0;
  }

  /** Tells what can't be shown, once, and for as long as that is so. */
  #complain(): void {
    const error = this.#model.failure ?? this.mistake;
    if (!error) this.failure = null;
    else if (error.message !== this.failure) this.#fail(error, 'ready');
  }

  #fail(error: unknown, state: FigureStateName): void {
    const message = error instanceof Error ? error.message : String(error);
    this.failure = message;
    this.state = state;
    tell(this, 'halfedge-error', { message, error });
    this.dispatchEvent(new Event('halfedge-settled'));
  }

  /** Whether a program has disposed of the mesh, of which nothing can be asked then; that is told. */
  #isLost(): boolean {
    if (!this.#model.mesh?.disposed) return false;
    this.#close();
    this.#fail(new Error(LOST), 'failed');
    return true;
  }

  #close(): void {
    this.#loading.giveUp();
    this.#view?.dispose();
    this.#view = this.#walk = null;
    this.#drawing.forget();
    this.renderRoot.querySelector('.labels')?.replaceChildren();
    this.#model.take(null);
  }

  #seen(seen: boolean): void {
    if (seen && this.state === 'waiting') void this.#load();
    if (seen) this.#retheme(); // what isn't rendered, as behind a tab, has no transitions
    if (this.#view) this.#view.stage.asleep = !seen;
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
    if (this.#isLost()) return;
    if (item?.kind === this.#model.hovered?.kind && item?.index === this.#model.hovered?.index)
      return;
    this.#model.hovered = item;
    this.#view?.update();
  }

  #choose(item: Item | null): void {
    if (this.#isLost()) return;
    const select = item ? itemName(item) : null;
    if (!this.#model.choose(item, { ...this.settings, select })) return;
    this.select = select;
    this.step = this.#model.story?.position ?? 0;
    this.#view?.update();
    this.requestUpdate();
    tell(this, 'halfedge-select', { item: select });
  }

  #pressed(event: KeyboardEvent): void {
    if (this.#isLost()) return;
    const picture = this.#picture;
    const known = actOnKey(event, {
      toggle: () => this.toggle(),
      stepForward: () => this.stepForward(),
      stepBack: () => this.stepBack(),
      seek: (position) => this.seek(position),
      walk: (key: WalkKey) => {
        const item = this.#model.walk(key);
        if (item) this.#choose(item);
      },
      orbit: (horizontal, vertical) => picture.orbit(horizontal, vertical),
      zoom: (factor) => picture.zoom(factor),
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
