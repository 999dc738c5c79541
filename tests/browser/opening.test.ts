import { HalfedgeMesh, init } from 'halfedge';
import { writeGltf } from 'halfedge/gltf';
import { dracoGltf } from './support/draco.js';
import { disconnect, ExplorerPage } from './support/explorer.js';

let explorer: ExplorerPage;
beforeAll(async () => {
  await init();
  explorer = await ExplorerPage.open();
});
beforeEach(() => explorer.sample('cube', 'Cube'));
afterEach(() => expect(explorer.complaints).toEqual([]));
afterAll(async () => {
  await explorer.close();
  await disconnect();
});

/** Pastes a text, as by the keyboard. */
const paste = (text: string) =>
  explorer.page.evaluate((pasted) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData('text/plain', pasted);
    const event = new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true });
    document.body.dispatchEvent(event);
  }, text);

const choose = (...files: { name: string; buffer: Buffer }[]) =>
  explorer.page.setInputFiles(
    '[data-file]',
    files.map((file) => ({ ...file, mimeType: 'application/octet-stream' })),
  );

const faces = () => explorer.page.textContent('.counts div:nth-child(3) dd');

describe('A text that is pasted', () => {
  test.each([
    ['obj', '# two\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n'],
    ['off', 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n'],
    [
      'ply',
      'ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n',
    ],
  ])('opens where it is %s', async (format, text) => {
    await paste(text);
    await explorer.ready(`Pasted mesh.${format}`);
    expect(await faces()).toBe('2');
  });

  test('is refused in a sentence where it is no mesh', async () => {
    await paste('Dear Sir or Madam,\nthank you');
    expect(await explorer.page.textContent('.notice [data-message]')).toBe(
      'It begins with “Dear Sir or Madam,”; expected the text of an OBJ, OFF, PLY, STL or glTF file.',
    );
    expect(await explorer.state('mesh')).toBe('Cube');
    await explorer.press('Escape');
  });

  test('opens where a control has the focus that takes no text', async () => {
    await explorer.page.click('.pick-bar label:has-text("Face")');
    await explorer.page.evaluate(() =>
      navigator.clipboard.writeText('OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n'),
    );
    await explorer.press('Control+v');
    await explorer.ready('Pasted mesh.off');
    await explorer.page.click('.pick-bar label:has-text("Auto")');
  });

  test('is followed where it is a link to this page, also when it was followed before', async () => {
    const link = 'http://elsewhere.test/explorer/#sample=torus&select=f2';
    await paste(link);
    await explorer.ready('Torus');
    expect(await explorer.state('selected')).toBe('f2');
    await explorer.goTo('v1');
    await paste(` ${link}\n`);
    await explorer.until('selected', 'f2');
    await paste('http://elsewhere.test/bunny.obj');
    expect(await explorer.page.textContent('.notice [data-message]')).toContain('It begins with');
    await explorer.press('Escape');
  });

  test('is followed where it is the end of a link, and a file may begin like one', async () => {
    await paste('\n#sample=torus&select=f2 ');
    await explorer.ready('Torus');
    expect(await explorer.state('selected')).toBe('f2');
    await paste('#sample=cube\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n');
    await explorer.ready('Pasted mesh.obj');
    expect(await faces()).toBe('1');
  });

  test('goes into a field where that has the focus', async () => {
    await explorer.page.focus('.goto input');
    await explorer.page.evaluate(() => navigator.clipboard.writeText('v3'));
    await explorer.press('Control+v', 'Enter');
    expect(await explorer.state('selected')).toBe('v3');
  });
});

describe('Several meshes that are chosen together', () => {
  const off = (name: string) => ({
    name,
    buffer: Buffer.from('OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n'),
  });
  const told = () => explorer.page.textContent('[data-passed-over]:not([hidden])');

  test('are told of in a sentence: the first is on show', async () => {
    const notes = { name: 'notes.txt', buffer: Buffer.from('no mesh') };
    await choose(notes, off('one.off'), off('two.off'));
    await explorer.ready('one.off');
    expect(await told()).toBe('two.off was not opened: the page shows one mesh at a time.');
    await choose(off('one.off'), off('two.off'), off('three.off'), off('four.off'));
    await explorer.page.waitForSelector('[data-passed-over]:has-text("were")');
    expect(await told()).toBe(
      'two.off and 2 other meshes were not opened: the page shows one mesh at a time.',
    );
    await explorer.sample('cube', 'Cube');
    expect(await explorer.page.isVisible('[data-passed-over]')).toBe(false);
  });

  test('are none where the others belong to the one that is opened', async () => {
    await choose({ name: 'one.mtl', buffer: Buffer.from('newmtl red\n') }, off('one.off'));
    await explorer.ready('one.off');
    expect(await explorer.page.isVisible('[data-passed-over]')).toBe(false);
  });
});

test('What an empty mesh says gives way to what is being opened', async () => {
  await paste('OFF\n0 0 0\n');
  await explorer.ready('Pasted mesh.off');
  expect(await explorer.page.isVisible('.empty-state')).toBe(true);
  let goOn = () => {};
  const held = new Promise<void>((resolve) => {
    goOn = resolve;
  });
  await explorer.page.route('**/suzanne*', async (route) => {
    await held;
    await route.continue();
  });
  await explorer.page.click('.mesh-button');
  await explorer.page.click('[data-sample=suzanne]');
  await explorer.page.waitForSelector('.busy');
  expect(await explorer.page.isVisible('.empty-state')).toBe(false);
  await explorer.page.click('[data-cancel]');
  await explorer.page.waitForSelector('.empty-state');
  expect(await explorer.page.isVisible('.busy')).toBe(false);
  // What was given up arrives all the same, and is not shown.
  await Promise.all([explorer.page.waitForResponse('**/suzanne*'), goOn()]);
  await explorer.page.unroute('**/suzanne*');
  expect(await explorer.page.isVisible('.empty-state')).toBe(true);
});

describe('glTF', () => {
  test('opens as GLB, welded', async () => {
    const glb = await writeGltf(HalfedgeMesh.torus(12, 6, { triangles: true }));
    await choose({ name: 'ring.glb', buffer: Buffer.from(glb) });
    await explorer.ready('ring.glb');
    expect(await faces()).toBe('144');
    expect(await explorer.validity()).toContain('closed');
  });

  test('opens with the file that it refers to, and asks for it where it is missing', async () => {
    const text = await writeGltf(HalfedgeMesh.icosahedron(), { format: 'gltf' });
    const document = JSON.parse(text) as { buffers: { uri: string }[] };
    const data = Buffer.from(document.buffers[0].uri.split(',')[1], 'base64');
    document.buffers[0].uri = 'parts/solid.bin';
    const main = { name: 'solid.gltf', buffer: Buffer.from(JSON.stringify(document)) };
    await choose(main);
    await explorer.page.waitForSelector('.notice:not([hidden])');
    expect(await explorer.page.textContent('.notice [data-message]')).toContain(
      'This glTF file needs its buffer “parts/solid.bin”: choose or drop both together.',
    );
    await choose({ name: 'solid.bin', buffer: data }, main);
    await explorer.ready('solid.gltf');
    expect(await faces()).toBe('20');
  });

  test.each(['half at 50%.bin', 'half%20at%2050%25.bin'])(
    'opens with a buffer whose name has a percent sign: %s',
    async (uri) => {
      const text = await writeGltf(HalfedgeMesh.icosahedron(), { format: 'gltf' });
      const document = JSON.parse(text) as { buffers: { uri: string }[] };
      const data = Buffer.from(document.buffers[0].uri.split(',')[1], 'base64');
      document.buffers[0].uri = uri;
      const main = { name: 'half.gltf', buffer: Buffer.from(JSON.stringify(document)) };
      await choose({ name: 'half at 50%.bin', buffer: data }, main);
      await explorer.ready('half.gltf');
      expect(await faces()).toBe('20');
    },
  );

  test('is asked for where its buffer is chosen alone', async () => {
    await choose({ name: 'solid.bin', buffer: Buffer.alloc(64) });
    await explorer.page.waitForSelector('.notice:not([hidden])');
    expect(await explorer.page.textContent('.notice [data-message]')).toBe(
      'It is no mesh by itself. If it is the buffer of a glTF file, choose or drop both together.',
    );
  });

  test('opens under another name, too', async () => {
    const glb = await writeGltf(HalfedgeMesh.cube());
    await choose({ name: 'model.vrm', buffer: Buffer.from(glb) });
    await explorer.ready('model.vrm');
    expect(await faces()).toBe('12');
    const text = await writeGltf(HalfedgeMesh.icosahedron(), { format: 'gltf' });
    await choose({ name: 'model.json', buffer: Buffer.from(text) });
    await explorer.ready('model.json');
    expect(await faces()).toBe('20');
  });

  test('opens where Draco has compressed it', async () => {
    const text = await dracoGltf(HalfedgeMesh.icoSphere(3));
    await choose({ name: 'packed.gltf', buffer: Buffer.from(text) });
    await explorer.ready('packed.gltf');
    expect(await faces()).toBe('1,280');
    expect(await explorer.validity()).toContain('closed');
  });

  test('is refused in a sentence where it is cut off', async () => {
    const glb = await writeGltf(HalfedgeMesh.icosahedron());
    await choose({ name: 'cut.glb', buffer: Buffer.from(glb.subarray(0, 200)) });
    await explorer.page.waitForSelector('.notice:not([hidden])');
    const message = await explorer.page.textContent('.notice [data-message]');
    expect(message).toBe('The GLB file ends at byte 200, expected 1188 bytes as its header says.');
    expect(await explorer.state('mesh')).toBe('Cube');
  });
});

describe('A large file', () => {
  const large = () => {
    const mesh = HalfedgeMesh.grid(160, 160);
    const text = mesh.write('obj');
    mesh.dispose();
    return { name: 'large.obj', buffer: Buffer.from(text) };
  };

  test('is read in another thread, which tells how far it is', async () => {
    const file = large();
    expect(file.buffer.length).toBeGreaterThan(2 ** 20);
    const worker = explorer.page.waitForEvent('worker');
    await explorer.page.evaluate(() => {
      const told: string[] = [];
      Object.assign(window, { told });
      const bar = document.querySelector('.busy progress') as HTMLElement;
      new MutationObserver(() => {
        if (!bar.hidden) told.push(document.querySelector('.busy')?.textContent ?? '');
      }).observe(bar, { attributes: true });
    });
    await choose(file);
    expect((await worker).url()).toContain('worker');
    await explorer.ready('large.obj');
    expect(await faces()).toBe('25,600');
    const told = await explorer.page.evaluate(() => (window as { told?: string[] }).told);
    expect(told).toContain('Reading large.obj …Cancel');
    expect(await explorer.page.isVisible('.busy')).toBe(false);
  });

  test('can be given up, and the mesh on show stays', async () => {
    await explorer.page.evaluate(() => {
      const bar = document.querySelector('.busy progress') as HTMLElement;
      const observer = new MutationObserver(() => {
        if (bar.hidden) return;
        observer.disconnect();
        (document.querySelector('[data-cancel]') as HTMLElement).click();
      });
      observer.observe(bar, { attributes: true });
    });
    await choose(large());
    await explorer.page.waitForFunction(() => !document.querySelector('.busy:not([hidden])'));
    await explorer.page.waitForTimeout(500);
    await explorer.rest();
    expect(await explorer.state('mesh')).toBe('Cube');
    expect(await explorer.page.isVisible('.notice')).toBe(false);
  });

  test('is refused in the same sentence as a small one', async () => {
    const file = large();
    const buffer = Buffer.concat([file.buffer, Buffer.from('f 1 2 x\n')]);
    await choose({ ...file, buffer });
    await explorer.page.waitForSelector('.notice:not([hidden])');
    const message = await explorer.page.textContent('.notice [data-message]');
    expect(message).toMatch(/^Line \d+: expected .*found "x"/);
  });
});
