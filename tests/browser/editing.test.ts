import { HalfedgeMesh, init } from 'halfedge';
import { digestOf } from '../../web/explorer/app/digest.js';
import { annulus, openGrid } from '../../web/explorer/samples/generators.js';
import { disconnect, ExplorerPage } from './support/explorer.js';

let explorer: ExplorerPage;
/** A page that nothing was done on yet. */
const open = async () => {
  explorer = await ExplorerPage.open();
  await explorer.press('2');
};
beforeAll(async () => {
  await init();
  await open();
});
afterEach(() => expect(explorer.complaints).toEqual([]));
afterAll(async () => {
  await explorer.close();
  await disconnect();
});

/** How many steps led back to meshes before, when the one on show was opened. */
let stepsBefore = 0;

/** A generated sample: the page's, and the same mesh here to do the same to. */
async function show(id: string, name: string, mesh: HalfedgeMesh) {
  await explorer.sample(id, name);
  mesh.history.enabled = true;
  await shows(mesh);
  stepsBefore = await steps();
  return mesh;
}

const steps = async () => Number(await explorer.state('undo'));

const sphere = () => show('icosphere', 'Icosphere', HalfedgeMesh.icoSphere(2));

/** Waits until the page shows the faces and positions of this mesh. */
const shows = (mesh: HalfedgeMesh) => explorer.until('digest', digestOf(mesh));

const click = (stem: string) => explorer.page.click(`[data-operation=${stem}]`);
const outcome = () => explorer.page.textContent('[data-outcome]');

/** The numbers below the operations, with what the last change added: `E 480 +3`. */
async function numbers(): Promise<string[]> {
  return explorer.page.$$eval('.numbers dl > div', (rows) =>
    rows.map((row) =>
      [...row.querySelectorAll('dt, dd')]
        .flatMap((cell) => [...cell.childNodes].map((node) => node.textContent))
        .join(' '),
    ),
  );
}

describe('An operation', () => {
  test('takes the digest away until the mesh is measured again', async () => {
    const mesh = await sphere();
    await explorer.goTo('e7');
    const digest = await explorer.page.evaluate(() => {
      document.querySelector<HTMLElement>('[data-operation=flipEdge]')?.click();
      return document.querySelector<HTMLElement>('main.stage')?.dataset.digest;
    });
    expect(digest).toBeUndefined();
    mesh.flipEdge(7);
    await shows(mesh);
  });

  test.each([
    ['its button', () => click('flipEdge')],
    ['its key', () => explorer.press('Shift+F')],
  ])('is done by %s, and keeps the edge selected', async (_name, flip) => {
    const mesh = await sphere();
    await explorer.goTo('e12');
    mesh.flipEdge(12);
    await flip();
    await shows(mesh);
    expect(await explorer.state('selected')).toBe('e12');
    expect(await outcome()).toBe('Done: flip e12.');
    // The player goes around what is there now.
    await explorer.press('End');
    expect(await explorer.visited()).toEqual([...mesh.edgeVertices(12)].map((v) => `v${v}`));
    expect(await numbers()).toEqual([
      'V 162',
      'E 480',
      'F 320',
      'χ 2',
      'genus 0',
      'loops 0',
      'parts 1',
    ]);
  });
});

/** What an operation does to the same mesh here; returns the item that it returned. */
type Twin = (mesh: HalfedgeMesh) => string;

/** Item, operation, key, and the same on a mesh of our own, on a sphere of 320 triangles. */
const onSphere: readonly (readonly [string, string, string, Twin])[] = [
  ['v9', 'dissolveVertex', 'Shift+D', (mesh) => `f${mesh.dissolveVertex(9)}`],
  ['e12', 'removeEdge', 'Shift+R', (mesh) => `f${mesh.removeEdge(12)}`],
  ['e12', 'splitEdge', 'Shift+S', (mesh) => `v${mesh.splitEdge(12)}`],
  ['e12', 'insertVertexOnEdge', 'Shift+V', (mesh) => `v${mesh.insertVertexOnEdge(12)}`],
  ['h31', 'collapse', 'Shift+C', (mesh) => `v${mesh.collapse(31)}`],
  ['f7', 'splitFace', 'Shift+S', (mesh) => `v${mesh.splitFace(7)}`],
  ['v9', 'bevelVertex', 'Shift+B', (mesh) => `f${mesh.bevelVertex(9, 0.3)}`],
  ['e12', 'bevelEdge', 'Shift+B', (mesh) => `f${mesh.bevelEdge(12, 0.3)}`],
  ['f7', 'insetFace', 'Shift+I', (mesh) => `f${mesh.insetFace(7, 0.35)}`],
  ['f7', 'makeHole', 'Shift+H', (mesh) => `h${mesh.makeHole(7)}`],
];

