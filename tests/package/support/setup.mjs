// Before the suite: packs the package, installs the tarball into an empty folder and starts
// Chromium, once for all test files. Whatever is made lies in one temporary folder outside of the
// repository, so that nothing can be found there but what was installed.

import { existsSync, mkdirSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { capture } from '../../../scripts/lib/run.mjs';
import { SWIFTSHADER, startChromium, stopChromium } from '../../support/chromium.mjs';

let folder;

export default async function setup({ maxWorkers }) {
  try {
    folder = mkdtempSync(join(tmpdir(), 'halfedge-package-'));
    refuseOuterPackages();
    const { filename, files } = await pack();
    const tarball = join(folder, filename);
    await install(tarball);
    // Pictures of WebGL are compared with those of WebGPU, so the same program has to draw both.
    await startChromium(maxWorkers, [SWIFTSHADER]);
    process.env.HALFEDGE_PACKED = JSON.stringify({
      folder,
      tarball,
      files: files.map((file) => file.path).sort(),
    });
  } catch (error) {
    await cleanUp();
    throw error;
  }
}

export async function cleanUp() {
  await stopChromium();
  if (folder) rmSync(folder, { recursive: true, force: true });
}

/** Node would find packages of any folder above, and what is missing would not be missed. */
function refuseOuterPackages() {
  for (let above = folder; above !== dirname(above); above = dirname(above)) {
    const packages = join(dirname(above), 'node_modules');
    if (existsSync(packages)) {
      throw new Error(
        `'${packages}' would be seen by the packages' tests: they need a temporary folder (TMPDIR) without.`,
      );
    }
  }
}

async function pack() {
  const report = await npm(['pack', '--json', '--loglevel=error', '--pack-destination', folder]);
  return JSON.parse(report)[0];
}

/** Offline and with an empty cache: the package needs nothing but itself. */
async function install(tarball) {
  const installed = join(folder, 'installed');
  mkdirSync(installed);
  await npm(['install', tarball, '--prefix', installed, '--offline', '--no-audit', '--no-fund']);
}

async function npm(args) {
  // Run by `npm test`, npm would take its folders and settings from the outer npm.
  const outer = Object.keys(process.env).filter((name) => name.startsWith('npm_'));
  const env = Object.fromEntries(outer.map((name) => [name, undefined]));
  const cache = ['--cache', join(folder, 'npm-cache')];
  const { ok, output, printed } = await capture('npm', [...args, ...cache], { env });
  if (!ok) throw new Error(`npm ${args.join(' ')} failed:\n${output}`);
  return printed;
}
