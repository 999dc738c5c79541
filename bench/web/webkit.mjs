// The benchmark in WebKit, the one of the system.

import { startWebKit } from '../../scripts/lib/webkit.mjs';
import { withServer } from './server.mjs';

/** How long it may take, in milliseconds. */
const MOST = 30 * 60_000;

export async function inWebKit({ say, ...options }) {
  const { driver, stop } = await startWebKit();
  try {
    return await withServer(async (address) => {
      await driver.manage().setTimeouts({ script: MOST });
      await driver.get(`${address}/bench/web/page.html`);
      await driver.wait(() => driver.executeScript('return "bench" in globalThis'), 60_000);
      const told = await driver.executeAsyncScript(
        `const [options, done] = arguments;
        bench(options).then((measured) => done({ measured }), (error) => done({ error: String(error) }));`,
        options,
      );
      if (told.error) throw new Error(told.error);
      const version = (await driver.getCapabilities()).getBrowserVersion();
      return { engine: `WebKit ${version}`, ...told.measured };
    });
  } finally {
    await stop();
  }
}