describe('Every operation on an item', () => {
  test.each(onSphere)('%s: %s, by button and by %s', async (item, stem, key, twin) => {
    const mesh = await sphere();
    const before = digestOf(mesh);
    await explorer.goTo(item);
    const result = twin(mesh);
    expect(digestOf(mesh)).not.toBe(before);
    await click(stem);
    await shows(mesh);
    expect(await explorer.state('selected')).toBe(result);
    expect(mesh.validate().filter(({ severity }) => severity === 'error')).toEqual([]);
    await explorer.page.focus('main.stage canvas');
    await explorer.press('Control+z');
    await explorer.until('digest', before);
    expect(await explorer.state('selected')).toBe(item);
    await explorer.press(key);
    await shows(mesh);
    expect(await explorer.state('selected')).toBe(result);
  });

  test('cuts an edge open, from its button or its key', async () => {
    const mesh = await show('grid', 'Open grid', openGrid(6));
    const inside = (v: number) => !mesh.isBoundaryVertex(v);
    const e = [...mesh.edges()].find((edge) => {
      const [a, b] = mesh.edgeVertices(edge);
      return inside(a) !== inside(b);
    }) as number;
    await explorer.goTo(`e${e}`);
    const h = mesh.cut(mesh.edgeHalfedge(e));
    await explorer.press('Shift+C');
    await shows(mesh);
    expect(await explorer.state('selected')).toBe(`h${h}`);
    expect(await explorer.page.textContent('.facts')).toContain('boundary');
  });

  test('deletes the selected vertex, edge or face with the Delete key', async () => {
    for (const [item, remove] of [
      ['v9', (mesh: HalfedgeMesh) => mesh.deleteVertex(9)],
      ['e12', (mesh: HalfedgeMesh) => mesh.deleteEdge(12)],
      ['f7', (mesh: HalfedgeMesh) => mesh.deleteFace(7)],
    ] as const) {
      const mesh = await sphere();
      await explorer.goTo(item);
      remove(mesh);
      await explorer.press('Delete');
      await shows(mesh);
      // Something that is still there is selected, and the player goes around it.
      expect(await explorer.state('selected')).toMatch(/^[vf]\d+$/);
      await explorer.press('End');
      expect((await explorer.visited()).length).toBeGreaterThan(0);
    }
  });
});

