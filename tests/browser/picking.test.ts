import { HalfedgeMesh, init, NONE } from 'halfedge';
import { openGrid, starPrism } from '../../web/explorer/samples/generators.js';
import { disconnect, ExplorerPage, type Point } from './support/explorer.js';

let explorer: ExplorerPage;
beforeAll(async () => {
  await init();
  explorer = await ExplorerPage.open();
});
afterEach(() => expect(explorer.complaints).toEqual([]));
afterAll(async () => {
  await explorer.close();
  await disconnect();
});

/** A generated sample: the page's, and the same mesh here to compare with. */
async function show(id: string, name: string, mesh: HalfedgeMesh) {
  await explorer.sample(id, name);
  await explorer.page.click('[name=pick-mode][value=auto]');
  const project = await explorer.projection();
  const at = (v: number): Point => project(mesh.positions.subarray(3 * v, 3 * v + 3));
  const middle = (...vertices: number[]): Point => {
    const sum = [0, 1, 2].map((k) =>
      vertices.reduce((total, v) => total + mesh.positions[3 * v + k], 0),
    );
    return project(sum.map((x) => x / vertices.length));
  };
  /** A face that is seen from the front: its corners go counter-clockwise in the window. */
  const front = [...mesh.faces()].find((f) => {
    const [a, b, c] = [...mesh.faceVertices(f)].map(at);
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) < -2000;
  }) as number;
  return { mesh, at, middle, front };
}

async function click([x, y]: Point): Promise<string | null> {
  await explorer.page.mouse.move(x, y);
  await explorer.page.mouse.click(x, y);
  await explorer.page.waitForTimeout(50);
  return explorer.state('selected');
}

/** The point `pixels` from `from` on the way to `to`. */
function towards([x, y]: Point, [u, v]: Point, pixels: number): Point {
  const length = Math.hypot(u - x, v - y);
  return [x + ((u - x) * pixels) / length, y + ((v - y) * pixels) / length];
}

describe('A click', () => {
  test('picks the vertex, the edge, the halfedge or the face under it', async () => {
    const { mesh, at, middle, front } = await show(
      'icosahedron',
      'Icosahedron',
      HalfedgeMesh.icosahedron(),
    );
    const corners = [...mesh.faceVertices(front)];
    const centre = middle(...corners);
    expect(await click(centre)).toBe(`f${front}`);
    await explorer.screenshot('face-1280-light');
    for (const v of corners) expect(await click(at(v))).toBe(`v${v}`);
    for (const h of mesh.faceHalfedges(front)) {
      const edge = middle(mesh.fromVertex(h), mesh.toVertex(h));
      expect(await click(edge)).toBe(`e${mesh.edge(h)}`);
      expect(await click(towards(edge, centre, 7))).toBe(`h${h}`);
    }
    await explorer.screenshot('halfedge-1280-light');
  });

  test('picks a boundary halfedge beside the surface', async () => {
    const { mesh, middle } = await show('grid', 'Open grid', openGrid(6));
    const boundary = [...mesh.halfedges()].filter((h) => mesh.face(h) === NONE);
    for (const h of boundary.slice(0, 5)) {
      const edge = middle(mesh.fromVertex(h), mesh.toVertex(h));
      const inside = middle(...mesh.faceVertices(mesh.face(mesh.opposite(h))));
      expect(await click(towards(edge, inside, -7))).toBe(`h${h}`);
      expect(await explorer.page.textContent('.facts')).toContain('boundary');
      expect(await explorer.page.getAttribute('[data-link=face]', 'data-target')).toBe('∅');
    }
  });

  test('picks a concave polygon as the one face it is', async () => {
    const { at, middle } = await show('star', 'Star prism', starPrism());
    const centre = middle(0, 1, 2, 3, 4, 5, 6, 7, 8, 9);
    expect(await click(centre)).toBe('f0');
    for (const tip of [0, 2, 4, 6, 8]) {
      expect(await click(towards(at(tip), centre, 60))).toBe('f0');
    }
    expect(await explorer.page.textContent('.facts')).toContain('degree 10');
    await explorer.screenshot('concave-face-1280-light');
  });

  test('picks only what the mode says', async () => {
    const { mesh, at, middle, front } = await show(
      'icosahedron',
      'Icosahedron',
      HalfedgeMesh.icosahedron(),
    );
    const [a, b, c] = mesh.faceVertices(front);
    const nearA = towards(middle(a, b, c), at(a), 25);
    const modes = { vertex: `v${a}`, face: `f${front}` };
    for (const [mode, expected] of Object.entries(modes)) {
      await explorer.page.click(`[name=pick-mode][value=${mode}]`);
      expect(await click(nearA)).toBe(expected);
    }
    const nearEdge = towards(middle(a, b), middle(a, b, c), 25);
    await explorer.page.click('[name=pick-mode][value=edge]');
    expect(await click(nearEdge)).toBe(`e${mesh.findEdge(a, b)}`);
    await explorer.page.click('[name=pick-mode][value=halfedge]');
    expect(await click(nearEdge)).toBe(`h${mesh.findHalfedge(a, b)}`);
  });

  test('beside the mesh selects nothing', async () => {
    await show('icosahedron', 'Icosahedron', HalfedgeMesh.icosahedron());
    expect(await explorer.state('selected')).not.toBeNull();
    expect(await click([60, 400])).toBeNull();
    expect(await explorer.page.textContent('#inspector-title')).toBe('Nothing selected');
    await explorer.screenshot('nothing-selected-1280-light');
  });
});

