import { disconnect } from './support/browser.js';
import { gzippedSize, tryStandalone } from './support/standalone.js';

/** What a page with exercises loads at most, in bytes as gzip -9 leaves them: figures and the editor are in it. */
const BUDGET = 1_150_000;

afterAll(disconnect);

describe('Installed, the standalone file of exercises', () => {
  test('runs a program in a plain page, and asks for no other file', async () => {
    const valence = '<halfedge-exercise task="valence"></halfedge-exercise>';
    await tryStandalone('exercise', valence, async (page) => {
      await page.waitForSelector('halfedge-exercise .cm-content');
      await page.click('halfedge-exercise [part~=run]');
      await page.waitForSelector('halfedge-exercise[state=failed]');
      const headline = await page.textContent('halfedge-exercise [part=headline]');
      expect(headline).toMatch(/expected 3\.$/);
    });
  });

  test('keeps within its budget', () => {
    expect(gzippedSize('exercise')).toBeLessThanOrEqual(BUDGET);
  });
});