describe('An operation with two items', () => {
  test('waits for the second, which can be walked to', async () => {
    const mesh = await show('grid', 'Open grid', openGrid(6));
    const first = mesh.faceHalfedge(14);
    const second = mesh.next(mesh.next(first));
    await explorer.goTo(`h${first}`);
    await explorer.press('Shift+E');
    expect(await explorer.state('pending')).toBe('insertEdge');
    expect(await explorer.page.textContent('.tag.first')).toBe(`from h${first}`);
    expect(await explorer.page.isVisible('.pending')).toBe(true);
    await explorer.screenshot('pending-1280-light');
    await explorer.press('n', 'n', 'Enter');
    const edge = mesh.insertEdge(first, second);
    await shows(mesh);
    expect(await explorer.state('selected')).toBe(`e${edge}`);
    expect(await explorer.state('pending')).toBeNull();
    expect(await numbers()).toEqual(
      expect.arrayContaining(['V 49', 'E 85 +1', 'F 37 +1', 'χ 1', 'loops 1']),
    );
  });

  test('takes the second from a click, of its kind only, and can be called off', async () => {
    const mesh = await show('grid', 'Open grid', openGrid(6));
    const first = mesh.faceHalfedge(14);
    const second = mesh.next(mesh.next(first));
    await explorer.goTo(`h${first}`);
    await click('insertEdge');
    expect(await explorer.page.isChecked('[name=pick-mode][value=halfedge]')).toBe(true);
    await explorer.press('Escape');
    expect(await explorer.state('pending')).toBeNull();
    expect(await explorer.page.isChecked('[name=pick-mode][value=auto]')).toBe(true);
    await click('insertEdge');
    const project = await explorer.projection();
    const at = (v: number) => project(mesh.positions.subarray(3 * v, 3 * v + 3));
    const corners = [...mesh.faceVertices(14)].map(at);
    const [p, q] = [at(mesh.fromVertex(second)), at(mesh.toVertex(second))];
    const middle = [0, 1].map((k) => corners.reduce((sum, c) => sum + c[k], 0) / corners.length);
    // Between the middle of the edge and that of the face.
    await explorer.page.mouse.click(
      0.8 * ((p[0] + q[0]) / 2) + 0.2 * middle[0],
      0.8 * ((p[1] + q[1]) / 2) + 0.2 * middle[1],
    );
    mesh.insertEdge(first, second);
    await shows(mesh);
  });

  test('is refused before it asks for the second where none would do', async () => {
    const mesh = await show('grid', 'Open grid', openGrid(6));
    const inner = mesh.faceHalfedge(14);
    await explorer.goTo(`h${inner}`);
    const glue = explorer.page.locator('[data-operation=glue]');
    expect(await glue.getAttribute('data-refused')).toBe('not-a-boundary-halfedge');
    await glue.click();
    expect(await explorer.state('pending')).toBeNull();
    expect(await explorer.state('refusal')).toBe('not-a-boundary-halfedge');
    expect(await explorer.state('witness')).toContain(`h${inner}`);
    await explorer.goTo(`h${mesh.boundaryLoops()[0]}`);
    expect(await glue.getAttribute('data-refused')).toBeNull();
    await glue.click();
    expect(await explorer.state('pending')).toBe('glue');
    await explorer.press('Escape');
  });

  test('is begun and completed by keys, from its button', async () => {
    const mesh = await show('grid', 'Open grid', openGrid(6));
    const first = mesh.faceHalfedge(14);
    await explorer.goTo(`h${first}`);
    await explorer.page.focus('[data-operation=insertEdge]');
    await explorer.press('Enter', 'n', 'n', 'Enter');
    mesh.insertEdge(first, mesh.next(mesh.next(first)));
    await shows(mesh);
  });

  test('refuses what does not go together', async () => {
    const mesh = await show('grid', 'Open grid', openGrid(6));
    const [first, second] = [mesh.faceHalfedge(14), mesh.faceHalfedge(0)];
    const refusal = mesh.checkInsertEdge(first, second);
    expect(refusal).not.toBeNull();
    await explorer.goTo(`h${first}`);
    await explorer.press('Shift+E');
    await explorer.goTo(`h${second}`);
    await explorer.press('Enter');
    expect(await explorer.page.textContent('.refusal [data-message]')).toBe(refusal?.message);
    await shows(mesh);
  });

  test('is not offered its first item as the second, also after a walk back to that', async () => {
    const mesh = await show('grid', 'Open grid', openGrid(6));
    const [first, second] = [mesh.faceHalfedge(14), mesh.faceHalfedge(0)];
    await explorer.goTo(`h${first}`);
    await explorer.press('Shift+E');
    const take = explorer.page.locator('.pending .witness button');
    await explorer.goTo(`h${second}`);
    expect(await take.textContent()).toBe(`Take h${second}`);
    await explorer.goTo(`h${first}`);
    expect(await take.isDisabled()).toBe(true);
    await explorer.press('Escape');
  });
});

describe('An operation on the whole mesh', () => {
  test('compact gives the selection its new name', async () => {
    const mesh = await sphere();
    await explorer.goTo('v9');
    await explorer.press('Delete');
    await explorer.goTo('v100');
    await explorer.press('Shift+K');
    mesh.deleteVertex(9);
    const maps = mesh.compact();
    await shows(mesh);
    expect(await explorer.state('selected')).toBe(`v${maps.vertices[100]}`);
    await explorer.press('Shift+N');
    expect(await outcome()).toBe('Nothing to do: delete isolated.');
    expect(await explorer.page.textContent('.report')).toBe('Nothing to do: delete isolated.');
    expect(await steps()).toBe(stepsBefore + 2);
  });

  test('dual opens another mesh, from where undo leads back', async () => {
    await show('cube', 'Cube', HalfedgeMesh.cube());
    await explorer.press('Shift+M');
    await explorer.ready('Dual of Cube');
    await explorer.page.waitForSelector('main.stage[data-digest]'); // it is measured
    expect((await numbers()).slice(0, 4)).toEqual(['V 6', 'E 12', 'F 8', 'χ 2']);
    expect(await outcome()).toBe('Done: dual.');
    expect(await steps()).toBe(stepsBefore + 1);
    await explorer.press('Control+z');
    await explorer.ready('Cube');
    await shows(HalfedgeMesh.cube());
    expect(await outcome()).toBe('Undone: dual.');
    await explorer.press('Control+y');
    await explorer.ready('Dual of Cube');
    await shows(HalfedgeMesh.cube().dual());
  });
});

