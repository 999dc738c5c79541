// Takes a picture of every state of the explorer, in wide and narrow windows, light and dark, to be looked
// at one by one: `node scripts/screenshots.mjs [state …] [window …]` writes to build/screenshots/states.

import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { argv } from 'node:process';
import { chromium } from 'playwright-core';
import setup, { cleanUp } from '../tests/browser/support/setup.mjs';
import { states } from './lib/explorer-states.mjs';
import { asProgram, Failure, root } from './lib/run.mjs';

const WINDOWS = [
  ['1280-light', { width: 1280, height: 800 }, 'light'],
  ['1280-dark', { width: 1280, height: 800 }, 'dark'],
  ['390-light', { width: 390, height: 844 }, 'light'],
  ['390-dark', { width: 390, height: 844 }, 'dark'],
];

const folder = join(root, 'build/screenshots/states');

await asProgram(async () => {
  const asked = argv.slice(2);
  const windows = chosen(WINDOWS, asked, ([name]) => name);
  const names = chosen(Object.keys(states), asked, (name) => name);
  const unknown = asked.filter((name) => !(name in states || WINDOWS.some(([it]) => it === name)));
  if (unknown.length > 0) {
    throw new Failure(
      `There is no state or window ${unknown}: the states are ${Object.keys(states).join(', ')}.`,
    );
  }
  mkdirSync(folder, { recursive: true });
  await setup();
  const shared = JSON.parse(process.env.HALFEDGE_EXPLORER);
  const browser = await chromium.connect(shared.browser);
  try {
    for (const each of windows) await photograph(browser, shared.address, names, each);
  } finally {
    await browser.close();
    await cleanUp();
  }
});

/** Those that are asked for by name; all if none is. */
function chosen(all, asked, nameOf) {
  const found = all.filter((each) => asked.includes(nameOf(each)));
  return found.length > 0 ? found : all;
}

/** One window goes through all states by their links, each followed by what a user would do there. */
async function photograph(browser, address, names, [window, viewport, colorScheme]) {
  const narrow = viewport.width < 760;
  const context = await browser.newContext({
    viewport,
    colorScheme,
    reducedMotion: 'reduce',
    ...(narrow ? { hasTouch: true, isMobile: true, deviceScaleFactor: 2 } : {}),
  });
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  const page = await context.newPage();
  page.setDefaultTimeout(60_000);
  await page.goto(address);
  await rest(page);
  for (const name of names) {
    const { link, act } = states[name];
    try {
      await reset(page, link);
      await rest(page);
      await act?.(page, { narrow });
      await rest(page);
    } catch (error) {
      console.warn(`${name} in ${window}: ${error.message}`);
    }
    await page.screenshot({ path: join(folder, `${name}-${window}.png`) });
    console.log(`${name}-${window}`);
  }
  await context.close();
}

/** As the page was in the beginning, but for the link that it follows: a page of its own takes long. */
async function reset(page, link = 'sample=bunny&select=v1224') {
  for (let i = 0; i < 3; i++) await page.keyboard.press('Escape');
  await page.mouse.move(0, 0);
  await page.click('[data-tab-button=circulate]');
  await page.evaluate(
    (hash) => {
      document.querySelector('.drop-target').hidden = true;
      document.querySelector('.busy').hidden = true;
      document.querySelector('.toast').hidden = true;
      location.hash = hash;
    },
    `${link}&${link.includes('labels') ? '' : 'labels=off:vhf'}`,
  );
  await page.waitForTimeout(100);
}

/** Waits until the picture is drawn and nothing moves. */
async function rest(page) {
  await page.evaluate(() => document.fonts.ready);
  await page.waitForSelector('html[data-state=ready], html[data-state=error]');
  await page.waitForTimeout(150);
}
