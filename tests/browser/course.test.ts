import { seriousFindings } from './support/axe.js';
import { closeFigures, disconnect, type FigurePageSettings, figures } from './support/figures.js';

afterEach(closeFigures);
afterAll(disconnect);

const course = (settings: FigurePageSettings) =>
  figures('', { ...settings, path: 'docs/course.html' });

describe('The course page', () => {
  test.each([
    ['a desktop, light', 'light', { width: 1280, height: 900 }],
    ['a desktop, dark', 'dark', { width: 1280, height: 900, dark: true }],
    ['a telephone, light', 'narrow', { width: 390, height: 844 }],
  ])('shows its ten figures with one context: %s', async (_name, look, settings) => {
    const page = await course(settings);
    expect(await page.ready()).toBe(10);
    expect((await page.counts()).contexts).toBe(1);
    expect(await page.events('halfedge-error')).toEqual([]);
    expect(page.complaints).toEqual([]);
    const wide = await page.page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    expect(wide).toBeLessThanOrEqual(0);
    expect(await seriousFindings(page.page)).toEqual([]);
    await page.screenshot(`course-${look}`);
    const names = await page.figure(({ shadowRoot }) =>
      Array.from(
        shadowRoot?.querySelectorAll('.tag.index:not(.away)') ?? [],
        ({ textContent }) => textContent,
      ),
    );
    expect(names.sort()).toEqual(['f0', 'f1', 'f2', 'v0', 'v1', 'v2', 'v3', 'v4']);
  });

  test('every figure that plays comes to its end', async () => {
    const page = await course({});
    await page.ready();
    const ends = await page.page.$$eval('halfedge-figure', (figures) =>
      figures.map((figure) => {
        figure.seek(99);
        return [figure.step, figure.sentence];
      }),
    );
    expect(ends.map(([step]) => step)).toEqual([0, 5, 5, 14, 8, 1, 1, 1, 1, 5]);
    expect(ends.filter(([, words]) => String(words).startsWith('Refused:'))).toHaveLength(2);
  });
});
