import { mkdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { HalfedgeMesh } from 'halfedge';
import type { Page } from 'playwright-core';
import { Tab, type TabSettings } from './tab.js';

export { disconnect } from '../../support/connection.js';

const shared = JSON.parse(process.env.HALFEDGE_EXPLORER ?? '{}') as {
  address: string;
  screenshots: string;
};

export interface Settings extends TabSettings {
  /** What the address has after `#`. */
  readonly link?: string;
  /** The mesh that is shown first; the first sample if left out. */
  readonly mesh?: string;
}

export type Point = readonly [x: number, y: number];

/** The explorer in a tab of its own, as a user sees it; read through its documented attributes. */
export class ExplorerPage {
  readonly page: Page;
  /** Errors and warnings in the console, uncaught errors and failed requests. */
  readonly complaints: string[];
  readonly #tab: Tab;

  private constructor(tab: Tab) {
    this.page = tab.page;
    this.complaints = tab.complaints;
    this.#tab = tab;
  }

  /** Opens the page and waits until the first mesh is drawn. */
  static async open(settings: Settings = {}): Promise<ExplorerPage> {
    const explorer = new ExplorerPage(await Tab.open(settings, { name: 'explorer' }));
    await explorer.page.goto(shared.address + (settings.link ? `#${settings.link}` : ''));
    await explorer.ready(settings.mesh ?? 'Bunny');
    return explorer;
  }

  /** Leaves the page; the next test may go on in its tab. */
  close(): Promise<void> {
    return this.#tab.leave();
  }

  /** Leaves the page, and closes its tab: for tests that added scripts to it, stopped its clock or closed it. */
  closeTab(): Promise<void> {
    return this.#tab.close();
  }

  /** Waits until this mesh is on show, drawn and at rest. */
  async ready(mesh: string): Promise<void> {
    await this.page.waitForSelector(`html[data-state=ready] main.stage[data-mesh="${mesh}"]`);
  }

  /** Opens a sample by the menu. */
  async sample(id: string, name: string): Promise<void> {
    await this.page.click('.mesh-button');
    await this.page.click(`[data-sample=${id}]`);
    await this.ready(name);
  }

  /** Opens a broken sample by the menu. */
  async broken(id: string, name: string): Promise<void> {
    await this.page.click('.mesh-button');
    await this.page.click(`[data-broken=${id}]`);
    await this.ready(name);
  }

  /** An attribute of the stage, without `data-`. */
  async state(name: string): Promise<string | null> {
    return this.page.getAttribute('main.stage', `data-${name}`);
  }

  /** Waits until the mesh is checked, and returns what the page says of it. */
  async validity(): Promise<string> {
    const line = this.page.locator('.validity', { hasNotText: 'Checking' });
    return (await line.textContent()) ?? '';
  }

  /** Waits until an attribute of the stage has this value; null: until it is gone. */
  async until(name: string, value: string | null): Promise<void> {
    const selector =
      value === null ? `main.stage:not([data-${name}])` : `main.stage[data-${name}="${value}"]`;
    await this.page.waitForSelector(selector);
  }

  /** Selects an item by its name, in the field of the inspector. */
  async goTo(item: string): Promise<void> {
    await this.page.fill('.goto input', item);
    await this.page.press('.goto input', 'Enter');
    await this.page.focus('main.stage canvas');
  }

  async press(...keys: string[]): Promise<void> {
    for (const key of keys) await this.page.keyboard.press(key);
  }

  /** The items that the player lists as visited. */
  async visited(): Promise<string[]> {
    return this.page.$$eval('ol.visited [data-item]', (buttons) =>
      buttons.map((button) => (button as HTMLElement).dataset.item ?? ''),
    );
  }

  /** Waits until the picture is drawn and nothing moves. */
  async rest(): Promise<void> {
    const ready = () => this.page.waitForSelector('html[data-state=ready]');
    await ready();
    // What was pressed last may set something in motion a moment later.
    await this.page.evaluate(() => new Promise((done) => setTimeout(done, 100)));
    await ready();
  }

  /** Waits, a minute at most, until something holds of the page at rest; returns whether it does. */
  async comesTrue(holds: () => Promise<boolean>): Promise<boolean> {
    const end = performance.now() + 60_000;
    for (;;) {
      await this.rest();
      if (await holds()) return true;
      if (performance.now() > end) return false;
    }
  }

  /** Waits for the camera to rest, and returns where positions of the mesh appear in the window. */
  async projection(): Promise<(position: ArrayLike<number>) => Point> {
    await this.rest();
    const m = ((await this.state('camera')) ?? '').split(' ').map(Number);
    const { width, height } = this.page.viewportSize() ?? { width: 0, height: 0 };
    return ({ 0: x, 1: y, 2: z }) => {
      const row = (k: number) => m[k] * x + m[4 + k] * y + m[8 + k] * z + m[12 + k];
      return [((row(0) / row(3) + 1) * width) / 2, ((1 - row(1) / row(3)) * height) / 2];
    };
  }

  /** Keeps a picture of the page among the artefacts. */
  async screenshot(name: string): Promise<void> {
    mkdirSync(shared.screenshots, { recursive: true });
    await this.page.evaluate(() => document.fonts.ready);
    await this.rest();
    await this.page.screenshot({ path: join(shared.screenshots, `${name}.png`) });
  }

  /** How many different colours the page shows in a part of the window. */
  async colours(x: number, y: number, width: number, height: number): Promise<number> {
    const picture = await this.page.screenshot({ clip: { x, y, width, height } });
    return this.page.evaluate(
      async (data) => {
        const bitmap = await createImageBitmap(await (await fetch(data)).blob());
        const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
        if (!context) return 0;
        context.drawImage(bitmap, 0, 0);
        const { data: pixels } = context.getImageData(0, 0, bitmap.width, bitmap.height);
        return new Set(new Uint32Array(pixels.buffer)).size;
      },
      `data:image/png;base64,${picture.toString('base64')}`,
    );
  }

  /** How many pixels of two pictures of the same size differ. */
  async differingPixels(one: Buffer, other: Buffer): Promise<number> {
    return this.page.evaluate(
      async (pictures) => {
        const [a, b] = await Promise.all(
          pictures.map(async (data) => {
            const bitmap = await createImageBitmap(await (await fetch(data)).blob());
            const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
            if (!context) throw new Error('there is no canvas to compare pictures on');
            context.drawImage(bitmap, 0, 0);
            const { data: pixels } = context.getImageData(0, 0, bitmap.width, bitmap.height);
            return new Uint32Array(pixels.buffer);
          }),
        );
        if (!a || !b || a.length !== b.length) throw new Error('the pictures differ in size');
        return a.reduce((sum, pixel, i) => sum + (pixel === b[i] ? 0 : 1), 0);
      },
      [one, other].map((picture) => `data:image/png;base64,${picture.toString('base64')}`),
    );
  }

  /** Drops a file on the page, as from the desktop. */
  async drop(name: string, content: string): Promise<void> {
    const transfer = await this.page.evaluateHandle(
      ([file, text]) => {
        const data = new DataTransfer();
        data.items.add(new File([text], file));
        return data;
      },
      [name, content] as const,
    );
    await this.page.dispatchEvent('main.stage', 'dragenter', { dataTransfer: transfer });
    await this.page.dispatchEvent('main.stage', 'drop', { dataTransfer: transfer });
  }
}

/** The mesh of a sample file, as the package reads it here. */
export function sampleMesh(name: string): HalfedgeMesh {
  const path = join(process.cwd(), 'web/explorer/samples', name);
  return HalfedgeMesh.parse(readFileSync(path, 'utf8'), { format: 'off' }).mesh;
}
