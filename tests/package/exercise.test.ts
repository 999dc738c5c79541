import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { brotliCompressSync, gzipSync } from 'node:zlib';
import { disconnect, withPage } from './support/browser.js';
import { packed, project } from './support/project.js';
import { serve } from './support/server.js';

const STANDALONE = 'node_modules/halfedge/dist/exercise/standalone.js';

/** What a page with exercises loads at most, in bytes as gzip -9 leaves them: figures and the editor are in it. */
const BUDGET = 1_150_000;

afterAll(disconnect);

describe('Installed, the standalone file of exercises', () => {
  test('runs a program in a plain page, and asks for no other file', async () => {
    const folder = project('exercise', {
      'index.html': `<!doctype html><html lang="en"><title>Exercise</title><link rel="icon" href="data:,">
        <script type="module" src="./${STANDALONE}"></script>
        <halfedge-exercise task="valence"></halfedge-exercise>`,
    });
    const server = await serve(folder);
    try {
      await withPage(server.address, async ({ page, complaints, requests }) => {
        await page.waitForSelector('halfedge-exercise .cm-content');
        await page.click('halfedge-exercise [part~=run]');
        await page.waitForSelector('halfedge-exercise[state=failed]');
        expect(await page.textContent('halfedge-exercise [part=headline]')).toMatch(
          /expected 3\.$/,
        );
        const paths = requests.map((address) => address.replace(server.address, ''));
        expect(paths.filter((path) => !/^(data|blob):/.test(path))).toEqual(['', STANDALONE]);
        // Where there is no WebGL, three.js says so.
        expect(complaints.filter((text) => !/WebGL/.test(text))).toEqual([]);
      });
    } finally {
      await server.close();
    }
  });

  test('keeps within its budget', () => {
    const bytes = readFileSync(join(packed.folder, 'installed', STANDALONE));
    const gzip = gzipSync(bytes, { level: 9 }).length;
    const brotli = brotliCompressSync(bytes).length;
    console.info(`exercise/standalone.js: gzip ${gzip}, brotli ${brotli} bytes`);
    expect(gzip).toBeLessThanOrEqual(BUDGET);
  });
});
