import { HalfedgeMesh, init } from 'halfedge';
import { disconnect, ExplorerPage, sampleMesh } from './support/explorer.js';

let explorer: ExplorerPage;
let mesh: HalfedgeMesh;
beforeAll(async () => {
  await init();
  mesh = sampleMesh('bunny.off');
  explorer = await ExplorerPage.open();
  await explorer.page.click('[data-tab-button=records]');
});
afterEach(() => expect(explorer.complaints).toEqual([]));
afterAll(async () => {
  await explorer.close();
  await disconnect();
});

/** The texts of the row of a record; null if it isn't in sight. */
const row = (index: number) =>
  explorer.page.evaluate((i) => {
    const element = document.querySelector(`.record[data-row="${i}"]:not([hidden])`);
    return element && [...element.children].map((cell) => cell.textContent);
  }, index);
const kind = () => explorer.page.getAttribute('[role=grid]', 'data-records');
/** The cells that are lit as read: `h12 prev`. */
const read = () =>
  explorer.page.$$eval('.record:not([hidden]) .read', (cells) =>
    cells.map((cell) => {
      const record = cell.parentElement?.firstElementChild?.textContent;
      return `${record} ${(cell as HTMLElement).dataset.name}`;
    }),
  );

describe('The records', () => {
  test('are the arrays of the mesh, at the selection', async () => {
    await explorer.goTo('h700');
    expect(await kind()).toBe('halfedge');
    const { toVertex, next, face } = mesh.connectivity;
    for (const h of [698, 700, 702]) {
      expect(await row(h)).toEqual([
        `h${h}`,
        `v${toVertex[h]}`,
        `h${next[h]}`,
        `h${mesh.prev(h)}`,
        `f${face[h]}`,
        `h${mesh.opposite(h)}`,
      ]);
    }
    await explorer.goTo('f33');
    expect(await row(33)).toEqual(['f33', `h${mesh.faceHalfedge(33)}`]);
    await explorer.goTo('v9');
    const [, anchor, x] = (await row(9)) ?? [];
    expect(anchor).toBe(`h${mesh.vertexHalfedge(9)}`);
    expect(Number(x)).toBeCloseTo(mesh.position(9)[0], 4);
    expect(await row(2000)).toBeNull();
  });

  test('cut nothing short, and stand below their names', async () => {
    for (const item of ['v9', 'h16943', 'e12', 'f33']) {
      await explorer.goTo(item);
      const { cut, lefts } = await explorer.page.evaluate(() => {
        const rows = [...document.querySelectorAll('.record.head, .record.selected')];
        const cells = rows.map((row) => [...row.children] as HTMLElement[]);
        const isCut = ({ scrollWidth, clientWidth }: HTMLElement) => scrollWidth > clientWidth;
        return {
          cut: cells
            .flat()
            .filter(isCut)
            .map(({ textContent }) => textContent),
          lefts: cells.map((row) => row.map((cell) => cell.getBoundingClientRect().left)),
        };
      });
      expect(cut).toEqual([]);
      for (const row of lefts.slice(1)) expect(row).toEqual(lefts[0]);
    }
  });

  test('light what is pointed at, and are lit by it', async () => {
    await explorer.goTo('h700');
    await explorer.page.hover('.record[data-row="701"] [data-name=next]');
    await explorer.until('hovered', `h${mesh.next(701)}`);
    await explorer.page.hover('.record[data-row="701"] [data-name=to]');
    await explorer.until('hovered', `v${mesh.toVertex(701)}`);
    await explorer.page.hover('.record[data-row="701"] [role=rowheader]');
    await explorer.until('hovered', 'h701');
    const at = await explorer.projection();
    await explorer.goTo('v1224');
    await explorer.page.mouse.move(...at(mesh.position(1224)));
    await explorer.until('hovered', 'v1224');
    expect(await explorer.page.textContent('.record.hovered [role=rowheader]')).toBe('v1224');
  });

  test('are walked along by clicks', async () => {
    await explorer.goTo('h700');
    await explorer.page.click('.record[data-row="700"] [data-name=face]');
    expect(await explorer.state('selected')).toBe(`f${mesh.face(700)}`);
    expect(await kind()).toBe('face');
    expect(await explorer.page.textContent('.record.selected')).toBe(
      `f${mesh.face(700)}h${mesh.faceHalfedge(mesh.face(700))}`,
    );
  });

  test('light the cells that a step of the circulator has read', async () => {
    await explorer.goTo('v1224');
    await explorer.press('.');
    expect(await kind()).toBe('halfedge');
    await explorer.press('.');
    const [first, second] = mesh.vertexOutgoingHalfedges(1224);
    const cells = [`h${first} prev`, `h${mesh.prev(first)} opposite`, `h${second} to`];
    // A cell far from the others is out of sight.
    const sight = [];
    for (const cell of cells) if (await row(Number(/\d+/.exec(cell)?.[0]))) sight.push(cell);
    expect(sight).toContain(cells[2]);
    expect((await read()).sort()).toEqual(sight.sort());
    expect(await explorer.page.textContent('.record.at [role=rowheader]')).toBe(`h${second}`);
    await explorer.screenshot('records-1280-light');
  });

  test('tell screen readers what is selected, and where the walk is', async () => {
    const marked = (state: string) =>
      explorer.page.locator(`.record[${state}] [role=rowheader]`).allTextContents();
    await explorer.goTo('h700');
    expect(await marked('aria-selected=true')).toEqual(['h700']);
    expect(await marked('aria-current=step')).toEqual([]);
    await explorer.goTo('v1224');
    expect(await marked('aria-selected=true')).toEqual(['v1224']);
    await explorer.press('.');
    const [first] = mesh.vertexOutgoingHalfedges(1224);
    expect(await marked('aria-current=step')).toEqual([`h${first}`]);
  });

  test('can be read and walked by keys alone, as a grid', async () => {
    await explorer.goTo('h700');
    await explorer.page.focus('[role=grid]');
    const active = () =>
      explorer.page.evaluate(() => {
        const id = document.querySelector('[role=grid]')?.getAttribute('aria-activedescendant');
        const cell = document.getElementById(id ?? '');
        return `${cell?.getAttribute('role')} ${cell?.textContent}`;
      });
    expect(await active()).toBe('rowheader h700');
    await explorer.press('ArrowDown', 'ArrowRight', 'ArrowRight');
    expect(await active()).toBe(`gridcell h${mesh.next(701)}`);
    expect(await explorer.state('hovered')).toBe(`h${mesh.next(701)}`);
    await explorer.press('Enter');
    expect(await explorer.state('selected')).toBe(`h${mesh.next(701)}`);
    await explorer.press('Control+End');
    expect(await active()).toBe(`gridcell h${(mesh.halfedgeSlots - 1) ^ 1}`);
    await explorer.press('Control+Home', 'PageDown', 'Home');
    expect(await active()).not.toBe('rowheader h0');
    const rows = await explorer.page.getAttribute('[role=grid]', 'aria-rowcount');
    expect(rows).toBe(String(mesh.halfedgeSlots + 1));
  });

  test('follow an edit, and show what was deleted', async () => {
    await explorer.goTo('f33');
    await explorer.page.focus('main.stage canvas');
    await explorer.press('Delete');
    await explorer.until('undo', '1');
    await explorer.page.check('[name=records][value=face]');
    await explorer.page.focus('[role=grid]');
    await explorer.press('Control+Home', 'PageDown', 'PageDown');
    while ((await row(33)) === null) await explorer.press('ArrowDown');
    expect(await row(33)).toEqual(['f33', 'deleted']);
    await explorer.press('Control+z');
    await explorer.until('undo', '0');
    expect(await row(33)).toEqual(['f33', `h${mesh.faceHalfedge(33)}`]);
  });
});

