import type { CDPSession, Page } from 'playwright-core';
import type { Point } from './explorer.js';

/** Where one finger goes down, and where it is lifted. */
export type Stroke = readonly [from: Point, to: Point];

const MOVES = 10;

/** Fingers on the screen, as the browser's own input has them: it scrolls and zooms the page where it may. */
export class Fingers {
  readonly #page: Page;
  readonly #session: CDPSession;

  private constructor(page: Page, session: CDPSession) {
    this.#page = page;
    this.#session = session;
  }

  static async on(page: Page): Promise<Fingers> {
    return new Fingers(page, await page.context().newCDPSession(page));
  }

  /** A short touch with as many fingers as there are points. */
  async tap(...points: Point[]): Promise<void> {
    await this.#send('touchStart', points);
    await this.#send('touchEnd', []);
    await this.#settle();
  }

  /** Fingers go down together, move along straight lines, and are lifted. */
  async move(...strokes: Stroke[]): Promise<void> {
    const at = (t: number) =>
      strokes.map(([[x, y], [u, v]]): Point => [x + t * (u - x), y + t * (v - y)]);
    await this.#send('touchStart', at(0));
    for (let i = 1; i <= MOVES; i++) {
      await this.#send('touchMove', at(i / MOVES));
      await this.#page.waitForTimeout(16);
    }
    await this.#send('touchEnd', []);
    await this.#settle();
  }

  /** How far the page has been scrolled and zoomed. */
  page(): Promise<{ scrolled: number; zoom: number }> {
    return this.#page.evaluate(() => {
      const { scale = 1, offsetLeft = 0, offsetTop = 0 } = window.visualViewport ?? {};
      return { scrolled: Math.hypot(scrollX + offsetLeft, scrollY + offsetTop), zoom: scale };
    });
  }

  async #send(type: 'touchStart' | 'touchMove' | 'touchEnd', points: Point[]): Promise<void> {
    const touchPoints = points.map(([x, y], id) => ({ x, y, id }));
    await this.#session.send('Input.dispatchTouchEvent', { type, touchPoints });
  }

  /** A page that scrolls goes on for a moment. */
  async #settle(): Promise<void> {
    await this.#page.waitForTimeout(300);
  }
}

/** One finger, or two around the same middle, to be moved. */
export function strokes(middle: Point, ...ways: [from: Point, to: Point][]): Stroke[] {
  const [x, y] = middle;
  return ways.map(([[a, b], [c, d]]) => [
    [x + a, y + b],
    [x + c, y + d],
  ]);
}