describe('The numbers', () => {
  test('tell what a change did to the topology, and what undo did to it', async () => {
    const mesh = await show('annulus', 'Annulus', annulus(14));
    const [h] = mesh.boundaryLoops();
    await explorer.goTo(`h${h}`);
    await click('fillHole');
    mesh.fillHole(h);
    await shows(mesh);
    const filled = ['V 42', 'E 70', 'F 29 +1', 'χ 1 +1', 'genus 0', 'loops 1 −1', 'parts 1'];
    expect(await numbers()).toEqual(filled);
    await explorer.screenshot('filled-1280-light');
    await explorer.page.focus('main.stage canvas');
    await explorer.press('Control+z');
    mesh.history.undo();
    await shows(mesh);
    expect(await numbers()).toEqual(expect.arrayContaining(['F 28 −1', 'χ 0 −1', 'loops 2 +1']));
  });
});

describe('History', () => {
  beforeEach(async () => {
    await explorer.close();
    await open();
  });

  test('goes back and forth by buttons and by keys, to exactly the same mesh', async () => {
    const mesh = await sphere();
    const states = [digestOf(mesh)];
    for (const e of [12, 40, 7]) {
      await explorer.goTo(`e${e}`);
      await explorer.press('Shift+F');
      mesh.flipEdge(e);
      states.push(digestOf(mesh));
      await shows(mesh);
    }
    expect(new Set(states).size).toBe(4);
    const undo = explorer.page.locator('[data-history=undo]');
    const redo = explorer.page.locator('[data-history=redo]');
    expect(await undo.textContent()).toBe('Undo flip e7');
    await undo.click();
    await explorer.until('digest', states[2]);
    expect(await explorer.state('selected')).toBe('e7');
    expect(await redo.textContent()).toBe('Redo flip e7');
    await explorer.page.focus('main.stage canvas');
    await explorer.press('Control+z');
    await explorer.until('digest', states[1]);
    expect(await explorer.state('selected')).toBe('e40');
    await explorer.press('Control+z');
    await explorer.until('digest', states[0]);
    expect(await outcome()).toBe('Undone: flip e12.');
    await explorer.press('Control+z');
    expect(await outcome()).toBe('There is nothing to undo.');
    expect(await undo.getAttribute('aria-disabled')).toBe('true');
    await explorer.press('Control+Shift+z');
    await explorer.until('digest', states[1]);
    await explorer.press('Control+y');
    await explorer.until('digest', states[2]);
    await redo.click();
    await explorer.until('digest', states[3]);
    expect([await explorer.state('undo'), await explorer.state('redo')]).toEqual(['3', '0']);
  });

  test('forgets what was undone when something else is done', async () => {
    await sphere();
    for (const keys of ['Shift+F', 'Control+z', 'Shift+F']) {
      await explorer.goTo('e30');
      await explorer.press(keys);
    }
    expect([await explorer.state('undo'), await explorer.state('redo')]).toEqual(['1', '0']);
  });

  test('leads back to edits that no file has, when another mesh is opened', async () => {
    const mesh = await sphere();
    await explorer.goTo('e30');
    await explorer.press('Shift+F');
    mesh.flipEdge(30);
    await shows(mesh);
    await explorer.sample('cube', 'Cube');
    const left = explorer.page.locator('[data-left]');
    expect(await left.textContent()).toContain('Icosphere has edits that were not saved.');
    await left.locator('button').click();
    await explorer.ready('Icosphere');
    expect(await left.isVisible()).toBe(false);
    await shows(mesh);
    await explorer.sample('cube', 'Cube');
    await explorer.sample('icosahedron', 'Icosahedron');
    expect(await left.isVisible()).toBe(false);
    const undo = explorer.page.locator('[data-history=undo]');
    expect(await undo.textContent()).toBe('Undo open Icosahedron');
    await undo.click();
    await explorer.ready('Icosphere');
    await shows(mesh);
    expect(await explorer.state('selected')).toBe('e30');
    expect(await undo.textContent()).toBe('Undo flip e30');
    await explorer.press('Control+y');
    await explorer.ready('Icosahedron');
  });
});

