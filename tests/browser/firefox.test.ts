// That nothing depends on Chromium: the explorer and a figure, on the shortest way through what they do.

import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { root } from '../../scripts/lib/run.mjs';
import { serve } from '../package/support/server.js';
import { Firefox, type FirefoxTab } from '../support/firefox.js';

const { address, screenshots } = JSON.parse(process.env.HALFEDGE_EXPLORER ?? '{}') as {
  address: string;
  screenshots: string;
};

/** Keeps a picture of the page among the artefacts. */
async function screenshot({ page }: FirefoxTab, name: string): Promise<void> {
  mkdirSync(screenshots, { recursive: true });
  await page.screenshot({ path: join(screenshots, `firefox-${name}.png`) });
}

let firefox: Firefox;
beforeAll(async () => {
  firefox = await Firefox.start();
});
afterAll(() => firefox?.close());

describe('In Firefox, the explorer', () => {
  let tab: FirefoxTab;
  beforeAll(async () => {
    tab = await firefox.open(address);
  });
  afterEach(() => expect(tab.complaints).toEqual([]));

  /** Waits until an attribute of the stage has a value that matches. */
  async function until(name: string, pattern: RegExp): Promise<void> {
    await tab.page.waitForFunction(
      (attribute, source) =>
        document.documentElement.dataset.state === 'ready' &&
        new RegExp(source).test(
          document.querySelector('main.stage')?.getAttribute(`data-${attribute}`) ?? '',
        ),
      {},
      name,
      pattern.source,
    );
  }

  test('opens with a mesh', async () => {
    await until('mesh', /^Bunny$/);
    expect(await tab.page.$$eval('main.stage canvas', (all) => all.length)).toBeGreaterThan(0);
  });

  test('picks what is clicked', async () => {
    await tab.page.mouse.click(640, 400);
    await until('selected', /^[vehf]\d+$/);
  });

  test('steps around a vertex', async () => {
    await tab.page.click('.goto input', { count: 3 });
    await tab.page.keyboard.type('v1224\n');
    await until('selected', /^v1224$/);
    await tab.page.focus('main.stage canvas');
    for (const visited of [1, 2, 3]) {
      await tab.page.keyboard.press('.');
      await tab.page.waitForSelector(`ol.visited li:nth-child(${visited})`);
    }
    const items = await tab.page.$$eval('ol.visited [data-item]', (all) => all.length);
    expect(items).toBe(3);
    await screenshot(tab, 'explorer');
  });

  test('opens a file that is dropped', async () => {
    await tab.page.evaluate(() => {
      const dataTransfer = new DataTransfer();
      const text = 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n';
      dataTransfer.items.add(new File([text], 'square.off'));
      for (const type of ['dragenter', 'drop']) {
        const event = new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true });
        document.querySelector('main.stage')?.dispatchEvent(event);
      }
    });
    await until('mesh', /^square\.off$/);
  });
});

test('In Firefox, a figure is drawn and played', async () => {
  const page = `<!doctype html>
<link rel="icon" href="data:,">
<script type="module" src="figure/standalone.js"></script>
<halfedge-figure src="shape:icosahedron" select="v3" query="vertexVertices" controls="player code"></halfedge-figure>`;
  const server = await serve(join(root, 'dist'), {
    answers: { '/page.html': { body: page, type: 'text/html' } },
  });
  try {
    const tab = await firefox.open(`${server.address}page.html`);
    await tab.page.waitForSelector('halfedge-figure[state=ready]');
    await tab.page.evaluate(() => {
      (
        document.querySelector('halfedge-figure') as unknown as { stepForward(): void }
      ).stepForward();
    });
    await tab.page.waitForSelector('halfedge-figure[step="1"]');
    await screenshot(tab, 'figure');
    expect(tab.complaints).toEqual([]);
  } finally {
    await server.close();
  }
});