describe('The pointer', () => {
  test('shows what a click would pick, and forgets it when it leaves', async () => {
    const { mesh, at, middle, front } = await show(
      'icosahedron',
      'Icosahedron',
      HalfedgeMesh.icosahedron(),
    );
    const corners = [...mesh.faceVertices(front)];
    await explorer.page.mouse.move(...middle(...corners));
    await explorer.until('hovered', `f${front}`);
    expect(await explorer.page.textContent('.readout')).toContain(`f${front} face`);
    await explorer.page.waitForSelector(`.tag.hover:text-is("f${front}")`); // with the next frame
    await explorer.screenshot('hovered-1280-light');
    await explorer.page.mouse.move(...at(corners[0]));
    await explorer.until('hovered', `v${corners[0]}`);
    await explorer.page.mouse.move(60, 400);
    await explorer.until('hovered', null);
  });

  test('turns the camera when it drags, and picks nothing then', async () => {
    const { mesh, middle, front } = await show(
      'icosahedron',
      'Icosahedron',
      HalfedgeMesh.icosahedron(),
    );
    const before = await explorer.state('camera');
    const selected = await explorer.state('selected');
    const [x, y] = middle(...mesh.faceVertices(front));
    await explorer.page.mouse.move(x, y);
    await explorer.page.mouse.down();
    await explorer.page.mouse.move(x + 60, y + 20, { steps: 5 });
    await explorer.page.mouse.up();
    await explorer.projection();
    expect(await explorer.state('camera')).not.toBe(before);
    expect(await explorer.state('selected')).toBe(selected);
  });
});

test('A mouse that moves while an edit takes the boundary away looks at no halfedge of the last frame', async () => {
  await show('grid', 'Open grid', openGrid(6));
  await explorer.goTo('f0');
  await explorer.rest();
  const undone = await explorer.page.evaluate(async () => {
    const canvas = document.querySelector('main.stage canvas') as HTMLElement;
    // The frame that the move asks for comes before the one that the edit asks for.
    const [clientX, clientY] = [450, 350];
    canvas.dispatchEvent(new PointerEvent('pointermove', { clientX, clientY, bubbles: true }));
    canvas.dispatchEvent(new KeyboardEvent('keydown', { key: 'X', shiftKey: true, bubbles: true }));
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    return document.querySelector<HTMLElement>('main.stage')?.dataset.undo;
  });
  expect(undone).toBe('1');
  await explorer.rest(); // no error is told of: see afterEach
});

test('A vertex without edges is drawn, hovered and clicked', async () => {
  const explorer = await ExplorerPage.open();
  await explorer.drop('lonely.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1.2 1.1 0\nf 1 2 3\n');
  await explorer.ready('lonely.obj');
  await explorer.page.click('[data-tab-button=circulate]');
  const at = (await explorer.projection())([1.2, 1.1, 0]);
  await explorer.page.mouse.move(at[0] - 60, at[1]);
  expect(await explorer.colours(at[0] - 3, at[1] - 3, 6, 6)).toBeGreaterThan(1);
  await explorer.page.mouse.move(...at);
  await explorer.until('hovered', 'v3');
  await explorer.page.mouse.click(...at);
  await explorer.until('selected', 'v3');
  expect(await explorer.page.textContent('.facts')).toContain('isolated');
  await explorer.screenshot('isolated-1280-light');
  expect(explorer.complaints).toEqual([]);
  await explorer.close();
});
