import { HalfedgeMesh, init } from 'halfedge';
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

const names = (letter: string, items: Iterable<number>) => [...items].map((i) => letter + i);
const hop = async () => (await explorer.page.textContent('.hop'))?.replaceAll('\u00a0', ' ');

describe('The circulator player', () => {
  test('steps around the one-ring in the order of mesh.vertexVertices, both ways', async () => {
    for (const direction of ['ccw', 'cw'] as const) {
      await explorer.goTo('v0');
      await explorer.goTo('v1224');
      await explorer.page.check(`[name=direction][value=${direction}]`);
      const expected = names('v', mesh.vertexVertices(1224, direction));
      expect(await explorer.state('count')).toBe(String(expected.length));
      for (let i = 1; i <= expected.length; i++) {
        await explorer.page.click('[aria-label="Step forward"]');
        expect(await explorer.visited()).toEqual(expected.slice(0, i));
      }
      expect(await explorer.state('player')).toBe('done');
      expect(await explorer.page.isDisabled('[aria-label="Step forward"]')).toBe(true);
    }
    await explorer.page.check('[name=direction][value=ccw]');
  });

  test('tells in words what each hop did', async () => {
    await explorer.goTo('v0');
    await explorer.goTo('v1224');
    await explorer.press('.', '.');
    const [first, second] = mesh.vertexOutgoingHalfedges(1224);
    expect(await hop()).toBe(
      `opposite(prev(h${first})) = h${second} → vertex ${mesh.toVertex(second)}`,
    );
    expect(await explorer.page.textContent('.code')).toBe("mesh.vertexVertices(1224, 'ccw')");
  });

  test('steps back, and scrubs to any place', async () => {
    await explorer.goTo('v0');
    await explorer.goTo('v1224');
    const expected = names('v', mesh.vertexVertices(1224));
    await explorer.press('.', '.', '.', ',');
    expect(await explorer.visited()).toEqual(expected.slice(0, 2));
    await explorer.page.fill('.scrub input', '5');
    expect(await explorer.visited()).toEqual(expected.slice(0, 5));
    await explorer.page.click('ol.visited li:nth-child(1) button');
    expect(await explorer.visited()).toEqual(expected.slice(0, 1));
    await explorer.page.click('[aria-label="Back to the start"]');
    expect(await explorer.visited()).toEqual([]);
  });

  test('keeps the focus at the ends of the lap, and on the visit that is chosen', async () => {
    const focused = explorer.page.locator(':focus');
    await explorer.goTo('v0');
    await explorer.press('End', ',');
    await explorer.page.focus('[aria-label="Step forward"]');
    await explorer.press('Enter');
    expect(await explorer.state('player')).toBe('done');
    expect(await focused.getAttribute('aria-label')).toBe('Step forward');
    await explorer.page.focus('ol.visited li:nth-child(2) button');
    await explorer.press('Enter');
    expect(await explorer.visited()).toHaveLength(2);
    expect(await focused.getAttribute('data-ordinal')).toBe('2');
    await explorer.page.focus('main.stage canvas');
  });

  test('plays to the end of the lap, marks the trail, and plays again', async () => {
    await explorer.goTo('v0');
    await explorer.goTo('v1224');
    await explorer.press('z');
    const speed = (label: string) => explorer.page.selectOption('.speed', { label });
    // At first slowly: on a busy machine it may be over before this process hears of it.
    await speed('0.5 a second');
    await explorer.page.click('.play');
    await explorer.page.waitForSelector(
      'body:has(main.stage[data-player=playing]) .play[aria-label=Pause]',
    );
    await speed('8 a second');
    await explorer.until('player', 'done');
    expect(await explorer.visited()).toEqual(names('v', mesh.vertexVertices(1224)));
    const count = Number(await explorer.state('count'));
    await explorer.page.waitForSelector(`.tag.current:text-is("${count}")`); // with the next frame
    const ordinals = await explorer.page.$$eval('.tag.ordinal:not(.away)', (all) =>
      all.map((tag) => tag.textContent),
    );
    expect(ordinals).toEqual(Array.from({ length: count - 1 }, (_, i) => String(count - 1 - i)));
    await explorer.screenshot('one-ring-1280-light');
    await speed('0.5 a second');
    await explorer.press('Space');
    await explorer.until('player', 'playing');
    await speed('8 a second');
    await explorer.until('player', 'done');
  });

  test('pauses where it is, and goes on from there', async () => {
    await explorer.goTo('v0');
    await explorer.goTo('v1224');
    await explorer.page.selectOption('.speed', { label: '1 a second' });
    await explorer.press('Space');
    // The first step or a later one: a busy machine may take a second to see it.
    await explorer.page.waitForSelector('main.stage[data-position]:not([data-position="0"])');
    await explorer.press('Space');
    await explorer.until('player', 'paused');
    const position = await explorer.state('position');
    await explorer.page.waitForTimeout(1300);
    expect(await explorer.state('position')).toBe(position);
    await explorer.page.selectOption('.speed', { label: '8 a second' });
    await explorer.page.click('.play');
    await explorer.until('player', 'done');
    expect(await explorer.visited()).toEqual(names('v', mesh.vertexVertices(1224)));
  });

  test('offers every circulator of the selected item', async () => {
    const kinds = () =>
      explorer.page.$$eval('[name=circulator]', (inputs) =>
        inputs.map((input) => (input as HTMLInputElement).value),
      );
    await explorer.goTo('v7');
    expect(await kinds()).toEqual([
      'vertexVertices',
      'vertexOutgoingHalfedges',
      'vertexIncomingHalfedges',
      'vertexEdges',
      'vertexFaces',
    ]);
    await explorer.goTo('f7');
    expect(await kinds()).toEqual(['faceVertices', 'faceHalfedges', 'faceEdges', 'faceFaces']);
    await explorer.goTo('e7');
    expect(await kinds()).toEqual(['edgeVertices', 'edgeHalfedges', 'edgeFaces']);
    expect(await explorer.page.isVisible('[name=direction]')).toBe(false);
    await explorer.page.check('[value=edgeFaces]');
    await explorer.press('End');
    expect(await explorer.visited()).toEqual(names('f', mesh.edgeFaces(7)));
  });

  test('goes around the vertex and the face of a halfedge, from there', async () => {
    await explorer.goTo('h500');
    await explorer.press('End');
    expect(await explorer.visited()).toEqual(names('h', mesh.halfedgeLoop(500)));
    await explorer.page.check('[name=around][value="1"]');
    await explorer.page.check('[value=vertexFaces]');
    await explorer.press('c', 'End');
    const v = mesh.fromVertex(500);
    expect(await explorer.page.textContent('.code')).toBe(`mesh.vertexFaces(${v}, 'cw', 500)`);
    expect(await explorer.visited()).toEqual(names('f', mesh.vertexFaces(v, 'cw', 500)));
    await explorer.page.check('[name=around][value="2"]');
    await explorer.page.check('[value=faceFaces]');
    await explorer.press('End');
    const f = mesh.face(500);
    expect(await explorer.visited()).toEqual(names('f', mesh.faceFaces(f, 'cw', 500)));
    await explorer.press('c', 'z');
    await explorer.screenshot('face-faces-1280-light');
  });
});

