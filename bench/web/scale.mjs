// `npm run bench:scale`: a mesh of ten million triangles in Node and in Chromium, with times and memory,
// and what happens past the 4 GiB of WebAssembly. Prints Markdown.
//   --quick   a hundredth of it, and no limit, to see whether it works
//   --write   keeps the tables in bench/README.md

import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { argv } from 'node:process';
import { fileURLToPath } from 'node:url';
import { withChromium } from './chromium.mjs';
import { keepReport } from './readme.mjs';

const quick = argv.includes('--quick');
/** Ten million triangles; sixty million, whose halfedges and input exceed 4 GiB together. */
const [side, largerSide] = quick ? [224] : [2236, 5478];
const steps = fileURLToPath(new URL('scale-steps.mjs', import.meta.url));

const engines = [inNode(), await inChromium()];
const machine = `${cpus()[0].model.trim()}, ${cpus().length} processors.`;
const report = [machine, stepTable(engines), ...(quick ? [] : [limits(engines)])].join('\n\n');
console.log(report);
if (argv.includes('--write')) keepReport('npm run bench:scale', report);

/** In a process of its own, whose memory then is what the steps needed. */
function inNode() {
  const program = `
    import { HalfedgeMesh, init } from 'halfedge';
    import { core } from './dist/loader.js';
    import { runIntoTheLimit, runSteps } from ${JSON.stringify(steps)};
    await init();
    const measured = runSteps({ HalfedgeMesh, core }, ${side});
    const resident = 1024 * process.resourceUsage().maxRSS;
    const limit = ${quick} ? undefined : runIntoTheLimit({ HalfedgeMesh, core }, ${side}, ${largerSide});
    console.log(JSON.stringify({ ...measured, resident, limit }));`;
  const cwd = fileURLToPath(new URL('../..', import.meta.url));
  const options = ['--input-type=module', '--eval', program];
  const output = execFileSync(process.execPath, options, { cwd, encoding: 'utf8' });
  return { engine: `Node ${process.version.slice(1)}`, ...JSON.parse(output) };
}

function inChromium() {
  return withChromium(async (browser, address) => {
    const page = await browser.newPage();
    await page.goto(`${address}/bench/web/blank.html`);
    const inPage = (task, ...sides) =>
      page.evaluate(
        async ([name, given]) => {
          const { HalfedgeMesh, init } = await import('/dist/index.js');
          const { core } = await import('/dist/loader.js');
          const tasks = await import('/bench/web/scale-steps.mjs');
          await init();
          return tasks[name]({ HalfedgeMesh, core }, ...given);
        },
        [task, sides],
      );
    const measured = await inPage('runSteps', side);
    const resident = await peakOfRenderers(browser);
    const limit = quick ? undefined : await inPage('runIntoTheLimit', side, largerSide);
    return { engine: `Chromium ${browser.version()}`, ...measured, resident, limit };
  });
}

/** The most memory that a page had, where the system tells: undefined elsewhere than on Linux. */
async function peakOfRenderers(browser) {
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  const peaks = processInfo
    .filter(({ type }) => type === 'renderer')
    .map(({ id }) => peakOfProcess(id));
  return Math.max(...peaks) || undefined;
}

function peakOfProcess(id) {
  try {
    const status = readFileSync(`/proc/${id}/status`, 'utf8');
    return 1024 * Number(/^VmHWM:\s+(\d+)/m.exec(status)[1]);
  } catch {
    return 0;
  }
}

function stepTable(engines) {
  const faces = count(engines[0].faces);
  const head = engines.flatMap(({ engine }) => [`${engine}, ms`, 'WebAssembly memory, MiB']);
  const rows = [
    [`a torus of ${faces} triangles`, ...head],
    ['---', ...head.map(() => '---:')],
    ...engines[0].steps.map(({ title }, i) => [
      title,
      ...engines.flatMap(({ steps }) => [count(steps[i].ms), mebibytes(steps[i].bytes)]),
    ]),
    [
      'most that the process had resident, MiB',
      ...engines.flatMap(({ resident }) => ['', resident ? mebibytes(resident) : '–']),
    ],
  ];
  return rows.map((cells) => `| ${cells.join(' | ')} |`).join('\n');
}

function limits(engines) {
  const larger = count(2 * largerSide ** 2);
  return engines
    .map(
      ({ engine, limit }) =>
        `${engine}, with ${limit.copies} copies of that mesh in ${mebibytes(limit.bytes)} MiB, asked for one more:\n` +
        `> ${limit.another}\n\nAsked for a mesh of ${larger} triangles:\n> ${limit.larger}`,
    )
    .join('\n\n');
}

function count(number) {
  return Math.round(number).toLocaleString('en-GB');
}

function mebibytes(bytes) {
  return count(bytes / 2 ** 20);
}
