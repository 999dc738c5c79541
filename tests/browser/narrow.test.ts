import { init } from 'halfedge';
import type { Page } from 'playwright-core';
import { openGrid } from '../../web/explorer/samples/generators.js';
import { disconnect, ExplorerPage } from './support/explorer.js';

beforeAll(() => init());
afterAll(disconnect);

interface Box {
  readonly x: number;
  readonly y: number;
  readonly right: number;
  readonly bottom: number;
}

/** Where the elements are that can be seen. */
function boxes(page: Page, selector: string): Promise<Box[]> {
  return page.$$eval(selector, (all) =>
    all
      .filter((each) => each.checkVisibility())
      .map((each) => {
        const { x, y, right, bottom } = each.getBoundingClientRect();
        return { x, y, right, bottom };
      }),
  );
}

/** Less than a pixel is no overlap. */
function overlap(a: Box, b: Box): boolean {
  return a.x < b.right - 1 && b.x < a.right - 1 && a.y < b.bottom - 1 && b.y < a.bottom - 1;
}

test('The name of the mesh can be read on a page that is zoomed in to 400 %', async () => {
  const explorer = await ExplorerPage.open({ width: 320, height: 200 });
  const name = explorer.page.locator('.mesh-button span');
  expect(await name.textContent()).toBe('Bunny');
  const [shown, whole] = await name.evaluate((span) => [span.clientWidth, span.scrollWidth]);
  expect(shown).toBeGreaterThanOrEqual(whole);
  const [menu, open] = await boxes(explorer.page, '.mesh-button, [data-open]');
  expect(overlap(menu, open)).toBe(false);
  expect(explorer.complaints).toEqual([]);
  await explorer.close();
});

test('The grip pulls the sheet of a telephone by clicks and by keys', async () => {
  const explorer = await ExplorerPage.open({ width: 390, height: 844, phone: true });
  const { page } = explorer;
  const grip = page.locator('.grip');
  const sheet = () => page.getAttribute('.panel', 'data-sheet');
  expect((await grip.boundingBox())?.height).toBeGreaterThanOrEqual(24);
  await grip.click();
  expect(await sheet()).toBe('tall');
  expect(await grip.getAttribute('aria-expanded')).toBe('true');
  await explorer.press('Enter');
  expect(await sheet()).toBe('half');
  await explorer.press('ArrowDown', 'Space');
  expect(await sheet()).toBe('half');
  const { x, y } = (await grip.boundingBox()) ?? { x: 0, y: 0 };
  await page.mouse.move(x + 100, y + 10);
  await page.mouse.down();
  await page.mouse.move(x + 100, y - 90);
  await page.mouse.up();
  expect(await sheet()).toBe('tall');
  expect(explorer.complaints).toEqual([]);
  await explorer.close();
});

test.each([
  ['asks', 'h0', 'Shift+E', '.pending'],
  ['refuses', 'e0', 'Shift+F', '.refusal'],
])('What an operation %s leaves the sheet of a telephone free', async (_name, item, key, card) => {
  const phone = { width: 390, height: 844, phone: true };
  const link = `sample=grid&select=${item}`;
  const explorer = await ExplorerPage.open({ ...phone, link, mesh: 'Open grid' });
  await explorer.press(key);
  await explorer.page.waitForSelector(card);
  for (const sheet of ['half', 'tall']) {
    const [panel, notice] = await boxes(explorer.page, `${card}, .panel[data-sheet=${sheet}]`);
    expect(notice.bottom).toBeLessThanOrEqual(panel.y);
    await explorer.page.click('.grip');
  }
  await explorer.close();
});

test.each([
  [390, 844],
  [640, 400],
  [844, 390],
  [568, 320],
])(
  'What a card tells of is lit beside it, in a window %i wide and %i high',
  async (width, height) => {
    const link = 'sample=grid&select=e0';
    const explorer = await ExplorerPage.open({ width, height, link, mesh: 'Open grid' });
    const { page } = explorer;
    /** Whether all of the labels are in the part of the picture that is left free. */
    const areFree = async (labels: string, card: string) => {
      const [notice, ...bars] = await boxes(page, `${card}, .panel, .top-bar, .pick-bar`);
      const lit = await boxes(page, `${labels}:not(.away):not([hidden])`);
      return (
        lit.length > 0 &&
        lit.every((label) => ![notice, ...bars].some((other) => overlap(label, other)))
      );
    };
    await explorer.press('Shift+F');
    expect(await explorer.comesTrue(() => areFree('.tag.witness', '.refusal'))).toBe(true);
    const [refusal] = await boxes(page, '.refusal');
    expect(refusal.bottom - refusal.y).toBeLessThan(135);
    await page.click('[data-tab-button=inspect]');
    await explorer.goTo('h0');
    await explorer.press('0', 'Shift+E');
    expect(await explorer.comesTrue(() => areFree('.tag.first', '.pending'))).toBe(true);
    const [pending] = await boxes(page, '.pending');
    expect(pending.bottom - pending.y).toBeLessThan(105);
    await explorer.press('n');
    expect(await page.isEnabled('.pending .witness button')).toBe(true);
    expect(explorer.complaints).toEqual([]);
    await explorer.close();
  },
);