describe('Attributes in the records', () => {
  /** Colours of vertices; normals and texture coordinates of corners; groups and materials of faces. */
  const ATTRIBUTED = `
v 0 0 0 1 0 0
v 1 0 0 0 1 0
v 1 1 0 0 0 1
v 0 1 0.5 0.25 0.5 0.75
vt 0 0
vt 1 0
vt 1 1
vt 0.125 1
vn 0 0 1
g left
usemtl steel
f 1/1/1 2/2/1 3/3/1
g right
f 1/1/1 3/3/1 4/4/1
`;
  let page: ExplorerPage;
  const texts = (selector: string) =>
    page.page.$$eval(selector, (cells) => cells.map((cell) => cell.textContent));
  const rowOf = (index: number) => texts(`.record[data-row="${index}"]:not([hidden]) > *`);
  beforeAll(async () => {
    page = await ExplorerPage.open();
    await page.page.click('[data-tab-button=records]');
    await page.drop('attributed.obj', ATTRIBUTED);
    await page.ready('attributed.obj');
  });
  afterEach(() => expect(page.complaints).toEqual([]));
  afterAll(() => page.close());

  test('have a column each, by their names, with all components in a cell', async () => {
    await page.goTo('v3');
    expect(await texts('.record.head > *')).toEqual(['vertex', 'halfedge', 'x', 'y', 'z', 'color']);
    expect((await rowOf(3)).slice(2)).toEqual(['0', '1', '0.5', '(0.25, 0.5, 0.75)']);
    await page.goTo('h0');
    expect((await texts('.record.head > *')).slice(5)).toEqual(['opposite', 'uv', 'normal']);
    const { mesh: parsed } = HalfedgeMesh.parse(ATTRIBUTED, { format: 'obj' });
    const corner = [...parsed.faceHalfedges(1)].find((h) => parsed.toVertex(h) === 3) ?? -1;
    await page.goTo(`h${corner}`);
    expect((await rowOf(corner)).slice(6)).toEqual(['(0.125, 1)', '(0, 0, 1)']);
    await page.goTo('f1');
    expect(await texts('.record.head > *')).toEqual(['face', 'halfedge', 'group', 'material']);
    expect((await rowOf(1)).slice(2)).toEqual(['2 “right”', '1 “steel”']);
  });

  test('are told to screen readers, and reached by keys, scrolled to where they can be read', async () => {
    await page.goTo('h0');
    await page.page.focus('[role=grid]');
    await page.press('End');
    const active = await page.page.evaluate(() => {
      const grid = document.querySelector('[role=grid]') as HTMLElement;
      const cell = document.getElementById(grid.getAttribute('aria-activedescendant') ?? '');
      const place = cell?.getBoundingClientRect();
      const room = grid.getBoundingClientRect();
      return {
        role: cell?.getAttribute('role'),
        title: cell?.title === cell?.textContent,
        name: cell?.dataset.name,
        columns: Number(grid.getAttribute('aria-colcount')),
        heads: grid.querySelectorAll('[role=columnheader]').length,
        inSight: place && place.left >= room.left && place.right <= room.right,
        scrolled: grid.scrollLeft > 0,
      };
    });
    expect(active).toEqual({
      ...{ role: 'gridcell', title: true, name: 'normal', columns: 8, heads: 8 },
      ...{ inSight: true, scrolled: true },
    });
    expect(await page.page.getAttribute('[role=columnheader][data-attribute]', 'title')).toBe(
      'attribute: 2 float32',
    );
    await page.screenshot('records-attributes-1280-light');
    // An attribute leads nowhere, and picks nothing.
    await page.press('Enter');
    expect(await page.state('selected')).toBe('h0');
    await page.press('Home');
    expect(await page.page.$eval('[role=grid]', (grid) => grid.scrollLeft)).toBe(0);
  });

  test('stay beside the name of their record', async () => {
    await page.goTo('h4');
    await page.page.focus('[role=grid]');
    await page.press('End');
    const left = (selector: string) =>
      page.page.$eval(selector, (cell) => cell.getBoundingClientRect().left);
    const grid = await left('[role=grid]');
    expect((await left('.record[data-row="4"] [role=rowheader]')) - grid).toBeLessThan(4);
    expect((await left('.record.head > :first-child')) - grid).toBeLessThan(4);
  });

  test('follow an edit and its way back', async () => {
    await page.goTo('f0');
    await page.page.click('[data-tab-button=edit]');
    await page.page.click('[data-operation=splitFace]');
    await page.until('undo', '1');
    await page.page.click('[data-tab-button=records]');
    await page.goTo('v4');
    await page.page.waitForSelector('.record.selected[data-row="4"]');
    expect((await rowOf(4)).at(-1)).toBe('(0.3333, 0.3333, 0.3333)');
    await page.press('Control+z');
    await page.until('undo', '0');
    await page.page.check('[name=records][value=vertex]');
    expect(await page.page.getAttribute('[role=grid]', 'aria-rowcount')).toBe('5');
  });
});

