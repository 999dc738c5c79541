import { buffer } from 'node:stream/consumers';
import { HalfedgeMesh, init } from 'halfedge';
import { disconnect, ExplorerPage } from './support/explorer.js';

/** A pyramid with one side turned over, its base twice, a face that uses vertex 99, and a fin. */
const PYRAMID = `OFF
6 9 0
-1 0 -1
1 0 -1
1 0 1
-1 0 1
0 1.5 0
0 0 2
4 0 1 2 3
3 1 0 4
3 1 2 4
3 3 2 4
3 0 3 4
4 2 3 0 1
3 0 1 99
3 2 3 5
2 0 1
`;

let explorer: ExplorerPage;
beforeAll(async () => {
  await init();
  explorer = await ExplorerPage.open();
});
beforeEach(() => explorer.sample('icosahedron', 'Icosahedron'));
afterEach(() => expect(explorer.complaints).toEqual([]));
afterAll(async () => {
  await explorer.close();
  await disconnect();
});

const dropPyramid = async () => {
  await explorer.drop('pyramid.off', PYRAMID);
  await explorer.ready('pyramid.off');
};
const entries = (code: string) => explorer.page.locator(`[data-finding=${code}] .entries button`);

describe('A broken file', () => {
  test('opens repaired, and lists what was wrong by kind, with the sentences of the package', async () => {
    await dropPyramid();
    const { page } = explorer;
    expect(await page.getAttribute('.panel', 'data-tab')).toBe('problems');
    expect(await page.locator('.finding h3').allTextContents()).toEqual([
      '1 face uses a vertex that is not there',
      '1 face has fewer than three corners',
      '1 face repeats another',
      '1 edge has more than two faces',
      '1 face points the wrong way',
    ]);
    expect(await page.textContent('.diagnosis')).toContain('5 problems were repaired');
    expect(await entries('index-out-of-range').allTextContents()).toEqual([
      'Face 6 uses vertex 99, but the last one is 5: it was left out. (Line 15)',
    ]);
    await explorer.screenshot('broken-1280-light');
  });

  test('shows where a problem is: the camera flies there and lights it', async () => {
    await dropPyramid();
    const earlier = await explorer.projection();
    const middle = [0, 0, 1];
    const edge = entries('edge-with-many-faces');
    await edge.click();
    expect(await explorer.state('problem')).toBe('edge-with-many-faces');
    expect(await edge.getAttribute('aria-pressed')).toBe('true');
    const later = await explorer.projection();
    const [x, y] = later(middle);
    // In the middle of what the panel leaves free.
    expect(Math.hypot(x - 456, y - 400)).toBeLessThan(60);
    expect(later(middle)).not.toEqual(earlier(middle));
    expect(await explorer.page.textContent('.tag.problem:not([hidden])')).toBe(
      'edge with many faces',
    );
    await explorer.screenshot('broken-witness-1280-light');
    await explorer.press('Escape');
    expect(await explorer.state('problem')).toBeNull();
    expect(await edge.getAttribute('aria-pressed')).toBe('false');
  });

  test('is shown as it was, or repaired, from the same place', async () => {
    await dropPyramid();
    await explorer.projection();
    const camera = await explorer.state('camera');
    const repaired = await explorer.colours(250, 150, 400, 500);
    await explorer.press('r');
    expect(await explorer.state('picture')).toBe('original');
    expect(await explorer.page.textContent('.picture-switch [role=status]')).toBe(
      'The original file is shown: 9 faces.',
    );
    expect(await explorer.page.locator('.legend li').allTextContents()).toEqual([
      'left out',
      'turned over',
      'cut or doubled',
    ]);
    expect(await explorer.page.isDisabled('[name=pick-mode][value=face]')).toBe(true);
    expect(await explorer.page.textContent('.inspector .facts')).toContain('switch to Repaired');
    expect(await explorer.page.textContent('.edit .empty')).toContain('Switch to Repaired');
    await explorer.press('n');
    expect(await explorer.page.textContent('.inspector .remark')).toContain('switch to Repaired');
    await explorer.projection();
    expect(await explorer.state('camera')).toBe(camera);
    expect(await explorer.colours(250, 150, 400, 500)).not.toBe(repaired);
    await explorer.screenshot('broken-original-1280-light');
    // By the keyboard alone: the switch is a group of radio buttons.
    await explorer.page.focus('.picture-switch input:checked');
    await explorer.press('ArrowRight');
    expect(await explorer.state('picture')).toBe('repaired');
    expect(await explorer.page.textContent('.inspector .remark')).toBe('');
    expect(await explorer.page.textContent('.edit .empty')).toContain('Pick a vertex');
    expect(await explorer.page.textContent('.picture-switch [role=status]')).toBe(
      'The repaired mesh is shown: 6 faces.',
    );
    expect(await explorer.state('camera')).toBe(camera);
  });

  test('shows the mesh again when an item of it is chosen', async () => {
    await dropPyramid();
    await explorer.press('r');
    await explorer.goTo('v2');
    expect(await explorer.state('picture')).toBe('repaired');
    expect(await explorer.state('selected')).toBe('v2');
  });

  test.each(['obj', 'ply', 'off', 'stl'] as const)(
    'can be downloaded as %s, which then needs no repair',
    async (format) => {
      await explorer.drop('pyramid 1.off', PYRAMID.replace('3 2 3 5', '3 5 5 5'));
      await explorer.ready('pyramid 1.off');
      const saved = explorer.page.waitForEvent('download');
      await explorer.page.click(`.file-problems [data-download=${format}]`);
      const download = await saved;
      expect(download.suggestedFilename()).toBe(`pyramid-1-repaired.${format}`);
      const content = await buffer(await download.createReadStream());
      const { mesh, report } = HalfedgeMesh.parse(content, { repair: false });
      expect(report.format).toBe(format);
      expect(mesh.validate(4).filter(({ severity }) => severity === 'error')).toEqual([]);
      expect(mesh.faceCount).toBe(format === 'stl' ? 6 : 5);
      expect(mesh.isClosed()).toBe(true);
      mesh.dispose();
      expect(await explorer.page.textContent('.file-problems .outcome')).toMatch(
        new RegExp(`^Saved pyramid-1-repaired\\.${format}, \\d+ bytes\\.`),
      );
    },
  );

  test('leaves no problems behind when a good one is opened', async () => {
    await dropPyramid();
    await explorer.press('r');
    await explorer.sample('cube', 'Cube');
    expect(await explorer.state('picture')).toBe('repaired');
    expect(await explorer.page.isVisible('.picture-switch')).toBe(false);
    expect(await explorer.page.isVisible('[data-tab-button=problems]')).toBe(false);
    expect(await explorer.page.getAttribute('.panel', 'data-tab')).toBe('circulate');
  });
});

