import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import type { FigureEvents, HalfedgeFigure } from 'halfedge/figure';
import type { Page } from 'playwright-core';
import { root } from '../../../scripts/lib/run.mjs';
import { serve } from '../../package/support/server.js';
import { type Preparation, Tab, type TabSettings } from './tab.js';

export { disconnect } from '../../support/connection.js';

const shared = JSON.parse(process.env.HALFEDGE_EXPLORER ?? '{}') as {
  screenshots: string;
};

export interface FigurePageSettings extends TabSettings {
  /** The Content-Security-Policy that is sent. */
  readonly policy?: string;
  /** Which sites' scripts may read it all; by default none. */
  readonly origins?: string;
  /** Whether the browser has WebGL. */
  readonly webgl?: boolean;
  /** The script of the page: the standalone file of figures, or of exercises. */
  readonly script?: 'figure' | 'exercise';
  /** A file of the repository to open; otherwise a page with the given body. */
  readonly path?: string;
}

/** What a page counts, in its own variables. */
interface Counts {
  contexts: number;
  copies: number;
  events: [name: string, detail: unknown][];
}

/** A page with figures, as a course has it: the standalone file, and elements. */
export class FigurePage {
  readonly page: Page;
  /** Errors and warnings in the console, and uncaught errors. */
  readonly complaints: string[];
  readonly #close: () => Promise<unknown>;

  private constructor({ page, complaints }: Tab, close: () => Promise<unknown>) {
    this.page = page;
    this.complaints = complaints;
    this.#close = close;
  }

  /** Opens a page with this body, and waits for the element to be defined. */
  static async open(body: string, settings: FigurePageSettings = {}): Promise<FigurePage> {
    const { policy, origins, webgl = true, path = 'figures.html', script = 'figure' } = settings;
    const html = `<!doctype html><html lang="en"><meta charset="utf-8">
      <meta name="viewport" content="width=device-width"><meta name="color-scheme" content="light dark">
      <title>Figures</title><script type="module" src="/dist/${script}/standalone.js"></script>
      <link rel="icon" href="data:,"><body>${body}</body></html>`;
    const type = 'text/html; charset=utf-8';
    const server = await serve(root, {
      answers: { 'figures.html': { body: html, type }, 'favicon.ico': { body: '' } },
      ...(policy ? { policy } : {}),
      ...(origins ? { origins } : {}),
    });
    const tab = await Tab.open(
      { width: 900, height: 700, ...settings },
      webgl ? WITH_WEBGL : WITHOUT_WEBGL,
    );
    const figures = new FigurePage(tab, async () => {
      await tab.leave();
      await server.close();
    });
    const { page } = tab;
    await page.goto(server.address + path);
    await page.waitForFunction(() => customElements.get('halfedge-figure') !== undefined);
    return figures;
  }

  close(): Promise<unknown> {
    return this.#close();
  }

  /** Waits until every figure of the page is on show; returns how many there are. */
  async ready(): Promise<number> {
    return this.page.evaluate(async () => {
      const figures = [...document.querySelectorAll('halfedge-figure')];
      for (const figure of figures) await figure.ready();
      await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
      return figures.length;
    });
  }

  /** Waits until no figure loads, those in exercises included, and nothing changes its look by and by. */
  async still(): Promise<void> {
    await this.page.waitForFunction(() => {
      const exercises = [...document.querySelectorAll('halfedge-exercise')];
      const roots = [document, ...exercises.map(({ shadowRoot }) => shadowRoot)];
      const figures = roots.flatMap((root) => [
        ...(root?.querySelectorAll('halfedge-figure') ?? []),
      ]);
      const isRunning = ({ playState }: Animation) => playState === 'running';
      return (
        figures.every(({ state }) => state !== 'loading') &&
        !document.getAnimations().some(isRunning)
      );
    });
  }

  /** Does something with the first figure of the page, in the page. */
  figure<Result>(act: (figure: HalfedgeFigure) => Result | Promise<Result>): Promise<Result> {
    return this.page.$eval('halfedge-figure', act as (it: Element) => Result | Promise<Result>);
  }

  /** The words beside the picture of the first figure. */
  async sentence(): Promise<string> {
    await this.figure(async (figure) => void (await figure.updateComplete));
    return (await this.page.textContent('halfedge-figure [part=sentence]'))?.trim() ?? '';
  }

