// Before the suite: builds the explorer, serves it and starts Chromium, once for all test files.

import { join } from 'node:path';
import { build, preview } from 'vite';
import { root as repository } from '../../../scripts/lib/run.mjs';
import { startChromium, stopChromium } from '../../support/chromium.mjs';

let server;

export default async function setup({ maxWorkers }) {
  try {
    const root = join(repository, 'web/explorer');
    await build({ root, logLevel: 'warn' });
    server = await preview({ root, logLevel: 'warn', preview: { port: 0, open: false } });
    await startChromium(maxWorkers);
    process.env.HALFEDGE_EXPLORER = JSON.stringify({
      address: server.resolvedUrls.local[0],
      screenshots: join(repository, 'build/screenshots'),
    });
  } catch (error) {
    await cleanUp();
    throw error;
  }
}

export async function cleanUp() {
  await stopChromium();
  await server?.close();
}