test.each([
  [390, 844],
  [568, 320], // the card lies in the middle
])(
  'What lies under a card when it comes up is moved beside it, in %i by %i',
  async (width, height) => {
    const explorer = await ExplorerPage.open({
      width,
      height,
      link: 'sample=grid',
      mesh: 'Open grid',
    });
    const { page } = explorer;
    const mesh = openGrid(6);
    const middle = async (e: number) => {
      const onScreen = await explorer.projection();
      const [a, b] = [...mesh.edgeVertices(e)].map((v) => onScreen(mesh.positions.subarray(3 * v)));
      return { x: (a[0] + b[0]) / 2, y: (a[1] + b[1]) / 2 };
    };
    const liesIn = async (e: number, { x, y, right, bottom }: Box) => {
      const at = await middle(e);
      return at.x > x && at.x < right && at.y > y && at.y < bottom;
    };
    await page.click('[data-tab-button=inspect]');
    await explorer.goTo('e0');
    await explorer.press('Shift+F');
    await explorer.rest();
    const [card] = await boxes(page, '.refusal');
    await page.reload();
    await explorer.ready('Open grid');
    await page.click('[data-tab-button=inspect]');
    const covered: number[] = [];
    for (const e of mesh.edges()) {
      if (mesh.isBoundaryEdge(e) && (await liesIn(e, card))) covered.push(e);
    }
    expect(covered.length).toBeGreaterThan(0);
    await explorer.goTo(`e${covered[0]}`);
    await explorer.press('Shift+F');
    const isFree = async () => {
      const others = await boxes(page, '.refusal, .panel, .top-bar, .pick-bar');
      return !(await Promise.all(others.map((box) => liesIn(covered[0], box)))).includes(true);
    };
    expect(await explorer.comesTrue(isFree)).toBe(true);
    expect(explorer.complaints).toEqual([]);
    await explorer.close();
  },
);

test.each([320, 390, 761, 820, 900, 901, 1001])(
  'No control of the bars lies on another or under the panel in a window %i wide',
  async (width) => {
    const link = 'sample=three-faces';
    const mesh = 'Three faces at an edge';
    const explorer = await ExplorerPage.open({ width, height: 800, link, mesh });
    const controls = '.top-bar button, .pick-bar label, .pick-bar button, .panel';
    const found = await boxes(explorer.page, controls);
    expect(found.filter(({ x, right }) => x < 0 || right > width)).toEqual([]);
    for (const [i, one] of found.entries()) {
      expect(found.slice(0, i).filter((other) => overlap(one, other))).toEqual([]);
    }
    await explorer.close();
  },
);

const TABS = ['inspect', 'circulate', 'edit', 'mesh', 'records', 'problems'];

test.each([
  [640, 400],
  [844, 390],
  [568, 320],
  [1280, 400],
])('A window %i wide and %i high has panel and picture side by side', async (width, height) => {
  const link = 'sample=three-faces&select=v7';
  const mesh = 'Three faces at an edge';
  const explorer = await ExplorerPage.open({ width, height, link, mesh });
  const { page } = explorer;
  const controls = '.top-bar button, .pick-bar label, .pick-bar button, .picture-switch, .panel';
  const found = await boxes(page, controls);
  const out = found.filter(({ x, y, right, bottom }) => {
    return x < 0 || y < 0 || right > width || bottom > height;
  });
  expect(out).toEqual([]);
  for (const [i, one] of found.entries()) {
    expect(found.slice(0, i).filter((other) => overlap(one, other))).toEqual([]);
  }
  const [panel, topBar, pickBar] = await Promise.all(
    ['.panel', '.top-bar', '.pick-bar'].map(async (name) => (await boxes(page, name))[0]),
  );
  expect(panel.x).toBeGreaterThanOrEqual(width / 2);
  expect(pickBar.y - topBar.bottom).toBeGreaterThan(0.6 * height);
  for (const tab of TABS) {
    await page.click(`[data-tab-button=${tab}]`);
    const [shown, ...others] = await boxes(page, '.panel .inspector, .panel .sections');
    expect(others).toEqual([]);
    expect(shown.bottom - shown.y).toBeGreaterThan(0.45 * height);
    // What lies farther down can be scrolled to; nothing is cut off at the side.
    const cut = await page.$$eval('.inspector, .sections, .tabs, .history, .pick-bar', (all) =>
      all.filter((each) => each.checkVisibility() && each.scrollWidth > each.clientWidth + 1),
    );
    expect(cut.length).toBe(0);
  }
  await page.click('[data-tab-button=circulate]');
  const [play] = await boxes(page, '.transport .play');
  expect(play.bottom).toBeLessThanOrEqual(panel.bottom);
  await page.click('[data-tab-button=inspect]');
  await page.click('[data-link=vertexHalfedge]');
  expect(await explorer.state('selected')).toMatch(/^h/);
  await explorer.screenshot(`low-${width}`);
  expect(explorer.complaints).toEqual([]);
  await explorer.close();
});

