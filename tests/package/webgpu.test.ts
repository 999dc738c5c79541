// What three.js's WebGPURenderer draws, with WebGPU and with its WebGL 2, beside WebGLRenderer: see
// support/three-renderers.js.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { root } from '../../scripts/lib/run.mjs';
import { disconnect, withPage } from './support/browser.js';
import { page } from './support/programs.js';
import { install, project } from './support/project.js';
import { serve } from './support/server.js';

const HALFEDGE = './node_modules/halfedge/dist';
const THREE = './node_modules/three';
const imports = {
  halfedge: `${HALFEDGE}/index.js`,
  'halfedge/three': `${HALFEDGE}/three/index.js`,
  'halfedge/three/webgpu': `${HALFEDGE}/three/webgpu.js`,
  three: `${THREE}/build/three.module.js`,
  'three/webgpu': `${THREE}/build/three.webgpu.js`,
  'three/tsl': `${THREE}/build/three.tsl.js`,
  'three/addons/': `${THREE}/examples/jsm/`,
};

let folder: string;
beforeAll(() => {
  folder = project('webgpu', {
    'index.html': page(
      './main.js',
      `<script type="importmap">${JSON.stringify({ imports })}</script>`,
    ),
    'main.js': readFileSync(join(root, 'tests/package/support/three-renderers.js'), 'utf8'),
  });
  install(folder, ['three']);
});
afterAll(disconnect);

/** Opens the page for as long as `use` runs; then nothing has been complained of. */
async function withRenderers(name: string, use: (run: Run) => Promise<void>): Promise<void> {
  const server = await serve(folder);
  try {
    await withPage(server.address, async ({ page, complaints }) => {
      await page.waitForFunction(() => document.title === 'ready');
      await use(runIn(page));
      await page.screenshot({ path: join(root, `build/screenshots/${name}.png`), fullPage: true });
      // Reading the pictures is what the page is for.
      expect(complaints.filter((text) => !text.includes('it reads pixels'))).toEqual([]);
    });
  } finally {
    await server.close();
  }
}

/** Calls a function of the page. */
type Run = <Result = Comparison>(name: string, ...args: unknown[]) => Promise<Result>;

const runIn =
  (page: Page): Run =>
  (name, ...args) =>
    page.evaluate(
      ([name, args]) => (globalThis as unknown as Record<string, Functions>)[name](...args),
      [name, args] as const,
    ) as never;

type Functions = (...args: readonly unknown[]) => Promise<unknown>;

interface Comparison {
  readonly ink: number;
  readonly otherInk: number;
  readonly differ: number;
}

interface Step extends Comparison {
  readonly bytes: number;
  readonly forSurface: number;
  readonly forLines: number;
  readonly allLines: number;
}

/** The names of three.js for what WebGPURenderer draws with. */
const BACKENDS = ['WebGPUBackend', 'WebGLBackend'];
const EVERYTHING = [...BACKENDS, 'WebGLRenderer'];

describe.each(BACKENDS)('With the %s of WebGPURenderer', (backend) => {
  test('helpers look as they do with WebGLRenderer, whatever the camera and the depths', async () => {
    await withRenderers(`webgpu-helpers-${backend}`, async (run) => {
      const views = [
        ...[{}, { camera: 'orthographic' }, { camera: 'within' }],
        ...[{ depths: 'logarithmicDepthBuffer' }, { depths: 'reversedDepthBuffer' }],
      ];
      const pictures = [
        ...views.map((view) => ({ helper: 'HalfedgesHelper', ...view })),
        { helper: 'BoundaryLoopsHelper' },
        { helper: 'CirculatorHelper' },
        { helper: 'ProblemsHelper' },
      ];
      const found: object[] = [];
      for (const options of pictures) {
        found.push({
          ...options,
          ...(await run('likeWebGL', backend, { mesh: 'box', ...options })),
        });
      }
      const isAlike = ({ ink, differ }: Comparison) => ink > 200 && differ / ink < 0.01;
      expect(found.filter((picture) => !isAlike(picture as Comparison))).toEqual([]);
      expect(found).toHaveLength(8);
    });
  });

  test('all helpers share a program', async () => {
    await withRenderers(`webgpu-programs-${backend}`, async (run) => {
      const [before, after] = await run<number[]>('programs', backend);
      expect(before).toBe(2); // for vertices, and for pixels
      expect(after).toBe(before);
    });
  });
});

describe.each(EVERYTHING)('With %s', (name) => {
  test('no arrow is hidden by the faces that it lies in, whatever the depths', async () => {
    await withRenderers(`webgpu-hills-${name}`, async (run) => {
      for (const depths of [undefined, 'logarithmicDepthBuffer']) {
        const options = { helper: 'HalfedgesHelper', mesh: 'hills', camera: 'above', depths };
        const { ink, otherInk } = await run('uponSurface', name, options);
        expect(ink).toBeGreaterThan(10_000);
        expect(otherInk / ink).toBeGreaterThan(0.995);
      }
    });
  });

  test('a helper with the lines of another renderer is told in a sentence', async () => {
    await withRenderers(`webgpu-wrong-lines-${name}`, async (run) => {
      const { thrown, ink } = await run<{ thrown: string[]; ink: number }>('withWrongLines', name);
      const expected =
        name === 'WebGLRenderer'
          ? "TypeError: WebGLRenderer can't draw the lines of a helper that is made with { lines: webgpuLines }; expected WebGPURenderer, or a helper without this option."
          : "TypeError: WebGPURenderer can't draw the lines of a helper that is made without { lines: webgpuLines }; expected WebGLRenderer, or a helper with this option, of halfedge/three/webgpu.";
      expect(thrown).toEqual([expected, expected]);
      expect(ink).toBeGreaterThan(200);
    });
  });

  test.each(['none', 'flat'])(
    'edits are drawn, and only what they changed is uploaded, with the normals %s',
    async (normals) => {
      await withRenderers(`webgpu-edits-${name}-${normals}`, async (run) => {
        const steps = await run<Record<string, Step>>('edited', name, normals);
        const all = Object.entries(steps).map(([edit, step]) => ({ edit, ...step }));
        expect(all.filter(({ ink, differ }) => !(ink > 10_000 && differ / ink < 0.001))).toEqual(
          [],
        );
        const { nothing, grow } = steps;
        expect([nothing.forSurface, nothing.forLines]).toEqual([0, 0]);
        // WebGPU sends words of four bytes, WebGPURenderer no normals that nothing needs.
        const most = (bytes: number) => (name === 'WebGLRenderer' ? bytes : 1.1 * bytes + 8);
        const others = all.filter(({ edit }) => !['nothing', 'grow'].includes(edit));
        expect(
          others.filter(({ bytes, forSurface }) => !(forSurface > 0 && forSurface <= most(bytes))),
        ).toEqual([]);
        expect(others).toHaveLength(5);
        expect(steps.move.forLines).toBeGreaterThan(0);
        expect(steps.move.forLines).toBeLessThan(steps.move.allLines / 8);
        expect(grow.bytes).toBeGreaterThan(10_000); // in new buffers
      });
    },
  );
});
