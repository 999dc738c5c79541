// `npm run setup`: installs what this machine lacks to build (and, with `tests` or `bench`, to test
// or benchmark) the project: the system's packages on Debian and Ubuntu, then the npm packages.

import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { argv } from 'node:process';
import { emscriptenToolchain } from './lib/emscripten.mjs';
import { filesBelow } from './lib/files.mjs';
import { asProgram, capture, Failure, isProgram, root, run, which } from './lib/run.mjs';

const includeFolders = ['/usr/include', '/usr/local/include', '/opt/homebrew/include'];

const read = (name) => JSON.parse(readFileSync(join(root, name), 'utf8'));
const { major, minor } = read('CMakePresets.json').cmakeMinimumRequired;
const leastCMake = `${major}.${minor}`;

const onPath = (...names) => names.some((name) => which(name) !== undefined);
const header = (path) => includeFolders.some((folder) => existsSync(join(folder, path)));

/**
 * What is needed, for which purpose: how to see that it is there, Debian's package, and its name
 * in a sentence. An emsdk in the environment counts as Emscripten.
 */
const requirements = [
  need('build', 'Emscripten (an activated emsdk)', 'emscripten', () => emscriptenToolchain()),
  need('build', `CMake ${leastCMake} or newer`, 'cmake', hasCMake),
  need('build', 'Ninja', 'ninja-build', () => onPath('ninja', 'ninja-build')),
  need('build', 'fast_float', 'libfast-float-dev', hasFastFloat),
  need('tests', 'g++', 'g++', () => onPath('g++')),
  need('tests', 'clang', 'clang', () => onPath('clang++')),
  need('tests', "clang's sanitizers and fuzzer", 'libclang-rt-dev', hasSanitizers),
  need('tests', 'clang-format', 'clang-format', () => onPath('clang-format')),
  need('tests', 'clang-tidy', 'clang-tidy', () => onPath('clang-tidy')),
  need('tests', 'GoogleTest', 'libgtest-dev', () => header('gtest/gtest.h')),
  need('tests', 'OpenMesh', 'libopenmesh-dev', () =>
    header('OpenMesh/Core/Mesh/PolyConnectivity.hh'),
  ),
  need('tests', 'CGAL', 'libcgal-dev', () => header('CGAL/Polyhedron_3.h')),
  need('tests', 'Chromium', 'chromium', () => onPath('chromium', 'chromium-browser')),
  need('tests', 'Firefox', 'firefox-esr', () => onPath('firefox-esr', 'firefox')),
  need('tests', 'WebKit', 'webkit2gtk-driver', () => onPath('WebKitWebDriver') || !hasApt()),
  need('tests', 'Valgrind', 'valgrind', () => onPath('valgrind') || !hasApt()),
  need('tests', 'Xvfb', 'xvfb', () => onPath('Xvfb') || !hasApt()),
  need('bench', 'g++', 'g++', () => onPath('g++')),
  need('bench', 'Google Benchmark', 'libbenchmark-dev', () => header('benchmark/benchmark.h')),
  need('bench', 'OpenMesh', 'libopenmesh-dev', () =>
    header('OpenMesh/Core/Mesh/PolyConnectivity.hh'),
  ),
  need('bench', 'CGAL', 'libcgal-dev', () => header('CGAL/Surface_mesh.h')),
];

function need(purpose, title, aptPackage, found) {
  return { purpose, title, aptPackage, found };
}

/** An older one doesn't know presets, or not these. */
function hasCMake() {
  const [version] = /[\d.]+/.exec(printedBy('cmake', '--version')) ?? [];
  return version !== undefined && !isOlder(version, leastCMake);
}

/** What a program prints; nothing where there is none, or only what stands for it until it is installed. */
function printedBy(program, ...args) {
  const { stdout } = spawnSync(program, args, { encoding: 'utf8' });
  return stdout ?? '';
}

/** CMake downloads fast_float where there is no package of it, so it is asked for on Debian only. */
function hasFastFloat() {
  return process.env.HALFEDGE_FAST_FLOAT_DIR || header('fast_float/fast_float.h') || !hasApt();
}

/** Whether clang can link AddressSanitizer and libFuzzer, which Debian packs apart from it. */
function hasSanitizers() {
  const folder = printedBy('clang++', '-print-resource-dir').trim();
  if (folder === '') return false;
  const libraries = filesBelow(join(folder, 'lib')).map((path) => basename(path));
  return ['asan', 'fuzzer'].every((part) =>
    libraries.some((name) => name.startsWith(`libclang_rt.${part}`)),
  );
}

const hasApt = () => onPath('apt-get');

/** Makes the machine ready for the given purposes: 'build', 'tests', 'bench'. */
export async function setup(purposes = ['build']) {
  checkPurposes(purposes);
  checkSystem();
  checkNode();
  const missing = () => requirements.filter((it) => purposes.includes(it.purpose) && !it.found());
  const before = missing();
  if (before.length > 0) {
    if (!hasApt()) throw new Failure(`Install ${sentenceOf(before)}, then run this again.`);
    await installByApt(before);
    const after = missing();
    if (after.length > 0) {
      throw new Failure(
        `apt-get has run, but ${sentenceOf(after)} cannot be found on this machine.`,
      );
    }
  }
  await installNpmPackages();
}

