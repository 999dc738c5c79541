import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { dragonOff } from '../fixtures/dragon.js';
import { disconnect, ExplorerPage } from './support/explorer.js';

const TETRAHEDRON = `OFF
4 4 6
0 0 0
1 0 0
0 1 0
0 0 1
3 0 2 1
3 0 1 3
3 0 3 2
3 1 2 3
`;

let explorer: ExplorerPage;
beforeAll(async () => {
  explorer = await ExplorerPage.open();
});
beforeEach(() => explorer.sample('icosahedron', 'Icosahedron'));
afterEach(() => expect(explorer.complaints).toEqual([]));
afterAll(async () => {
  await explorer.close();
  await disconnect();
});

const notice = () => explorer.page.waitForSelector('[role=alert]:not([hidden])');
const message = () => explorer.page.textContent('[role=alert] [data-message]');

describe('A file', () => {
  test('that is dropped on the page opens', async () => {
    await explorer.drop('tetrahedron.off', TETRAHEDRON);
    await explorer.ready('tetrahedron.off');
    expect(await explorer.page.textContent('.counts')).toContain('Vertices4Edges6Faces4');
    await explorer.press('End');
    expect(await explorer.visited()).toHaveLength(3);
    await explorer.screenshot('dropped-1280-light');
  });

  test('whose z points up is stood up, and stays upright when it is turned', async () => {
    const { page } = explorer;
    // Three times as high as wide.
    await explorer.drop('tower.off', TETRAHEDRON.replace('0 0 1\n', '0 0 3\n'));
    await explorer.ready('tower.off');
    /** How far the top is to the right of the foot on the screen, and how far above it. */
    const rise = async () => {
      const at = await explorer.projection();
      const [[x, y], [topX, topY]] = [at([0, 0, 0]), at([0, 0, 3])];
      return [topX - x, y - topY] as const;
    };
    expect(Math.abs((await rise())[0])).toBeGreaterThan(20);
    await page.click('[data-tab-button=mesh]');
    await page.click('.up-choice label:has-text("z")');
    const expectUpright = async () => {
      const [right, up] = await rise();
      expect(up).toBeGreaterThan(100);
      // Lines that are upright meet far below and above the picture.
      expect(Math.abs(right)).toBeLessThan(0.2 * up);
    };
    await expectUpright();
    await explorer.screenshot('z-up-1280-light');
    await page.focus('main.stage canvas');
    const [, height] = await rise();
    await explorer.press('ArrowLeft', 'ArrowLeft');
    // It is turned around its own axis, and seen from as high as before.
    expect((await rise())[1] / height).toBeCloseTo(1, 1);
    await explorer.press('ArrowUp');
    await expectUpright();
    await page.mouse.move(300, 500);
    await page.mouse.down();
    await page.mouse.move(420, 470, { steps: 4 });
    await page.mouse.up();
    await expectUpright();
    await explorer.press('0');
    await expectUpright();
    await explorer.press('y');
    expect(Math.abs((await rise())[0])).toBeGreaterThan(20);
    expect(await page.isChecked('.up-choice [value=y]')).toBe(true);
  });

  test('that is chosen in the dialog opens', async () => {
    const chooser = explorer.page.waitForEvent('filechooser');
    await explorer.page.click('[data-open]');
    const quad = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n';
    await (await chooser).setFiles({
      name: 'quad.obj',
      mimeType: 'model/obj',
      buffer: Buffer.from(quad),
    });
    await explorer.ready('quad.obj');
    expect(await explorer.page.textContent('.counts')).toContain('Vertices4Edges4Faces1');
  });

  test('that can’t be read is refused in a sentence, and the mesh on show stays', async () => {
    const panel = await explorer.page.locator('.panel').boundingBox();
    await explorer.drop('broken.off', TETRAHEDRON.replace('3 0 3 2', '3 0 x 2'));
    await notice();
    expect(await message()).toMatch(/^Line 9: expected .*found "x" \(read as OFF\)\.$/);
    expect(await explorer.page.locator('.panel').boundingBox()).toEqual(panel);
    expect(await explorer.page.textContent('[role=alert]')).toContain(
      '“broken.off” was not opened',
    );
    expect(await explorer.page.textContent('[role=alert]')).toContain(
      'The view shows Icosahedron.',
    );
    await explorer.screenshot('error-1280-light');
    expect(await explorer.state('mesh')).toBe('Icosahedron');
    await explorer.press('.');
    expect(await explorer.visited()).toHaveLength(1);
    await explorer.page.click('[role=alert] [aria-label=Dismiss]');
    expect(await explorer.page.isVisible('[role=alert]')).toBe(false);
    await explorer.drop('tetrahedron.off', TETRAHEDRON);
    await explorer.ready('tetrahedron.off');
  });

  test.each([
    ['notes.txt', 'Dear diary, this is no mesh.'],
    ['empty.off', ''],
    ['picture.obj', '\u0000\u0001\u0002\ufffd'.repeat(50)],
  ])('%s that is no mesh is refused in a sentence', async (name, content) => {
    await explorer.drop(name, content);
    await notice();
    expect(await message()).toMatch(/^[A-Z“"].{15,}\.$/s);
    expect(await explorer.state('mesh')).toBe('Icosahedron');
  });

  test('of another kind is told what the page reads, glTF included', async () => {
    await explorer.drop('empty.off', '');
    await notice();
    expect(await message()).toBe(
      'The file is empty (0 bytes), expected an OBJ, OFF, PLY, STL, GLB or glTF file.',
    );
  });

  test('without faces opens as vertices alone', async () => {
    await explorer.drop('points.off', 'OFF\n2 0 0\n0 0 0\n1 0 0\n');
    await explorer.ready('points.off');
    expect(await explorer.state('selected')).toBe('v0');
    expect(await explorer.page.getAttribute('[data-link]', 'data-target')).toBe('∅');
    expect(await explorer.page.textContent('.hop')).toContain('nothing to visit');
    expect(await explorer.validity()).toBe(
      'Valid: all invariants hold; no faces, 2 isolated vertices.',
    );
  });
});

describe('A folder', () => {
  let folder: string;
  beforeEach(() => {
    folder = mkdtempSync(join(tmpdir(), 'halfedge-folder-'));
  });
  afterEach(() => rmSync(folder, { recursive: true }));

  /** As from the desktop: a page can't make a transfer that carries a folder. */
  const drop = async (...files: string[]) => {
    const session = await explorer.page.context().newCDPSession(explorer.page);
    const data = { items: [], files, dragOperationsMask: 1 };
    for (const type of ['dragEnter', 'dragOver', 'drop'] as const) {
      await session.send('Input.dispatchDragEvent', { type, x: 300, y: 300, data });
    }
    await session.detach();
  };

  test('that is dropped opens the first mesh in it, with the files that it needs', async () => {
    mkdirSync(join(folder, 'buffers'));
    writeFileSync(join(folder, 'a picture.png'), 'no mesh');
    const positions = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0);
    writeFileSync(join(folder, 'buffers/corners.bin'), Buffer.from(positions.buffer));
    const gltf = {
      asset: { version: '2.0' },
      buffers: [{ byteLength: 36, uri: 'buffers/corners.bin' }],
      bufferViews: [{ buffer: 0, byteLength: 36 }],
      accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: 'VEC3' }],
      meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
      nodes: [{ mesh: 0 }],
      scenes: [{ nodes: [0] }],
    };
    writeFileSync(join(folder, 'triangle.gltf'), JSON.stringify(gltf));
    await drop(folder);
    await explorer.ready('triangle.gltf');
    expect(await explorer.page.textContent('.counts')).toContain('Vertices3Edges3Faces1');
  });

  test('opens the first of its meshes by name, one of its own before those of its folders', async () => {
    mkdirSync(join(folder, 'a'));
    writeFileSync(join(folder, 'a/deep.off'), TETRAHEDRON);
    for (let i = 0; i < 120; i++) writeFileSync(join(folder, `notes ${i}.txt`), 'no mesh');
    writeFileSync(join(folder, 'z.off'), TETRAHEDRON);
    writeFileSync(join(folder, 'y.off'), TETRAHEDRON);
    await drop(folder);
    await explorer.ready('y.off');
  });

  test('without a mesh is refused in a sentence that says what was looked for', async () => {
    writeFileSync(join(folder, 'notes.txt'), 'no mesh');
    await drop(folder);
    await notice();
    expect(await message()).toBe('There is no OBJ, OFF, PLY, STL, GLB or glTF file in it.');
    expect(await explorer.page.textContent('[role=alert]')).toContain(
      `“${basename(folder)}” was not opened`,
    );
    expect(await explorer.state('mesh')).toBe('Icosahedron');
  });
});

test('A mesh of 871,414 faces opens, and can be picked and walked', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'halfedge-dragon-'));
  const path = join(folder, 'dragon.off');
  writeFileSync(path, dragonOff());
  await explorer.page.setInputFiles('[data-file]', path);
  await explorer.page.waitForSelector('html[data-state=ready] [data-mesh="dragon.off"]', {
    timeout: 120_000,
  });
  rmSync(folder, { recursive: true });
  expect(await explorer.page.textContent('.counts')).toContain('Faces871,414');
  await explorer.screenshot('dragon-1280-light');
  await explorer.press('z');
  await explorer.projection();
  await explorer.press('End');
  expect(await explorer.visited()).toHaveLength(Number(await explorer.state('count')));
  await explorer.projection();
  await explorer.screenshot('dragon-close-1280-light');
}, 180_000);
