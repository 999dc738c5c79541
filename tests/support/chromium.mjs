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

let browsers = [];

/** Starts so many browsers, for connection.ts to connect to. */
export async function startChromium(workers) {
  const executablePath = which('chromium') ?? which('chromium-browser');
  if (!executablePath) throw new Error('There is no Chromium on PATH: `npm run setup tests`.');
  const quiet = ['background-networking', 'component-update', 'sync', 'quic'];
  const args = ['--no-sandbox', '--no-first-run', ...quiet.map((name) => `--disable-${name}`)];
  // WebGL in software: it runs where there is no graphics card.
  args.push('--use-angle=swiftshader', '--enable-unsafe-swiftshader');
  args.push('--enable-unsafe-webgpu', '--use-webgpu-adapter=swiftshader'); // and WebGPU
  // Half of the processors' time would go into what no test looks at: putting the page together by the
  // same emulated graphics card, and four samples to a pixel.
  args.push('--disable-gpu-compositing', '--webgl-antialiasing-mode=none');
  args.push(`--disable-features=${LEFT_OUT.join(',')}`);
  for (let i = 0; i < workers; ++i) {
    browsers.push(await chromium.launchServer({ executablePath, args }));
  }
  // Tests run in other realms, or processes: the environment is what they share with this one.
  const endpoints = browsers.map((browser) => browser.wsEndpoint());
  process.env.HALFEDGE_CHROMIUM = JSON.stringify(endpoints);
}

/** Ends those that were started. */
export async function stopChromium() {
  await Promise.all(browsers.map((browser) => browser.close()));
  browsers = [];
}
