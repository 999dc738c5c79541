// The examples with a 3D picture, each as somebody would run it: a folder of its own, in which the packed
// package is installed, and the others that its package.json names.

import { cpSync, mkdirSync, readFileSync, symlinkSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { setTimeout as pause } from 'node:timers/promises';
import { root } from '../../scripts/lib/run.mjs';
import { disconnect, screenshots } from './support/browser.js';
import { Example } from './support/example.js';
import { node, project, tool } from './support/project.js';
import { serve, serveWith } from './support/server.js';

const VITE = tool('vite/bin/vite.js');

/** A copy of an example. Its packages are those of the repository; `others` names different ones for some. */
function install(name: string, others: Record<string, string> = {}): string {
  const folder = project(`example-${name}`, {});
  cpSync(join(root, 'examples', name), folder, { recursive: true });
  const { dependencies } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  for (const dependency of Object.keys(dependencies)) {
    if (dependency === 'halfedge') continue;
    const path = join(folder, 'node_modules', dependency);
    mkdirSync(dirname(path), { recursive: true });
    symlinkSync(tool(others[dependency] ?? dependency), path);
  }
  return folder;
}

/** Opens the page of a server, and closes both. */
async function visit(
  starting: ReturnType<typeof serve>,
  use: (example: Example) => Promise<void>,
): Promise<void> {
  const server = await starting;
  try {
    await Example.open(server.address, use);
  } finally {
    await server.close();
  }
}

afterAll(disconnect);

describe('The example of three.js', () => {
  /** Picks a face, edits it and takes that back. */
  async function edits(example: Example) {
    const { page } = example;
    const counts = await example.text('#counts', /faces/);
    expect(counts).toBe('200 vertices, 380 edges, 182 faces');
    expect(await page.isDisabled('[data-edit=extrude]')).toBe(true);
    await example.click(0, 30);
    const picked = await example.text('#picked', /^Face \d+ has 4 corners/);
    await page.click('[data-edit=extrude]');
    await example.text('#counts', /^204 vertices, 388 edges, 186 faces$/);
    const [, bytes] = /: ([\d,]+) bytes/.exec(await example.text('#uploaded', /bytes/)) ?? [];
    expect(Number(bytes.replace(',', ''))).toBeLessThan(2000);
    expect(await example.text('#picked', /./)).not.toBe(picked);
    await page.click('#undo');
    expect(await example.text('#counts', /^200/)).toBe(counts);
    expect(await example.text('#picked', /./)).toBe(picked);
    await page.click('[data-edit=delete]');
    expect(await example.text('#picked', /./)).toBe('No face is picked.');
    expect(example.complaints).toEqual([]);
  }

  test.each(['three', 'three-oldest'])('runs without a bundler, with %s', async (three) => {
    await visit(serve(install('three', { three })), async (example) => {
      await edits(example);
      await example.page.click('#undo');
      await example.click(0, 30);
      await example.page.click('[data-edit=extrude]');
      await screenshots(example.page, `example-${three}`);
      expect(example.complaints).toEqual([]);
    });
  });

  test('runs when it is built by Vite', async () => {
    const folder = install('three');
    await node(folder, VITE, 'build');
    await visit(serve(join(folder, 'dist')), edits);
  });
});

describe('The example of React Three Fiber', () => {
  let folder: string;
  beforeAll(() => {
    folder = install('react-three-fiber');
  });

  /** Picks an edge, edits it until that is refused, and takes it all back. */
  async function edits(example: Example) {
    const { page } = example;
    const press = (name: string) => page.getByRole('button', { name }).click();
    const counts = await example.text('#counts', /faces/);
    expect(counts).toBe('42 vertices, 120 edges, 80 faces');
    await example.click();
    await example.text('#picked', /^Edge \d+ joins .* between faces/);
    await press('Split');
    await example.text('#counts', /^43 vertices, 123 edges, 82 faces$/);
    await press('Undo');
    await example.text('#counts', /^42/);
    await screenshots(page, 'example-react');
    await press('Delete');
    await example.text('#counts', /^42 vertices, 119 edges, 78 faces$/);
    await example.text('#picked', /^No edge/);
    await page.setViewportSize({ width: 1280, height: 720 });
    await pause(300); // the picture follows
    await example.click(135, 84); // beside the hole
    await example.text('#picked', /on the boundary, at face \d+\.$/);
    await press('Flip');
    await example.text('#refusal', /^Edge \d+ lies on the boundary/);
    await page.screenshot({ path: join(root, 'build/screenshots/example-react-refusal.png') });
    // React Three Fiber 9.8.2 uses a clock that three.js has deprecated.
    expect(example.complaints.filter((text) => !text.startsWith('THREE.Clock: '))).toEqual([]);
  }

  test('runs in the development server of Vite, where React does everything twice', async () => {
    await visit(serveWith(folder, VITE, '--host', '127.0.0.1', '--port', '0'), edits);
  });

  test('runs when it is built', async () => {
    await node(folder, VITE, 'build');
    await visit(serve(join(folder, 'dist')), edits);
  });
});
