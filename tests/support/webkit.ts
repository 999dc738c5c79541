import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { WebDriver } from 'selenium-webdriver';
import { startWebKit } from '../../scripts/lib/webkit.mjs';
import { type Answer, type RunningServer, serve } from '../package/support/server.js';

/** Collects what a page complains of. WebDriver doesn't tell, so that it runs in the page, before all else. */
const COLLECTOR = `<script>
  {
    const complaints = (window.complaints = []);
    addEventListener('error', ({ message, target }) => complaints.push(message ?? target.outerHTML), true);
    addEventListener('unhandledrejection', ({ reason }) => complaints.push(String(reason)));
    for (const kind of ['error', 'warn']) {
      const { [kind]: print } = console;
      console[kind] = (...all) => {
        complaints.push(all.join(' '));
        print(...all);
      };
    }
  }
</script>`;

/** WebKit, and the pages that it opens, one after the other. */
export class WebKit {
  readonly #driver: WebDriver;
  readonly #stop: () => Promise<void>;
  readonly #servers: RunningServer[] = [];

  private constructor(driver: WebDriver, stop: () => Promise<void>) {
    this.#driver = driver;
    this.#stop = stop;
  }

  static async start(): Promise<WebKit> {
    const { driver, stop } = await startWebKit();
    return new WebKit(driver, stop);
  }

  /** Serves a folder, and opens the page at its root: the one that is given, or its `index.html`. */
  async open(folder: string, page?: string): Promise<WebKitPage> {
    const html = page ?? readFileSync(join(folder, 'index.html'), 'utf8');
    const body = html.replace(/<!doctype html>(\s*<html[^>]*>\s*<head>)?/i, `$&${COLLECTOR}`);
    const answers: Record<string, Answer> = {
      '/index.html': { body, type: 'text/html; charset=utf-8' },
    };
    const server = await serve(folder, { answers });
    this.#servers.push(server);
    await this.#driver.get(server.address);
    return new WebKitPage(this.#driver);
  }

  async close(): Promise<void> {
    await this.#stop();
    await Promise.all(this.#servers.map((server) => server.close()));
  }
}

/** The page that is open. */
export class WebKitPage {
  readonly driver: WebDriver;

  constructor(driver: WebDriver) {
    this.driver = driver;
  }

  /** What the expression is, as the page sees it. */
  evaluate<T>(expression: string): Promise<T> {
    return this.driver.executeScript(`return (${expression})`);
  }

  /** Waits until the expression holds in the page. */
  async until(expression: string): Promise<void> {
    await this.driver.wait(() => this.evaluate<unknown>(expression), 90_000, `until ${expression}`);
  }

  /** Errors and warnings in the console, uncaught errors, and what could not be loaded. */
  complaints(): Promise<string[]> {
    return this.evaluate('window.complaints');
  }

  /** A picture of it, as PNG. */
  async screenshot(): Promise<Buffer> {
    await this.driver.executeAsyncScript(
      'const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(() => done()))',
    );
    return Buffer.from(await this.driver.takeScreenshot(), 'base64');
  }
}
