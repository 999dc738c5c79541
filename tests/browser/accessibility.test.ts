import type { Page } from 'playwright-core';
import { seriousFindings } from './support/axe.js';
import { disconnect, ExplorerPage } from './support/explorer.js';

afterAll(disconnect);

/** Goes to another state by its link, and waits for the mesh and for what is selected there. */
async function follow(page: Page, link: string, mesh: string): Promise<void> {
  await page.evaluate((hash) => {
    location.hash = hash;
  }, link);
  const selected = new URLSearchParams(link).get('select');
  const item = { null: '', nothing: ':not([data-selected])' }[String(selected)];
  const state = item ?? `[data-selected="${selected}"]`;
  await page.waitForSelector(`main.stage[data-mesh="${mesh}"]${state}`);
}

test.each([
  ['a desktop, light', {}],
  ['a desktop, dark', { dark: true }],
  ['a telephone, light', { width: 390, height: 844, phone: true }],
  ['a telephone, dark', { width: 390, height: 844, phone: true, dark: true }],
])(
  'axe-core finds nothing serious on any panel, in any state: %s',
  async (_name, settings) => {
    const explorer = await ExplorerPage.open(settings);
    const { page } = explorer;
    const found: Record<string, string[]> = {};
    const look = async (place: string) => {
      await explorer.rest();
      const serious = await seriousFindings(page);
      if (serious.length > 0) found[place] = serious;
    };
    for (const tab of ['inspect', 'circulate', 'edit', 'mesh', 'records']) {
      if (tab === 'inspect' && !('phone' in settings)) continue;
      await page.click(`[data-tab-button=${tab}]`);
      await explorer.press('.', '.');
      await look(tab);
    }
    await page.click('.mesh-button');
    await look('menu');
    await explorer.press('Escape');
    await page.click('.captions > button');
    await page.check('[name=label-scope][value=all]');
    await page.check('[name=pointers]');
    await look('names and links');
    await explorer.press('Escape', '?');
    await look('keys');
    await explorer.press('Escape');
    await follow(page, 'sample=grid&select=e0', 'Open grid');
    await explorer.press('Shift+F');
    await page.waitForSelector('.refusal:not([hidden])');
    await look('refusal');
    await follow(page, 'sample=grid&select=h2', 'Open grid');
    await explorer.press('Shift+E');
    await page.waitForSelector('.pending:not([hidden])');
    await look('an operation that waits');
    await follow(page, 'sample=grid&select=nothing', 'Open grid');
    await page.click('[data-tab-button=circulate]');
    await look('nothing selected');
    await follow(page, 'sample=pinched&select=f0', 'Pinched vertex');
    await page.click('[data-tab-button=mesh]');
    await page.waitForSelector('.problems button');
    await look('warnings and loops');
    await page.click('[data-share]');
    await page.waitForSelector('[data-toast]:not([hidden])');
    await look('a link that was copied');
    await follow(page, 'sample=klein', 'Klein bottle');
    await page.waitForSelector('[data-finding]');
    await page.click('.entries button');
    await look('problems');
    await page.check('[name=picture][value=original]');
    await look('the original');
    await page.evaluate(() => {
      location.hash = 'sample=none';
    });
    await page.waitForSelector('.notice:not([hidden])');
    await look('failure');
    expect(found).toEqual({});
    expect(explorer.complaints).toEqual([]);
    await explorer.close();
  },
  360_000,
);

/** How often the colour changes from row to row at the left of a picture. */
function dashesAtLeft(page: Page, picture: Buffer): Promise<number> {
  return page.evaluate(
    async (data) => {
      const bitmap = await createImageBitmap(await (await fetch(data)).blob());
      const context = new OffscreenCanvas(1, bitmap.height).getContext('2d');
      context?.drawImage(bitmap, 0, 0);
      const { buffer } = context?.getImageData(0, 0, 1, bitmap.height).data ?? new Uint8Array();
      const column = new Uint32Array(buffer);
      return column.filter((pixel, y) => y > 0 && pixel !== column[y - 1]).length;
    },
    `data:image/png;base64,${picture.toString('base64')}`,
  );
}

test('Lesser words are as strong as others where the system asks for more contrast', async () => {
  const { page } = await ExplorerPage.open({ link: 'sample=cube&select=v3', mesh: 'Cube' });
  const muted = () =>
    page.evaluate(() => {
      const probe = document.body.appendChild(document.createElement('i'));
      const colorOf = (name: string) => {
        probe.style.color = `var(--${name})`;
        return getComputedStyle(probe).color;
      };
      return colorOf('muted') === colorOf('text') && colorOf('line-strong') === colorOf('text');
    });
  expect(await muted()).toBe(false);
  await page.emulateMedia({ contrast: 'more' });
  expect(await muted()).toBe(true);
});

test('What is chosen can be seen in the colours of the system, where those are forced', async () => {
  const explorer = await ExplorerPage.open({ link: 'sample=cube&select=v3', mesh: 'Cube' });
  const { page } = explorer;
  await page.emulateMedia({ forcedColors: 'active' });
  const isLit = (selector: string) =>
    page.$eval(selector, (chosen) => {
      const lit = document.body.appendChild(document.createElement('i'));
      lit.style.backgroundColor = 'Highlight';
      const [one, other] = [chosen, lit].map((each) => getComputedStyle(each).backgroundColor);
      lit.remove();
      return one === other;
    });
  await explorer.press('.', '.');
  const unlit: string[] = [];
  for (const selector of [
    '.tabs [aria-current=true]',
    '.pick-bar label:has(:checked)',
    '.chips label:has(:checked)',
    '.listing [aria-current]',
    '.visited [aria-current]',
  ]) {
    if (!(await isLit(selector))) unlit.push(selector);
  }
  expect(unlit).toEqual([]);
  await page.click('.mesh-button');
  expect(await isLit('.mesh-menu [aria-current=true]')).toBe(true);
  await explorer.press('Escape');
  await page.click('[data-tab-button=records]');
  await explorer.press('h');
  await page.waitForSelector('.record.selected');
  expect(await isLit('.record.selected')).toBe(true);
  await page.hover('.record[data-row="9"] [role=rowheader]');
  const rim = await page.locator('.record.hovered').screenshot();
  expect(await dashesAtLeft(page, rim)).toBeGreaterThan(5);
  await explorer.close();
});
