import type { Page } from 'playwright-core';
import { collectComplaints, warnOfReadPixels } from '../../support/complaints.js';
import { connect } from '../../support/connection.js';

export interface TabSettings {
  readonly width?: number;
  readonly height?: number;
  readonly dark?: boolean;
  readonly motion?: boolean;
  /** A telephone: touch, and two device pixels to the CSS pixel. */
  readonly phone?: boolean;
}

/** Scripts that run before those of each page in a tab. They stay as long as the tab, so they have a name. */
export interface Preparation {
  readonly name: string;
  readonly prepare?: (page: Page) => Promise<void>;
}

/** Tabs that the tests of this file have left, by what can't be changed any more. */
const left = new Map<string, Tab[]>();

/**
 * A tab of a browser without a past. To open one takes as long as what is shown in it, so a test goes on in one that
 * another test has left, if there is any.
 */
export class Tab {
  readonly page: Page;
  /** Errors and warnings in the console, uncaught errors and failed requests. */
  complaints: string[] = [];
  readonly #kind: string;

  private constructor(page: Page, kind: string) {
    this.page = page;
    this.#kind = kind;
  }

  static async open(settings: TabSettings, { name, prepare }: Preparation): Promise<Tab> {
    const { width = 1280, height = 800, dark = false, motion = false, phone = false } = settings;
    const viewport = { width, height };
    const media = {
      colorScheme: dark ? 'dark' : 'light',
      reducedMotion: motion ? 'no-preference' : 'reduce',
    } as const;
    const kind = `${name}${phone ? ' on a telephone' : ''}`;
    let tab = left.get(kind)?.pop();
    if (tab) {
      await tab.page.setViewportSize(viewport);
      await tab.page.emulateMedia({ ...media, media: null, forcedColors: null, contrast: null });
    } else {
      const context = await (await connect()).newContext({
        viewport,
        ...media,
        ...(phone ? { hasTouch: true, isMobile: true, deviceScaleFactor: 2 } : {}),
      });
      context.setDefaultTimeout(90_000); // a busy machine takes its time
      await context.grantPermissions(['clipboard-read', 'clipboard-write']);
      tab = new Tab(await context.newPage(), kind);
      await warnOfReadPixels(tab.page);
      await prepare?.(tab.page);
    }
    tab.complaints = collectComplaints(tab.page);
    return tab;
  }

  /** Leaves the page, and the tab to the next test. */
  async leave(): Promise<void> {
    const { page } = this;
    page.removeAllListeners();
    await page.unrouteAll();
    await page.evaluate(() => localStorage.clear());
    await page.goto('about:blank');
    left.set(this.#kind, [...(left.get(this.#kind) ?? []), this]);
  }

  /** Closes it: what a test has done to it can't be undone. */
  close(): Promise<void> {
    return this.page.context().close();
  }
}
