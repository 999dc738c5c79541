import { disconnect, ExplorerPage } from './support/explorer.js';

let explorer: ExplorerPage;
beforeEach(async () => {
  explorer = await ExplorerPage.open({ link: 'sample=cube&select=v7', mesh: 'Cube' });
  await explorer.page.evaluate(() => {
    const context = document.querySelector('canvas')?.getContext('webgl2');
    const lose = context?.getExtension('WEBGL_lose_context');
    Object.assign(window, {
      loseContext: () => lose?.loseContext(),
      restoreContext: () => lose?.restoreContext(),
    });
  });
});
afterEach(() => explorer.close());
afterAll(disconnect);

/** Takes the WebGL context away, or gives it back, and waits until the page has heard of it. */
async function turn(way: 'lose' | 'restore'): Promise<void> {
  await explorer.page.evaluate(async (what) => {
    const event = what === 'lose' ? 'webglcontextlost' : 'webglcontextrestored';
    const heard = new Promise((done) => {
      document.querySelector('canvas')?.addEventListener(event, done, { once: true });
    });
    // A context that was lost just now can't be given back yet.
    await new Promise((done) => setTimeout(done, 500));
    (window as unknown as Record<string, () => void>)[`${what}Context`]();
    await heard;
  }, way);
}

/** How many colours the middle of the picture has. */
const colours = () => explorer.colours(256, 200, 400, 400);

/** The middle of the picture, drawn with the fonts of the page. */
async function picture(): Promise<Buffer> {
  await explorer.page.evaluate(() => document.fonts.ready);
  await explorer.rest();
  return explorer.page.screenshot({ clip: { x: 256, y: 200, width: 400, height: 400 } });
}

const canBeSeen = () =>
  explorer.page.$eval('.stage canvas', (it) => it.checkVisibility({ opacityProperty: true }));

test('is drawn again when the browser gives the graphics card back', async () => {
  const { page } = explorer;
  expect(await colours()).toBeGreaterThan(100);
  const before = await picture();
  await explorer.press('3');
  await turn('lose');
  expect(await page.textContent('.notice:not([hidden]) [data-message]')).toContain('graphics card');
  expect(await canBeSeen()).toBe(false);
  for (const format of ['png', 'svg']) {
    await page.click(`.mesh-facts [data-download=${format}]`);
    await page.waitForSelector('.mesh-facts .outcome:has-text("Not saved: ")');
  }
  await turn('restore');
  let differing = Number.NaN;
  await explorer.comesTrue(async () => {
    differing = await explorer.differingPixels(before, await picture());
    return differing < 100;
  });
  expect(differing).toBeLessThan(100); // of 160,000
  expect(await canBeSeen()).toBe(true);
  expect(await page.isHidden('.notice')).toBe(true);
  await page.click('.mesh-facts [data-download=png]');
  await page.waitForSelector('.mesh-facts .outcome:has-text("Saved cube.png")');
});

test('can be lost again after a change of the mesh, and leaves nothing behind', async () => {
  await turn('lose');
  await turn('restore');
  await explorer.goTo('f0');
  await explorer.press('Shift+I');
  await explorer.rest();
  await turn('lose');
  await turn('restore');
  await explorer.press('Control+z');
  expect(await explorer.comesTrue(async () => (await colours()) > 100)).toBe(true);
  expect(explorer.complaints).toEqual([]);
});