test('The circulator player visits a boundary vertex as an open path, in the dark', async () => {
  const dark = await ExplorerPage.open({ dark: true });
  await dark.sample('grid', 'Open grid');
  await dark.goTo('v3');
  await dark.press('z', 'End');
  // 7 vertices to a row: the path runs from one boundary neighbour of v3 to the other.
  expect(await dark.visited()).toEqual(['v4', 'v10', 'v2']);
  expect(await dark.page.textContent('.facts')).toContain('boundary');
  await dark.screenshot('boundary-vertex-1280-dark');
  expect(dark.complaints).toEqual([]);
  await dark.close();
});

describe('The camera of the player', () => {
  /** Plays a lap step by step, or in one leap; the numbers in the picture then, and whether the camera has moved. */
  async function lapOf(link: string, name: string, leaps = false) {
    const page = await ExplorerPage.open({ link, mesh: name });
    await page.rest();
    const before = await page.state('camera');
    for (let i = leaps ? 1 : Number(await page.state('count')); i > 0; i--) {
      await page.press(leaps ? 'End' : '.');
      await page.rest();
    }
    const tags = await page.page.$$eval(
      '.tag:is(.ordinal, .current):not(.away):not([hidden])',
      (all) => all.map((tag) => Number(tag.textContent)),
    );
    const moved = (await page.state('camera')) !== before;
    const count = Number(await page.state('count'));
    expect(page.complaints).toEqual([]);
    await page.close();
    return { numbers: tags.sort((a, b) => a - b), count, moved };
  }

  test.each([
    ['sample=bunny', 'Bunny'],
    ['sample=bunny&select=h500', 'Bunny'],
    ['sample=torus', 'Torus'],
  ])('comes near enough for all numbers to be read: %s', async (link, name) => {
    const { numbers, count, moved } = await lapOf(link, name);
    expect(numbers).toEqual(Array.from({ length: count }, (_, i) => i + 1));
    expect(moved).toBe(true);
  });

  test('comes as near for a leap to the end, but not for other names of what is shown', async () => {
    const { numbers, count, moved } = await lapOf('sample=bunny', 'Bunny', true);
    expect(numbers).toEqual(Array.from({ length: count }, (_, i) => i + 1));
    expect(moved).toBe(true);
    const page = await ExplorerPage.open({ link: 'sample=bunny&at=3&query=vertexVertices' });
    await page.press('0');
    await page.rest();
    const far = await page.state('camera');
    await page.page.selectOption('[name=dialect]', 'cgal');
    await page.rest();
    expect([await page.state('position'), await page.state('camera')]).toEqual(['3', far]);
    await page.close();
  });

  test.each([
    'sample=cube&select=f0',
    'sample=cube&edits=reverse&select=f0', // faces show their backs
  ])(
    'turns to the selected item where a walk begins behind the mesh, and to the items after it: %s',
    async (link) => {
      const page = await ExplorerPage.open({ link, mesh: 'Cube' });
      const cube = HalfedgeMesh.cube();
      /** Whether a face looks towards the camera: of a cube, whether it is seen. */
      const isSeen = async (f: number) => {
        const onScreen = await page.projection();
        const corners = [...cube.faceVertices(f)].map((v) =>
          onScreen(cube.positions.subarray(3 * v, 3 * v + 3)),
        );
        const turns = corners.reduce((sum, [x, y], i) => {
          const [nextX, nextY] = corners[(i + 1) % corners.length];
          return sum + x * nextY - y * nextX;
        }, 0);
        return turns < 0; // counter-clockwise, where y grows downwards
      };
      expect(await isSeen(0)).toBe(true);
      for (let i = 0; i < 26; i++) await page.press('ArrowLeft'); // half a turn
      expect(await isSeen(0)).toBe(false);
      await page.page.check('[value=faceFaces]');
      await page.page.focus('main.stage canvas');
      for (let i = 0; i < 4; i++) {
        await page.press('.');
        const f = Number((await page.visited()).at(-1)?.slice(1));
        const faces = i === 0 ? [0, f] : [f];
        const areSeen = async () => (await Promise.all(faces.map(isSeen))).every(Boolean);
        expect(await page.comesTrue(areSeen)).toBe(true);
      }
      expect(page.complaints).toEqual([]);
      await page.close();
    },
  );

  test.each([
    ['sample=cube&select=v2', 'Cube', 'c'],
    ['sample=icosahedron&select=v2', 'Icosahedron', '+++'],
    ['sample=torus&select=v40', 'Torus', ''],
    ['sample=torus&select=f7&query=faceFaces', 'Torus', ''],
  ])(
    'turns once for a short walk, and keeps the selected item in sight: %s',
    async (link, name, keys) => {
      const page = await ExplorerPage.open({ link, mesh: name });
      await page.page.focus('main.stage canvas');
      for (const key of keys) await page.press(key);
      const cameras = new Set<string | null>();
      const count = Number(await page.state('count'));
      for (let i = 1; i <= count; i++) {
        await page.press('.');
        await page.rest();
        cameras.add(await page.state('camera'));
        for (const tag of ['.tag.self', `.tag.current:text-is("${i}")`]) {
          expect(await page.page.isVisible(`${tag}:not(.behind, .away)`)).toBe(true);
        }
      }
      expect(count).toBeGreaterThan(2);
      expect(cameras.size).toBe(1);
      expect(page.complaints).toEqual([]);
      await page.close();
    },
  );

  test('turns in time to what comes to lie behind the horizon', async () => {
    const page = await ExplorerPage.open();
    await page.broken('crack', 'Crack');
    await page.goTo('h967'); // on the crack, which runs around the sphere
    await page.press('1');
    for (let i = 1; i <= 28; i++) {
      await page.press('.');
      const isSeen = () => page.page.isVisible(`.tag.current:not(.behind, .away):text-is("${i}")`);
      expect(await page.comesTrue(isSeen)).toBe(true);
    }
    expect(page.complaints).toEqual([]);
    await page.close();
  });

  test('ends as near to the selected item as it began to fly, whatever is visited meanwhile', async () => {
    const page = await ExplorerPage.open({ motion: true });
    await page.page.focus('main.stage canvas');
    for (let i = 0; i < 26; i++) await page.press('ArrowLeft'); // half a turn
    await page.rest();
    await page.page.evaluate(() => {
      const step = () => new KeyboardEvent('keydown', { key: '.', bubbles: true });
      for (let i = 0; i < 3; i++) document.activeElement?.dispatchEvent(step());
    });
    const camera = async () => {
      await page.rest();
      return ((await page.state('camera')) ?? '').split(' ').map(Number);
    };
    const after = await camera();
    expect(await page.visited()).toHaveLength(3);
    await page.press('z'); // to the selected item
    for (const [i, number] of (await camera()).entries()) expect(number).toBeCloseTo(after[i], 3);
    expect(page.complaints).toEqual([]);
    await page.close();
  });

  test.each([
    ['sample=cube&select=f3', 'Cube'],
    ['sample=grid', 'Open grid'],
  ])('stays where the faces are large: %s', async (link, name) => {
    expect((await lapOf(link, name)).moved).toBe(false);
  });
});
