// The scripts behind `npm start` and `npm test` on other machines: a copy of them runs where PATH has only the
// programs that a test puts there.

import { spawn } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, realpathSync, rmSync, symlinkSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
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
  test('refuses what there is not', async () => {
    const sentence = 'There is no purpose test: the purposes are build, tests, bench.';
    expect(await node(['scripts/setup.mjs', 'test'])).toEqual(fails(sentence));
  });

  test('runs by a link, too', async () => {
    symlinkSync(checkout, join(folder, 'link'));
    const script = join(folder, 'link/scripts/setup.mjs');
    expect(await node([script, 'test'])).toMatchObject({ status: 1 });
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
