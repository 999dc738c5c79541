import { disconnect, ExplorerPage } from './support/explorer.js';
import { disconnect as disconnectFigures, FigurePage } from './support/figures.js';

afterAll(async () => {
  await disconnect();
  await disconnectFigures();
});

describe('Where less motion is asked for, the explorer', () => {
  let explorer: ExplorerPage;
  const LINK = 'sample=icosahedron&select=e12';

  afterEach(async () => {
    expect(explorer.complaints).toEqual([]);
    await explorer.closeTab(); // and the clock that some of them stop
  });

  const open = async (motion: boolean) => {
    explorer = await ExplorerPage.open({ motion, link: LINK, mesh: 'Icosahedron' });
    await explorer.rest();
  };

  /** How many frames are drawn, and how many looks of elements change by and by, after `act`. */
  async function motionOf(act: () => Promise<unknown>): Promise<{ frames: number; looks: number }> {
    const frames = async () => Number(await explorer.state('frames'));
    const before = await frames();
    await act();
    const looks = await explorer.page.evaluate(
      () => document.getAnimations().filter(({ playState }) => playState === 'running').length,
    );
    await explorer.page.waitForTimeout(700);
    await explorer.rest();
    return { frames: (await frames()) - before, looks };
  }

  test('flies nowhere, and changes nothing by and by', async () => {
    await open(false);
    for (const keys of [['z'], ['0'], ['n', 'z'], ['2', 'Shift+F'], ['Control+z'], ['4']]) {
      const { frames, looks } = await motionOf(() => explorer.press(...keys));
      expect([keys, frames <= 4, looks]).toEqual([keys, true, 0]);
    }
  });

  test('does not let the mesh turn on when a drag has ended', async () => {
    await open(false);
    const { mouse } = explorer.page;
    await mouse.move(300, 300);
    await mouse.down();
    await mouse.move(360, 330, { steps: 3 });
    const { frames } = await motionOf(() => mouse.up());
    expect(frames).toBeLessThanOrEqual(2);
  });

  test('plays a walk step by step all the same', async () => {
    await open(false);
    await explorer.goTo('v3');
    await explorer.press(' ');
    await explorer.until('player', 'done');
    expect(await explorer.visited()).toHaveLength(5);
    await explorer.press(',', ',');
    expect(await explorer.state('position')).toBe('3');
  });

  test('shows the mesh after an operation, and before it again, at once', async () => {
    await open(true);
    const { page } = explorer;
    await page.clock.install();
    await page.clock.pauseAt(Date.now() + 60_000);
    const drawn = async (keys: string, undo: string) => {
      const before = Number(await explorer.state('frames'));
      await explorer.press(keys);
      await page.clock.runFor(600);
      expect(await explorer.state('undo')).toBe(undo);
      return Number(await explorer.state('frames')) - before;
    };
    await page.click('[data-tab-button=edit]');
    expect(await drawn('Shift+F', '1')).toBeGreaterThan(10);
    expect(await drawn('Control+z', '0')).toBeGreaterThan(10);
    await page.emulateMedia({ reducedMotion: 'reduce' });
    expect(await drawn('Shift+F', '1')).toBeLessThanOrEqual(4);
    expect(await drawn('Control+z', '0')).toBeLessThanOrEqual(4);
  });

  test('follows a choice that is made while it is open', async () => {
    await open(true);
    const { page } = explorer;
    await page.clock.install();
    await page.clock.pauseAt(Date.now() + 60_000);
    const drawn = async (act: () => Promise<unknown>) => {
      const before = Number(await explorer.state('frames'));
      await act();
      await page.clock.runFor(600);
      return Number(await explorer.state('frames')) - before;
    };
    const drag = async () => {
      await page.mouse.move(300, 300);
      await page.mouse.down();
      await page.mouse.move(360, 330, { steps: 3 });
      await page.clock.runFor(100);
      await page.mouse.up();
    };
    expect(await drawn(() => explorer.press('z'))).toBeGreaterThan(10);
    expect(await drawn(drag)).toBeGreaterThan(10);
    await page.emulateMedia({ reducedMotion: 'reduce' });
    expect(await drawn(() => explorer.press('0'))).toBeLessThanOrEqual(4);
    expect(await drawn(drag)).toBeLessThanOrEqual(6);
  });
});

describe('Where less motion is asked for, a figure', () => {
  let figures: FigurePage;

  afterEach(async () => {
    expect(figures.complaints).toEqual([]);
    await figures.close();
  });

  const open = async (attributes: string) => {
    figures = await FigurePage.open(`<halfedge-figure ${attributes} controls></halfedge-figure>`);
    await figures.ready();
  };

  test('shows the state after an operation at once, and the one before it again', async () => {
    await open('src="shape:grid(3, 2, triangles)" operation="collapse h8"');
    for (const label of ['Step forward', 'Step back']) {
      const { copies } = await figures.counts();
      await figures.page.click(`halfedge-figure [aria-label="${label}"]`);
      await figures.page.waitForTimeout(700);
      const drawn = (await figures.counts()).copies - copies;
      expect([drawn > 0, drawn <= 3]).toEqual([true, true]);
    }
  });

  test('does not play by itself, but steps and plays when it is told to', async () => {
    await open('src="shape:icosahedron" select="v3" query="vertexVertices" speed="20" autoplay');
    await figures.page.waitForTimeout(500);
    expect(await figures.figure(({ step, playing }) => [step, playing])).toEqual([0, false]);
    await figures.page.click('halfedge-figure [aria-label="Step forward"]');
    expect(await figures.figure(({ step }) => step)).toBe(1);
    await figures.page.click('halfedge-figure [aria-label=Play]');
    await figures.page.waitForSelector('halfedge-figure[step="5"]');
  });
});
