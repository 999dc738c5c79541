// Takes a picture of every state of the explorer, of the examples and of the course, in wide and narrow
// windows, light and dark, to be looked at one by one: `node scripts/screenshots.mjs [state …] [window …]`
// writes to build/screenshots/states.

import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { argv } from 'node:process';
import { chromium } from 'playwright-core';
import setup, { cleanUp } from '../tests/browser/support/setup.mjs';
import { projects, serveProject, serveRepository } from './lib/example-servers.mjs';
import { states } from './lib/explorer-states.mjs';
import { pageStates } from './lib/page-states.mjs';
import { asProgram, Failure, root } from './lib/run.mjs';

const WINDOWS = {
  '1280-light': { width: 1280, height: 800, colorScheme: 'light' },
  '1280-dark': { width: 1280, height: 800, colorScheme: 'dark' },
  '390-light': { width: 390, height: 844, colorScheme: 'light' },
  '390-dark': { width: 390, height: 844, colorScheme: 'dark' },
};

const folder = join(root, 'build/screenshots/states');

await asProgram(async () => {
  const asked = argv.slice(2);
  const all = { ...states, ...pageStates };
  const unknown = asked.filter((name) => !(name in all || name in WINDOWS));
  if (unknown.length > 0) {
    const known = Object.keys(all).join(', ');
    throw new Failure(`There is no state or window ${unknown}: the states are ${known}.`);
  }
  const names = chosen(Object.keys(all), asked);
  mkdirSync(folder, { recursive: true });
  await setup({ maxWorkers: 1 });
  const shared = JSON.parse(process.env.HALFEDGE_EXPLORER);
  const browser = await chromium.connect(JSON.parse(process.env.HALFEDGE_CHROMIUM)[0]);
  try {
    for (const window of chosen(Object.keys(WINDOWS), asked)) {
      await photographExplorer(
        browser,
        shared.address,
        names.filter((name) => name in states),
        window,
      );
    }
    await photographPages(
      browser,
      names.filter((name) => name in pageStates),
      chosen(Object.keys(WINDOWS), asked),
    );
  } finally {
    await browser.close();
    await cleanUp();
  }
});

/** Those that are asked for by name; all if none is. */
function chosen(all, asked) {
  const found = all.filter((name) => asked.includes(name));
  return found.length > 0 ? found : all;
}

async function openPage(browser, window) {
  const { width, height, colorScheme } = WINDOWS[window];
  const context = await browser.newContext({
    viewport: { width, height },
    colorScheme,
    reducedMotion: 'reduce',
    ...(isNarrow(window) ? { hasTouch: true, isMobile: true, deviceScaleFactor: 2 } : {}),
  });
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  const page = await context.newPage();
  page.setDefaultTimeout(60_000);
  return page;
}

function isNarrow(window) {
  return WINDOWS[window].width < 760;
}

/** Takes a picture of a page, or of a part of it. */
async function photograph(target, name, window) {
  await target.screenshot({ path: join(folder, `${name}-${window}.png`) });
  console.log(`${name}-${window}`);
}

/** One window goes through all states by their links, each followed by what a user would do there. */
async function photographExplorer(browser, address, names, window) {
  if (names.length === 0) return;
  const page = await openPage(browser, window);
  await page.goto(address);
  await rest(page);
  for (const name of names) {
    const { link, aim, act, moves } = states[name];
    try {
      await reset(page, link);
      await rest(page);
      if (aim) await aimAtSelection(page);
      if (moves) await begin(page);
      await act?.(page, { narrow: isNarrow(window) });
      if (moves) await page.clock.runFor(moves);
      else await rest(page);
    } catch (error) {
      console.warn(`${name} in ${window}: ${error.message}`);
    }
    await photograph(page, name, window);
    if (moves) await end(page);
  }
  await page.context().close();
}

/** Stops the clock, so that a motion can be seen at a moment of it. */
async function begin(page) {
  await page.emulateMedia({ reducedMotion: 'no-preference' });
  await page.clock.install();
  await page.clock.pauseAt(Date.now() + 60_000);
}

async function end(page) {
  await page.clock.resume();
  await page.emulateMedia({ reducedMotion: 'reduce' });
}

/** Flies to what is selected, where that isn't in sight. */
async function aimAtSelection(page) {
  await page.keyboard.press('z');
  await rest(page);
}

/** As the page was in the beginning, but for the link that it follows: a page of its own takes long. */
async function reset(page, link = 'sample=bunny&select=v1224') {
  for (let i = 0; i < 3; i++) await page.keyboard.press('Escape');
  await page.click('[data-tab-button=circulate]');
  await page.mouse.move(0, 0);
  await page.evaluate(
    (hash) => {
      document.querySelector('.drop-target').hidden = true;
      document.querySelector('.busy').hidden = true;
      document.querySelector('.toast').hidden = true;
      // A link is followed only where it is another one.
      history.replaceState(null, '', location.pathname);
      location.hash = hash;
    },
    Object.entries({ labels: 'off:vhf', names: 'halfedge' })
      .filter(([setting]) => !link.includes(`${setting}=`))
      .reduce((hash, [setting, value]) => `${hash}&${setting}=${value}`, link),
  );
  await page.waitForTimeout(100);
}

/** Waits until the picture is drawn and nothing moves. */
async function rest(page) {
  await page.evaluate(() => document.fonts.ready);
  await page.waitForSelector('html[data-state=ready], html[data-state=error]');
  await page.waitForTimeout(150);
}

/** Examples and the course, each in a page of its own. */
async function photographPages(browser, names, windows) {
  if (names.length === 0) return;
  const repository = await serveRepository();
  const servers = { repository };
  for (const name of projects) servers[name] = await serveProject(name);
  try {
    for (const name of names) {
      const { project, path = '', ready, act, each } = pageStates[name];
      const [address] = servers[project ?? 'repository'].resolvedUrls.local;
      for (const window of windows) {
        const page = await openPage(browser, window);
        await page.goto(address + path);
        await page.waitForSelector(ready);
        await page.waitForTimeout(2000);
        await act?.(page);
        await page.waitForTimeout(500);
        await photograph(page, name, window);
        if (each) await photographEach(page.locator(each), name, window);
        await page.context().close();
      }
    }
  } finally {
    for (const server of Object.values(servers)) await server.close();
  }
}

async function photographEach(parts, name, window) {
  for (const [i, part] of (await parts.all()).entries()) {
    await part.scrollIntoViewIfNeeded();
    await part.evaluate((element) => element.ready?.());
    await part.page().waitForTimeout(300);
    await photograph(part, `${name}-${i + 1}`, window);
  }
}
