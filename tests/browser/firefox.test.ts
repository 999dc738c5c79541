// That nothing depends on Chromium: the explorer and a figure, on the shortest way through what they do.

import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { root } from '../../scripts/lib/run.mjs';
import { serve } from '../package/support/server.js';
import { Firefox, type FirefoxTab } from '../support/firefox.js';
import { EXERCISE, elementPage, FIGURE, SQUARE, VALENCE } from './support/elements.js';

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
    await tab.page.evaluate((text) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([text], 'square.off'));
      for (const type of ['dragenter', 'drop']) {
        const event = new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true });
        document.querySelector('main.stage')?.dispatchEvent(event);
      }
    }, SQUARE);
    await until('mesh', /^square\.off$/);
  });
});

/** Opens a page with an element of the package, as one file brings it. */
async function openElement(file: 'figure' | 'exercise', element: string) {
  const server = await serve(join(root, 'dist'), {
    answers: {
      '/page.html': { body: elementPage(file, element), type: 'text/html; charset=utf-8' },
    },
  });
  return { server, tab: await firefox.open(`${server.address}page.html`) };
}

test('In Firefox, a figure is drawn and played', async () => {
  const { server, tab } = await openElement('figure', FIGURE);
  try {
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

describe('In Firefox, an exercise', () => {
  let opened: Awaited<ReturnType<typeof openElement>>;
  beforeAll(async () => {
    opened = await openElement('exercise', EXERCISE);
    await opened.tab.page.waitForSelector('halfedge-exercise >>> .cm-content');
  });
  afterAll(() => opened?.server.close());

  /** Types a program over the one that is there, runs it by the keyboard, and waits for what is told. */
  async function run(code: string, state: 'passed' | 'failed'): Promise<string> {
    const { page } = opened.tab;
    await page.click('halfedge-exercise >>> .cm-content');
    await page.keyboard.down('Control');
    await page.keyboard.press('a');
    await page.keyboard.up('Control');
    await page.keyboard.type(code);
    const told = page.evaluate(
      () =>
        new Promise<void>((done) =>
          document.addEventListener('halfedge-result', () => done(), { once: true }),
        ),
    );
    await page.keyboard.down('Control');
    await page.keyboard.press('Enter');
    await page.keyboard.up('Control');
    await told;
    await page.waitForSelector(`halfedge-exercise[state=${state}]`);
    return page.$eval('halfedge-exercise >>> .headline', (it) => it.textContent ?? '');
  }

  test('is typed, run, told what is wrong, and solved', async () => {
    expect(await run('const valence = (mesh, v) => 2;', 'failed')).toBe('It counts one too few.');
    expect(await run('const valence = (mesh, v) => { for (;;); }', 'failed')).toBe(
      'The loop in line 1 does not end.',
    );
    expect(await run('const valence = (mesh, v) => 3 +;', 'failed')).toMatch(
      /^Line 1, column \d+: /,
    );
    expect(await run(VALENCE, 'passed')).toBe('Right.');
    await screenshot(opened.tab, 'exercise');
    expect(opened.tab.complaints).toEqual([]);
  });
});
