import { HalfedgeMesh, init } from 'halfedge';
import { disconnect, ExplorerPage, type Point } from './support/explorer.js';
import { disconnect as disconnectFigures, FigurePage } from './support/figures.js';
import { Fingers, strokes } from './support/fingers.js';

const PHONE = { width: 390, height: 844, phone: true };

beforeAll(() => init());
afterAll(async () => {
  await disconnect();
  await disconnectFigures();
});

describe('Fingers on the explorer', () => {
  const mesh = () => HalfedgeMesh.icosahedron();
  let explorer: ExplorerPage;
  let fingers: Fingers;
  let middle: Point;

  beforeAll(async () => {
    explorer = await ExplorerPage.open({
      ...PHONE,
      link: 'sample=icosahedron',
      mesh: 'Icosahedron',
    });
    fingers = await Fingers.on(explorer.page);
    middle = (await explorer.projection())([0, 0, 0]);
  });
  beforeEach(async () => {
    await explorer.page.focus('main.stage canvas');
    await explorer.press('Escape', '0');
    await explorer.rest();
  });
  afterEach(async () => {
    expect(explorer.complaints).toEqual([]);
    expect(await fingers.page()).toEqual({ scrolled: 0, zoom: 1 });
  });
  afterAll(() => explorer.close());

  /** Where the camera stands as seen from the middle of the mesh, and where that middle is in the window. */
  async function sight() {
    const project = await explorer.projection();
    const m = ((await explorer.state('camera')) ?? '').split(' ').map(Number);
    const length = Math.hypot(m[3], m[7], m[11]);
    const direction = [m[3], m[7], m[11]].map((x) => x / length);
    return { direction, distance: m[15] / length, middle: project([0, 0, 0]) };
  }
  const dot = (a: number[], b: number[]) => a.reduce((sum, x, i) => sum + x * b[i], 0);

  /** The vertex that is nearest to the eye, and where it is in the picture. */
  async function frontVertex(): Promise<{ front: number; at: Point }> {
    const { positions } = mesh();
    const project = await explorer.projection();
    const { direction } = await sight();
    const depth = (v: number) => dot([...positions.subarray(3 * v, 3 * v + 3)], direction);
    const [front] = [...mesh().vertices()].sort((a, b) => depth(a) - depth(b));
    return { front, at: project(positions.subarray(3 * front, 3 * front + 3)) };
  }

  test('a tap picks what is under it, and one beside the mesh nothing', async () => {
    const {
      front,
      at: [x, y],
    } = await frontVertex();
    await fingers.tap([x + 6, y + 5]); // no finger is exact
    expect(await explorer.state('selected')).toBe(`v${front}`);
    await fingers.tap([30, middle[1]]);
    expect(await explorer.state('selected')).toBe(null);
  });

  test('find the slider of a walk tall enough', async () => {
    const slider = explorer.page.locator('.scrub input');
    await fingers.tap((await frontVertex()).at);
    await explorer.page.click('[data-tab-button=circulate]');
    const box = await slider.boundingBox();
    await explorer.page.click('[data-tab-button=inspect]');
    expect(box?.height).toBeGreaterThanOrEqual(24);
  });

  test('reach further than a mouse', async () => {
    const {
      front,
      at: [x, y],
    } = await frontVertex();
    const beside = (pixels: number): Point => [x + 0.6 * pixels, y + 0.8 * pixels];
    await fingers.tap(beside(18));
    expect(await explorer.state('selected')).toBe(`v${front}`);
    await fingers.tap([30, middle[1]]); // two taps beside each other would be a double one
    await fingers.tap(beside(26));
    expect(await explorer.state('selected')).not.toBe(`v${front}`);
    await explorer.page.mouse.click(...beside(18));
    expect(await explorer.state('selected')).not.toBe(`v${front}`);
    await explorer.page.mouse.click(...beside(9));
    expect(await explorer.state('selected')).toBe(`v${front}`);
  });

  test('one finger turns the mesh, and picks nothing', async () => {
    const before = await sight();
    await fingers.move(
      ...strokes(middle, [
        [0, 0],
        [90, 60],
      ]),
    );
    const after = await sight();
    expect(dot(before.direction, after.direction)).toBeLessThan(0.9);
    expect(after.distance / before.distance).toBeCloseTo(1, 1);
    expect(await explorer.state('selected')).toBe(null);
    expect(await explorer.state('hovered')).toBe(null);
  });

  test('two fingers that part come nearer, and pick nothing', async () => {
    const before = await sight();
    await fingers.move(
      ...strokes(
        middle,
        [
          [-30, 0],
          [-90, 0],
        ],
        [
          [30, 0],
          [90, 0],
        ],
      ),
    );
    const after = await sight();
    expect(after.distance).toBeLessThan(0.6 * before.distance);
    expect(dot(before.direction, after.direction)).toBeGreaterThan(0.999);
    expect(await explorer.state('selected')).toBe(null);
  });

  test('two fingers side by side move the mesh with them', async () => {
    const before = await sight();
    await fingers.move(
      ...strokes(
        middle,
        [
          [-30, 0],
          [-30, -80],
        ],
        [
          [30, 0],
          [30, -80],
        ],
      ),
    );
    const after = await sight();
    expect(after.middle[1] - before.middle[1]).toBeLessThan(-50);
    expect(Math.abs(after.middle[0] - before.middle[0])).toBeLessThan(10);
    expect(after.distance / before.distance).toBeCloseTo(1, 1);
    expect(dot(before.direction, after.direction)).toBeGreaterThan(0.999);
    expect(await explorer.state('selected')).toBe(null);
  });

  test('two fingers that tap pick nothing', async () => {
    await fingers.tap(middle, [middle[0] + 40, middle[1]]);
    expect(await explorer.state('selected')).toBe(null);
  });
});