test.each([
  [320, 800],
  [390, 844],
  [560, 400],
  [640, 400],
])(
  'In a window of %i by %i, all tabs are in one line, and the keys are told',
  async (width, height) => {
    const link = 'sample=three-faces';
    const explorer = await ExplorerPage.open({
      width,
      height,
      link,
      mesh: 'Three faces at an edge',
    });
    const { page } = explorer;
    const tabs = await boxes(page, '.tabs button');
    expect(tabs).toHaveLength(6);
    expect(new Set(tabs.map(({ y }) => y)).size).toBe(1);
    const cut = (all: Element[]) => all.filter((it) => it.scrollWidth > it.clientWidth).length;
    expect(await page.$$eval('.tabs button', cut)).toBe(0);
    const bar = await boxes(page, '.top-bar button:not([popover] *)');
    for (const [i, box] of bar.entries()) {
      expect(box.right).toBeLessThanOrEqual(width);
      expect(bar.slice(0, i).filter((other) => overlap(box, other))).toEqual([]);
    }
    expect(await page.isVisible('.top-bar [aria-label=Keys]')).toBe(true);
    expect(explorer.complaints).toEqual([]);
    await explorer.close();
  },
);

test('The tabs stay where they are, whether a vertex, an edge, a face or nothing is selected', async () => {
  const explorer = await ExplorerPage.open();
  const places: (number | undefined)[] = [];
  for (const item of ['v5', 'e5', 'f5']) {
    await explorer.goTo(item);
    places.push((await explorer.page.locator('.tabs').boundingBox())?.y);
  }
  await explorer.press('Escape');
  places.push((await explorer.page.locator('.tabs').boundingBox())?.y);
  expect(new Set(places).size).toBe(1);
  await explorer.close();
});

test('The tab that is marked is the section on show, also when the window becomes wider', async () => {
  const explorer = await ExplorerPage.open({ width: 390, height: 844 });
  const { page } = explorer;
  const marked = () =>
    page.$$eval('.tabs [aria-current=true]', (all) => all.map((each) => each.textContent));
  await page.click('[data-tab-button=inspect]');
  expect(await marked()).toEqual(['Inspect']);
  await page.setViewportSize({ width: 1280, height: 800 });
  await explorer.rest();
  expect(await marked()).toEqual(['Circulate']);
  expect(await page.isVisible('.transport .play')).toBe(true);
  await page.setViewportSize({ width: 390, height: 844 });
  await explorer.rest();
  expect(await marked()).toEqual(['Inspect']);
  await explorer.close();
});

test('A window of another size shows all of the mesh, or as much as before if somebody has moved', async () => {
  const numbersOf = async (page: ExplorerPage) =>
    (await page.state('camera'))?.split(' ').map(Number);
  const sizes = [
    { width: 844, height: 390 },
    { width: 390, height: 844 },
  ];
  for (const [from, to] of [sizes, [...sizes].reverse()]) {
    const turned = await ExplorerPage.open({ ...from, link: 'sample=cube', mesh: 'Cube' });
    const fresh = await ExplorerPage.open({ ...to, link: 'sample=cube', mesh: 'Cube' });
    await turned.page.setViewportSize(to);
    await turned.rest();
    await fresh.rest();
    const expected = (await numbersOf(fresh)) ?? [];
    expect(expected).toHaveLength(16);
    for (const [i, number] of ((await numbersOf(turned)) ?? []).entries()) {
      expect(number).toBeCloseTo(expected[i], 3);
    }
    // Once somebody has come nearer, they stay near: there and back again is where they were.
    await turned.press('+');
    await turned.press('+');
    await turned.rest();
    const near = (await numbersOf(turned)) ?? [];
    await turned.page.setViewportSize(from);
    await turned.rest();
    await turned.page.setViewportSize(to);
    await turned.rest();
    for (const [i, number] of ((await numbersOf(turned)) ?? []).entries()) {
      expect(number).toBeCloseTo(near[i], 3);
    }
    expect(near[15]).not.toBeCloseTo(expected[15], 2); // how far the middle of the mesh is
    await turned.close();
    await fresh.close();
  }
});
