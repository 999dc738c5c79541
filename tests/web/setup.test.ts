// The scripts behind `npm start` and `npm test` on other machines: a copy of them runs where PATH has only the
// programs that a test puts there.

import { spawn } from 'node:child_process';
import {
  chmodSync,
  cpSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  realpathSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { filesBelow } from '../../scripts/lib/files.mjs';
import { root } from '../../scripts/lib/run.mjs';

let folder: string;
let checkout: string;

beforeEach(() => {
  folder = realpathSync(mkdtempSync(join(tmpdir(), 'halfedge setup-')));
  checkout = join(folder, 'a checkout');
  for (const name of ['scripts', 'package.json', 'package-lock.json', 'CMakePresets.json']) {
    cpSync(join(root, name), join(checkout, name), { recursive: true });
  }
  mkdirSync(join(folder, 'bin'));
});

afterEach(() => rmSync(folder, { recursive: true, force: true }));

function write(path: string, text: string) {
  mkdirSync(dirname(join(folder, path)), { recursive: true });
  writeFileSync(join(folder, path), text);
}

/** Puts a program on PATH, written in the language of the shell. */
function install(name: string, script = '') {
  write(`bin/${name}`, `#!/bin/sh\n${script}\n`);
  chmodSync(join(folder, 'bin', name), 0o755);
}

/** All that a build needs. */
function installTools() {
  install('cmake', 'echo cmake version 3.30.1');
  install('ninja');
  write('emsdk/upstream/emscripten/cmake/Modules/Platform/Emscripten.cmake', '');
  // It keeps what it was called with.
  install('npm', `echo "$@" >> "${folder}/npm.log"; /bin/mkdir -p node_modules`);
}

/** Runs Node in the copy, perhaps as another user; returns all that was printed. */
function node(args: string[], { uid }: { uid?: number } = {}) {
  const user = `data:text/javascript,process.getuid = () => ${uid}`;
  const all = uid === undefined ? args : ['--import', user, ...args];
  const env = { PATH: join(folder, 'bin'), EMSDK: join(folder, 'emsdk') };
  return new Promise<{ status: number | null; printed: string }>((resolve, reject) => {
    const child = spawn(process.execPath, all, { cwd: checkout, env });
    let printed = '';
    for (const stream of [child.stdout, child.stderr]) {
      stream.on('data', (chunk) => {
        printed += chunk;
      });
    }
    child.on('error', reject);
    child.on('close', (status) => resolve({ status, printed: printed.trim() }));
  });
}

const fails = (sentence: string) => ({
  status: 1,
  printed: expect.stringMatching(new RegExp(`(^|\n)${sentence}$`)),
});

describe('The set-up', () => {
  test('names what has to be installed, and how new', async () => {
    expect(await node(['scripts/setup.mjs'])).toEqual(
      fails('Install Emscripten .an activated emsdk., CMake 3.22 or newer and Ninja, then run .*'),
    );
    installTools();
    install('cmake', 'echo cmake version 3.18.4');
    expect(await node(['scripts/setup.mjs'])).toEqual(
      fails('Install CMake 3.22 or newer, then run this again.'),
    );
  });

  test('takes a compiler that only stands for one as missing', async () => {
    installTools();
    install('clang++', 'echo no developer tools were found >&2; exit 1');
    const { status, printed } = await node(['scripts/setup.mjs', 'tests']);
    expect(status).toBe(1);
    expect(printed).toMatch(/^Install .*clang's sanitizers and fuzzer.*, then run this again\.$/);
  });

  test('refuses a Node that a tool refuses', async () => {
    const path = join(checkout, 'package-lock.json');
    const lock = JSON.parse(readFileSync(path, 'utf8'));
    const major = Number.parseInt(process.versions.node, 10);
    lock.packages['node_modules/vite'].engines.node = `^${major - 1}.1.0 || >=${major + 1}.0.0`;
    writeFileSync(path, JSON.stringify(lock));
    expect(await node(['scripts/setup.mjs'])).toEqual(
      fails(
        `This is Node ${process.versions.node}, and vite needs .${major - 1}.1.0 .* install a newer one.`,
      ),
    );
  });

  test('refuses what there is not', async () => {
    const sentence = 'There is no purpose test: the purposes are build, tests, bench.';
    expect(await node(['scripts/setup.mjs', 'test'])).toEqual(fails(sentence));
  });

  test('says what to run as root where sudo refuses', async () => {
    const sentence = 'As root, run `apt-get update && apt-get install .*cmake.*`, then run this .*';
    install('apt-get', 'exit 100');
    expect(await node(['scripts/setup.mjs'], { uid: 1000 })).toEqual(fails(sentence));
    install('sudo', 'echo sudo: a terminal is required >&2; exit 1');
    expect(await node(['scripts/setup.mjs'], { uid: 1000 })).toEqual(fails(sentence));
  });

  test('names what the system has no package of', async () => {
    installTools();
    rmSync(join(folder, 'bin/ninja'));
    install('cmake', 'echo cmake version 3.18.4');
    install('env', '/usr/bin/env "$@"');
    install('apt-get');
    install(
      'apt-cache',
      `printf 'cmake:\\n  Installed: 1\\n  Candidate: 1\\nninja-build:\\n  Candidate: (none)\\n'`,
    );
    expect((await node(['scripts/setup.mjs'], { uid: 0 })).printed).toMatch(
      /^apt-get has no ninja-build.*: install Ninja.* in another way, then run this again\.$/m,
    );
  });

  test('installs all npm packages, until that has been done once', async () => {
    installTools();
    const calls = () => readFileSync(join(folder, 'npm.log'), 'utf8').trim().split('\n');
    install('npm', `echo "$@" >> "${folder}/npm.log"; /bin/mkdir -p node_modules; exit 1`);
    expect(await node(['scripts/setup.mjs'])).toMatchObject({ status: 1 });
    installTools();
    expect(await node(['scripts/setup.mjs'])).toMatchObject({ status: 0 });
    expect(await node(['scripts/setup.mjs'])).toMatchObject({ status: 0 });
    expect(calls()).toHaveLength(2);
    expect(calls()[1]).toMatch(/^ci --include=dev --include=optional --include=peer /);
  });

  test('runs by a link, too', async () => {
    symlinkSync(checkout, join(folder, 'link'));
    const script = join(folder, 'link/scripts/setup.mjs');
    expect(await node([script, 'test'])).toMatchObject({ status: 1 });
  });
});

describe('`npm test`', () => {
  test('tries nothing without what it needs', async () => {
    const { status, printed } = await node(['scripts/test.mjs']);
    expect(status).toBe(1);
    expect(printed).toMatch(/\nInstall .*, then run this again\.\n── Set-up: 0 passed, 1 failed/);
    expect(printed.match(/^── .*: /gm)).toHaveLength(1);
    expect(printed).toMatch(/\n0 passed, 1 failed, 0 skipped$/);
  });
});

test('Parts, benchmarks and options that there are not are refused in a sentence', async () => {
  const part = 'There is no part wsm: the parts are wasm, web.';
  expect(await node(['scripts/build.mjs', 'wsm'])).toEqual(fails(part));
  expect(await node(['scripts/bench.mjs', 'wep'])).toEqual(
    fails('Name a benchmark: web, start, .*'),
  );
  expect(await node(['scripts/fuzz.mjs', '--minuts', '1'])).toEqual(
    fails("Unknown option '--minuts'.*"),
  );
});

describe('The build', () => {
  test('can not do without the npm packages', async () => {
    for (const name of ['core.js', 'core.wasm']) write(`a checkout/dist/${name}`, '');
    const packages = 'The npm packages are missing: `npm run setup` installs them.';
    expect(await node(['scripts/build.mjs', 'web'])).toEqual(fails(packages));
  });

  test('starts afresh where the project was moved or has another toolchain', async () => {
    installTools();
    const isKept = async (place: string, toolchain: string) => {
      write(
        'a checkout/build/wasm/CMakeCache.txt',
        `CMAKE_HOME_DIRECTORY:INTERNAL=${place}\nCMAKE_TOOLCHAIN_FILE:FILEPATH=${toolchain}\n`,
      );
      const call = `configurePreset('wasm', ['-DCMAKE_TOOLCHAIN_FILE=/emscripten.cmake'])`;
      const script = `(await import('./scripts/build.mjs')).${call}`;
      const ran = await node(['--input-type=module', '-e', `await ${script}`]);
      expect(ran).toEqual({ status: 0, printed: '' });
      return existsSync(join(checkout, 'build/wasm'));
    };
    symlinkSync(checkout, join(folder, 'link'));
    expect(await isKept(checkout, '/emscripten.cmake')).toBe(true);
    expect(await isKept(join(folder, 'link'), '/emscripten.cmake')).toBe(true);
    expect(await isKept(join(folder, 'emsdk'), '/emscripten.cmake')).toBe(false);
    expect(await isKept('/no/such/folder', '/emscripten.cmake')).toBe(false);
    expect(await isKept(checkout, '/other.cmake')).toBe(false);
  });
});

test('Links to nothing, such as the locks of an editor, are none of the files', () => {
  write('src/a.h', '');
  symlinkSync('nobody@nowhere', join(folder, 'src/.#a.h'));
  expect(filesBelow(join(folder, 'src'))).toEqual([join(folder, 'src/a.h')]);
});
