// Before the suite: builds the explorer, serves it and starts Chromium, once for all test files.

import { join } from 'node:path';
import { build, preview } from 'vite';
import { root as repository } from '../../../scripts/lib/run.mjs';
import { launchChromium } from '../../support/chromium.mjs';

let server;
let browser;

export default async function setup() {
  try {
    const root = join(repository, 'web/explorer');
    await build({ root, logLevel: 'warn' });
    server = await preview({ root, logLevel: 'warn', preview: { port: 0, open: false } });
    browser = await launchChromium();
    // Tests run in other realms, or processes: the environment is what they share with this one.
    process.env.HALFEDGE_EXPLORER = JSON.stringify({
      address: server.resolvedUrls.local[0],
      browser: browser.wsEndpoint(),
      screenshots: join(repository, 'build/screenshots'),
    });
  } catch (error) {
    await cleanUp();
    throw error;
  }
}

export async function cleanUp() {
  await browser?.close();
  await server?.close();
}
