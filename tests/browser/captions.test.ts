import { init } from 'halfedge';
import { openGrid } from '../../web/explorer/samples/generators.js';
import { disconnect, ExplorerPage } from './support/explorer.js';

afterAll(disconnect);
beforeAll(() => init());

/** The names of items that are in sight. */
const names = ({ page }: ExplorerPage) =>
  page.$$eval('.tag.index:not(.away):not([hidden])', (tags) =>
    tags.map((tag) => tag.textContent ?? ''),
  );
/** The numbers of the links in sight. */
const numbers = async ({ page }: ExplorerPage) => {
  const tags = await page.$$eval('.tag.link:not(.away):not([hidden])', (all) =>
    all.map((tag) => tag.textContent ?? ''),
  );
  return tags.sort();
};

test('Items have their names at the selection, wherever there is room, or nowhere', async () => {
  const link = 'sample=grid&select=f8';
  const explorer = await ExplorerPage.open({ link, mesh: 'Open grid' });
  const mesh = openGrid(6);
  expect(await names(explorer)).toEqual([]);
  await explorer.press('l');
  await explorer.rest();
  const around = [
    ...[...mesh.faceVertices(8)].map((v) => `v${v}`),
    ...[...mesh.faceHalfedges(8)].map((h) => `h${h}`),
  ];
  const shown = await names(explorer);
  expect(around).toEqual(expect.arrayContaining(shown));
  expect(shown.length).toBeGreaterThanOrEqual(6); // the number of the link may lie over one
  await explorer.page.click('.captions > button');
  await explorer.page.check('[name=label-scope][value=all]');
  await explorer.page.uncheck('[name=label-kind][value=vertex]');
  await explorer.page.uncheck('[name=label-kind][value=halfedge]');
  await explorer.press('Escape');
  await explorer.rest();
  const faces = await names(explorer);
  expect(faces.length).toBeGreaterThan(4);
  expect(faces.every((name) => name.startsWith('f'))).toBe(true);
  await explorer.press('l');
  await explorer.rest();
  expect(await names(explorer)).toEqual([]);
  expect(explorer.complaints).toEqual([]);
  await explorer.close();
});

test('A window without room for names says to zoom in', async () => {
  const link = 'sample=grid&select=nothing&labels=all:vf';
  const explorer = await ExplorerPage.open({ width: 390, height: 844, link, mesh: 'Open grid' });
  const hint = () => explorer.page.textContent('.names-hint');
  await explorer.rest();
  expect([await names(explorer), await hint()]).toEqual([[], 'Zoom in to read the names']);
  expect(await explorer.page.isVisible('.names-hint')).toBe(true);
  await explorer.page.focus('main.stage canvas');
  await explorer.press('+', '+', '+');
  await explorer.rest();
  expect((await names(explorer)).length).toBeGreaterThan(4);
  expect(await explorer.page.isVisible('.names-hint')).toBe(false);
  await explorer.press('0', 'l'); // far away again, but no names are asked for
  await explorer.rest();
  expect([await names(explorer), await hint()]).toEqual([[], '']);
  expect(explorer.complaints).toEqual([]);
  await explorer.close();
});

test('No more than 300 names are shown, and none of items that are out of sight', async () => {
  const link = 'sample=bunny&select=nothing&labels=all:vehf';
  const explorer = await ExplorerPage.open({ link });
  expect(await names(explorer)).toEqual([]); // edges of less than 56 pixels
  await explorer.goTo('v1224');
  await explorer.press('z', '+', '+', '+');
  await explorer.rest();
  const shown = await names(explorer);
  expect(shown.length).toBeGreaterThan(20);
  expect(shown.length).toBeLessThanOrEqual(300);
  expect(explorer.complaints).toEqual([]);
  await explorer.close();
});

