import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { Builder, Capabilities, type WebDriver } from 'selenium-webdriver';
import { DriverService } from 'selenium-webdriver/remote';
import { which } from '../../scripts/lib/run.mjs';
import { type Answer, type RunningServer, serve } from '../package/support/server.js';
import { Display } from './display.js';

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

/**
 * WebKit as GTK's browsers have it, the engine of Safari, driven by WebDriver. It draws on a display of Xvfb. There
 * is no such browser on macOS or Windows.
 */
export class WebKit {
  readonly #driver: WebDriver;
  readonly #service: DriverService;
  readonly #display: Display | undefined;
  readonly #servers: RunningServer[] = [];

  private constructor(driver: WebDriver, service: DriverService, display: Display | undefined) {
    this.#driver = driver;
    this.#service = service;
    this.#display = display;
  }

  /** The program that drives it, if there is one. */
  static readonly program = which('WebKitWebDriver');

  static async start(): Promise<WebKit> {
    if (WebKit.program === undefined) throw new Error('There is no WebKitWebDriver on PATH.');
    const display = await Display.start();
    const service = new DriverService.Builder(WebKit.program)
      .setLoopback(true)
      .setEnvironment({ ...process.env, ...display?.environment } as Record<string, string>)
      .build();
    try {
      const driver = await new Builder()
        .usingServer(await service.start(120_000)) // a busy machine takes its time
        .withCapabilities(new Capabilities({ browserName: 'MiniBrowser' }))
        .build();
      await driver.manage().setTimeouts({ script: 90_000 });
      await driver.manage().window().setRect({ x: 0, y: 0, width: 1280, height: 838 });
      return new WebKit(driver, service, display);
    } catch (error) {
      await service.kill();
      display?.stop();
      throw error;
    }
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
    await this.#driver.quit();
    await this.#service.kill();
    this.#display?.stop();
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
