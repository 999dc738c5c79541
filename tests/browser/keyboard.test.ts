import type { Page } from 'playwright-core';
import { disconnect, ExplorerPage } from './support/explorer.js';

afterAll(disconnect);

/**
 * Presses Tab until the focus has come around; returns the controls in sight that it did not come to, and
 * those where nothing shows that it is there.
 */
async function tabThrough(page: Page): Promise<{ missed: string[]; unseen: string[] }> {
  const expected = await page.evaluate(() => {
    const all = document.querySelectorAll<HTMLElement>(
      'button, select, [tabindex="0"], input:not([type=radio]), input[type=radio]:checked',
    );
    const reachable = [...all].filter(
      (each) => each.checkVisibility() && !each.matches(':disabled, [inert] *'),
    );
    reachable.forEach((each, i) => {
      each.dataset.stop = String(i);
    });
    (document.activeElement as HTMLElement | null)?.blur();
    return reachable.length;
  });
  const reached = new Set<string>();
  const unseen: string[] = [];
  for (let presses = 0; presses < expected + 5; presses++) {
    await page.keyboard.press('Tab');
    const at = await page.evaluate(() => {
      const focused = document.activeElement as HTMLElement;
      const rings = [focused, focused.closest('label')].map((each) => {
        if (!each) return false;
        const { outlineStyle, outlineWidth, boxShadow } = getComputedStyle(each);
        return (outlineStyle !== 'none' && outlineWidth !== '0px') || boxShadow !== 'none';
      });
      const name = focused.getAttribute('aria-label') ?? focused.textContent?.trim();
      return { stop: focused.dataset.stop, name, isSeen: rings.some(Boolean) };
    });
    if (at.stop === undefined || reached.has(at.stop)) continue;
    reached.add(at.stop);
    if (!at.isSeen) unseen.push(at.name ?? '');
  }
  const missed = await page.$$eval(
    '[data-stop]',
    (all, stops) =>
      all
        .filter((each) => !stops.includes((each as HTMLElement).dataset.stop ?? ''))
        .map((each) => each.getAttribute('aria-label') ?? each.textContent ?? ''),
    [...reached],
  );
  return { missed, unseen };
}

test.each([
  ['circulate', 'sample=suzanne&select=h500', 'Suzanne'],
  ['edit', 'sample=cube&select=e3', 'Cube'],
  ['mesh', 'sample=annulus&select=v0', 'Annulus'],
  ['records', 'sample=cube&select=v3', 'Cube'],
  ['problems', 'sample=three-faces', 'Three faces at an edge'],
])(
  'Tab comes to every control beside the panel “%s”, and shows where it is',
  async (tab, link, mesh) => {
    const explorer = await ExplorerPage.open({ link, mesh });
    await explorer.page.click(`[data-tab-button=${tab}]`);
    await explorer.rest();
    expect(await tabThrough(explorer.page)).toEqual({ missed: [], unseen: [] });
    expect(explorer.complaints).toEqual([]);
    await explorer.close();
  },
);

test('Menus open, close and choose by keys alone, and give the focus back', async () => {
  const explorer = await ExplorerPage.open({ link: 'sample=cube&select=v3', mesh: 'Cube' });
  const { page } = explorer;
  await page.focus('.mesh-button');
  await explorer.press('Enter', 'Tab', 'Tab', 'Tab', 'Enter');
  await explorer.ready('Icosahedron');
  expect(await page.evaluate(() => document.activeElement?.className)).toContain('mesh-button');
  await page.focus('.captions > button');
  await explorer.press('Enter', 'Tab', 'ArrowRight');
  expect(await page.isChecked('[name=label-scope][value=selection]')).toBe(true);
  await explorer.press('Tab', 'Space');
  expect(await page.isChecked('[name=label-kind][value=vertex]')).toBe(false);
  await explorer.press('Escape');
  expect(await page.isVisible('.captions-menu')).toBe(false);
  expect(await page.evaluate(() => document.activeElement?.parentElement?.className)).toBe(
    'captions',
  );
  await explorer.press('?');
  await page.waitForSelector('dialog.help[open]');
  await explorer.press('Escape');
  expect(await page.isVisible('dialog.help')).toBe(false);
  expect(explorer.complaints).toEqual([]);
  await explorer.close();
});