test('The links of the selected item are arrows with their numbers, ∅ where they are empty', async () => {
  const link = 'sample=grid&select=h0&pointers=on';
  const explorer = await ExplorerPage.open({ link, mesh: 'Open grid' });
  const face = await explorer.page.getAttribute('[data-link=face]', 'data-target');
  expect(await numbers(explorer)).toEqual(['3', face === '∅' ? '4 ∅' : '4', '5', '6', '7']);
  await explorer.press('o');
  await explorer.rest();
  const other = await explorer.page.getAttribute('[data-link=face]', 'data-target');
  expect([face, other].filter((target) => target === '∅')).toHaveLength(1);
  expect(await numbers(explorer)).toEqual(['3', other === '∅' ? '4 ∅' : '4', '5', '6', '7']);
  await explorer.page.click('[data-share]');
  await explorer.page.waitForSelector('[data-toast]:has-text("Link copied")');
  expect(await explorer.page.evaluate(() => location.hash)).toContain('pointers=on');
  await explorer.press('v');
  await explorer.rest();
  expect(await numbers(explorer)).toEqual(['1']);
  await explorer.press('.');
  await explorer.rest();
  expect(await numbers(explorer)).toEqual([]); // the walk has the picture to itself
  expect(explorer.complaints).toEqual([]);
  await explorer.close();
});

test.each([false, true])(
  'Numbers of links are square, those of visits round (dark: %p)',
  async (dark) => {
    const link = 'sample=icosahedron&select=v3';
    const explorer = await ExplorerPage.open({ dark, link, mesh: 'Icosahedron' });
    /** The radius of the corners as a share of that of a circle. */
    const roundness = (selector: string) =>
      explorer.page.$$eval(selector, (all) =>
        all
          .filter((each) => each.checkVisibility({ visibilityProperty: true }))
          .map((each) => {
            const { borderTopLeftRadius } = getComputedStyle(each);
            const corner = Number.parseFloat(borderTopLeftRadius);
            const { width } = each.getBoundingClientRect();
            return borderTopLeftRadius.endsWith('%')
              ? corner / 50
              : Math.min(1, (2 * corner) / width);
          }),
      );
    const links = await roundness('.tag.link, .inspector .number');
    expect(links).toHaveLength(2);
    expect(Math.max(...links)).toBeLessThan(0.5);
    await explorer.press('.', '.', '.');
    await explorer.rest();
    expect(await roundness('.tag.link')).toEqual([]);
    const visits = await roundness('.tag.current, .tag.ordinal, .visited i');
    expect(visits.length).toBeGreaterThan(3);
    expect(Math.min(...visits)).toBe(1);
    expect(explorer.complaints).toEqual([]);
    await explorer.close();
  },
);

test('The attributes of an item are listed below its links', async () => {
  const explorer = await ExplorerPage.open();
  const off = 'COFF\n3 1 3\n0 0 0 255 0 0 255\n1 0 0.5 0 255 0 255\n0 1 0 0 0 255 255\n3 0 1 2\n';
  await explorer.drop('coloured.off', off);
  await explorer.ready('coloured.off');
  await explorer.goTo('v1');
  const listed = await explorer.page.$$eval('.attributes > div', (lines) =>
    lines.map((line) => [...line.children].map((part) => part.textContent)),
  );
  expect(listed[0]).toEqual(['position', '(1, 0, 0.5)']);
  expect(listed[1][0]).toBe('color');
  expect(listed[2]).toEqual(['angle defect', '138.2°']);
  await explorer.goTo('e0');
  expect(await explorer.page.textContent('.attributes')).toBe('length1.118');
  await explorer.goTo('h1'); // on the boundary, and has nothing
  expect(await explorer.page.isVisible('.attributes')).toBe(false);
  expect(explorer.complaints).toEqual([]);
  await explorer.close();
});

test('Each link has its number in the picture, also where another label is beside it', async () => {
  const explorer = await ExplorerPage.open({ link: 'sample=cube&select=h0', mesh: 'Cube' });
  for (let h = 0; h < 24; h++) {
    await explorer.goTo(`h${h}`);
    await explorer.rest();
    expect([h, await numbers(explorer)]).toEqual([h, ['3', '4', '5', '6', '7']]);
  }
  await explorer.close();
});
