import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { capture, root } from '../../scripts/lib/run.mjs';
import { environment, packed, project } from './support/project.js';

const SQUARE = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n';

/** Runs `npx halfedge` in a project, without a network. */
function npx(cwd: string, ...args: string[]) {
  const env = { ...environment, npm_config_cache: join(packed.folder, 'npm-cache') };
  return capture('npx', ['--offline', '--loglevel=error', 'halfedge', ...args], { cwd, env });
}

describe('Installed, `npx halfedge`', () => {
  let folder: string;
  beforeAll(() => {
    folder = project('cli', { 'square.obj': SQUARE });
  });

  test('tells its version', async () => {
    const { version } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
    expect(await npx(folder, '--version')).toMatchObject({ ok: true, printed: `${version}\n` });
  });

  test('tells what is in a file', async () => {
    const { ok, printed } = await npx(folder, 'info', '--json', 'square.obj');
    expect(JSON.parse(printed)).toMatchObject({
      format: 'obj',
      vertices: 4,
      faces: 1,
      valid: true,
    });
    expect(ok).toBe(true);
  });

  test('converts a file, and ends with another status where it can not', async () => {
    expect(await npx(folder, 'convert', 'square.obj', 'square.ply')).toMatchObject({
      ok: true,
      output: '',
    });
    expect(existsSync(join(folder, 'square.ply'))).toBe(true);
    expect(await npx(folder, 'check', 'nowhere.obj')).toMatchObject({
      ok: false,
      output: "halfedge: nowhere.obj can't be read: no such file or directory (ENOENT).\n",
    });
  });
});
