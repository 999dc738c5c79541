import { disconnect, ExplorerPage } from './support/explorer.js';

afterAll(disconnect);

/** Copies the link to the state of a page. */
async function share({ page }: ExplorerPage): Promise<string> {
  await page.click('[data-share]');
  await page.waitForSelector('[data-toast]:has-text("Link copied")');
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  expect(copied).toBe(await page.evaluate(() => location.href));
  return new URL(copied).hash.slice(1);
}

const STATES = ['mesh', 'digest', 'selected', 'position', 'count', 'undo', 'picture', 'problem'];

async function stateOf(explorer: ExplorerPage) {
  await explorer.rest();
  await explorer.page.waitForSelector('main.stage[data-digest]');
  const states = await Promise.all(STATES.map((name) => explorer.state(name)));
  const listing = await explorer.page.$$eval('.listing li', (all) =>
    all.map((li) => li.textContent),
  );
  const camera = (await explorer.state('camera'))?.split(' ').map((x) => Number(x).toFixed(2));
  return { states, listing, camera, visited: await explorer.visited() };
}

/** Opens the link of a page in another one, and expects the same there. */
async function expectSame(explorer: ExplorerPage): Promise<ExplorerPage> {
  const expected = await stateOf(explorer);
  const link = await share(explorer);
  const mesh = (await explorer.state('mesh')) ?? '';
  const other = await ExplorerPage.open({ link, mesh });
  expect(await stateOf(other)).toEqual(expected);
  return other;
}

async function closeAll(...explorers: ExplorerPage[]): Promise<void> {
  for (const explorer of explorers) {
    expect(explorer.complaints).toEqual([]);
    await explorer.close();
  }
}

test('A link leads to the same mesh, selection, circulator, step, names and view', async () => {
  const explorer = await ExplorerPage.open();
  await explorer.sample('suzanne', 'Suzanne');
  await explorer.goTo('h500');
  await explorer.page.check('[name=around][value="1"]');
  await explorer.page.check('[value=vertexFaces]');
  await explorer.page.selectOption('[name=dialect]', 'cgal');
  await explorer.press('c', '.', '.', 'ArrowLeft', 'ArrowUp', '+');
  const other = await expectSame(explorer);
  expect(await other.page.inputValue('[name=dialect]')).toBe('cgal');
  await closeAll(explorer, other);
});

test('What is told of a link goes with the mesh that it leads to', async () => {
  const explorer = await ExplorerPage.open();
  await share(explorer);
  await explorer.sample('cube', 'Cube');
  expect(await explorer.page.isVisible('[data-toast]')).toBe(false);
  await closeAll(explorer);
});

test('Edits of a sample are done again, and can be undone', async () => {
  const explorer = await ExplorerPage.open();
  await explorer.sample('cube', 'Cube');
  await explorer.goTo('f2');
  await explorer.press('Shift+E');
  await explorer.until('undo', '1');
  await explorer.goTo('e3');
  await explorer.press('Shift+V');
  await explorer.until('undo', '2');
  const other = await expectSame(explorer);
  expect(await other.page.evaluate(() => location.hash)).toContain('extrudeFace');
  await other.press('Control+z', 'Control+z');
  await other.until('undo', '0');
  await closeAll(explorer, other);
});

test('A link leads to the problem that is lit, to the tab and to what is picked', async () => {
  const explorer = await ExplorerPage.open();
  await explorer.broken('three-faces', 'Three faces at an edge');
  await explorer.page.click('[data-finding] [data-code]');
  await explorer.press('ArrowLeft', 'ArrowUp', 'r');
  await explorer.until('picture', 'original');
  const first = await expectSame(explorer);
  expect(await first.state('problem')).toBe(await explorer.state('problem'));
  expect(await first.page.getAttribute('.panel', 'data-tab')).toBe('problems');
  await explorer.press('r');
  await explorer.page.check('[name=pick-mode][value=edge]', { force: true });
  await explorer.page.click('[data-tab-button=records]');
  const second = await expectSame(explorer);
  expect(await second.page.getAttribute('.panel', 'data-tab')).toBe('records');
  expect(await second.page.isChecked('[name=pick-mode][value=edge]')).toBe(true);
  await closeAll(explorer, first, second);
});

test('A small mesh of a file is in the link itself', async () => {
  const explorer = await ExplorerPage.open();
  const text = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 1\nf 1 2 3 4\nf 2 5 3\n';
  await explorer.drop('two faces.obj', text);
  await explorer.ready('two faces.obj');
  await explorer.goTo('f1');
  const other = await expectSame(explorer);
  expect(await other.state('mesh')).toBe('two faces.obj');
  await closeAll(explorer, other);
});