test('A key that is held edits once and plays once; steps, walks and undo go on', async () => {
  const explorer = await ExplorerPage.open({ link: 'sample=cube&select=f0', mesh: 'Cube' });
  const { keyboard } = explorer.page;
  const hold = async (key: string) => {
    for (let i = 0; i < 4; i++) await keyboard.down(key); // all but the first are repeats
    await keyboard.up(key);
  };
  await keyboard.down('Shift');
  await hold('I');
  await keyboard.up('Shift');
  expect(await explorer.state('undo')).toBe('1');
  await explorer.press('Shift+S', 'Shift+S');
  await keyboard.down('Control');
  await hold('z');
  await keyboard.up('Control');
  expect(await explorer.state('undo')).toBe('0');
  await explorer.goTo('h0');
  await explorer.press('n', 'n', 'n');
  const before = await explorer.state('selected');
  await explorer.press('n');
  await hold('n');
  expect(await explorer.state('selected')).toBe('h0'); // around a square, twice
  expect(before).not.toBe('h0');
  await explorer.press('n');
  await hold('N'); // with capitals locked
  await explorer.press('n', 'n', 'n');
  expect(await explorer.state('selected')).toBe('h0');
  await hold('.');
  expect(Number(await explorer.state('position'))).toBeGreaterThan(2);
  await explorer.press('Home');
  await explorer.page.selectOption('.speed', { label: '0.5 a second' }); // not at its end when we look
  await hold(' ');
  expect(await explorer.state('player')).toBe('playing');
  await explorer.goTo('v0');
  await hold('Delete');
  expect(await explorer.state('undo')).toBe('1');
  expect(explorer.complaints).toEqual([]);
  await explorer.close();
});

test('The field for an item hands the keys back: after Enter they walk, and Escape leaves the selection alone', async () => {
  const explorer = await ExplorerPage.open({ link: 'sample=cube&select=v0', mesh: 'Cube' });
  const { page } = explorer;
  const field = () => page.inputValue('.goto input');
  await explorer.press('g', 'h', '0', 'Enter', 'n', 'n');
  expect(await field()).toBe('');
  expect(await explorer.state('selected')).not.toBe('h0');
  await explorer.press('n', 'n');
  expect(await explorer.state('selected')).toBe('h0');
  // Tab goes on where the field is.
  await explorer.press('g', 'f', '2', 'Enter', 'Tab');
  expect(await page.evaluate(() => document.activeElement?.closest('.inspector') !== null)).toBe(
    true,
  );
  await explorer.press('g', 'v', 'Escape');
  expect(await field()).toBe('');
  expect(await explorer.state('selected')).toBe('f2');
  // What is refused stays there, to be changed.
  await explorer.press('g', 'f', '9', 'Enter', 'Backspace', '3', 'Enter', 'h');
  expect(await explorer.state('selected')).toMatch(/^h/);
  expect(explorer.complaints).toEqual([]);
  await explorer.close();
});

/** What has the focus. */
const focused = (page: Page) =>
  page.evaluate(() => {
    const { id, tagName, className } = document.activeElement as HTMLElement;
    return id || className || tagName;
  });

describe('The focus stays in the panel', () => {
  test('when the link that has it leads nowhere', async () => {
    const explorer = await ExplorerPage.open({ link: 'sample=annulus', mesh: 'Annulus' });
    const { page } = explorer;
    // From a halfedge with a face, of which the focus is on the link, to its opposite at the boundary.
    for (let h = 0; ; h++) {
      await page.fill('.goto input', `h${h}`);
      await page.press('.goto input', 'Enter');
      if (await page.isVisible('.facts .on-boundary')) break;
    }
    if (await page.isDisabled('[data-link=face]')) await page.click('[data-link=opposite]');
    await page.focus('[data-link=face]');
    await explorer.press('o');
    expect(await page.isDisabled('[data-link=face]')).toBe(true);
    expect(await focused(page)).toBe('inspector-title');
    expect(explorer.complaints).toEqual([]);
    await explorer.close();
  });

  test('when all links go', async () => {
    const link = 'sample=annulus&select=h0';
    const explorer = await ExplorerPage.open({ link, mesh: 'Annulus' });
    await explorer.page.focus('[data-link=opposite]');
    await explorer.press('Escape');
    expect(await explorer.state('selected')).toBe(null);
    expect(await focused(explorer.page)).toBe('inspector-title');
    expect(explorer.complaints).toEqual([]);
    await explorer.close();
  });

  test('when the last visit is taken back', async () => {
    const link = 'sample=annulus&select=v0';
    const explorer = await ExplorerPage.open({ link, mesh: 'Annulus' });
    const { page } = explorer;
    await page.click('[aria-label="Step forward"]');
    await page.focus('.visited button');
    await explorer.press(',');
    expect(await page.locator('.visited button').count()).toBe(0);
    expect(await focused(page)).toBe('visited');
    expect(explorer.complaints).toEqual([]);
    await explorer.close();
  });
});
