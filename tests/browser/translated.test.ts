import type { Page } from 'playwright-core';
import { disconnect, ExplorerPage } from './support/explorer.js';

afterAll(disconnect);

/** What a browser does that translates a page: other texts, up to twice as long, in elements of its own. */
function translate(page: Page): Promise<void> {
  return page.evaluate(() => {
    const walk = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    const texts: Text[] = [];
    while (walk.nextNode()) texts.push(walk.currentNode as Text);
    for (const text of texts) {
      const parent = text.parentElement;
      if (!parent?.translate || parent.closest('option, script, style')) continue;
      const words = document.createElement('font');
      words.textContent = text.data.replace(/\p{L}{4,}/gu, (word) => word + word.slice(0, 8));
      text.replaceWith(words);
    }
  });
}

/** Where the elements are that can be seen, from left to right. */
function spans(page: Page, selector: string): Promise<{ x: number; y: number; right: number }[]> {
  return page.$$eval(selector, (all) =>
    all
      .filter((each) => each.checkVisibility())
      .map((each) => {
        const range = document.createRange();
        range.selectNodeContents(each); // the words, that may be wider than what they are in
        const { x, y, right } = range.getBoundingClientRect();
        return { x, y, right };
      }),
  );
}

const WALK = 'sample=icosahedron&select=v0&query=vertexFaces&at=2&labels=all:vehf';
const CODE = '.listing li, .code, .hop, .visited button, .links .api, .links .target, .labels .tag';

test('A translation leaves code and the names of items as they are', async () => {
  const explorer = await ExplorerPage.open({ link: WALK, mesh: 'Icosahedron' });
  const { page } = explorer;
  const code = () => page.$$eval(CODE, (all) => all.map(({ textContent }) => textContent));
  const before = await code();
  expect(before).toContain('function* vertexFaces(mesh, v) {');
  await translate(page);
  expect(await code()).toEqual(before);
  expect(await page.textContent('[data-tab-button=circulate]')).toBe('CirculateCirculat');
  await explorer.closeTab();
});

test('Code and coordinates run from left to right on a page that runs from right to left', async () => {
  const explorer = await ExplorerPage.open({ link: WALK, mesh: 'Icosahedron' });
  const { page } = explorer;
  await page.evaluate(() => {
    document.documentElement.dir = 'rtl';
  });
  // The indent of its lines, and the bracket that ends one, tell the direction.
  const [head, first] = await page.$$eval('.listing code', (all) =>
    all.slice(0, 2).map((code) => {
      const text = document.createTreeWalker(code, NodeFilter.SHOW_TEXT);
      const range = document.createRange();
      let last = text.nextNode();
      for (let node = last; node; node = text.nextNode()) if (node.nodeValue) last = node;
      const end = (last as Text).length;
      range.setStart(last as Text, end - 1);
      range.setEnd(last as Text, end);
      const whole = code.getBoundingClientRect();
      return { left: whole.left, right: whole.right, end: range.getBoundingClientRect().right };
    }),
  );
  expect(head.end).toBeCloseTo(head.right, 0);
  expect(first.end).toBeCloseTo(first.right, 0);
  const directions = await page.$$eval(`${CODE}, .attributes dd, .records-grid`, (all) =>
    all.map((each) => getComputedStyle(each).direction),
  );
  expect(new Set(directions)).toEqual(new Set(['ltr']));
  await explorer.closeTab();
});

describe.each([
  [1280, 800],
  [390, 844],
])('Where words are longer, in a window of %i × %i,', (width, height) => {
  const translated = async () => {
    const explorer = await ExplorerPage.open({ width, height, link: WALK, mesh: 'Icosahedron' });
    await translate(explorer.page);
    return explorer;
  };

  test('no tab covers another one or leaves the window', async () => {
    const explorer = await translated();
    const tabs = await spans(explorer.page, '.tabs button');
    expect(tabs.length).toBeGreaterThan(3);
    for (const [i, { x, y, right }] of tabs.entries()) {
      const next = tabs[i + 1];
      if (next && Math.abs(next.y - y) < 2) expect(right).toBeLessThan(next.x);
      expect(x).toBeGreaterThanOrEqual(0);
      expect(right).toBeLessThanOrEqual(width);
    }
    await explorer.closeTab();
  });

  test('what chooses the kind to pick stays in the window', async () => {
    const explorer = await translated();
    const choices = await spans(explorer.page, '.pick-bar label, .pick-bar button');
    expect(choices.length).toBeGreaterThan(3);
    for (const { right } of choices) expect(right).toBeLessThanOrEqual(width);
    await explorer.closeTab();
  });
});