test('A link that is pasted into the address of an open page is followed', async () => {
  const explorer = await ExplorerPage.open();
  await explorer.page.evaluate(() => {
    location.hash = 'sample=torus&select=v7&query=vertexFaces&at=2';
  });
  await explorer.ready('Torus');
  await explorer.until('selected', 'v7');
  await explorer.until('position', '2');
  await closeAll(explorer);
});

test('A link shows what it names and nothing else, and the address goes with its mesh', async () => {
  const link = 'sample=cube&select=f1&names=cgal&labels=all:vf';
  const explorer = await ExplorerPage.open({ link, mesh: 'Cube' });
  const { page } = explorer;
  expect(await page.inputValue('[name=dialect]')).toBe('cgal');
  expect(await page.isChecked('[name=label-scope][value=all]')).toBe(true);
  await page.evaluate(() => {
    location.hash = 'sample=torus&select=v7';
  });
  await explorer.ready('Torus');
  await explorer.until('selected', 'v7');
  expect(await page.inputValue('[name=dialect]')).toBe('halfedge');
  expect(await page.isChecked('[name=label-scope][value=off]')).toBe(true);
  expect(await page.evaluate(() => location.hash)).toBe('#sample=torus&select=v7');
  await explorer.sample('cube', 'Cube');
  expect(await page.evaluate(() => location.hash)).toBe('');
  await closeAll(explorer);
});

describe('Back to the plain address, from a link,', () => {
  const torus = (page: ExplorerPage['page']) =>
    page.evaluate(() => {
      location.hash = 'sample=torus&select=f3';
    });

  test('shows what was on show there, and forward follows the link again', async () => {
    const explorer = await ExplorerPage.open();
    const { page } = explorer;
    await explorer.sample('cube', 'Cube');
    await torus(page);
    await explorer.ready('Torus');
    await page.goBack();
    await explorer.ready('Cube');
    expect(await page.isVisible('.notice')).toBe(false);
    await page.goForward();
    await explorer.ready('Torus');
    await explorer.until('selected', 'f3');
    expect(explorer.complaints).toEqual([]);
    await closeAll(explorer);
  });

  test('gives back the names, labels and pointers that were chosen there', async () => {
    const explorer = await ExplorerPage.open();
    const { page } = explorer;
    const choices = async () => [
      await page.inputValue('[name=dialect]'),
      await page.isChecked('[name=direction][value=cw]'),
      await page.isChecked('[name=label-scope][value=all]'),
      await page.isChecked('[name=pointers]'),
      await page.isChecked('[name=pick-mode][value=face]'),
      await page.getAttribute('.panel', 'data-tab'),
    ];
    await page.selectOption('[name=dialect]', 'openmesh');
    await page.click('[data-tab-button=edit]');
    await page.evaluate(() => {
      location.hash =
        'sample=torus&select=v3&names=cgal&direction=cw&labels=all:vf&pointers=on&pick=face&tab=mesh';
    });
    await explorer.ready('Torus');
    expect(await choices()).toEqual(['cgal', true, true, true, true, 'mesh']);
    await page.goBack();
    await explorer.ready('Bunny');
    expect(await choices()).toEqual(['openmesh', false, false, false, false, 'edit']);
    await closeAll(explorer);
  });

  test('brings a mesh back with its edits, and keeps those of the mesh of the link', async () => {
    const explorer = await ExplorerPage.open();
    const { page } = explorer;
    await explorer.sample('icosahedron', 'Icosahedron');
    await explorer.goTo('e3');
    await explorer.press('Shift+F');
    await explorer.until('undo', '1');
    await explorer.rest();
    const edited = await explorer.state('digest');
    await torus(page);
    await explorer.ready('Torus');
    await page.goBack();
    await explorer.ready('Icosahedron');
    await explorer.until('undo', '1');
    await explorer.until('digest', edited);
    await page.goForward();
    await explorer.ready('Torus');
    await explorer.goTo('f5');
    await explorer.press('Delete');
    await explorer.until('undo', '3');
    await page.goBack();
    await explorer.ready('Icosahedron');
    await page.click('[data-left] button');
    await explorer.ready('Torus');
    await explorer.until('undo', '3');
    await closeAll(explorer);
  });

  test('opens what the page begins with, where the page began with the link', async () => {
    const explorer = await ExplorerPage.open({ link: 'sample=cube', mesh: 'Cube' });
    await explorer.page.evaluate(() => {
      location.hash = '';
    });
    await explorer.ready('Bunny');
    expect(await explorer.page.isVisible('.notice')).toBe(false);
    await closeAll(explorer);
  });
});

