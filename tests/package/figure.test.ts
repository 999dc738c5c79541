import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { brotliCompressSync, gzipSync } from 'node:zlib';
import { disconnect, withPage } from './support/browser.js';
import { packed, project } from './support/project.js';
import { serve } from './support/server.js';

const STANDALONE = 'node_modules/halfedge/dist/figure/standalone.js';

/** What a page with figures loads at most, in bytes as gzip -9 leaves them: three.js and the core are in it. */
const BUDGET = 850_000;

afterAll(disconnect);

describe('Installed, the standalone file of figures', () => {
  test('makes a figure in a plain page, and asks for no other file', async () => {
    const folder = project('figure', {
      'index.html': `<!doctype html><html lang="en"><title>Figure</title><link rel="icon" href="data:,">
        <script type="module" src="./${STANDALONE}"></script>
        <halfedge-figure loading="eager" src="shape:cube" select="f0" query="faceVertices" step="2" controls></halfedge-figure>`,
    });
    const server = await serve(folder);
    try {
      await withPage(server.address, async ({ page, complaints, requests }) => {
        await page.waitForSelector('halfedge-figure[state=ready][step="2"]');
        expect(await page.textContent('halfedge-figure [part=sentence]')).toContain('→ vertex');
        const paths = requests.map((address) => address.replace(server.address, ''));
        expect(paths.filter((path) => !path.startsWith('data:'))).toEqual(['', STANDALONE]);
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
    console.info(`figure/standalone.js: gzip ${gzip}, brotli ${brotli} bytes`);
    expect(gzip).toBeLessThanOrEqual(BUDGET);
  });
});
