import { disconnect, ExplorerPage } from './support/explorer.js';

afterAll(disconnect);

/** The topology numbers of the mesh panel. */
async function counts({ page }: ExplorerPage): Promise<Record<string, string>> {
  await page.waitForFunction(() => !document.querySelector('.counts')?.textContent?.includes('…'));
  const entries = await page.$$eval('.counts > div', (rows) =>
    rows.map((row) => [row.querySelector('dt')?.textContent, row.querySelector('dd')?.textContent]),
  );
  return Object.fromEntries(entries);
}

describe('The page', () => {
  test('opens with a real mesh, its numbers and a vertex to start from', async () => {
    const explorer = await ExplorerPage.open();
    expect(await counts(explorer)).toEqual({
      Vertices: '2,826',
      Edges: '8,472',
      Faces: '5,648',
      'Euler χ': '2',
      Genus: '0',
      'Boundary loops': '0',
    });
    expect(await explorer.validity()).toMatch(/^Valid: all invariants hold/);
    expect(await explorer.state('selected')).toMatch(/^v\d+$/);
    expect(await explorer.state('player')).toBe('paused');
    // The middle of the picture is a shaded, wired surface, not a blank canvas.
    expect(await explorer.colours(380, 330, 200, 200)).toBeGreaterThan(60);
    await explorer.screenshot('opened-1280-light');
    expect(explorer.complaints).toEqual([]);
    await explorer.close();
  });

  test('draws no frame before there is a mesh, and the first sample is on its way before WebAssembly is', async () => {
    const explorer = await ExplorerPage.open();
    const { page } = explorer;
    let goOn = () => {};
    const held = new Promise<void>((resolve) => {
      goOn = resolve;
    });
    await page.route('**/core*.wasm', async (route) => {
      await held;
      await route.continue();
    });
    await Promise.all([page.waitForRequest('**/bunny*.off'), page.reload()]);
    await page.waitForSelector('.panel');
    await page.setViewportSize({ width: 1200, height: 800 });
    await page.waitForTimeout(300);
    expect(await explorer.state('frames')).toBeNull();
    goOn();
    await explorer.ready('Bunny');
    expect(Number(await explorer.state('frames'))).toBeGreaterThan(0);
    expect(await explorer.colours(380, 330, 200, 200)).toBeGreaterThan(60);
    await explorer.close();
  });

  test('draws nothing while nothing changes', async () => {
    const explorer = await ExplorerPage.open();
    await explorer.projection();
    const before = await explorer.state('frames');
    await explorer.page.waitForTimeout(900);
    expect(await explorer.state('frames')).toBe(before);
    await explorer.press('ArrowLeft');
    await explorer.projection();
    expect(Number(await explorer.state('frames'))).toBeGreaterThan(Number(before));
    await explorer.close();
  });

  test('opens every sample, each of them valid', async () => {
    const explorer = await ExplorerPage.open();
    const samples = await explorer.page.$$eval('[data-sample]', (buttons) =>
      buttons.map((button) => [
        (button as HTMLElement).dataset.sample ?? '',
        button.querySelector('b')?.textContent ?? '',
      ]),
    );
    expect(samples.length).toBeGreaterThanOrEqual(10);
    for (const [id, name] of samples) {
      await explorer.sample(id, name);
      await counts(explorer);
      expect(await explorer.validity()).toMatch(/^Valid/);
      expect(await explorer.state('selected')).not.toBeNull();
      await explorer.screenshot(`sample-${id}`);
    }
    expect(explorer.complaints).toEqual([]);
    await explorer.close();
  }, 360_000);

  test('follows the theme of the system, and keeps the one that is chosen', async () => {
    const explorer = await ExplorerPage.open({ dark: true });
    const { page } = explorer;
    expect(await page.getAttribute('html', 'data-theme')).toBe('dark');
    const background = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    expect(await background()).toBe('rgb(21, 24, 28)');
    await explorer.screenshot('opened-1280-dark');
    await page.click('[aria-label="Switch to light theme"]');
    expect(await background()).toBe('rgb(255, 255, 255)');
    await page.reload();
    await explorer.ready('Bunny');
    expect(await page.getAttribute('html', 'data-theme')).toBe('light');
    expect(explorer.complaints).toEqual([]);
    await explorer.close();
  });

  test('has cards of glass only where a graphics card draws, and nobody asks for less transparency', async () => {
    const explorer = await ExplorerPage.open();
    const { page } = explorer;
    const look = () =>
      page.$eval('.panel.card', (card) => {
        const { backgroundColor, backdropFilter } = getComputedStyle(card);
        return [backgroundColor, backdropFilter];
      });
    const opaque = ['color(srgb 1 1 1)', 'none'];
    expect(await page.getAttribute('html', 'data-cards')).toBe('opaque'); // this one has no graphics card
    expect(await look()).toEqual(opaque);
    await page.evaluate(() => {
      document.documentElement.dataset.cards = 'glass';
    });
    expect(await look()).toEqual(['rgba(255, 255, 255, 0.88)', 'blur(14px) saturate(1.3)']);
    const session = await page.context().newCDPSession(page);
    const features = [{ name: 'prefers-reduced-transparency', value: 'reduce' }];
    await session.send('Emulation.setEmulatedMedia', { features });
    expect(await look()).toEqual(opaque);
    await session.detach();
    await explorer.close();
  });

  test.each([false, true])('fits a telephone (dark: %s)', async (dark) => {
    const explorer = await ExplorerPage.open({ width: 390, height: 844, phone: true, dark });
    const { page } = explorer;
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(
      390,
    );
    const outside = await page.$$eval(
      '.top-bar button, .pick-bar label, .tabs button',
      (all) =>
        all.filter((element) => {
          const { left, right, width } = element.getBoundingClientRect();
          return width > 0 && (left < 0 || right > innerWidth);
        }).length,
    );
    expect(outside).toBe(0);
    const shade = dark ? 'dark' : 'light';
    await explorer.screenshot(`opened-390-${shade}`);
    await page.tap('.play');
    await explorer.until('player', 'done');
    expect((await explorer.visited()).length).toBe(Number(await explorer.state('count')));
    await explorer.screenshot(`played-390-${shade}`);
    await page.tap('[data-tab-button=inspect]');
    expect(await page.isVisible('.links')).toBe(true);
    expect(await page.isVisible('.transport')).toBe(false);
    await page.tap('.links button');
    expect(await explorer.state('selected')).toMatch(/^h\d+$/);
    await explorer.screenshot(`inspected-390-${shade}`);
    expect(explorer.complaints).toEqual([]);
    await explorer.close();
  });

  test('lists its keys', async () => {
    const explorer = await ExplorerPage.open();
    await explorer.press('?');
    expect(await explorer.page.textContent('dialog[open]')).toContain('play or pause');
    await explorer.screenshot('keys-1280-light');
    await explorer.press('Escape');
    expect(await explorer.page.isVisible('dialog.help')).toBe(false);
    expect(await explorer.state('selected')).not.toBeNull();
    await explorer.close();
  });

  test('names every control for assistive technology', async () => {
    const explorer = await ExplorerPage.open();
    await explorer.goTo('h10');
    const nameless = await explorer.page.$$eval('button, input, select, canvas', (controls) =>
      controls
        .filter((control) => {
          const label = control.closest('label')?.textContent ?? '';
          const name = control.getAttribute('aria-label') ?? control.textContent ?? '';
          return name.trim() === '' && label.trim() === '';
        })
        .map((control) => control.outerHTML),
    );
    expect(nameless).toEqual([]);
    await explorer.close();
  });
});

test.each([
  [1280, 800, true],
  [1920, 1080, true],
  [390, 844, false],
])('A window of %i × %i pixels keeps its shape on paper', async (width, height, showsPanel) => {
  const explorer = await ExplorerPage.open({ width, height, link: 'sample=cube', mesh: 'Cube' });
  const { page } = explorer;
  await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')));
  await page.emulateMedia({ media: 'print' });
  // A4, with margins of 8 mm.
  const paper = [734, 1062];
  if (width > height) paper.reverse();
  await page.setViewportSize({ width: paper[0], height: paper[1] });
  const box = await page.locator('main.stage canvas').boundingBox();
  if (!box) throw new Error('there is no picture on paper');
  expect(box.width / box.height).toBeCloseTo(width / height, 1);
  expect(box.x + box.width).toBeLessThanOrEqual(paper[0]);
  expect(box.y + box.height).toBeLessThanOrEqual(paper[1]);
  expect(await page.isVisible('.panel')).toBe(showsPanel);
  await explorer.close();
});