test('Undo and redo name the item of their step, and are not cut off before it', async () => {
  const named = await ExplorerPage.open({
    link: 'sample=icosphere&select=h131',
    mesh: 'Icosphere',
  });
  const { page } = named;
  const isCut = (label: Element) => label.scrollWidth > label.clientWidth;
  await named.press('Shift+C');
  await named.until('undo', '1');
  expect(await page.textContent('[data-history=undo]')).toBe('Undo collapse h131');
  expect(await page.$eval('[data-history=undo] span', isCut)).toBe(false);
  await named.press('Control+z');
  await named.until('redo', '1');
  expect(await page.textContent('[data-history=redo]')).toBe('Redo collapse h131');
  expect(await page.$eval('[data-history=redo] span', isCut)).toBe(false);
  expect(named.complaints).toEqual([]);
  await named.close();
});

test('Leaving the page asks, as long as there are edits that no file has', async () => {
  const leaving = await ExplorerPage.open({ link: 'sample=cube&select=e3', mesh: 'Cube' });
  const { page } = leaving;
  await leaving.press('Shift+V');
  await leaving.until('undo', '1');
  const asked = page.waitForEvent('dialog');
  await page.close({ runBeforeUnload: true });
  const dialog = await asked;
  expect(dialog.type()).toBe('beforeunload');
  await dialog.dismiss();
  await page.click('[data-tab-button=mesh]');
  await page.click('[data-download=obj]');
  const closed = page.waitForEvent('close');
  await page.close({ runBeforeUnload: true });
  await closed;
  expect(leaving.complaints).toEqual([]);
  await leaving.closeTab();
});

describe('The picture', () => {
  test('moves from before to after, and is where it belongs when it is interrupted', async () => {
    const moving = await ExplorerPage.open({ motion: true });
    const { page } = moving;
    const mesh = HalfedgeMesh.icoSphere(2);
    mesh.history.enabled = true;
    await moving.press('2');
    await moving.sample('icosphere', 'Icosphere');
    await moving.goTo('h31');
    await moving.press('z');
    await moving.rest();
    // A number at an arrow may lie a fraction of a pixel beside where it was.
    const picture = () => page.screenshot({ clip: { x: 0, y: 0, width: 900, height: 740 } });
    const before = await picture();
    await page.clock.install();
    await page.clock.pauseAt(Date.now() + 60_000);

    mesh.collapse(31);
    await moving.press('Shift+C');
    await page.clock.runFor(100);
    const early = await picture();
    await page.clock.runFor(150);
    const late = await picture();
    await page.clock.runFor(1000);
    const after = await picture();
    const pictures = [before, early, late, after];
    for (const [i, one] of pictures.entries()) {
      for (const other of pictures.slice(0, i)) {
        expect(await moving.differingPixels(one, other)).toBeGreaterThan(1000);
      }
    }
    expect(await moving.state('digest')).toBe(digestOf(mesh));

    // Back and forth again before the first motion is at its end.
    await moving.press('Control+z');
    await page.clock.runFor(100);
    await moving.press('Control+y');
    await page.clock.runFor(100);
    expect(await moving.differingPixels(await picture(), after)).toBeGreaterThan(1000);
    await page.clock.runFor(1000);
    expect(await moving.state('digest')).toBe(digestOf(mesh));
    expect(await moving.differingPixels(await picture(), after)).toBeLessThan(100);
    await moving.press('Control+z');
    await page.clock.runFor(1000);
    expect(await moving.differingPixels(await picture(), before)).toBeLessThan(100);
    expect(moving.complaints).toEqual([]);
    await moving.closeTab();
  }, 180_000);

  test('changes at once where motion is to be reduced', async () => {
    await sphere();
    await explorer.goTo('h31');
    await explorer.projection();
    const before = Number(await explorer.state('frames'));
    await explorer.press('Shift+C');
    await explorer.until('selected', 'v3');
    await explorer.page.waitForTimeout(600);
    await explorer.rest();
    expect(Number(await explorer.state('frames')) - before).toBeLessThanOrEqual(3);
  });
});

