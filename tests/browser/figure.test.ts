import type { HalfedgeFigure } from 'halfedge/figure';
import { closeFigures, disconnect, type FigurePage, figures, ONE_RING } from './support/figures.js';

afterEach(closeFigures);
afterAll(disconnect);

describe('A figure', () => {
  test('takes the word false for what it says', async () => {
    const page = await figures(
      '<halfedge-figure src="shape:cube" build="false" autoplay="false"></halfedge-figure>',
    );
    await page.ready();
    const flags = () => page.figure(({ build, autoplay }) => [build, autoplay]);
    expect(await flags()).toEqual([false, false]);
    await page.figure((figure) => figure.setAttribute('build', ''));
    expect(await flags()).toEqual([true, false]);
    await page.figure((figure) => figure.setAttribute('build', 'false'));
    expect(await flags()).toEqual([false, false]);
    await page.figure((figure) => Object.assign(figure, { autoplay: true }));
    expect(await page.figure((figure) => figure.hasAttribute('autoplay'))).toBe(true);
  });

  test('plays the circulator that it is asked for, and tells each step', async () => {
    const page = await figures(ONE_RING, { motion: true });
    await page.ready();
    await page.figure((figure) => {
      figure.speed = 20;
      figure.play();
    });
    await page.page.waitForSelector('halfedge-figure[step="5"]');
    const steps = await page.events('halfedge-step');
    expect(steps.map(({ step }) => step)).toEqual([1, 2, 3, 4, 5]);
    const items = await page.figure(({ mesh }) => [...(mesh?.vertexVertices(3) ?? [])].map(String));
    expect(steps.map(({ item }) => item)).toEqual(items.map((v) => `v${v}`));
    expect(await page.sentence()).toBe(steps[4].sentence);
    expect(await page.figure(({ playing }) => playing)).toBe(false);
    expect(page.complaints).toEqual([]);
  });

  test('refuses an operation on what an earlier one has deleted', async () => {
    const page = await figures(
      '<halfedge-figure src="shape:cube" operation="deleteFace f0, splitFace f0" controls></halfedge-figure>',
    );
    await page.ready();
    await page.figure((figure) => figure.seek(9));
    expect(await page.figure(({ step }) => step)).toBe(2);
    expect(await page.sentence()).toContain('f is face 0, which was deleted; expected a live one.');
    expect(page.complaints).toEqual([]);
  });

  test('is played, stepped, turned and walked by keys and buttons', async () => {
    const page = await figures(ONE_RING);
    await page.ready();
    await page.page.focus('halfedge-figure canvas');
    for (const key of ['.', '.', '.', ',']) await page.page.keyboard.press(key);
    expect(await page.figure(({ step }) => step)).toBe(2);
    expect(await page.sentence()).toContain('→ vertex');
    await page.page.click('halfedge-figure [aria-label="Step forward"]');
    expect(await page.figure(({ step }) => step)).toBe(3);
    await page.page.click('halfedge-figure [part~=direction]');
    await page.figure(async (figure) => void (await figure.updateComplete));
    expect(await page.figure(({ direction, step }) => [direction, step])).toEqual(['cw', 3]);
    await page.page.focus('halfedge-figure canvas');
    await page.page.keyboard.press('h');
    expect(await page.events('halfedge-select')).toEqual([{ item: expect.stringMatching(/^h\d/) }]);
  });

  test('pauses by the button by which it plays', async () => {
    const page = await figures(ONE_RING.replace('select', 'speed="0.1" select'));
    await page.ready();
    await page.page.click('halfedge-figure .play');
    expect(await page.figure(({ playing }) => playing)).toBe(true);
    await page.page.click('halfedge-figure .play');
    expect(await page.figure(({ playing }) => playing)).toBe(false);
  });

  test('is ready with the mesh that it was asked for last, or not at all', async () => {
    const page = await figures('<halfedge-figure src="shape:cube"></halfedge-figure>');
    await page.ready();
    const faces = await page.page.evaluate(async () => {
      const figure = document.querySelector('halfedge-figure') as HalfedgeFigure;
      figure.src = 'shape:torus(8,6)';
      const { faceCount } = await figure.ready();
      figure.src = 'shape:nothing';
      const missing = await figure.ready().then(
        () => 'ready',
        (error) => error.message,
      );
      return [faceCount, missing];
    });
    expect(faces).toEqual([48, expect.stringContaining('nothing')]);
  });

  test('lights the line that runs, in the names of the library that is chosen', async () => {
    const page = await figures(ONE_RING);
    await page.ready();
    await page.figure((figure) => figure.seek(2));
    await page.page.selectOption('halfedge-figure select', 'openmesh');
    await page.figure(async (figure) => void (await figure.updateComplete));
    const current = await page.page.textContent('halfedge-figure .code [aria-current=step]');
    expect(current?.trim()).toBe('yield om.to_vertex_handle(h);');
  });

  test('selects what is clicked', async () => {
    const page = await figures('<halfedge-figure src="shape:grid(1, 1)"></halfedge-figure>');
    await page.ready();
    await page.page.click('halfedge-figure canvas');
    expect(await page.events('halfedge-select')).toEqual([{ item: 'f0' }]);
    expect(await page.figure(({ select }) => select)).toBe('f0');
  });

  test('shows an operation before and after, and takes it back', async () => {
    const page = await figures(
      '<halfedge-figure src="shape:grid(3, 2, triangles)" operation="flip e14" controls></halfedge-figure>',
    );
    await page.ready();
    const ends = () =>
      page.figure(({ mesh }) => [...(mesh?.edgeVertices(14) ?? [])].map(Number).sort());
    const before = await ends();
    expect(await page.sentence()).toBe('Before: flip e14.');
    await page.figure((figure) => figure.stepForward());
    expect(await page.sentence()).toBe('Done: flip e14.');
    expect(await ends()).not.toEqual(before);
    await page.figure((figure) => figure.stepBack());
    expect(await ends()).toEqual(before);
  });

  test('says why an operation is refused, and with which witness', async () => {
    const page = await figures(
      '<halfedge-figure src="shape:tetrahedron" operation="collapse h2" controls></halfedge-figure>',
    );
    await page.ready();
    await page.figure((figure) => figure.stepForward());
    const [refused] = await page.events('halfedge-refused');
    expect(refused.code).toBe('leaves-pillow');
    expect(await page.sentence()).toBe(`Refused: collapse h2. ${refused.message}`);
    expect(await page.figure(({ mesh }) => mesh?.validate())).toEqual([]);
    await page.page.waitForSelector('halfedge-figure .tag.witness'); // with the next frame
    const marked = await page.page.$$eval('halfedge-figure .tag.witness', (tags) =>
      tags.map(({ textContent }) => textContent),
    );
    expect(marked).toHaveLength(refused.witness.edges.length + refused.witness.faces.length);
  });

  test('builds a list of faces one by one, up to one that is the wrong way round', async () => {
    const page = await figures(`<halfedge-figure build controls><script type="text/plain">
OFF
4 2 0
0 0 0
1 0 0
1 1 0
0 1 0
3 0 1 2
3 0 2 1
</script></halfedge-figure>`);
    await page.ready();
    await page.figure((figure) => figure.seek(1));
    expect(await page.sentence()).toBe('f0 = addFace(0, 1, 2): all its edges are new.');
    await page.figure((figure) => figure.seek(2));
    expect(await page.sentence()).toMatch(/^(f1 = addFace|Refused: face 1)/);
  });

  test.each([
    ['prism', 8],
    ['cone', 33],
    ['cylinder', 34],
    ['grid', 100],
    ['grid(4, triangles)', 32],
    ['grid(triangles)', 200],
    ['torus', 512],
    ['torus(8)', 128],
    ['uvSphere(radius=2)', 512],
    ['icoSphere', 1280],
  ])('makes shape:%s, whose numbers have defaults, of %d faces', async (shape, faces) => {
    const page = await figures(`<halfedge-figure src="shape:${shape}"></halfedge-figure>`);
    await page.ready();
    expect(await page.figure(({ mesh }) => mesh?.faceCount)).toBe(faces);
  });

  test.each([
    ['src="shape:blob"', 'src is “shape:blob”; expected shape: and one of tetrahedron'],
    ['src="shape:torus(8, 6"', 'src is “shape:torus(8, 6”; expected shape:torus(…), closed.'],
    ['src="shape:cube(3)"', 'src is “shape:cube(3)”; expected no number.'],
    ['src="shape:cone(8, 2)"', 'src is “shape:cone(8, 2)”; expected 1 number at most.'],
    ['src="shape:torus(2)"', 'rings is 2; expected an integer from 3'],
    ['src="http://["', 'src is “http://[”; expected the address of a file, or shape:'],
    ['src="nowhere.off"', 'nowhere.off could not be fetched: the server answered 404.'],
    ['', 'This figure has no mesh'],
    [
      'src="shape:cube" select="v99"',
      'select is “v99”: this mesh does not have v99; it has vertex 0 to 7.',
    ],
    [
      'src="shape:cube" operation="flip e99"',
      'operation is “flip e99”: this mesh does not have e99; it has',
    ],
    [
      'src="shape:torus(8 6)"',
      'src is “shape:torus(8 6)”; expected commas between numbers, found “8 6”.',
    ],
    [
      'src="shape:torus(2, 6)"',
      'src is “shape:torus(2, 6)”: rings is 2; expected an integer from 3 on.',
    ],
    ['src="shape:cube" query="friends"', 'query is “friends”; expected one of vertexVertices'],
    ['src="shape:cube" select="f0" query="vertexFaces"', 'vertexFaces goes around a vertex; f0 is'],
    [
      'src="shape:cube" direction="up" query="vertexFaces"',
      'direction is “up”; expected ccw or cw.',
    ],
    ['src="shape:cube" overlays="glitter"', 'overlays has “glitter”; expected some of halfedges'],
    ['src="shape:cube" operation="melt e3"', '“melt e3” is no operation on an edge'],
    ['src="shape:cube" camera="1 2"', 'camera is “1 2”; expected three numbers'],
    [
      'src="shape:cube" camera="1e300,0,0"',
      'camera is “1e300,0,0”; expected numbers below 3.4e38.',
    ],
    [
      'src="shape:cube" camera="0 0 0"',
      'camera is “0 0 0”; expected a direction, other than 0 0 0.',
    ],
    ['src="shape:cube" camera="1 2 3 1 2 3"', 'expected that it stands elsewhere than where it'],
    ['src="shape:cube" up="x"', 'up is “x”; expected y or z.'],
    ['src="shape:cube" step="abc"', 'step is no number; expected how many steps are made.'],
    ['src="shape:cube" speed="fast"', 'speed is no number; expected steps a second, more than 0.'],
    ['src="shape:cube" speed="0"', 'speed is 0; expected steps a second'],
    ['src="shape:cube" theme="Dark"', 'theme is “Dark”; expected auto, light or dark.'],
    ['src="shape:cube" loading="now"', 'loading is “now”; expected lazy or eager.'],
    ['src="shape:cube" controls="palyer"', 'controls has “palyer”; expected some of player, code.'],
  ])('with %s says what is wrong', async (attributes, sentence) => {
    const page = await figures(`<halfedge-figure ${attributes}></halfedge-figure>`);
    await page.page.waitForSelector('halfedge-figure [part=error]');
    expect(await page.page.textContent('halfedge-figure [part=error]')).toContain(sentence);
    expect(await page.events('halfedge-error')).toHaveLength(1);
  });

  test.each([
    ['before its first', -3, 'stepForward', 1],
    ['after its last', 99, 'stepBack', 2],
  ] as const)('steps on from a step %s', async (_where, step, move, reached) => {
    const page = await figures(
      `<halfedge-figure src="shape:cube" query="vertexVertices" select="v0" step="${step}"></halfedge-figure>`,
    );
    await page.ready();
    const told = await page.page.$eval(
      'halfedge-figure',
      async (figure, { step, move }) => {
        figure.step = step;
        await figure.updateComplete;
        figure[move]();
        return figure.step;
      },
      { step, move },
    );
    expect(told).toBe(reached);
  });

  test('follows a wrong attribute that is corrected, and tells what is still wrong', async () => {
    const page = await figures(
      '<halfedge-figure src="shape:cube" camera="1 2" controls="palyer"></halfedge-figure>',
    );
    await page.ready();
    const failure = async (attribute: string, value: string) => {
      await page.page.$eval(
        'halfedge-figure',
        (figure, [name, text]) => figure.setAttribute(name, text),
        [attribute, value],
      );
      await page.figure(async (figure) => void (await figure.updateComplete));
      const error = await page.page.$('halfedge-figure [part=error]');
      return error && (await error.textContent());
    };
    expect(await failure('camera', '1 2 x')).toContain('camera is “1 2 x”; expected three');
    expect(await failure('select', 'v99')).toContain('select is “v99”');
    expect(await failure('camera', '0 0 1')).toContain('select is “v99”');
    expect(await failure('select', 'v1')).toContain('controls has “palyer”');
    expect(await failure('controls', 'player')).toBe(null);
    expect(await failure('speed', '-1')).toContain('speed is -1;');
    await page.page.$eval('halfedge-figure', (figure) => figure.removeAttribute('speed'));
    expect(await failure('controls', 'player code')).toBe(null);
    expect(await page.figure(({ state }) => state)).toBe('ready');
    const before = await page.settled();
    expect(await failure('camera', '1 0 0')).toBe(null);
    expect(await page.settled()).toBeGreaterThan(before);
  });

  test.each(['removed', 'set to undefined, as frameworks do'])(
    'is as if an attribute had never been there when it is %s',
    async (how) => {
      const page = await figures(
        `<halfedge-figure src="shape:cube" select="v1" query="vertexVertices" step="2" direction="cw" dialect="cgal"
          speed="2" overlays="labels" controls="code" camera="1 1 1" up="z" theme="dark" loading="eager"></halfedge-figure>`,
      );
      await page.ready();
      await page.page.$eval(
        'halfedge-figure',
        (figure, isRemoved) => {
          const names = 'direction dialect speed overlays camera up theme loading'.split(' ');
          for (const name of names) {
            if (isRemoved) figure.removeAttribute(name);
            else Object.assign(figure, { [name]: undefined });
          }
        },
        how === 'removed',
      );
      await page.figure(async (figure) => void (await figure.updateComplete));
      expect(await page.page.$('halfedge-figure [part=error]')).toBe(null);
      expect(await page.sentence()).toBe('opposite(prev(h6)) = h3 → vertex 0');
      expect(
        await page.figure(({ direction, dialect, speed }) => [direction, dialect, speed]),
      ).toEqual(['ccw', 'halfedge', 1.5]);
      expect(page.complaints).toEqual([]);
    },
  );

  test('takes operations back where the attribute names none any more', async () => {
    const page = await figures(
      '<halfedge-figure src="shape:grid(3, 2, triangles)" operation="flip e14" step="1"></halfedge-figure>',
    );
    await page.ready();
    const before = await page.settled();
    await page.figure((figure) => figure.setAttribute('operation', 'melt e14'));
    expect(await page.settled()).toBeGreaterThan(before);
  });

  test('draws the mesh as a program has left it, and selects nothing that is gone', async () => {
    const page = await figures(ONE_RING);
    await page.ready();
    /** Deletes a vertex; tells what is selected then, the step, and the visits in the picture. */
    const deleted = async (vertex: number) => {
      await page.page.$eval(
        'halfedge-figure',
        async (it, v) => {
          const figure = it as HalfedgeFigure;
          figure.mesh?.deleteVertex(v);
          figure.refresh();
          await figure.updateComplete;
        },
        vertex,
      );
      await page.settled();
      const { select, step } = await page.figure(({ select, step }) => ({ select, step }));
      const tags = await page.page.$$eval('halfedge-figure .tag:is(.ordinal, .current)', (them) =>
        them.map(({ textContent }) => textContent),
      );
      return { select, step, tags };
    };
    const ring = await page.figure((figure) => {
      figure.seek(5);
      return [...(figure.mesh?.vertexVertices(3) ?? [])].map(Number);
    });
    const { select, step } = await deleted(ring[1]);
    expect([select, step]).toEqual(['v3', 4]);
    expect(await page.sentence()).toContain('→ vertex');
    // Its attributes say now that it goes around the first vertex.
    expect(await deleted(3)).toEqual({ select: null, step: 4, tags: ['4', '3', '2', '1'] });
    expect(page.complaints).toEqual([]);
    expect(await page.events('halfedge-error')).toEqual([]);
  });

  test.each<[how: string, act: (page: FigurePage) => Promise<unknown>]>([
    ['refreshed', (page) => page.figure((figure) => figure.refresh())],
    ['to be seen whole', (page) => page.figure((figure) => figure.fit())],
    ['told to step', (page) => page.figure((figure) => figure.stepForward())],
    ['told to play', (page) => page.figure((figure) => figure.play())],
    [
      'told to select',
      (page) => page.figure((figure) => void Object.assign(figure, { select: 'v2' })),
    ],
    [
      'walked by a key',
      async ({ page }) => {
        await page.focus('halfedge-figure canvas');
        await page.keyboard.press('n');
      },
    ],
    ['clicked', ({ page }) => page.click('halfedge-figure canvas')],
    [
      'resized with the window',
      async ({ page }) => {
        await page.setViewportSize({ width: 500, height: 700 });
        await page.waitForSelector('halfedge-figure [part=error]', { timeout: 5000 });
      },
    ],
    ['shown in the dark', ({ page }) => page.emulateMedia({ colorScheme: 'dark' })],
  ])('tells that its mesh was disposed of when it is %s, and shows another', async (_how, act) => {
    const page = await figures(ONE_RING);
    await page.ready();
    await page.settled();
    await page.figure((figure) => figure.mesh?.dispose());
    await act(page);
    await page.figure(async (figure) => void (await figure.updateComplete));
    const told =
      'A program has disposed of the mesh, which belongs to the figure: set src or bytes to show another one.';
    expect(await page.page.textContent('halfedge-figure [part=error]')).toBe(told);
    const errors = await page.events('halfedge-error');
    expect(errors.map(({ message }) => message)).toEqual([told]);
    const shown = await page.figure(async (figure) => {
      const lost = figure.state;
      const refused = await figure.ready().catch((error: Error) => error.message);
      figure.src = 'shape:cube';
      const mesh = await figure.ready();
      return [lost, refused, figure.state, mesh.vertexCount];
    });
    expect(shown).toEqual(['failed', told, 'ready', 8]);
    expect(page.complaints).toEqual([]);
  });

  test('plays on while a program moves vertices', async () => {
    const page = await figures(ONE_RING, { motion: true });
    await page.ready();
    const playing = await page.figure((figure) => {
      figure.play();
      (figure.mesh as { positions: Float32Array }).positions[0] += 0.1;
      figure.refresh();
      return [figure.playing, figure.step];
    });
    expect(playing).toEqual([true, 1]);
  });

  test('keeps its controls where something is picked that its walk does not go around', async () => {
    const page = await figures(ONE_RING);
    await page.ready();
    await page.figure((figure) => figure.seek(3));
    const heights = () =>
      page.page.$$eval('halfedge-figure :is(.bar, .code)', (all) =>
        all.map((each) => each.getBoundingClientRect().height),
      );
    const enabled = () =>
      page.page.$$eval(
        'halfedge-figure :is(.bar, .code) :is(button, input, select):not(:disabled)',
        (all) => all.length,
      );
    expect(await enabled()).toBeGreaterThan(5);
    await page.page.focus('halfedge-figure canvas');
    await page.page.keyboard.press('h');
    await page.figure(async (figure) => void (await figure.updateComplete));
    const before = await heights();
    await page.page.keyboard.press('f');
    await page.figure(async (figure) => void (await figure.updateComplete));
    expect(await page.figure(({ select }) => select)).toMatch(/^f/);
    expect(await enabled()).toBe(0);
    expect(await page.page.textContent('halfedge-figure output')).toBe('0 of 5');
    expect(await page.page.$('halfedge-figure .code [aria-current=step]')).toBe(null);
    expect(await heights()).toEqual(before);
    expect(await page.events('halfedge-error')).toEqual([]);
  });

  test('has nothing to play where the first operation is refused', async () => {
    const page = await figures(
      '<halfedge-figure src="shape:tetrahedron" operation="collapse h2, flip e1" controls></halfedge-figure>',
    );
    await page.ready();
    const disabled = () => page.page.isDisabled('halfedge-figure .play');
    expect(await disabled()).toBe(false);
    await page.page.click('halfedge-figure .play');
    expect(await page.sentence()).toContain('Refused: collapse h2.');
    expect(await disabled()).toBe(true);
    await page.page.click('halfedge-figure .restart');
    await page.figure(async (figure) => void (await figure.updateComplete));
    expect(await disabled()).toBe(false);
  });

  test.each([true, false])('stands meshes up whose z points up (WebGL: %s)', async (webgl) => {
    const tower = 'OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 3\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n';
    const page = await figures(
      `<halfedge-figure camera="-2 -3 1"><template>${tower}</template></halfedge-figure>`,
      { webgl },
    );
    await page.ready();
    /** Where the name of a vertex is in the window, once it is selected. */
    const placeOf = async (name: string) => {
      await page.page.$eval(
        'halfedge-figure',
        (figure, vertex) => figure.setAttribute('select', vertex),
        name,
      );
      if (webgl) await page.settled();
      const label = page.page.locator(`halfedge-figure ${webgl ? '.tag' : '.poster text'}`, {
        hasText: name,
      });
      const { x, y } = (await label.boundingBox()) ?? { x: NaN, y: NaN };
      return { x, y };
    };
    const rise = async () => {
      const [foot, top] = [await placeOf('v0'), await placeOf('v3')];
      return [top.x - foot.x, foot.y - top.y] as const;
    };
    const [aside] = await rise();
    expect(Math.abs(aside)).toBeGreaterThan(20);
    await page.figure((figure) => figure.setAttribute('up', 'z'));
    const [right, up] = await rise();
    expect(up).toBeGreaterThan(100);
    expect(Math.abs(right)).toBeLessThan(0.2 * up);
  });

  test('without WebGL names faintly what is hidden, and follows keys', async () => {
    const corner = '<halfedge-figure src="shape:cube" select="v0" query="vertexFaces" camera=';
    const page = await figures(`${corner}"1 1.2 1.4" step="3" controls></halfedge-figure>`, {
      webgl: false,
    });
    await page.ready();
    /** The names in the picture that are seen well. */
    const seen = async () => {
      await page.figure(async (figure) => void (await figure.updateComplete));
      return page.page.$$eval('halfedge-figure .poster text', (them) =>
        them.filter((it) => it.getAttribute('opacity') === '1').map((it) => it.textContent),
      );
    };
    const press = (key: string) => page.page.press('halfedge-figure canvas', key);
    const [x] = await page.figure(({ mesh }) => [...(mesh?.position(0) ?? [])]);
    expect(x).toBeLessThan(0); // so it looks from the other side
    expect(await seen()).toEqual([]);
    await page.figure((figure) => figure.setAttribute('camera', '-1 -1.2 -1.4'));
    expect(await seen()).toEqual(['1', '2', '3', 'v0']);
    for (let i = 0; i < 18; i++) await press('ArrowRight');
    expect((await seen()).length).toBeLessThan(4);
    const before = await page.page.getAttribute('halfedge-figure .poster polygon', 'points');
    await press('+');
    await seen();
    const after = await page.page.getAttribute('halfedge-figure .poster polygon', 'points');
    expect(after).not.toBe(before);
    await press(',');
    expect(await page.figure(({ step }) => step)).toBe(2);
    await press('h');
    expect(await page.figure(({ select }) => select)).toMatch(/^h/);
  });

  test('takes another mesh after the first, by its address or as bytes, with a trail in it', async () => {
    const page = await figures(ONE_RING.replace('code', 'code" overlays="vertex-labels'));
    await page.ready();
    await page.figure(async (figure) => {
      figure.query = null;
      figure.src = 'shape:cube';
      figure.select = 'v0';
      await figure.updateComplete;
      const cube = await figure.ready();
      figure.bytes = cube.toBytes();
      figure.trail = {
        steps: [{ item: 'v1', sentence: 'First.' }, { item: 'v3' }],
        missing: ['v7'],
      };
      figure.step = 2;
      await figure.updateComplete;
      await figure.ready();
      figure.stepBack();
    });
    expect(await page.events('halfedge-error')).toEqual([]);
    expect(await page.sentence()).toBe('First.');
    await page.page.waitForSelector('halfedge-figure .tag.witness');
    const lit = await page.page.$$eval('halfedge-figure .tag.witness', (tags) =>
      tags.map(({ textContent }) => textContent),
    );
    expect(lit).toEqual(['✕ v7']);
  });
});