  /** How many different colours the canvas of each figure has. */
  colours(): Promise<number[]> {
    return this.page.$$eval('halfedge-figure', (figures) =>
      figures.map((figure) => {
        const canvas = figure.shadowRoot?.querySelector('canvas') as HTMLCanvasElement;
        const { width, height } = canvas;
        const context = canvas.getContext('2d') as CanvasRenderingContext2D;
        const { data } = context.getImageData(0, 0, width, height);
        return new Set(new Uint32Array(data.buffer)).size;
      }),
    );
  }

  /** WebGL contexts that were made, and pictures that were copied to figures. */
  counts(): Promise<Omit<Counts, 'events'>> {
    return this.page.evaluate(() => {
      const { contexts, copies } = window as unknown as Counts;
      return { contexts, copies };
    });
  }

  /** The pictures copied so far, once 30 frames went by without one: however slow the machine is. */
  settled(): Promise<number> {
    return this.page.evaluate(async () => {
      const counts = window as unknown as Counts;
      for (let before = counts.copies, frames = 0; frames < 30; frames += 1) {
        await new Promise(requestAnimationFrame);
        if (counts.copies === before) continue;
        before = counts.copies;
        frames = 0;
      }
      return counts.copies;
    });
  }

  /** The events of figures so far, but for ready. */
  events<Name extends keyof FigureEvents>(name: Name): Promise<FigureEvents[Name][]> {
    return this.page.evaluate(
      (wanted) =>
        (window as unknown as Counts).events.filter(([it]) => it === wanted).map(([, it]) => it),
      name as string,
    ) as Promise<FigureEvents[Name][]>;
  }

  async screenshot(name: string): Promise<void> {
    mkdirSync(shared.screenshots, { recursive: true });
    const path = join(shared.screenshots, `${name}.png`);
    await this.page.screenshot({ path, fullPage: true, timeout: 90_000 });
  }
}

type Method = (this: object, ...parameters: unknown[]) => unknown;

/** Makes pages count what matters here. */
async function watch(page: Page, webgl: boolean): Promise<void> {
  await page.addInitScript((allowed) => {
    const counts = window as unknown as Counts;
    counts.contexts = counts.copies = 0;
    counts.events = [];
    for (const canvas of [HTMLCanvasElement, OffscreenCanvas]) {
      const { getContext } = canvas.prototype as unknown as { getContext: Method };
      Object.assign(canvas.prototype, {
        getContext(this: object, kind: string, ...options: unknown[]) {
          if (!kind.includes('webgl')) return getContext.call(this, kind, ...options);
          if (!allowed) return null;
          counts.contexts += 1;
          return getContext.call(this, kind, ...options);
        },
      });
    }
    const { drawImage } = CanvasRenderingContext2D.prototype as unknown as { drawImage: Method };
    Object.assign(CanvasRenderingContext2D.prototype, {
      drawImage(this: object, ...parameters: unknown[]) {
        counts.copies += 1;
        drawImage.apply(this, parameters);
      },
    });
    for (const name of ['select', 'step', 'refused', 'error']) {
      document.addEventListener(`halfedge-${name}`, (event) => {
        const { detail } = event as CustomEvent;
        counts.events.push([event.type, JSON.parse(JSON.stringify(detail))]);
      });
    }
  }, webgl);
}

const WITH_WEBGL: Preparation = { name: 'figures', prepare: (page) => watch(page, true) };
const WITHOUT_WEBGL: Preparation = {
  name: 'figures without WebGL',
  prepare: (page) => watch(page, false),
};

/** The page on show in a test: one at a time. */
let open: FigurePage | undefined;

/** Opens a page with that body. */
export async function figures(
  body: string,
  settings: FigurePageSettings = {},
): Promise<FigurePage> {
  open = await FigurePage.open(body, settings);
  return open;
}

/** To be called after each test that opens one. */
export async function closeFigures(): Promise<void> {
  await open?.close();
  open = undefined;
}

export const ONE_RING =
  '<halfedge-figure src="shape:icosahedron" select="v3" query="vertexVertices" controls="player code"></halfedge-figure>';
