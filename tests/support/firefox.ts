import { type ChildProcess, spawn } from 'node:child_process';
import type { Readable } from 'node:stream';
import puppeteer, { type Browser, type Page } from 'puppeteer-core';
import { which } from '../../scripts/lib/run.mjs';

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
  readonly #display: ChildProcess | undefined;

  private constructor(browser: Browser, display: ChildProcess | undefined) {
    this.#browser = browser;
    this.#display = display;
  }

  static async start(): Promise<Firefox> {
    const executablePath = which('firefox-esr') ?? which('firefox');
    if (!executablePath) throw new Error('There is no Firefox on PATH: `npm run setup tests`.');
    const xvfb = which('Xvfb');
    const screen = xvfb === undefined ? undefined : await startDisplay(xvfb);
    try {
      const browser = await puppeteer.launch({
        browser: 'firefox',
        executablePath,
        headless: screen === undefined,
        defaultViewport: { width: 1280, height: 800 },
        timeout: 120_000, // a busy machine takes its time
        env: {
          ...process.env,
          ...(screen && { DISPLAY: screen.name, LIBGL_ALWAYS_SOFTWARE: '1' }),
        },
      });
      return new Firefox(browser, screen?.display);
    } catch (error) {
      screen?.display.kill();
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
    this.#display?.kill();
  }
}

/** Starts a display without a screen, at the first number that is free. */
async function startDisplay(xvfb: string): Promise<{ display: ChildProcess; name: string }> {
  const args = ['-displayfd', '3', '-screen', '0', '1400x1000x24', '-nolisten', 'tcp'];
  const display = spawn(xvfb, args, { stdio: ['ignore', 'ignore', 'ignore', 'pipe'] });
  const name = await new Promise<string>((resolve, reject) => {
    display.on('error', reject);
    display.on('close', (status) => reject(new Error(`Xvfb ended (${status}).`)));
    (display.stdio[3] as Readable).once('data', (number) => resolve(`:${String(number).trim()}`));
  });
  return { display, name };
}