describe('A refusal', () => {
  test('is marked before, and shown as its sentence with its witness lit', async () => {
    const mesh = await show('grid', 'Open grid', openGrid(6));
    const e = [...mesh.edges()].find((edge) => mesh.isBoundaryEdge(edge)) as number;
    const refusal = mesh.checkFlipEdge(e);
    await explorer.goTo(`e${e}`);
    const button = explorer.page.locator('[data-operation=flipEdge]');
    expect(await button.getAttribute('data-refused')).toBe(refusal?.code);
    await button.click();
    expect(await explorer.state('refusal')).toBe('boundary-edge');
    expect(await explorer.page.textContent('.refusal [data-message]')).toBe(refusal?.message);
    const [h] = refusal?.witness.halfedges ?? [];
    expect(await explorer.state('witness')).toBe(`e${e} h${h}`);
    expect(await explorer.page.textContent('.tag.witness:not(.away)')).toContain('✕');
    await explorer.screenshot('refused-1280-light');
    await explorer.page.click(`.refusal [data-item=h${h}]`);
    expect(await explorer.state('selected')).toBe(`h${h}`);
    expect(await explorer.state('refusal')).toBe('boundary-edge');
    await shows(mesh);
    expect(await steps()).toBe(stepsBefore);
    await explorer.page.focus('main.stage canvas');
    await explorer.press('Escape');
    expect(await explorer.state('refusal')).toBeNull();
    expect(await explorer.page.isVisible('.refusal')).toBe(false);
    const labels = explorer.page.locator('.tag.witness:visible');
    expect(await explorer.comesTrue(async () => (await labels.count()) === 0)).toBe(true);
  });

  test('gives the focus back where it is dismissed', async () => {
    await show('grid', 'Open grid', openGrid(6));
    await explorer.goTo('e0');
    await explorer.page.focus('[data-operation=flipEdge]');
    await explorer.press('Enter');
    await explorer.page.focus('.refusal .dismiss');
    await explorer.press('Enter');
    const focused = explorer.page.locator(':focus');
    expect(await focused.getAttribute('data-operation')).toBe('flipEdge');
    await explorer.page.focus('main.stage canvas');
  });
});

describe('The list of boundary loops', () => {
  test('goes to a loop: selects a halfedge of it, and flies there', async () => {
    await explorer.sample('annulus', 'Annulus');
    await explorer.press('3');
    const before = await explorer.state('camera');
    const loops = explorer.page.locator('.loops button');
    await loops.first().waitFor(); // facts come after the picture
    expect(await loops.allTextContents()).toEqual([
      expect.stringMatching(/^loop h\d+ 14 edges$/),
      expect.stringMatching(/^loop h\d+ 14 edges$/),
    ]);
    await loops.nth(1).click();
    expect(await explorer.state('selected')).toMatch(/^h\d+$/);
    const flew = async () => (await explorer.state('camera')) !== before;
    expect(await explorer.comesTrue(flew)).toBe(true);
    await explorer.press('2');
  });
});

describe('The list of problems', () => {
  test('names the pinched vertex, and goes to it', async () => {
    await explorer.sample('pinched', 'Pinched vertex');
    await explorer.goTo('v5');
    await explorer.press('3');
    const problem = explorer.page.locator('[data-problem]').first();
    expect(await problem.textContent()).toMatch(/^warning.*vertex 0/i);
    await problem.click();
    expect(await explorer.state('selected')).toBe('v0');
    await explorer.screenshot('problem-1280-light');
    await explorer.press('2');
  });

  test('names vertices that lie in one place, and goes to one', async () => {
    await explorer.broken('crack', 'Crack');
    await explorer.press('3');
    const problem = explorer.page.locator('[data-problem=coincident-vertices]').first();
    expect(await problem.textContent()).toMatch(/^warning.*as vertex \d+ does\.$/i);
    await problem.click();
    expect(await explorer.state('selected')).toMatch(/^v\d+$/);
    await explorer.press('2');
  });
});