function checkPurposes(purposes) {
  const known = [...new Set(requirements.map((it) => it.purpose))];
  const unknown = purposes.filter((purpose) => !known.includes(purpose));
  if (unknown.length > 0) {
    throw new Failure(`There is no purpose ${unknown}: the purposes are ${known.join(', ')}.`);
  }
}

/** Programs are found, and started, as Linux and macOS do it. */
function checkSystem() {
  if (process.platform !== 'win32') return;
  throw new Failure('The project is built and tested on Linux and macOS: on Windows, take WSL.');
}

/** What the tools of npm ask for, the pickiest first, and the package: an older Node fails later, and less clearly. */
function checkNode() {
  const { engines, devDependencies } = read('package.json');
  const { packages } = read('package-lock.json');
  const tools = ['vite', 'jest', ...Object.keys(devDependencies)].map((name) => {
    return [name, packages[`node_modules/${name}`]?.engines?.node];
  });
  for (const [name, range] of [...tools, ['halfedge', engines.node]]) {
    if (range === undefined || isInRange(process.versions.node, range)) continue;
    throw new Failure(
      `This is Node ${process.versions.node}, and ${name} needs ${range}: install a newer one.`,
    );
  }
}

/** Whether a version is in a range such as "^20.19.0 || >=22.12.0". */
function isInRange(version, range) {
  return range.split('||').some((part) => {
    const [, sign, least] = /^\s*(\^|>=|)\s*v?([\d.]+)/.exec(part) ?? [];
    if (least === undefined) return true; // it is said in another way: npm tells
    const isSameMajor = Number.parseInt(version, 10) === Number.parseInt(least, 10);
    return !isOlder(version, least) && (sign === '>=' || isSameMajor);
  });
}

const isOlder = (version, other) => other.localeCompare(version, 'en', { numeric: true }) > 0;

function sentenceOf(missing) {
  const titles = [...new Set(missing.map((it) => it.title))];
  const last = titles.pop();
  return titles.length > 0 ? `${titles.join(', ')} and ${last}` : last;
}

async function installByApt(missing) {
  const packages = [...new Set(missing.map((it) => it.aptPackage))];
  console.log(`Installing with apt-get: ${packages.join(' ')}`);
  await becomeRoot(packages);
  if ((await unknownToApt(packages)).length > 0) await apt(['update', '-qq']);
  const unknown = await unknownToApt(packages);
  if (unknown.length > 0) {
    const titles = sentenceOf(missing.filter((it) => unknown.includes(it.aptPackage)));
    throw new Failure(
      `apt-get has no ${unknown.join(', ')}: install ${titles} in another way, then run this again.`,
    );
  }
  const install = ['install', '-y', '-q', '--no-install-recommends', ...packages];
  try {
    await apt(install);
  } catch (error) {
    // The package lists may be older than the archive: renew them and try once more.
    if (!(error instanceof Failure)) throw error;
    await apt(['update', '-qq']);
    await apt(install);
  }
}

/** The packages of which apt's lists name no version; in a fresh container that is all. */
async function unknownToApt(packages) {
  const { output } = await capture('apt-cache', ['policy', ...packages], { env: { LC_ALL: 'C' } });
  const known = new Set();
  for (const [, name] of output.matchAll(/^(\S+):\n(?: .*\n)*? *Candidate: (?!\(none\))/gm)) {
    known.add(name);
  }
  return packages.filter((name) => !known.has(name));
}

const isRoot = () => process.getuid() === 0;

/** Sees that apt-get can run as root: sudo may be missing, or refuse, or have no terminal to ask on. */
async function becomeRoot(packages) {
  if (isRoot()) return;
  try {
    await run('sudo', ['true'], { input: 'inherit' });
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
    const command = `apt-get update && apt-get install ${packages.join(' ')}`;
    throw new Failure(`As root, run \`${command}\`, then run this again.`);
  }
}

/** Runs apt-get as root, by sudo where that is needed. */
async function apt(args) {
  // Through sudo, since it drops the environment of its caller.
  const command = ['env', 'DEBIAN_FRONTEND=noninteractive', 'apt-get', '-o', 'Dpkg::Use-Pty=0'];
  const [program, ...rest] = isRoot() ? command : ['sudo', ...command];
  await run(program, [...rest, ...args], { input: 'inherit' });
}

/** `npm ci`, unless node_modules was made from the package-lock.json of now. */
async function installNpmPackages() {
  const lock = readFileSync(join(root, 'package-lock.json'));
  const stamp = join(root, 'node_modules/.halfedge-lock');
  const digest = createHash('sha256').update(lock).digest('hex');
  if (existsSync(stamp) && readFileSync(stamp, 'utf8') === digest) return;
  console.log('Installing the npm packages (npm ci)');
  // Also with NODE_ENV=production, as many containers have it, and with settings that leave packages out.
  const all = ['dev', 'optional', 'peer'].map((kind) => `--include=${kind}`);
  await run('npm', ['ci', ...all, '--no-progress', '--loglevel=error']);
  writeFileSync(stamp, digest);
}

if (isProgram(import.meta.url)) {
  await asProgram(() => setup(['build', ...argv.slice(2)]));
}
