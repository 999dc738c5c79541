import puppeteer, { type Browser, type Page } from 'puppeteer-core';
import { startDisplay } from '../../scripts/lib/display.mjs';
import { which } from '../../scripts/lib/run.mjs';

type Display = Awaited<ReturnType<typeof startDisplay>>;

/** A tab, and what the browser complains of in it: errors and warnings in the console, uncaught errors. */
export interface FirefoxTab {
  readonly page: Page;
  readonly complaints: string[];
}

/**
 * Debian's Firefox, driven by WebDriver BiDi. Without a screen Firefox has no WebGL on Linux, whatever its
 * preferences: it draws in software, on a display of Xvfb. Elsewhere it runs headless.
 */
export class Firefox {
  readonly #browser: Browser;
  readonly #display: Display;

  private constructor(browser: Browser, display: Display) {
    this.#browser = browser;
    this.#display = display;
  }

  static async start(): Promise<Firefox> {
    const executablePath = which('firefox-esr') ?? which('firefox');
    if (!executablePath) throw new Error('There is no Firefox on PATH: `npm run setup tests`.');
    const display = await startDisplay();
    try {
      const browser = await puppeteer.launch({
        browser: 'firefox',
        executablePath,
        headless: display.environment.DISPLAY === undefined,
        defaultViewport: { width: 1280, height: 800 },
        timeout: 120_000, // a busy machine takes its time
        env: { ...process.env, ...display.environment },
      });
      return new Firefox(browser, display);
    } catch (error) {
      display.stop();
      throw error;
    }
  }

  /** Opens a page. */
  async open(address: string): Promise<FirefoxTab> {
    const page = await this.#browser.newPage();
    page.setDefaultTimeout(90_000);
    const complaints: string[] = [];
    page.on('console', (message) => {
      if (['error', 'warn'].includes(message.type())) complaints.push(message.text());
    });
    page.on('pageerror', (error) => complaints.push(String(error)));
    page.on('requestfailed', (it) => complaints.push(`${it.url()}: ${it.failure()?.errorText}`));
    await page.goto(address);
    return { page, complaints };
  }

  async close(): Promise<void> {
    await this.#browser.close();
    this.#display.stop();
  }
}
