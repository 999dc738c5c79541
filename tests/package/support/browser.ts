import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { setTimeout as pause } from 'node:timers/promises';
import type { Page } from 'playwright-core';
import { root } from '../../../scripts/lib/run.mjs';
import { collectComplaints, warnOfReadPixels } from '../../support/complaints.js';
import { connect } from '../../support/connection.js';

export { disconnect } from '../../support/connection.js';

/** How long something is waited for, in milliseconds: a busy machine takes its time. */
const PATIENCE = 60_000;

/** A page, and what the browser tells of it as it goes. */
interface Watched {
  page: Page;
  /** Errors and warnings in the console, uncaught errors, and requests that failed. */
  complaints: string[];
  /** All lines in the console. */
  lines: string[];
  /** The addresses requested. */
  requests: string[];
}

/**
 * Opens a page in a fresh profile and waits until it has a title, whatever it complains of before. One that gets none
 * within a minute has the title ''.
 */
export async function visit(address: string) {
  return withPage(address, async ({ page, complaints, requests }) => {
    let title = '';
    // Playwright's own way to wait for something in a page needs a policy that allows eval.
    for (const end = performance.now() + PATIENCE; title === '' && performance.now() < end; ) {
      await pause(20);
      title = await page.title();
    }
    return { title, complaints, requests };
  });
}

/** What a page says, whatever complaints there are in the console. */
export async function titleOf(address: string): Promise<string> {
  return withPage(address, async ({ page }) => {
    await page.waitForFunction(() => document.title !== '');
    return page.title();
  });
}

/** Opens a page in a fresh profile for as long as `use` runs. */
export async function withPage<T>(
  address: string,
  use: (watched: Watched) => Promise<T>,
): Promise<T> {
  const context = await (await connect()).newContext();
  context.setDefaultTimeout(PATIENCE);
  try {
    const page = await context.newPage();
    const complaints = collectComplaints(page);
    const lines: string[] = [];
    const requests: string[] = [];
    page.on('console', (message) => lines.push(message.text()));
    await warnOfReadPixels(page);
    page.on('request', (request) => requests.push(request.url()));
    await page.goto(address);
    return await use({ page, complaints, lines, requests });
  } finally {
    await context.close();
  }
}

/** Keeps pictures of a page among the artefacts: on a desktop and a telephone, light and dark. */
export async function screenshots(page: Page, name: string): Promise<void> {
  const folder = join(root, 'build/screenshots');
  mkdirSync(folder, { recursive: true });
  const sizes = [
    [1280, 800],
    [390, 844],
  ];
  for (const [width, height] of sizes) {
    await page.setViewportSize({ width, height });
    for (const colorScheme of ['light', 'dark'] as const) {
      await page.emulateMedia({ colorScheme });
      await pause(300); // what follows the size or the scheme draws again
      await page.screenshot({ path: join(folder, `${name}-${width}-${colorScheme}.png`) });
    }
  }
}
