import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { brotliCompressSync, gzipSync } from 'node:zlib';
import type { Page } from 'playwright-core';
import { withPage } from './browser.js';
import { packed, project } from './project.js';
import { serve } from './server.js';

type Element = 'figure' | 'exercise';

const fileOf = (element: Element) => `node_modules/halfedge/dist/${element}/standalone.js`;

/** Opens a plain page with an element, which may ask for no file but that of the element. */
export async function tryStandalone(
  element: Element,
  body: string,
  use: (page: Page) => Promise<void>,
): Promise<void> {
  const script = fileOf(element);
  const folder = project(element, {
    'index.html': `<!doctype html><html lang="en"><title>${element}</title><link rel="icon" href="data:,">
      <script type="module" src="./${script}"></script>
      ${body}`,
  });
  const server = await serve(folder);
  try {
    await withPage(server.address, async ({ page, complaints, requests }) => {
      await use(page);
      const paths = requests.map((address) => address.replace(server.address, ''));
      expect(paths.filter((path) => !/^(data|blob):/.test(path))).toEqual(['', script]);
      // Where there is no WebGL, three.js says so.
      expect(complaints.filter((text) => !/WebGL/.test(text))).toEqual([]);
    });
  } finally {
    await server.close();
  }
}

/** How many bytes gzip -9 leaves of the file; said, with those of brotli. */
export function gzippedSize(element: Element): number {
  const bytes = readFileSync(join(packed.folder, 'installed', fileOf(element)));
  const gzip = gzipSync(bytes, { level: 9 }).length;
  const brotli = brotliCompressSync(bytes).length;
  console.info(`${element}/standalone.js: gzip ${gzip}, brotli ${brotli} bytes`);
  return gzip;
}