test('Edges have records: their two halfedges', async () => {
  const cube = await ExplorerPage.open({ link: 'sample=cube&select=e5', mesh: 'Cube' });
  await cube.page.click('[data-tab-button=records]');
  await cube.page.waitForSelector('.record.selected[data-row="10"]');
  expect(await cube.page.getAttribute('[role=grid]', 'data-records')).toBe('halfedge');
  expect(await cube.page.locator('.record.selected:not([hidden])').count()).toBe(2);
  await cube.page.check('[name=records][value=edge]');
  await cube.goTo('e7');
  expect(await cube.page.textContent('.record.selected')).toBe('e7h14h15');
  await cube.page.click('.record[data-row="7"] [data-name=second]');
  expect(await cube.state('selected')).toBe('h15');
  expect(cube.complaints).toEqual([]);
  await cube.close();
});

test('Records that need no scrolling are there when the table is first opened', async () => {
  const cube = await ExplorerPage.open({ link: 'sample=cube&select=h3', mesh: 'Cube' });
  await cube.page.click('[data-tab-button=records]');
  await cube.page.waitForSelector('.record.selected[data-row="3"]');
  expect(cube.complaints).toEqual([]);
  await cube.close();
});

test('A large mesh has a few rows in the page, and all of them in reach', async () => {
  const [width, height] = [320, 160];
  const lines: string[] = [];
  for (let y = 0; y <= height; y++) {
    for (let x = 0; x <= width; x++) lines.push(`v ${x} ${y} 0`);
  }
  const corner = (x: number, y: number) => 1 + x + y * (width + 1);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      lines.push(
        `f ${corner(x, y)} ${corner(x + 1, y)} ${corner(x + 1, y + 1)} ${corner(x, y + 1)}`,
      );
    }
  }
  await explorer.drop('wide.obj', lines.join('\n'));
  await explorer.ready('wide.obj');
  const halfedges = 2 * (width * (height + 1) + height * (width + 1));
  await explorer.page.check('[name=records][value=halfedge]');
  expect(await explorer.page.getAttribute('[role=grid]', 'aria-rowcount')).toBe(
    String(halfedges + 1),
  );
  expect(await explorer.page.locator('.record').count()).toBeLessThan(40);
  await explorer.page.focus('[role=grid]');
  await explorer.press('Control+End');
  expect(await row(halfedges - 1)).not.toBeNull();
  // The wheel moves by what it says, however long the table is.
  await explorer.press('Control+Home');
  await explorer.page.hover('.record[data-row="2"] [role=rowheader]');
  await explorer.page.mouse.wheel(0, 52);
  await explorer.page.waitForSelector('.rows-window > :first-child[data-row="2"]');
  // The scrollbar goes through all of them.
  await explorer.page.evaluate(() => {
    const rows = document.querySelector('.rows') as HTMLElement;
    rows.scrollTop = rows.scrollHeight;
  });
  await explorer.page.waitForSelector(`.record[data-row="${halfedges - 1}"]:not([hidden])`);
});
