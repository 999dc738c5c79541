// The browsers that the suites drive by playwright-core: Debian's Chromium, one for each of Jest's workers.
// In one browser the pages of two test files would wait for the same process that draws, and share a
// clipboard.

import { chromium } from 'playwright-core';
import { which } from '../../scripts/lib/run.mjs';

/**
 * What Chromium is to leave. Each window loads a page with suggestions for the address bar, out of sight, which takes
 * it as long as the explorer: the first two. The last list of a command line counts, so it has what playwright-core
 * would have in its own, as far as tests can notice.
 */
const LEFT_OUT = [
  ...['WebUIOmniboxPopup', 'WebUIOmniboxAimPopup'],
  ...['AimEnabled', 'AvoidUnnecessaryBeforeUnloadCheckSync', 'DestroyProfileOnBrowserClose'],
  ...['HttpsFirstBalancedModeAutoEnable', 'HttpsUpgrades', 'LensOverlay', 'MediaRouter'],
  ...['NetworkTimeServiceQuerying', 'OptimizationHints', 'PaintHolding', 'PreconnectToSearch'],
  ...['AvoidCorsURLLoaderRestartOnRedirect', 'ThirdPartyStoragePartitioning'],
];

// WebGL in software, so that it runs where there is no graphics card.

/** As WebGPU is drawn, too. */
export const SWIFTSHADER = {
  args: ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  env: {},
};

/** Four files of the explorer's suite take four fifths of the time with it. It may not be installed. */
const MESA = {
  args: ['--use-angle=gl-egl', '--ignore-gpu-blocklist'],
  env: { LIBGL_ALWAYS_SOFTWARE: '1' },
};

let browsers = [];

/** Starts so many browsers, for connection.ts to connect to, with the first of `drawing` that works. */
export async function startChromium(workers, drawing = [MESA, SWIFTSHADER]) {
  const executablePath = which('chromium') ?? which('chromium-browser');
  if (!executablePath) throw new Error('There is no Chromium on PATH: `npm run setup tests`.');
  const quiet = ['background-networking', 'component-update', 'sync', 'quic'];
  const args = ['--no-sandbox', '--no-first-run', ...quiet.map((name) => `--disable-${name}`)];
  args.push('--enable-unsafe-webgpu', '--use-webgpu-adapter=swiftshader');
  // Half of the processors' time would go into what no test looks at: putting the page together by the
  // same emulated graphics card, and four samples to a pixel.
  args.push('--disable-gpu-compositing', '--webgl-antialiasing-mode=none');
  args.push(`--disable-features=${LEFT_OUT.join(',')}`);
  for (const webgl of drawing) {
    for (let i = 0; i < workers; ++i) {
      const env = { ...process.env, ...webgl.env };
      const options = { executablePath, args: [...args, ...webgl.args], env };
      browsers.push(await chromium.launchServer(options));
    }
    if (await hasWebGL(browsers[0])) break;
    await stopChromium();
  }
  if (browsers.length === 0) throw new Error('Chromium draws no WebGL here.');
  // Tests run in other realms, or processes: the environment is what they share with this one.
  const endpoints = browsers.map((browser) => browser.wsEndpoint());
  process.env.HALFEDGE_CHROMIUM = JSON.stringify(endpoints);
}

/** Whether pages in it can draw. */
async function hasWebGL(server) {
  const browser = await chromium.connect(server.wsEndpoint());
  try {
    const page = await browser.newPage();
    return await page.evaluate(
      () => document.createElement('canvas').getContext('webgl2') !== null,
    );
  } finally {
    await browser.close();
  }
}

/** Ends those that were started. */
export async function stopChromium() {
  await Promise.all(browsers.map((browser) => browser.close()));
  browsers = [];
}