describe('Fingers on a figure', () => {
  const FIGURE =
    '<halfedge-figure src="shape:icosahedron" camera="0 0 1" controls></halfedge-figure>';
  let figures: FigurePage;
  let fingers: Fingers;
  let middle: Point;

  beforeEach(async () => {
    const text = '<p style="height: 300px">Text.</p>';
    figures = await FigurePage.open(`${text}${FIGURE}<p style="height: 2000px">More.</p>`, PHONE);
    await figures.ready();
    fingers = await Fingers.on(figures.page);
    const box = await figures.page.locator('halfedge-figure canvas').boundingBox();
    if (!box) throw new Error('There is no canvas.');
    middle = [box.x + box.width / 2, box.y + box.height / 2];
  });
  afterEach(async () => {
    expect(figures.complaints).toEqual([]);
    await figures.close();
  });

  /** Whether `act` has changed the picture. */
  async function changes(act: () => Promise<unknown>): Promise<boolean> {
    const picture = () =>
      figures.figure(({ shadowRoot }) => shadowRoot?.querySelector('canvas')?.toDataURL());
    const before = await picture();
    await act();
    return (await picture()) !== before;
  }

  test('up and down scrolls the page, as long as the figure is not chosen', async () => {
    const up = strokes(middle, [
      [0, 60],
      [0, -100],
    ]);
    expect(await changes(() => fingers.move(...up))).toBe(false);
    expect((await fingers.page()).scrolled).toBeGreaterThan(80);
    expect(await figures.events('halfedge-select')).toEqual([]);
  });

  test('from side to side turns it at once', async () => {
    const aside = strokes(middle, [
      [-50, 0],
      [50, 0],
    ]);
    expect(await changes(() => fingers.move(...aside))).toBe(true);
    expect(await fingers.page()).toEqual({ scrolled: 0, zoom: 1 });
    expect(await figures.events('halfedge-select')).toEqual([]);
  });

  test('after a tap, which picks, one finger turns it and two zoom; the page stays', async () => {
    await fingers.tap(middle);
    expect(await figures.events('halfedge-select')).toHaveLength(1);
    const gestures = [
      strokes(middle, [
        [0, 60],
        [0, -60],
      ]),
      strokes(
        middle,
        [
          [-20, 0],
          [-70, 0],
        ],
        [
          [20, 0],
          [70, 0],
        ],
      ),
    ];
    for (const gesture of gestures) {
      expect(await changes(() => fingers.move(...gesture))).toBe(true);
      expect(await fingers.page()).toEqual({ scrolled: 0, zoom: 1 });
    }
    expect(await figures.events('halfedge-select')).toHaveLength(1);
  });

  test('two fingers zoom the page, as long as the figure is not chosen', async () => {
    const apart = strokes(
      middle,
      [
        [-20, 0],
        [-80, 0],
      ],
      [
        [20, 0],
        [80, 0],
      ],
    );
    await fingers.move(...apart);
    expect((await fingers.page()).zoom).toBeGreaterThan(1.3);
    expect(await figures.events('halfedge-select')).toEqual([]);
  });
});