const BROKEN = [
  ['sample=teapot', 'It names the sample “teapot”, which this page does not have.'],
  ['select=v3', 'It names no mesh: it has neither “sample” nor “mesh”.'],
  ['mesh=AAAA', 'The mesh in it is cut off or changed: copy the whole link again.'],
  ['sample=bunny&camera=1,2,x,4,5,6', 'The camera in it is “1,2,x,4,5,6”; expected six numbers.'],
  ['sample=bunny&select=q3', '“q3” in it is no item: expected such as v12, h31, e15 or f7.'],
  ['sample=bunny&select=v3&query=faceFaces', 'v3 has no circulator “faceFaces”.'],
  ['sample=cube&select=v3&at=9', 'It has at=9; expected 0 to 3, as many as that walk visits.'],
  ['sample=cube&select=v3&around=2&at=1', 'It has around=2; of v3 only 0 is known.'],
  ['sample=bunny&edits=paint f3', 'It has the edit “paint f3”, which this page does not know.'],
  ['sample=bunny&names=latin', 'It asks for the names of “latin”, which this page does not know.'],
] as const;

test('A broken link is told in a sentence and leaves a mesh to work with', async () => {
  const told = () => explorer.page.textContent('.notice [data-message]');
  const explorer = await ExplorerPage.open({ link: BROKEN[0][0] });
  expect(await explorer.page.textContent('.notice h2')).toBe('The link could not be followed');
  for (const [link, why] of BROKEN) {
    await explorer.page.evaluate((hash) => {
      location.hash = hash;
    }, link);
    await explorer.page.waitForSelector(`.notice:has-text("${why}")`);
    expect(await told()).toBe(why);
    expect(await explorer.state('mesh')).toBe(link.includes('cube') ? 'Cube' : 'Bunny');
  }
  await closeAll(explorer);
});

test('A link may tell where a walk stands without its name: it is the first one', async () => {
  const explorer = await ExplorerPage.open({ link: 'sample=cube&select=f2&at=3', mesh: 'Cube' });
  expect(await explorer.page.isVisible('.notice')).toBe(false);
  expect([await explorer.state('position'), await explorer.state('count')]).toEqual(['3', '4']);
  await closeAll(explorer);
});

test('A link to an item that its mesh does not have says so', async () => {
  const explorer = await ExplorerPage.open({ link: 'sample=cube&select=v99', mesh: 'Cube' });
  const told = await explorer.page.textContent('.notice [data-message]');
  expect(told).toContain('v99');
  await closeAll(explorer);
});

test('An edit in a link that is refused tells why', async () => {
  const link = 'sample=grid&edits=removeVertexOnEdge v24';
  const explorer = await ExplorerPage.open({ link, mesh: 'Open grid' });
  const told = await explorer.page.textContent('.notice [data-message]');
  expect(told).toMatch(/^The edit “removeVertexOnEdge v24” in it could not be done\. .{20,}\.$/);
  await closeAll(explorer);
});

test('An edit in a link that is refused is told of in one card, as long as that link is the last', async () => {
  const link = 'sample=cube&edits=splitFace f0,flipEdge e1';
  const explorer = await ExplorerPage.open({ link, mesh: 'Cube' });
  const { page } = explorer;
  const cards = () =>
    page.$$eval('[role=alert]', (all) =>
      all.filter((each) => each.checkVisibility()).map((each) => each.textContent),
    );
  expect(await cards()).toEqual([expect.stringContaining('“flipEdge e1” in it')]);
  expect(await explorer.state('refusal')).toBeNull();
  await page.evaluate(() => {
    location.hash = 'sample=none';
  });
  await page.waitForSelector('.notice:has-text("“none”")');
  expect(await cards()).toHaveLength(1);
  await page.evaluate(() => {
    location.hash = 'sample=cube&edits=insertEdge h0';
  });
  await page.waitForSelector('.notice:has-text("insertEdge h0")');
  expect(await explorer.state('pending')).toBeNull();
  await closeAll(explorer);
});

test('An edit in a link is not done to another item than the one it names', async () => {
  const link = 'sample=icosahedron&edits=flipEdge e3,flipEdge e9999';
  const explorer = await ExplorerPage.open({ link, mesh: 'Icosahedron' });
  const told = await explorer.page.textContent('.notice [data-message]');
  expect(told).toBe(
    'The edit “flipEdge e9999” in it could not be done. There is no e9999: this mesh has edge 0 to 29.',
  );
  expect(await explorer.state('undo')).toBe('1');
  await closeAll(explorer);
});

