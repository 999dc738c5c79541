import { type HalfedgeMesh, init } from 'halfedge';
import { disconnect, ExplorerPage, sampleMesh } from './support/explorer.js';

let explorer: ExplorerPage;
let mesh: HalfedgeMesh;
beforeAll(async () => {
  await init();
  mesh = sampleMesh('bunny.off');
  explorer = await ExplorerPage.open();
});
afterEach(() => expect(explorer.complaints).toEqual([]));
afterAll(async () => {
  await explorer.close();
  await disconnect();
});

describe('The keyboard', () => {
  test('walks along every link', async () => {
    await explorer.goTo('v100');
    let h: number = mesh.vertexHalfedge(100);
    await explorer.press('h');
    expect(await explorer.state('selected')).toBe(`h${h}`);
    for (const [key, step] of [
      ['n', (at: number) => mesh.next(at)],
      ['o', (at: number) => mesh.opposite(at)],
      ['p', (at: number) => mesh.prev(at)],
      ['n', (at: number) => mesh.next(at)],
    ] as const) {
      h = step(h);
      await explorer.press(key);
      expect(await explorer.state('selected')).toBe(`h${h}`);
    }
    for (const [key, target] of [
      ['v', `v${mesh.toVertex(h)}`],
      ['u', `v${mesh.fromVertex(h)}`],
      ['e', `e${mesh.edge(h)}`],
      ['f', `f${mesh.face(h)}`],
    ]) {
      await explorer.goTo(`h${h}`);
      await explorer.press(key);
      expect(await explorer.state('selected')).toBe(target);
    }
    await explorer.press('h');
    expect(await explorer.state('selected')).toBe(`h${mesh.faceHalfedge(mesh.face(h))}`);
  });

  test('says so where there is no such link', async () => {
    await explorer.goTo('v3');
    await explorer.press('n');
    expect(await explorer.state('selected')).toBe('v3');
    expect(await explorer.page.textContent('.remark')).toContain('v3 has no such link');
    await explorer.goTo('h3');
    await explorer.press('h');
    expect(await explorer.page.textContent('.remark')).toBe('h3 is a halfedge already.');
  });

  test('zooms to the selection and back to the whole mesh', async () => {
    await explorer.goTo('v1224');
    const at = async () =>
      (await explorer.projection())(mesh.positions.subarray(3 * 1224, 3 * 1225));
    const neighbour = async () => {
      const [w] = mesh.vertexVertices(1224);
      return (await explorer.projection())(mesh.positions.subarray(3 * w, 3 * w + 3));
    };
    const apart = async () => {
      const [[x, y], [u, v]] = [await at(), await neighbour()];
      return Math.hypot(u - x, v - y);
    };
    const before = await apart();
    await explorer.press('z');
    expect(await explorer.comesTrue(async () => (await apart()) > 3 * before)).toBe(true);
    await explorer.press('0');
    const isBack = async () => Math.abs((await apart()) / before - 1) < 0.5;
    expect(await explorer.comesTrue(isBack)).toBe(true);
  });

  test('gives up the selection with Escape', async () => {
    await explorer.goTo('f12');
    await explorer.press('Escape');
    expect(await explorer.state('selected')).toBeNull();
  });
});

describe('The inspector', () => {
  test('shows the links (3) to (7) of a halfedge as buttons that walk', async () => {
    await explorer.goTo('h77');
    const links = await explorer.page.$$eval('ul.links button', (buttons) =>
      buttons.map((button) => [
        button.querySelector('.number')?.textContent,
        (button as HTMLElement).dataset.link,
        (button as HTMLElement).dataset.target,
      ]),
    );
    expect(links).toEqual([
      ['3', 'toVertex', `v${mesh.toVertex(77)}`],
      ['4', 'face', `f${mesh.face(77)}`],
      ['5', 'next', `h${mesh.next(77)}`],
      ['6', 'opposite', `h${mesh.opposite(77)}`],
      ['7', 'prev', `h${mesh.prev(77)}`],
      ['', 'fromVertex', `v${mesh.fromVertex(77)}`],
      ['', 'edge', `e${mesh.edge(77)}`],
    ]);
    await explorer.page.click('[data-link=prev]');
    expect(await explorer.state('selected')).toBe(`h${mesh.prev(77)}`);
    await explorer.page.click('[data-link=face]');
    expect(await explorer.state('selected')).toBe(`f${mesh.face(77)}`);
  });

  test('points at nothing any more when the link under the mouse is gone', async () => {
    await explorer.goTo('h77');
    await explorer.page.hover('[data-link=edge]');
    await explorer.until('hovered', `e${mesh.edge(77)}`);
    await explorer.page.click('[data-link=edge]'); // an edge has fewer links
    await explorer.until('selected', `e${mesh.edge(77)}`);
    await explorer.until('hovered', null);
    await explorer.page.mouse.move(500, 20);
  });

  test('shows the empty link of a boundary halfedge as ∅, which leads nowhere', async () => {
    await explorer.sample('annulus', 'Annulus');
    await explorer.press('3');
    await explorer.page.click('.loops button');
    await explorer.press('1');
    expect(await explorer.state('selected')).toMatch(/^h\d+$/);
    const face = explorer.page.locator('[data-link=face]');
    expect(await face.getAttribute('data-target')).toBe('∅');
    expect(await face.isDisabled()).toBe(true);
    expect(await explorer.page.textContent('.inspector')).not.toContain('-1');
    await explorer.screenshot('boundary-halfedge-1280-light');
    await explorer.sample('bunny', 'Bunny');
  });

  test('refuses names that are none, and items that are not there, in a sentence', async () => {
    await explorer.goTo('v5');
    await explorer.goTo('nonsense');
    expect(await explorer.page.textContent('.remark')).toContain('“nonsense” is no item');
    await explorer.goTo('f5648');
    expect(await explorer.page.textContent('.remark')).toBe(
      'There is no f5648: this mesh has face 0 to 5647.',
    );
    expect(await explorer.state('selected')).toBe('v5');
    await explorer.press('h');
    expect(await explorer.page.inputValue('.goto input')).toBe('');
  });

  test('turns the picture to an item on the far side', async () => {
    const depths = async () => {
      await explorer.rest();
      const m = ((await explorer.state('camera')) ?? '').split(' ').map(Number);
      return (v: number) => {
        const [x, y, z] = mesh.positions.subarray(3 * v, 3 * v + 3);
        return m[3] * x + m[7] * y + m[11] * z + m[15];
      };
    };
    const depth = await depths();
    const farthest = [...mesh.vertices()].reduce((a, b) => (depth(a) > depth(b) ? a : b));
    await explorer.goTo(`v${farthest}`);
    const isNearer = async () => (await depths())(farthest) < depth(farthest);
    expect(await explorer.comesTrue(isNearer)).toBe(true);
  });
});
