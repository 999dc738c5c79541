// That nothing depends on Chromium, or on V8: the package, the explorer, a figure and an exercise in the engine of
// Safari, on the shortest way through what they do.

import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { By, Key } from 'selenium-webdriver';
import { root } from '../../scripts/lib/run.mjs';
import { webkitDriver } from '../../scripts/lib/webkit.mjs';
import { WebKit, type WebKitPage } from '../support/webkit.js';
import { EXERCISE, elementPage, FIGURE, SQUARE, VALENCE } from './support/elements.js';

const { screenshots } = JSON.parse(process.env.HALFEDGE_EXPLORER ?? '{}') as {
  screenshots: string;
};

/** Keeps a picture of the page among the artefacts. */
async function screenshot(page: WebKitPage, name: string): Promise<void> {
  mkdirSync(screenshots, { recursive: true });
  writeFileSync(join(screenshots, `webkit-${name}.png`), await page.screenshot());
}

if (webkitDriver === undefined) {
  console.warn('Skipped: WebKit, as there is no WebKitWebDriver on PATH.');
}
const inWebKit = webkitDriver === undefined ? describe.skip : describe;

inWebKit('In WebKit', () => {
  let webkit: WebKit;
  let page: WebKitPage;
  beforeAll(async () => {
    webkit = await WebKit.start();
  });
  afterAll(() => webkit?.close());
  afterEach(async () => expect(await page.complaints()).toEqual([]));

  describe('the package', () => {
    beforeAll(async () => {
      page = await webkit.open(
        join(root, 'dist'),
        `<!doctype html>
<link rel="icon" href="data:,">
<script type="module">
  import * as core from './index.js';
  import * as inline from './inline.js';
  import { parseInWorker } from './worker.js';

  const told = {};
  for (const [name, { init, HalfedgeMesh }] of Object.entries({ core, inline })) {
    await init();
    const mesh = HalfedgeMesh.icosahedron();
    const spoken = [];
    for (const v of mesh.vertices()) for (const w of mesh.vertexVertices(v)) spoken.push(w);
    const rows = mesh.allVertexVertices();
    told[name] = [spoken.length, String(spoken) === String([...rows.items]), mesh.validate().length];
  }
  await core.init();
  try {
    core.HalfedgeMesh.fromTriangles([0, 0, 0, 1, 0, 0], [0, 1, 1]);
  } catch (error) {
    told.error = error.message;
  }
  const { mesh } = await parseInWorker(new TextEncoder().encode(${JSON.stringify(SQUARE)}), { format: 'off' });
  mesh.history.enabled = true;
  const e = mesh.findEdge(0, 2);
  mesh.flipEdge(e);
  told.flipped = [mesh.findEdge(1, 3) === e, mesh.history.undo(), mesh.findEdge(0, 2) === e];
  window.told = told;
</script>`,
      );
    });

    test('is loaded both ways, circulates, parses in a worker, edits and undoes, and explains errors', async () => {
      await page.until('window.told || complaints.length > 0');
      expect(await page.evaluate('window.told')).toEqual({
        core: [60, true, 0],
        inline: [60, true, 0],
        error:
          'Face 0 uses vertex 1 at 2 corners (its corners are 0, 1, 1); a face may use a vertex once.',
        flipped: [true, true, true],
      });
    });
  });

  describe('the explorer', () => {
    beforeAll(async () => {
      page = await webkit.open(join(root, 'build/explorer'));
    });

    /** Waits until an attribute of the stage has a value that matches. */
    const until = (name: string, pattern: RegExp) =>
      page.until(
        `document.documentElement.dataset.state === 'ready' &&
        ${pattern}.test(document.querySelector('main.stage').dataset.${name})`,
      );

    test('opens with a mesh', async () => {
      await until('mesh', /^Bunny$/);
      expect(
        await page.evaluate("document.querySelectorAll('main.stage canvas').length"),
      ).toBeGreaterThan(0);
    });

    test('picks what is clicked', async () => {
      const actions = page.driver.actions();
      await actions.move({ x: 400, y: 400 }).click().perform();
      await until('selected', /^[vehf]\d+$/);
    });

    test('steps around a vertex', async () => {
      await page.driver.findElement(By.css('.goto input')).sendKeys('v1224', Key.ENTER);
      await until('selected', /^v1224$/);
      const canvas = await page.driver.findElement(By.css('main.stage canvas'));
      for (const visited of [1, 2, 3]) {
        await canvas.sendKeys('.');
        await page.until(`document.querySelector('ol.visited li:nth-child(${visited})')`);
      }
      expect(
        await page.evaluate("document.querySelectorAll('ol.visited [data-item]').length"),
      ).toBe(3);
      await screenshot(page, 'explorer');
    });

    test('opens a file that is chosen, and one that is dropped', async () => {
      const folder = mkdtempSync(join(tmpdir(), 'halfedge-webkit-'));
      try {
        writeFileSync(join(folder, 'chosen.off'), SQUARE);
        const input = await page.driver.findElement(By.css('input[type=file]'));
        await input.sendKeys(join(folder, 'chosen.off'));
        await until('mesh', /^chosen\.off$/);
      } finally {
        rmSync(folder, { recursive: true });
      }
      await page.driver.executeScript(
        `
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(new File([arguments[0]], 'dropped.off'));
        for (const type of ['dragenter', 'drop']) {
          const event = new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true });
          document.querySelector('main.stage').dispatchEvent(event);
        }`,
        SQUARE,
      );
      await until('mesh', /^dropped\.off$/);
    });
  });

  describe('a figure', () => {
    beforeAll(async () => {
      page = await webkit.open(join(root, 'dist'), elementPage('figure', FIGURE));
    });

    test('is drawn and played', async () => {
      await page.until("document.querySelector('halfedge-figure[state=ready]')");
      await page.driver.executeScript("document.querySelector('halfedge-figure').stepForward()");
      await page.until(`document.querySelector('halfedge-figure[step="1"]')`);
      await screenshot(page, 'figure');
    });
  });

  describe('an exercise', () => {
    beforeAll(async () => {
      page = await webkit.open(join(root, 'dist'), elementPage('exercise', EXERCISE));
      await page.until(
        `document.querySelector('halfedge-exercise').shadowRoot?.querySelector('.cm-content')`,
      );
    });

    /** Types a program over the one that is there, runs it by the keyboard, and waits for what is told. */
    async function run(code: string, state: 'passed' | 'failed'): Promise<string> {
      const { driver } = page;
      const exercise = await driver.findElement(By.css('halfedge-exercise'));
      const shadow = await exercise.getShadowRoot();
      await (await shadow.findElement(By.css('.cm-content'))).click();
      await driver.executeScript(`
        window.told = new Promise((done) =>
          document.addEventListener('halfedge-result', () => done(), { once: true }));`);
      const actions = driver.actions();
      const press = (key: string) => actions.keyDown(Key.CONTROL).sendKeys(key).keyUp(Key.CONTROL);
      press('a').sendKeys(code);
      await press(Key.ENTER).perform();
      await driver.executeAsyncScript('told.then(arguments[0])');
      await page.until(`document.querySelector('halfedge-exercise[state=${state}]')`);
      return page.evaluate(
        "document.querySelector('halfedge-exercise').shadowRoot.querySelector('.headline').textContent",
      );
    }

    test('is typed, run, told what is wrong, and solved', async () => {
      expect(await run('const valence = (mesh, v) => 2;', 'failed')).toBe('It counts one too few.');
      expect(await run('const valence = (mesh, v) => { for (;;); }', 'failed')).toBe(
        'The loop in line 1 does not end.',
      );
      expect(await run('const valence = (mesh, v) => count(v);', 'failed')).toBe(
        "The code stops with an error: Can't find variable: count.",
      );
      expect(await run(VALENCE, 'passed')).toBe('Right.');
      await screenshot(page, 'exercise');
    });
  });
});