describe('The broken samples', () => {
  test('open with a sentence that explains them, or say why they can’t', async () => {
    const samples = await explorer.page.$$eval('[data-broken]', (buttons) =>
      buttons.map((button) => [
        (button as HTMLElement).dataset.broken ?? '',
        button.querySelector('b')?.textContent ?? '',
      ]),
    );
    expect(samples.length).toBeGreaterThanOrEqual(12);
    for (const [id, name] of samples.filter(([id]) => id !== 'cut-short')) {
      await explorer.broken(id, name);
      expect(await explorer.page.textContent('.lesson')).toMatch(/^[A-Z].+\.$/);
      // Those are valid as they are: there is no other picture of them.
      const isValid = ['crack', 't-junction'].includes(id);
      expect([id, await explorer.page.isVisible('.picture-switch')]).toEqual([id, !isValid]);
      if (!isValid) {
        await explorer.press('r');
        expect(await explorer.state('picture')).toBe('original');
      }
      await explorer.screenshot(`broken-${id}`);
    }
    const [, last] = samples[samples.length - 2];
    await explorer.page.click('.mesh-button');
    await explorer.page.click('[data-broken=cut-short]');
    await explorer.page.waitForSelector('[role=alert]:not([hidden])');
    expect(await explorer.page.textContent('[role=alert] [data-message]')).toMatch(
      /^Line \d+: expected .*found the end of the file/,
    );
    expect(await explorer.state('mesh')).toBe(last);
    await explorer.page.click('[role=alert] [aria-label=Dismiss]');
  }, 120_000);

  test('list more than a hundred problems of a kind by their number', async () => {
    await explorer.broken('scan', 'Noisy scan');
    const wrong = entries('opposite-orientation');
    expect(await wrong.count()).toBe(5);
    await wrong.last().click();
    expect(await wrong.count()).toBeGreaterThan(50);
    const text = await explorer.page.textContent('[data-finding=opposite-orientation]');
    expect(text).toMatch(/… and \d+ more that are not listed one by one\./);
  });

  test('a crack is stitched in the Edit tab, which says so and can be undone', async () => {
    await explorer.broken('crack', 'Crack');
    await explorer.press('2');
    await explorer.page.click('[data-operation=stitchBoundaries]');
    expect(await explorer.page.textContent('.report')).toBe('52 edges stitched.');
    await explorer.page.waitForSelector('[data-number=loops] dd >> text=/^0/');
    await explorer.press('Control+z');
    expect(await explorer.state('undo')).toBe('0');
    await explorer.page.waitForSelector('[data-number=loops] dd >> text=/^2/');
  });
});

test.each([false, true])('Fits a telephone (dark: %s)', async (dark) => {
  const phone = await ExplorerPage.open({ width: 390, height: 844, phone: true, dark });
  const shade = dark ? 'dark' : 'light';
  await phone.broken('not-there', 'Nowhere and not there');
  await phone.screenshot(`broken-390-${shade}`);
  await phone.page.tap('.picture-switch label:has([value=original])');
  expect(await phone.state('picture')).toBe('original');
  await phone.page.tap('[data-finding=index-out-of-range] .entries button');
  expect(await phone.state('problem')).toBe('index-out-of-range');
  await phone.screenshot(`broken-original-390-${shade}`);
  expect(await phone.page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
  expect(phone.complaints).toEqual([]);
  await phone.close();
});

test('On a telephone the switch over the picture covers nothing of the mesh', async () => {
  const phone = await ExplorerPage.open({ width: 390, height: 844, phone: true });
  await phone.drop('pyramid.off', PYRAMID);
  await phone.ready('pyramid.off');
  const inWindow = await phone.projection();
  const switched = await phone.page.locator('.picture-switch .segments').boundingBox();
  const picks = await phone.page.locator('.pick-bar').boundingBox();
  if (!switched || !picks) throw new Error('The switch or the bar below the picture is missing');
  for (const corner of [
    [-1, 0, -1],
    [1, 0, -1],
    [1, 0, 1],
    [-1, 0, 1],
    [0, 1.5, 0],
    [0, 0, 2],
  ]) {
    const [, y] = inWindow(corner);
    expect(y).toBeGreaterThan(switched.y + switched.height);
    expect(y).toBeLessThan(picks.y);
  }
  expect(phone.complaints).toEqual([]);
  await phone.close();
});
