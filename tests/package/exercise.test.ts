import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { disconnect, titleOf, withPage } from './support/browser.js';
import { page } from './support/programs.js';
import { install, node, project, tool } from './support/project.js';
import { type RunningServer, serve } from './support/server.js';
import { gzippedSize, tryStandalone } from './support/standalone.js';

/** What a page with exercises loads at most, in bytes as gzip -9 leaves them: figures and the editor are in it. */
const BUDGET = 1_150_000;

afterAll(disconnect);

describe('Installed, the standalone file of exercises', () => {
  test('runs a program in a plain page, and asks for no other file', async () => {
    const valence = '<halfedge-exercise task="valence"></halfedge-exercise>';
    await tryStandalone('exercise', valence, async (page) => {
      await page.waitForSelector('halfedge-exercise .cm-content');
      await page.click('halfedge-exercise [part~=run]');
      await page.waitForSelector('halfedge-exercise[state=failed]');
      const headline = await page.textContent('halfedge-exercise [part=headline]');
      expect(headline).toMatch(/expected 3\.$/);
    });
  });

  test('keeps within its budget', () => {
    expect(gzippedSize('exercise')).toBeLessThanOrEqual(BUDGET);
  });
});

describe('Installed, `halfedge/exercise`', () => {
  const sources = {
    'package.json': '{ "private": true, "type": "module" }',
    'src/index.js': "import 'halfedge/exercise';\n",
    // three.js and the editor are large, and not to be split by this.
    'vite.config.js': 'export default { build: { chunkSizeWarningLimit: 4000 } };\n',
  };
  const body = '<title>Exercise</title><halfedge-exercise task="valence"></halfedge-exercise>';

  /** A project with all that docs/exercise.md tells to install, but for what comes with it. */
  function projectWithPeers(name: string, files: Record<string, string>): string {
    const folder = project(name, files);
    const { peerDependencies } = JSON.parse(
      readFileSync(join(folder, 'node_modules/halfedge/package.json'), 'utf8'),
    );
    install(folder, Object.keys(peerDependencies));
    return folder;
  }

  /** Runs a wrong program, then a right one, in the worker that the bundler has made. */
  async function expectWorking(starting: Promise<RunningServer>): Promise<void> {
    const server = await starting;
    try {
      await withPage(server.address, async ({ page, complaints }) => {
        const exercise = page.locator('halfedge-exercise');
        await exercise.locator('.cm-content').waitFor();
        await exercise.locator('[part~=run]').click();
        await page.waitForSelector('halfedge-exercise[state=failed]');
        await exercise.evaluate((element) => {
          const it = element as HTMLElement & { code: string; exercise: { solution: string } };
          it.code = it.exercise.solution;
        });
        await exercise.locator('[part~=run]').click();
        await page.waitForSelector('halfedge-exercise[state=passed]');
        expect(complaints.filter((text) => !/WebGL/.test(text))).toEqual([]);
      });
    } finally {
      await server.close();
    }
  }

  test('is built by Vite without a warning, and runs programs in its worker', async () => {
    const html = page('/src/index.js', body);
    const folder = projectWithPeers('exercise-vite', { ...sources, 'index.html': html });
    const output = await node(folder, tool('vite/bin/vite.js'), 'build');
    expect(output).not.toMatch(/warn|externalized|node:/i);
    await expectWorking(serve(join(folder, 'dist')));
  });

  const program = (from: string) => `
import { init } from 'halfedge/inline';
import '${from}';
const exercise = document.createElement('halfedge-exercise');
exercise.task = 'valence';
document.body.append(exercise);
init().then(() => exercise.run()).then(({ passed }) => String(passed), (error) => error.message).then((text) => { document.title = text; });
`;
  const instead = "import 'halfedge/exercise/standalone' instead, which contains it";

  test.each([
    [
      'esm',
      'halfedge/exercise',
      `Some bundlers (Angular, Bun, esbuild, Rollup) leave it behind: ${instead}`,
    ],
    ['iife', 'halfedge/exercise', `can't be looked for beside it: ${instead}`],
    ['esm', 'halfedge/exercise/standalone', 'false'],
    ['iife', 'halfedge/exercise/standalone', 'false'],
  ])('by esbuild as %s from %s, it runs or says what to do', async (format, from, told) => {
    const folder = projectWithPeers('exercise-esbuild', {
      'main.js': program(from),
      'index.html': '<!doctype html><body><script type="module" src="bundle.js"></script>',
    });
    const options = ['--bundle', `--format=${format}`, '--outfile=bundle.js', '--log-level=error'];
    await node(folder, tool('esbuild/bin/esbuild'), 'main.js', ...options);
    const server = await serve(folder);
    try {
      expect(await titleOf(server.address)).toContain(told);
    } finally {
      await server.close();
    }
  });
});
