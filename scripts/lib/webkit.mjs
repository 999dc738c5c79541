// WebKit as GTK's browsers have it, the engine of Safari, driven by WebDriver. There is none on macOS or Windows.

import { Builder, Capabilities } from 'selenium-webdriver';
import { DriverService } from 'selenium-webdriver/remote/index.js';
import { startDisplay } from './display.mjs';
import { which } from './run.mjs';

/** The program that drives it, if there is one. */
export const webkitDriver = which('WebKitWebDriver');

/**
 * Starts it with one page, as large as the other browsers of the tests.
 *
 * @returns {Promise<{ driver: import('selenium-webdriver').WebDriver, stop: () => Promise<void> }>}
 */
export async function startWebKit() {
  if (webkitDriver === undefined) {
    throw new Error('There is no WebKitWebDriver on PATH: `npm run setup tests`.');
  }
  const display = await startDisplay();
  const service = new DriverService.Builder(webkitDriver)
    .setLoopback(true)
    .setEnvironment({ ...process.env, ...display.environment })
    .build();
  const end = async () => {
    await service.kill();
    display.stop();
  };
  try {
    const driver = await new Builder()
      .usingServer(await service.start(120_000)) // a busy machine takes its time
      .withCapabilities(new Capabilities({ browserName: 'MiniBrowser' }))
      .build();
    await driver.manage().setTimeouts({ script: 90_000 });
    await driver.manage().window().setRect({ x: 0, y: 0, width: 1280, height: 838 });
    const stop = async () => {
      try {
        await driver.quit();
      } finally {
        await end();
      }
    };
    return { driver, stop };
  } catch (error) {
    await end();
    throw error;
  }
}
