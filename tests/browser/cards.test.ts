import type { Page } from 'playwright-core';
import { disconnect, ExplorerPage } from './support/explorer.js';

afterAll(disconnect);

const TRIANGLE = 'OFF\n3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n';
const NAMES = ['scan_2024_11_final_version_cleaned_decimated_v12.off', `${'n'.repeat(196)}.off`];

/** The words of what is shown there that lie outside of it, or outside of the window. */
function wordsOutside(page: Page, selector: string): Promise<string[]> {
  return page.$$eval(selector, (all) => {
    const shown = all.filter((each) => each.checkVisibility());
    if (shown.length === 0) return ['nothing is shown'];
    return shown.flatMap((card) => {
      const box = card.getBoundingClientRect();
      const right = Math.min(box.right, innerWidth) + 0.5;
      const isOutside = (rect: DOMRect) => rect.left < box.left - 0.5 || rect.right > right;
      const range = document.createRange();
      return [...card.querySelectorAll('*'), card]
        .filter((each) => {
          range.selectNodeContents(each);
          return [...range.getClientRects()].some(isOutside);
        })
        .map((each) => each.textContent ?? '');
    });
  });
}

describe.each(NAMES)('The name %s', (name) => {
  test.each([
    [390, 844],
    [1280, 800],
  ])('breaks in cards and in the panel, in a window %i wide', async (width, height) => {
    const explorer = await ExplorerPage.open({ width, height, link: 'sample=cube', mesh: 'Cube' });
    const { page } = explorer;
    await explorer.drop(name, TRIANGLE);
    await explorer.ready(name);
    await explorer.press('3');
    await page.click('.mesh-facts [data-download=off]');
    await page.waitForSelector('.outcome:has-text("Saved")');
    expect(await wordsOutside(page, '.mesh-facts h2, .mesh-facts .outcome')).toEqual([]);
    await page.click('[data-tab-button=edit]');
    await page.click('[data-operation=reverse]');
    await explorer.sample('cube', 'Cube');
    expect(await wordsOutside(page, '[data-left]')).toEqual([]);
    await explorer.drop(name, 'OFF\n3 1 3\n');
    await page.waitForSelector('.notice:not([hidden])');
    expect(await wordsOutside(page, '.notice')).toEqual([]);
    expect(explorer.complaints).toEqual([]);
    await explorer.close();
  });
});

test.each([
  [320, 568],
  [390, 844],
  [844, 390],
  [1280, 800],
])('One toast lies below the other, in a window of %i by %i', async (width, height) => {
  const link = 'sample=cube&select=f0&tab=edit';
  const explorer = await ExplorerPage.open({ width, height, link, mesh: 'Cube' });
  const { page } = explorer;
  await page.click('[data-operation=splitFace]');
  await explorer.until('undo', '1');
  // They would hide by themselves, after some seconds: a busy machine may look later than that.
  await page.evaluate(() => {
    const { setTimeout: own } = window;
    const short = (act: () => void, ms = 0) => (ms < 5000 ? own(act, ms) : 0);
    Object.assign(window, { setTimeout: short });
  });
  await explorer.sample('grid', 'Open grid');
  await page.click('[data-share]');
  await page.waitForSelector('[data-toast]:has-text("Link copied")');
  const left = await page.locator('[data-left]').boundingBox();
  const toast = await page.locator('[data-toast]').boundingBox();
  expect(left && toast && left.y + left.height <= toast.y).toBe(true);
  expect(left && toast && Math.min(left.x, toast.x) >= 0).toBe(true);
  await page.click('[data-left] button');
  await explorer.ready('Cube');
  await explorer.close();
});

test.each([
  [390, 844],
  [1280, 800],
])(
  'What was not opened is told over the toasts, in a window of %i by %i',
  async (width, height) => {
    const explorer = await ExplorerPage.open({ width, height, link: 'sample=cube', mesh: 'Cube' });
    const { page } = explorer;
    await page.evaluate(() => {
      navigator.clipboard.writeText = () => Promise.reject(new Error('not allowed'));
    });
    await page.click('[data-share]');
    await page.waitForSelector('[data-toast] input:not([hidden])'); // which nothing hides by itself
    await page.click('[data-toast] button');
    expect(await page.isVisible('[data-toast]')).toBe(false);
    await page.click('[data-share]');
    await page.waitForSelector('[data-toast] input:not([hidden])');
    await explorer.drop('broken.off', 'OFF\n3 1 3\n');
    await page.waitForSelector('.notice:not([hidden])');
    expect(await page.isVisible('[data-toast]')).toBe(false);
    await page.click('.notice:not([hidden]) button');
    expect(await page.isVisible('.notice')).toBe(false);
    await explorer.close();
  },
);

test('A repair that finds nothing to do leaves the list under the pointer', async () => {
  const link = 'sample=cube&select=v0&tab=edit';
  const explorer = await ExplorerPage.open({ width: 1280, height: 800, link, mesh: 'Cube' });
  const { page } = explorer;
  await explorer.press('Shift+R');
  await page.waitForSelector('.refusal:not([hidden])');
  const button = page.locator('[data-operation=deleteIsolatedVertices]');
  await button.scrollIntoViewIfNeeded();
  const before = await button.boundingBox();
  await button.click();
  await page.waitForSelector('.report:has-text("Nothing to do")');
  await explorer.rest();
  expect(await button.boundingBox()).toEqual(before);
  expect(await wordsOutside(page, '.report')).toEqual([]);
  const isInSight = await page.$eval('.report', (report) => {
    const { left, top } = report.getBoundingClientRect();
    return document.elementFromPoint(left + 20, top + 12) === report;
  });
  expect(isInSight).toBe(true);
  // The refusal of what was asked for before isn't its answer.
  expect(await page.isVisible('.refusal')).toBe(false);
  expect(explorer.complaints).toEqual([]);
  await explorer.close();
});

test.each([
  [390, 844],
  [844, 390],
  [1280, 800],
])('What a saved file lacks comes into sight, in a window of %i by %i', async (width, height) => {
  const explorer = await ExplorerPage.open({ width, height });
  const { page } = explorer;
  const named = 'g wheel\nusemtl steel\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n';
  await explorer.drop('wheel.obj', named);
  await explorer.ready('wheel.obj');
  await explorer.press('3');
  await page.click('.mesh-facts [data-download=stl]');
  await page.waitForSelector('.outcome:has-text("Left out the face attribute")');
  const areInSight = await page.$eval('.mesh-facts .outcome', (outcome) => {
    const range = document.createRange();
    range.selectNodeContents(outcome);
    return [...range.getClientRects()].map(
      ({ left, top, bottom }) =>
        document.elementFromPoint(left + 1, top + 1) === outcome &&
        document.elementFromPoint(left + 1, bottom - 1) === outcome,
    );
  });
  expect(areInSight.length).toBeGreaterThan(1);
  expect(areInSight).not.toContain(false);
  expect(explorer.complaints).toEqual([]);
  await explorer.close();
});
