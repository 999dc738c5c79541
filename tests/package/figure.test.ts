import { disconnect } from './support/browser.js';
import { gzippedSize, tryStandalone } from './support/standalone.js';

/** What a page with figures loads at most, in bytes as gzip -9 leaves them: three.js and the core are in it. */
const BUDGET = 850_000;

afterAll(disconnect);

describe('Installed, the standalone file of figures', () => {
  test('makes a figure in a plain page, and asks for no other file', async () => {
    const cube =
      '<halfedge-figure loading="eager" src="shape:cube" select="f0" query="faceVertices" step="2" controls></halfedge-figure>';
    await tryStandalone('figure', cube, async (page) => {
      await page.waitForSelector('halfedge-figure[state=ready][step="2"]');
      expect(await page.textContent('halfedge-figure [part=sentence]')).toContain('→ vertex');
    });
  });

  test('keeps within its budget', () => {
    expect(gzippedSize('figure')).toBeLessThanOrEqual(BUDGET);
  });
});
