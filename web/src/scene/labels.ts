import { Vector3 } from 'three';
import type { Stage } from './stage.js';

/** Of no more than this it is asked whether something hides them: each takes a ray. */
const MOST_TRIED = 300;

/** A small text at a point of the scene. */
export interface Label {
  readonly text: string;
  /** A class that says what it marks; see overlays.css. */
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
}

/** Labels come in the order of their importance; ones that would cover an earlier one are hidden. */
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
      element.className = `tag ${label.look}${label.role ? ` role-${label.role}` : ''}`;
      if (element.textContent !== label.text) element.textContent = label.text;
    });
    this.#stage.invalidate();
  }

  /** Before each frame: moves the labels with their points. `hides` tells what is out of sight. */
  update(hides: (point: Vector3) => boolean): void {
    const taken: { x: number; y: number; width: number }[] = [];
    this.#labels.forEach((label, i) => {
      const element = this.#pool[i];
      const width = 8 + 7 * label.text.length;
      const { x, y, z } = this.#place(label, width);
      const covered = taken.some(
        (other) => Math.abs(other.x - x) < (other.width + width) / 2 && Math.abs(other.y - y) < 17,
      );
      const inSight = z < 1 && !covered;
      const behind = inSight && i < MOST_TRIED && hides(label.point);
      const shown = inSight && !(behind && label.look === 'index');
      element.classList.toggle('away', !shown);
      if (!shown) return;
      taken.push({ x, y, width });
      // The disc or line that this label stands above must not be covered either.
      if (label.look === 'self' && !label.side && label.lift > 0) {
        taken.push({ x, y: y + label.lift, width: 14 });
      }
      element.classList.toggle('behind', behind);
      element.style.transform = `translate(-50%, -50%) translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
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
