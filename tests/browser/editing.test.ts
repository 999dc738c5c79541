import { HalfedgeMesh, init } from 'halfedge';
import { digestOf } from '../../web/explorer/app/digest.js';
import { openGrid } from '../../web/explorer/samples/generators.js';
import { disconnect, ExplorerPage } from './support/explorer.js';

let explorer: ExplorerPage;
beforeAll(async () => {
  await init();
  explorer = await ExplorerPage.open();
  await explorer.press('2');
});
afterEach(() => expect(explorer.complaints).toEqual([]));
afterAll(async () => {
  await explorer.close();
  await disconnect();
});

/** A generated sample: the page's, and the same mesh here to do the same to. */
async function show(id: string, name: string, mesh: HalfedgeMesh) {
  await explorer.sample(id, name);
  mesh.history.enabled = true;
  await shows(mesh);
  return mesh;
}

const sphere = () => show('icosphere', 'Icosphere', HalfedgeMesh.icoSphere(2));

/** Waits until the page shows the faces and positions of this mesh. */
const shows = (mesh: HalfedgeMesh) => explorer.until('digest', digestOf(mesh));

const click = (stem: string) => explorer.page.click(`[data-operation=${stem}]`);
const outcome = () => explorer.page.textContent('[data-outcome]');

/** The numbers below the operations, with what the last change added: `E 480 +3`. */
async function numbers(): Promise<string[]> {
  return explorer.page.$$eval('.numbers > div', (rows) =>
    rows.map((row) =>
      [...row.querySelectorAll('dt, dd')]
        .flatMap((cell) => [...cell.childNodes].map((node) => node.textContent))
        .join(' '),
    ),
  );
}

describe('An operation', () => {
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

describe('History', () => {
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

  test('forgets what was undone when something else is done, and all with another mesh', async () => {
    await sphere();
    for (const keys of ['Shift+F', 'Control+z', 'Shift+F']) {
      await explorer.goTo('e30');
      await explorer.press(keys);
    }
    expect([await explorer.state('undo'), await explorer.state('redo')]).toEqual(['1', '0']);
    await explorer.sample('cube', 'Cube');
    expect(await explorer.state('undo')).toBe('0');
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
    expect(await explorer.state('undo')).toBe('0');
    await explorer.page.focus('main.stage canvas');
    await explorer.press('Escape');
    expect(await explorer.state('refusal')).toBeNull();
    expect(await explorer.page.isVisible('.refusal')).toBe(false);
    expect(await explorer.page.locator('.tag.witness:visible').count()).toBe(0);
  });
});

describe('The list of boundary loops', () => {
  test('goes to a loop: selects a halfedge of it, and flies there', async () => {
    await explorer.sample('annulus', 'Annulus');
    await explorer.press('3');
    const before = await explorer.state('camera');
    const loops = explorer.page.locator('.loops button');
    expect(await loops.allTextContents()).toEqual([
      expect.stringMatching(/^loop h\d+14 edges$/),
      expect.stringMatching(/^loop h\d+14 edges$/),
    ]);
    await loops.nth(1).click();
    expect(await explorer.state('selected')).toMatch(/^h\d+$/);
    await explorer.projection();
    expect(await explorer.state('camera')).not.toBe(before);
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
});