test('A link to a mesh that cannot be opened says so, and leaves the one on show as it is', async () => {
  const link = 'sample=cut-short&edits=flipEdge e3&select=v3&names=cgal';
  const explorer = await ExplorerPage.open({ link });
  const title = () => explorer.page.textContent('.notice h2');
  expect(await title()).toBe('“Cut short” was not opened');
  expect(await explorer.page.textContent('.notice .calm')).toContain('The view shows Bunny.');
  await explorer.page.evaluate(() => {
    location.hash = 'sample=icosahedron&select=e5';
  });
  await explorer.until('selected', 'e5');
  expect(await explorer.page.isVisible('.notice')).toBe(false);
  await explorer.page.evaluate((hash) => {
    location.hash = hash;
  }, link);
  await explorer.page.waitForSelector('.notice:has-text("Cut short")');
  await explorer.rest();
  expect(await title()).toBe('“Cut short” was not opened');
  expect([await explorer.state('selected'), await explorer.state('undo')]).toEqual(['e5', '0']);
  expect(await explorer.page.inputValue('[name=dialect]')).toBe('halfedge');
  await closeAll(explorer);
});

test('The address lets go of a link whose mesh is still on its way when a file is opened', async () => {
  const explorer = await ExplorerPage.open({ link: 'sample=cube', mesh: 'Cube' });
  const { page } = explorer;
  let goOn = () => {};
  const held = new Promise<void>((resolve) => {
    goOn = resolve;
  });
  await page.route('**/suzanne*', async (route) => {
    await held;
    await route.continue();
  });
  await page.evaluate(() => {
    location.hash = 'sample=suzanne&select=v3';
  });
  await page.waitForSelector('.busy');
  await page.setInputFiles('[data-file]', {
    name: 'one.off',
    mimeType: 'application/octet-stream',
    buffer: Buffer.from('OFF 3 1 0  0 0 0  1 0 0  0 1 0  3 0 1 2'),
  });
  await explorer.ready('one.off');
  goOn();
  await page.waitForFunction(() => location.hash === '');
  expect(await explorer.state('mesh')).toBe('one.off');
  await page.unroute('**/suzanne*');
  await page.goBack(); // to the cube, which is what the page began with
  await explorer.ready('Cube');
  await closeAll(explorer);
});

test('A link that could not be copied is shown; Escape in it leaves the selection alone', async () => {
  const explorer = await ExplorerPage.open({ link: 'sample=cube&select=e3', mesh: 'Cube' });
  const { page } = explorer;
  await page.evaluate(() => {
    navigator.clipboard.writeText = () => Promise.reject(new Error('refused'));
  });
  await page.focus('[data-share]');
  await page.keyboard.press('Enter');
  await page.waitForSelector('[data-toast] input:not([hidden])');
  expect(await page.inputValue('[data-toast] input')).toContain('#sample=cube&select=e3');
  await page.focus('[data-toast] input');
  await page.keyboard.press('Escape');
  expect(await page.isVisible('[data-toast]')).toBe(false);
  expect(await explorer.state('selected')).toBe('e3');
  expect(await page.evaluate(() => document.activeElement?.hasAttribute('data-share'))).toBe(true);
  await closeAll(explorer);
});

test('A mesh that is too large for a link is told of', async () => {
  const explorer = await ExplorerPage.open();
  const lines: string[] = [];
  for (let i = 0; i < 1200; i++) {
    const [x, y, z] = [i % 40, Math.floor(i / 40), Math.sin(i)];
    lines.push(`v ${x} ${y} ${z / 7}`, `v ${x + z / 3} ${y} 0`, `v ${x} ${y + z / 5} ${z}`);
    lines.push(`f ${3 * i + 1} ${3 * i + 2} ${3 * i + 3}`);
  }
  await explorer.drop('much.obj', lines.join('\n'));
  await explorer.ready('much.obj');
  await explorer.page.click('[data-share]');
  const told = await explorer.page.textContent('[data-toast] p');
  expect(told).toMatch(/^much\.obj is too large for a link: it would be \d+ kB long, 32 kB/);
  await closeAll(explorer);
});

test('Of a mesh that is far too large, no link is tried', async () => {
  const explorer = await ExplorerPage.open();
  const side = 200;
  const vertices = Array.from({ length: side * side }, (_, i) => {
    return `${i % side} ${Math.floor(i / side)} ${Math.sin(i)}`;
  });
  const faces = Array.from({ length: (side - 1) ** 2 }, (_, i) => {
    const v = i + Math.floor(i / (side - 1));
    return `4 ${v} ${v + 1} ${v + side + 1} ${v + side}`;
  });
  const file = [`OFF ${vertices.length} ${faces.length} 0`, ...vertices, ...faces].join('\n');
  await explorer.drop('vast.off', file);
  await explorer.ready('vast.off');
  await explorer.page.click('[data-share]');
  const told = await explorer.page.textContent('[data-toast] p');
  expect(told).toMatch(/^vast\.off is too large for a link: it would be far longer, 32 kB/);
  await closeAll(explorer);
});
