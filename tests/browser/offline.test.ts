import { HalfedgeMesh, init } from 'halfedge';
import { writeGltf } from 'halfedge/gltf';
import type { Page } from 'playwright-core';
import { disconnect, ExplorerPage } from './support/explorer.js';

beforeAll(() => init());
afterAll(disconnect);

const told = async (page: Page) => {
  await page.waitForSelector('.notice:not([hidden])');
  return [
    await page.textContent('.notice h2'),
    await page.textContent('.notice [data-message]'),
    await page.textContent('.notice .calm'),
  ];
};
const state = (page: Page) => page.getAttribute('html', 'data-state');
const ONLINE = 'Try again when you are online, or reload the page then.';

/** Opens the page again, without what has such an address. Returns how it can be had again. */
async function reloadWithout(page: Page, pattern: string): Promise<() => Promise<void>> {
  await page.route(pattern, (route) => route.abort());
  await page.reload();
  await page.waitForSelector('html[data-state=error]');
  return () => page.unroute(pattern);
}

test('A page whose WebAssembly was not fetched says so, and fetches it when a mesh is opened', async () => {
  const explorer = await ExplorerPage.open();
  const { page } = explorer;
  const restore = await reloadWithout(page, '**/core*.wasm');
  const why = 'The WebAssembly module of the page could not be fetched.';
  expect(await told(page)).toEqual(['“Bunny” was not opened', why, ONLINE]);
  await restore();
  await explorer.sample('cube', 'Cube');
  expect(await page.isVisible('.notice')).toBe(false);
  await explorer.close();
});

test('A link is told of that could not be followed without WebAssembly', async () => {
  const explorer = await ExplorerPage.open({ link: 'sample=cube', mesh: 'Cube' });
  const { page } = explorer;
  const restore = await reloadWithout(page, '**/core*.wasm');
  const why = 'The WebAssembly module of the page could not be fetched.';
  await page.waitForSelector('.notice:has-text("The link could not be followed")');
  expect(await told(page)).toEqual(['The link could not be followed', why, ONLINE]);
  expect(await state(page)).toBe('error');
  await restore();
  await explorer.sample('torus', 'Torus');
  await explorer.close();
});

test('A page whose first sample was not fetched says so, and opens others', async () => {
  const explorer = await ExplorerPage.open();
  const { page } = explorer;
  const restore = await reloadWithout(page, '**/bunny*.off');
  const why = 'The sample could not be fetched.';
  expect(await told(page)).toEqual(['“Bunny” was not opened', why, ONLINE]);
  await explorer.sample('cube', 'Cube');
  await restore();
  await explorer.sample('bunny', 'Bunny');
  await explorer.close();
});

describe('What is fetched when it is needed for the first time', () => {
  const glb = async () => {
    using mesh = HalfedgeMesh.icosahedron();
    return { name: 'solid.glb', buffer: Buffer.from(await writeGltf(mesh)) };
  };
  const large = async () => {
    using mesh = HalfedgeMesh.grid(160, 160);
    return { name: 'large.obj', buffer: Buffer.from(mesh.write('obj')) };
  };
  test.each([
    ['reads glTF', '**/gltf-*.js', glb],
    ['reads glTF', '**/GLTFLoader-*.js', glb],
    ['reads large files', '**/worker-*.js', large],
    ['reads large files', '**/worker-thread-*.js', large],
  ])('is told of where what %s is not there: %s', async (what, pattern, make) => {
    const explorer = await ExplorerPage.open({ link: 'sample=cube', mesh: 'Cube' });
    const { page } = explorer;
    const file = await make();
    const choose = () =>
      page.setInputFiles('.top-bar input[type=file]', {
        ...file,
        mimeType: 'application/octet-stream',
      });
    let isThere = false;
    await page.route(pattern, (route) => (isThere ? route.continue() : route.abort()));
    await choose();
    const why = `The part of the page that ${what} could not be fetched.`;
    expect(await told(page)).toEqual([
      `“${file.name}” was not opened`,
      why,
      `${ONLINE} The view shows Cube.`,
    ]);
    isThere = true;
    await choose();
    await explorer.ready(file.name);
    await explorer.close();
  });
});

test('A browser without WebGL 2 is told what the page lacks, and what to do', async () => {
  const explorer = await ExplorerPage.open();
  const { page } = explorer;
  await page.addInitScript(() => {
    const { getContext } = HTMLCanvasElement.prototype;
    Object.assign(HTMLCanvasElement.prototype, {
      getContext(this: HTMLCanvasElement, kind: string, ...options: unknown[]) {
        return kind.startsWith('webgl') ? null : getContext.call(this, kind, ...options);
      },
    });
  });
  await page.reload();
  await page.waitForSelector('html[data-state=error]');
  expect(await told(page)).toEqual([
    'The explorer could not start',
    'This browser gives the page no WebGL 2, which draws the mesh.',
    'Turn on graphics acceleration in its settings and reload the page, or open it in another browser.',
  ]);
  expect(await page.locator('button').count()).toBe(0);
  await explorer.closeTab();
});
