import { Vector3 } from 'three';
import { type Box, LabelPlaces, type Trace } from './label-places.js';
import type { Stage } from './stage.js';

/** So many names of items at most are shown: more can't be read, and cost time in every frame. */
const MOST_NAMES = 300;
/** Of no more other labels than this it is asked whether something hides them: each takes a ray. */
const MOST_TRIED = 300;

/** Where no link is drawn longer than this, in CSS pixels, their numbers would only hide them. */
const SHORTEST_LINKS = 20;
/** What so many labels name is kept clear by others that go aside: each asks for each of these. */
const MOST_TRACES = 64;

/** A small text at a point of the scene. */
export interface Label {
  readonly text: string;
  /** A class that says what it marks; see label-styles.ts. */
  readonly look:
    | 'self'
    | 'hover'
    | 'ordinal'
    | 'current'
    | 'link'
    | 'witness'
    | 'first'
    | 'problem'
    | 'index';
  /** Which role of the palette a link's label has. */
  readonly role?: string;
  readonly point: Vector3;
  /** How far it lies from the point, in CSS pixels: upwards, or towards `side`. */
  readonly lift: number;
  readonly side?: Vector3 | undefined;
  /** What it names, where that is a line: from corner to corner. */
  readonly line?: readonly Vector3[] | undefined;
  /**
   * Whether it goes aside where it would cover another one, or what another one names, instead of being hidden or
   * taken for it.
   */
  readonly yields?: boolean;
  /** Whether it lies over the surface, as what it stands beside does: then nothing hides it. */
  readonly over?: boolean;
}

/** How wide a label is, in CSS pixels, as its style has it: to ask the page would cost a layout in every frame. */
export function widthOf({ look, text: { length } }: Pick<Label, 'look' | 'text'>): number {
  switch (look) {
    case 'index':
      return 4 + 6.6 * length;
    case 'ordinal':
    case 'current':
    case 'link':
      return Math.max(look === 'current' ? 27 : 20, 12 + 6.7 * length);
    default:
      return 18 + 7.2 * length;
  }
}

/**
 * Labels come in the order of their importance. One that would cover an earlier one goes aside if it
 * yields, and is hidden otherwise.
 */
export class Labels {
  readonly #stage: Stage;
  readonly #host: HTMLElement;
  readonly #pool: HTMLElement[] = [];
  readonly #seen = new Vector3();
  readonly #aside = new Vector3();
  #labels: readonly Label[] = [];

  constructor(stage: Stage, host: HTMLElement) {
    this.#stage = stage;
    this.#host = host;
  }

  /** Shows other labels, from the next `update` on. */
  set(labels: readonly Label[]): void {
    this.#labels = labels;
    while (this.#pool.length < labels.length) {
      const element = document.createElement('span');
      element.className = 'tag';
      this.#pool.push(element);
      this.#host.append(element);
    }
    this.#pool.forEach((element, i) => {
      const label = labels[i];
      element.hidden = !label;
      if (!label) return;
      const look = `tag ${label.look}${label.role ? ` role-${label.role}` : ''}`;
      if (element.dataset.look !== look) {
        element.dataset.look = look;
        element.className = look;
      }
      if (element.textContent !== label.text) element.textContent = label.text;
    });
  }

  /** Before each frame: moves the labels with their points. `hides` tells what is out of sight. */
  update(hides: (point: Vector3) => boolean): void {
    const traces = this.#labels.map((label) => (label.yields ? this.#trace(label) : null));
    const places = new LabelPlaces(
      traces.filter((trace) => trace !== null).slice(0, MOST_TRACES),
      traces.some((trace) => trace !== null) ? this.#names() : [],
    );
    const areTiny = this.#areTiny(traces);
    let names = 0;
    this.#labels.forEach((label, i) => {
      const element = this.#pool[i];
      const width = widthOf(label);
      const wanted = this.#place(label, width);
      const trace = traces[i];
      const own = places.isFree(wanted, width) ? wanted : undefined;
      const place = trace ? places.best(wanted, width, trace) : own;
      const isName = label.look === 'index';
      const isCrowded = isName ? names === MOST_NAMES : label.look === 'link' && areTiny;
      const inSight = wanted.z < 1 && place && !isCrowded;
      const isTried = !label.over && (isName || i < MOST_TRIED);
      const behind = inSight && isTried && hides(label.point);
      const shown = inSight && !(behind && isName);
      element.classList.toggle('away', !shown);
      if (!shown) return;
      if (isName) names += 1;
      const { x, y } = place;
      places.take(x, y, width);
      // The disc or line that this label stands above must not be covered either.
      if (label.look === 'self' && !label.side && label.lift > 0) {
        places.take(x, y + label.lift, 14);
      }
      element.classList.toggle('behind', behind === true);
      element.style.transform = `translate(-50%, -50%) translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
    });
  }

  /** Where the first names of items will lie that don't go aside. */
  #names(): Box[] {
    const names = this.#labels.filter(({ look, yields }) => look === 'index' && !yields);
    return names.slice(0, MOST_TRACES).map((label) => {
      const width = widthOf(label);
      const { x, y } = this.#place(label, width);
      return { x, y, width };
    });
  }

  /** Whether all links that are lines are too short for numbers beside them. */
  #areTiny(traces: readonly (Trace | null)[]): boolean {
    const lines = traces.filter((_, i) => this.#labels[i].look === 'link' && this.#labels[i].line);
    const reach = (line: Trace | null) => {
      const [from, to] = [line?.at(0), line?.at(-1)];
      return from && to ? Math.hypot(from.x - to.x, from.y - to.y) : 0;
    };
    return lines.length > 0 && lines.every((line) => reach(line) < SHORTEST_LINKS);
  }

  /** What a label names, as it lies on the canvas. */
  #trace({ point, line = [point] }: Label): Trace {
    return line.map((corner) => {
      const { x, y } = this.#stage.project(corner, this.#seen);
      return { x, y };
    });
  }

  /** Where a label comes to lie on the canvas: whole, if its point is there. */
  #place({ point, lift, side }: Label, width: number): Vector3 {
    const seen = this.#stage.project(point, this.#seen);
    const right = this.#stage.size.x;
    const onCanvas = seen.x >= 0 && seen.x <= right;
    if (!side) {
      seen.y -= lift;
    } else {
      const { x, y } = this.#stage.project(side, this.#aside);
      const [dx, dy] = [x - seen.x, y - seen.y];
      const length = Math.hypot(dx, dy) || 1;
      seen.x += (lift * dx) / length;
      seen.y += (lift * dy) / length;
    }
    const margin = width / 2 + 6;
    if (onCanvas) seen.x = Math.min(right - margin, Math.max(margin, seen.x));
    return seen;
  }
}
