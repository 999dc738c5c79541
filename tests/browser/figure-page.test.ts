// What pages do with figures: many of them, hidden, scaled, printed, moved, and without what a browser has.

import { STRICT_POLICY } from '../package/support/server.js';
import { closeFigures, disconnect, figures, ONE_RING } from './support/figures.js';

afterEach(closeFigures);
afterAll(disconnect);

describe('A page of figures', () => {
  test('shows twenty of them with one WebGL context, and draws nothing while nothing changes', async () => {
    const shapes = ['tetrahedron', 'cube', 'octahedron', 'dodecahedron', 'grid(3, 2)'];
    const body = Array.from({ length: 20 }, (_, i) => {
      const shape = shapes[i % shapes.length];
      return `<halfedge-figure loading="eager" src="shape:${shape}" select="f0"></halfedge-figure>`;
    });
    const page = await figures(`<style>body { columns: 5 }</style>${body.join('')}`);
    expect(await page.ready()).toBe(20);
    const copies = await page.settled();
    expect((await page.counts()).contexts).toBe(1);
    for (const colours of await page.colours()) expect(colours).toBeGreaterThan(10);
    await page.page.waitForTimeout(500);
    expect((await page.counts()).copies).toBe(copies);
    expect(page.complaints).toEqual([]);
  });

  test('gives the stage what its other parts leave of a height that the page sets', async () => {
    const figure = (style: string, controls: string) =>
      `<halfedge-figure loading="eager" src="shape:cube" select="v0" query="vertexVertices" controls="${controls}"
        style="${style}"></halfedge-figure>`;
    const page = await figures(`<div style="display: grid; grid-template: 320px / repeat(5, 1fr)">
      ${figure('height: 300px', 'player code')}
      ${figure('max-height: 300px; align-self: start', 'player code')}
      ${figure('height: 100%', 'player')}
      ${figure('', 'player')}
      ${figure('align-self: start', 'player')}
    </div>`);
    expect(await page.ready()).toBe(5);
    const seen = await page.page.$$eval('halfedge-figure', (all) =>
      all.map((element) => {
        const part = (name: string) => element.shadowRoot?.querySelector(name) as HTMLElement;
        const [inner, stage, canvas] = ['figure', '.stage', 'canvas'].map(part);
        return {
          height: element.offsetHeight,
          inside: inner?.offsetHeight,
          overflowing: Math.max(0, (inner?.scrollHeight ?? 0) - (inner?.clientHeight ?? 0)),
          stage: stage?.offsetHeight ?? 0,
          canvas: canvas?.offsetHeight,
          asWide: (stage?.offsetWidth ?? 0) / (stage?.offsetHeight ?? 0),
        };
      }),
    );
    expect(seen.map(({ height }) => height).slice(0, 4)).toEqual([300, 300, 320, 320]);
    for (const { height, inside, overflowing, stage, canvas } of seen) {
      expect({ inside, overflowing, canvas }).toEqual({
        inside: height,
        overflowing: 0,
        canvas: stage,
      });
      expect(stage).toBeGreaterThan(60);
    }
    expect(seen[4]?.asWide).toBeCloseTo(1.6, 1); // nothing is set: its own ratio
    // The line that is at work is in sight, though the code is longer than its part.
    await page.figure((first) => first.seek(3));
    const line = await page.page.$eval('halfedge-figure', (element) => {
      const box = (name: string) =>
        element.shadowRoot?.querySelector(name)?.getBoundingClientRect();
      const [lines, current] = [box('.lines'), box('.code [aria-current]')];
      return current && lines && current.top >= lines.top && current.bottom <= lines.bottom + 1;
    });
    expect(line).toBe(true);
    expect(await page.page.evaluate(() => scrollY)).toBe(0);
  });

  test('loads a figure when it comes near, and does not draw one that is out of sight', async () => {
    const page = await figures(`<div style="height: 4000px"></div>${ONE_RING}`);
    expect(await page.figure(({ state }) => state)).toBe('waiting');
    expect((await page.counts()).contexts).toBe(0);
    await page.page.evaluate(() => scrollTo(0, 4000));
    await page.page.waitForSelector('halfedge-figure[state=ready]');
    await page.page.evaluate(() => scrollTo(0, 0));
    const copies = await page.settled();
    await page.figure((figure) => figure.seek(2));
    expect(await page.settled()).toBe(copies);
    await page.page.evaluate(() => scrollTo(0, 4000));
    await page.page.waitForFunction(
      (before) => (window as unknown as { copies: number }).copies > before,
      copies,
    );
  });

  test('loads a figure that came into view while the page was busy', async () => {
    const late = `<script>
      const Observer = IntersectionObserver;
      window.IntersectionObserver = class extends Observer {
        constructor(tell, options) {
          const entries = [];
          super((more) => entries.push(...more) > 1 && tell(entries), options);
        }
      };
    </script>`;
    const page = await figures(`${late}<div style="height: 4000px"></div>${ONE_RING}`);
    await page.page.waitForTimeout(200);
    expect(await page.figure(({ state }) => state)).toBe('waiting');
    await page.page.evaluate(() => scrollTo(0, 4000));
    await page.page.waitForSelector('halfedge-figure[state=ready]');
  });
});

describe('A figure in its page', () => {
  test('is whole in a tab that was hidden while it loaded', async () => {
    const page = await figures(
      '<div hidden><halfedge-figure src="shape:cube" loading="eager"></halfedge-figure></div><halfedge-figure src="shape:cube"></halfedge-figure>',
    );
    await page.ready();
    await page.page.evaluate(() => {
      document.querySelector('div')?.removeAttribute('hidden');
    });
    await page.page.waitForFunction(
      () => (document.querySelector('halfedge-figure')?.getBoundingClientRect().height ?? 0) > 99,
    );
    await page.settled();
    const pictures = await page.page.$$eval('halfedge-figure', (all) =>
      all.map((figure) => figure.shadowRoot?.querySelector('canvas')?.toDataURL()),
    );
    expect(pictures[0] === pictures[1]).toBe(true);
  });

  test.each(['transform: scale(1.6); transform-origin: 0 0', 'transform: scale(0.5)', 'zoom: 1.6'])(
    'is picked in where it is shown in another size: %s',
    async (style) => {
      const page = await figures(
        `<div style="width: 400px; ${style}"><halfedge-figure src="shape:cube" camera="0 0 1"></halfedge-figure></div>`,
      );
      await page.ready();
      const front = await page.figure(({ mesh }) =>
        [...(mesh?.faces() ?? [])].find((f) => (mesh?.faceNormal(f)[2] ?? 0) > 0.9),
      );
      const box = await page.page.locator('halfedge-figure canvas').boundingBox();
      if (!box) throw new Error('The figure has no canvas.');
      const { x, y, width, height } = box;
      await page.page.mouse.click(x + 0.58 * width, y + 0.62 * height);
      expect(await page.figure(({ select }) => select)).toBe(`f${front}`);
      await page.page.mouse.click(x + 0.05 * width, y + 0.05 * height);
      expect(await page.figure(({ select }) => select)).toBe(null);
    },
  );

  test.each([
    ['in a dialog', '<dialog open>', 302],
    ['in a row', '<div style="display: flex">', 302],
    ['in a row that is narrower', '<div style="display: flex; width: 200px">', 200],
    [
      'in a column of a grid',
      '<div style="display: grid; grid: auto / 1fr 1fr; width: 400px">',
      200,
    ],
    ['beside text', '<div style="float: right">', 302],
  ])('is seen where nobody has given it a width: %s', async (_where, around, width) => {
    const page = await figures(`${around}<halfedge-figure src="shape:cube"></halfedge-figure>`);
    await page.ready();
    const box = await page.page.locator('halfedge-figure').boundingBox();
    expect(box?.width).toBe(width);
    expect(box?.height).toBeGreaterThan(100);
  });

  test('keeps the keys that it uses from the page, and no others', async () => {
    const page = await figures(ONE_RING);
    await page.ready();
    await page.page.evaluate(() => {
      const heard: string[] = [];
      Object.assign(window, { heard });
      document.addEventListener('keydown', ({ key }) => heard.push(key));
    });
    const press = async (inside: string, keys: readonly string[]) => {
      await page.page.focus(`halfedge-figure ${inside}`);
      for (const key of keys) await page.page.keyboard.press(key);
      return page.page.evaluate(() =>
        (window as unknown as { heard: string[] }).heard.splice(0).join(' '),
      );
    };
    const onCanvas = ['.', ' ', ' ', 'ArrowLeft', 'n', 'x', 'PageDown', 'Control+b'];
    expect(await press('canvas', onCanvas)).toBe('x PageDown Control b');
    expect(await press('[part~=slider]', ['ArrowLeft', 'Home', 'x'])).toBe('x');
    expect(await press('[part~=direction]', [' ', 'ArrowLeft'])).toBe('ArrowLeft');
    expect(await press('select', ['ArrowDown', 'c', 'Escape'])).toBe('Escape');
  });

  test('is printed whole after the window was resized while it was out of sight', async () => {
    const page = await figures(
      '<halfedge-figure src="shape:cube"></halfedge-figure><div style="height: 5000px"></div>',
    );
    await page.ready();
    await page.page.evaluate(() => scrollTo(0, 5000));
    await page.settled();
    await page.page.setViewportSize({ width: 700, height: 500 });
    await page.settled();
    await page.page.pdf();
    const drawn = await page.figure(({ shadowRoot }) => {
      const canvas = shadowRoot?.querySelector('canvas') as HTMLCanvasElement;
      const pixels = canvas.getContext('2d')?.getImageData(0, 0, canvas.width, canvas.height);
      return pixels?.data.some((value) => value > 0);
    });
    expect(drawn).toBe(true);
  });

  test('keeps its labels in their places on paper, where nothing is drawn anew', async () => {
    const page = await figures('<halfedge-figure src="shape:cube" select="v1"></halfedge-figure>');
    await page.ready();
    await page.page.emulateMedia({ media: 'print' });
    const places = await page.figure((figure) => {
      const place = () => {
        const [tag, stage] = ['.tag.self', '.stage'].map((part) =>
          figure.shadowRoot?.querySelector(part)?.getBoundingClientRect(),
        );
        if (!tag || !stage) return [];
        return [
          (tag.left + tag.width / 2 - stage.left) / stage.width,
          (tag.top + tag.height / 2 - stage.top) / stage.height,
        ];
      };
      return ['', '500px', '350px'].map((width) => {
        figure.style.width = width; // measured before the size is noticed
        return place().map((part) => Number(part.toFixed(2)));
      });
    });
    expect(places[0]).toHaveLength(2);
    expect(places[1]).toEqual(places[0]);
    expect(places[2]).toEqual(places[0]);
  });

  test('can be read where the system forces its colours', async () => {
    const page = await figures(
      '<halfedge-figure src="shape:cube" select="f0" query="faceVertices" step="2" overlays="labels" controls="player code"></halfedge-figure>',
    );
    await page.page.emulateMedia({ forcedColors: 'active' });
    await page.ready();
    const looks = await page.figure(({ shadowRoot }) => {
      const style = (selector: string) =>
        getComputedStyle(shadowRoot?.querySelector(selector) as Element);
      const probe = document.body.appendChild(document.createElement('i'));
      probe.style.backgroundColor = 'Highlight';
      const highlight = getComputedStyle(probe).backgroundColor;
      return {
        // Forced, the letters and their halo would have one colour.
        names: style('.tag.index').getPropertyValue('forced-color-adjust'),
        isLit: style('.code [aria-current]').backgroundColor === highlight,
      };
    });
    expect(looks).toEqual({ names: 'none', isLit: true });
  });

  test.each(['light', 'dark'])(
    'is as strong as its text where more contrast is asked for, %s',
    async (theme) => {
      const page = await figures(
        `<halfedge-figure src="shape:cube" theme="${theme}" controls caption="A cube"></halfedge-figure>`,
      );
      await page.ready();
      const strengths = () =>
        page.figure((figure) => {
          const caption = figure.shadowRoot?.querySelector('figcaption') as HTMLElement;
          const { color } = getComputedStyle(figure);
          return {
            captionIsText: getComputedStyle(caption).color === color,
            line: getComputedStyle(figure).getPropertyValue('--line'),
          };
        });
      const before = await strengths();
      await page.page.emulateMedia({ contrast: 'more' });
      const after = await strengths();
      expect(before.captionIsText).toBe(false);
      expect(after.captionIsText).toBe(true);
      expect(after.line).not.toBe(before.line);
    },
  );

  test('is tried again, by its button and when the network comes back, where it could not be reached', async () => {
    const page = await figures(
      '<halfedge-figure loading="eager" src="mesh.off" select="v0"></halfedge-figure>',
    );
    const tetrahedron =
      'OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n';
    const answer = { status: 503, body: '' };
    await page.page.route('**/mesh.off', (route) => route.fulfill(answer));
    const state = (expected: string) =>
      page.page.waitForSelector(`halfedge-figure[state=${expected}]`, { state: 'attached' });
    const told = () =>
      page.figure(({ shadowRoot }) => shadowRoot?.querySelector('.error')?.textContent);
    const reload = (outcome: string) =>
      page
        .figure((figure) =>
          figure.reload().then(
            () => '',
            ({ message }) => message as string,
          ),
        )
        .then((message) => expect(message).toContain(outcome));
    await reload('mesh.off could not be fetched: the server answered 503.');
    expect(await told()).toContain('the server answered 503');
    // It may fail again, and can be tried again.
    await page.page.click('halfedge-figure [part~=again]');
    await state('failed');
    Object.assign(answer, { status: 200, body: tetrahedron });
    await page.page.click('halfedge-figure [part~=again]');
    await state('ready');
    expect(await told()).toBeUndefined();
    expect(
      await page.figure(({ mesh, shadowRoot }) => [
        mesh?.faceCount,
        shadowRoot?.activeElement?.tagName,
      ]),
    ).toEqual([4, 'CANVAS']);
    await page.page.evaluate(() => dispatchEvent(new Event('online')));
    await state('ready'); // which has nothing to try again
    answer.status = 404;
    await reload('the server answered 404');
    answer.status = 200;
    await page.page.evaluate(() => dispatchEvent(new Event('online')));
    await state('ready');
    // What is wrong in the file stays so.
    answer.body = 'OFF\n4 x 0\n';
    await reload('Line 2');
    expect(await page.page.$('halfedge-figure [part~=again]')).toBeNull();
  });

  test('lets the wheel scroll the page until it has the focus', async () => {
    const page = await figures(`${ONE_RING}<div style="height: 4000px"></div>`);
    await page.ready();
    await page.page.mouse.move(300, 200);
    await page.page.mouse.wheel(0, 120);
    await page.page.waitForFunction(() => scrollY > 0);
    await page.page.evaluate(() => scrollTo(0, 0));
    await page.page.focus('halfedge-figure canvas');
    const { copies } = await page.counts();
    await page.page.mouse.wheel(0, 120);
    await page.page.waitForFunction(
      (before) => (window as unknown as { copies: number }).copies > before,
      copies,
    );
    expect(await page.page.evaluate(() => scrollY)).toBe(0);
  });

  test('draws itself without WebGL, and can be stepped all the same', async () => {
    const page = await figures(ONE_RING, { webgl: false });
    await page.ready();
    await page.figure((figure) => figure.seek(2));
    expect(await page.sentence()).toContain('→ vertex');
    expect(await page.page.$$eval('halfedge-figure .poster polygon', (it) => it.length)).toBe(20);
    const tags = await page.page.$$eval('halfedge-figure .poster text', (it) =>
      it.map(({ textContent }) => textContent),
    );
    expect(tags).toEqual(['1', '2', 'v3']);
  });

  test('loads at once where nothing tells what is in sight, as in jsdom', async () => {
    const lacks = '<script>delete window.IntersectionObserver; delete window.matchMedia;</script>';
    const page = await figures(`${lacks}<div style="height: 3000px"></div>${ONE_RING}`, {
      webgl: false,
    });
    await page.page.waitForSelector('halfedge-figure[state=ready]', { state: 'attached' });
    await page.figure((figure) => figure.play());
    await page.page.waitForSelector('halfedge-figure[step="1"]', { state: 'attached' });
    await page.figure((figure) => figure.remove());
    expect(page.complaints.filter((text) => !/WebGL/.test(text))).toEqual([]);
  });

  test('works where the page forbids to make code of texts', async () => {
    const page = await figures(ONE_RING, { policy: STRICT_POLICY });
    await page.ready();
    await page.figure((figure) => figure.seek(5));
    const visited = await page.events('halfedge-step');
    expect(visited.map(({ step }) => step)).toEqual([5]);
    const last = await page.figure(({ mesh }) => [...(mesh?.vertexVertices(3) ?? [])].at(-1));
    expect(visited[0].item).toBe(`v${last}`);
  });

  test('moves in the page, and goes on', async () => {
    const page = await figures(`<main></main>${ONE_RING}`);
    await page.ready();
    await page.page.evaluate(() => {
      const figure = document.querySelector('halfedge-figure') as HTMLElement;
      document.querySelector('main')?.append(figure);
    });
    await page.ready();
    await page.page.focus('halfedge-figure canvas');
    await page.page.keyboard.press('.');
    expect(await page.figure(({ step }) => step)).toBe(1);
    expect((await page.counts()).contexts).toBe(1);
  });

  test('loads where it was copied from one that is on show', async () => {
    const page = await figures(ONE_RING);
    await page.ready();
    const copied = await page.figure(async (figure) => {
      const copy = figure.cloneNode() as typeof figure;
      figure.replaceWith(copy);
      return (await copy.ready()).vertexCount;
    });
    expect(copied).toBe(12);
  });

  test('is waited for while it is moved, whatever it has loaded by then', async () => {
    const page = await figures(ONE_RING);
    await page.ready();
    const counts = await page.figure(async (figure) => {
      const other = document.createElement('halfedge-figure') as typeof figure;
      other.src = 'shape:cube';
      other.loading = 'lazy';
      figure.after(other);
      const waiting = [other.ready(), other.ready()];
      figure.before(other);
      return (await Promise.all(waiting)).map(({ vertexCount }) => vertexCount);
    });
    expect(counts).toEqual([8, 8]);
  });

  test('tells all who wait for it when it is taken out of the page', async () => {
    const page = await figures(ONE_RING);
    await page.ready();
    const answers = await page.figure(async (figure) => {
      const other = document.createElement('halfedge-figure') as typeof figure;
      other.src = 'shape:cube';
      figure.after(other);
      const waiting = [other.ready(), other.ready()];
      other.remove();
      const tooLong = new Promise<string>((done) => setTimeout(done, 5000, 'It never settles.'));
      const answer = (promise: Promise<unknown>) =>
        promise.then(() => 'It is ready.').catch(({ message }: Error) => message);
      return Promise.all(waiting.map((promise) => Promise.race([answer(promise), tooLong])));
    });
    expect(answers).toEqual(Array(2).fill('The figure is not in a page.'));
  });

  test('draws with the pixels of the screen that the window comes to, and back', async () => {
    const page = await figures(
      '<halfedge-figure src="shape:cube" style="display: block; width: 400px"></halfedge-figure>',
    );
    await page.ready();
    const session = await page.page.context().newCDPSession(page.page);
    /** How many pixels the picture has to a CSS pixel then. */
    const drawn = async (deviceScaleFactor: number) => {
      const window = { width: 900, height: 700, mobile: false, deviceScaleFactor };
      await session.send('Emulation.setDeviceMetricsOverride', window);
      // Chromium tells nobody of a screen that is emulated, until it has another reason to look at media queries.
      for (const colorScheme of ['dark', 'light'] as const) {
        await page.page.emulateMedia({ colorScheme });
      }
      await page.settled();
      return page.figure(({ shadowRoot }) => {
        const canvas = shadowRoot?.querySelector('canvas') as HTMLCanvasElement;
        return canvas.width / canvas.clientWidth;
      });
    };
    for (const [factor, ratio] of [
      [2, 2],
      [1.5, 1.5],
      [3, 2],
      [1, 1],
    ]) {
      expect(await drawn(factor)).toBeCloseTo(ratio);
    }
    expect((await page.colours())[0]).toBeGreaterThan(3); // it isn't blank
    await session.detach();
    expect(page.complaints).toEqual([]);
  });

  test('follows the theme of the system, or its own', async () => {
    const body = '<halfedge-figure src="shape:cube"></halfedge-figure>';
    const page = await figures(body, { dark: true });
    await page.ready();
    const background = () =>
      page.figure((figure) => getComputedStyle(figure).getPropertyValue('--page').trim());
    expect(await background()).toBe('#15181c');
    await page.figure((figure) => figure.setAttribute('theme', 'light'));
    expect(await background()).toBe('#ffffff');
  });
});

describe('The colours of a figure', () => {
  const cube = (style = '') =>
    `<halfedge-figure loading="eager" src="shape:cube" overlays="" camera="0 0 1" style="${style}"></halfedge-figure>`;

  test('may be written in every way that CSS has', async () => {
    const notations = [
      '#3366cc',
      'rgb(51 102 204)',
      'hsl(220deg 60% 50%)',
      'color-mix(in srgb, #3366cc, #3366cc)',
      'light-dark(#3366cc, #ff0000)',
      'color(srgb 0.2 0.4 0.8)',
      'oklch(0.5325 0.1679 262.29)',
    ];
    const cubes = notations.map((text) => cube(`--halfedge-gl-surface: ${text}`));
    const page = await figures(cubes.join(''));
    await page.ready();
    const middles = await page.page.$$eval('halfedge-figure', (all) =>
      all.map(({ shadowRoot }) => {
        const canvas = shadowRoot?.querySelector('canvas') as HTMLCanvasElement;
        const context = canvas.getContext('2d') as CanvasRenderingContext2D;
        const { data } = context.getImageData(canvas.width / 2, canvas.height / 2, 1, 1);
        return [...data];
      }),
    );
    const [[red, , blue]] = middles;
    expect(blue).toBeGreaterThan(red + 50);
    const isBlue = middles.map((middle) => middle.every((x, k) => Math.abs(x - middles[0][k]) < 4));
    const told = Object.fromEntries(notations.map((notation, i) => [notation, isBlue[i]]));
    expect(told).toEqual(Object.fromEntries(notations.map((notation) => [notation, true])));
    expect(page.complaints).toEqual([]);
  });

  test('go along when the page sets others, also behind a tab', async () => {
    const page = await figures(
      `<style>.red { --halfedge-gl-surface: #c02020 }</style><section>${cube()}</section>`,
    );
    await page.ready();
    const until = (wanted: boolean) =>
      page.page.waitForFunction((red) => {
        const figure = document.querySelector('halfedge-figure');
        const canvas = figure?.shadowRoot?.querySelector('canvas') as HTMLCanvasElement;
        const context = canvas.getContext('2d') as CanvasRenderingContext2D;
        const { data } = context.getImageData(canvas.width / 2, canvas.height / 2, 1, 1);
        return data[3] === 255 && data[0] > data[1] + 50 === red;
      }, wanted);
    const setClass = (names: string) =>
      page.page.evaluate((text) => document.documentElement.setAttribute('class', text), names);
    const setDisplay = (display: string) =>
      page.page.$eval(
        'section',
        async (section, text) => {
          section.style.display = text;
          for (let i = 0; i < 4; i++) await new Promise(requestAnimationFrame);
        },
        display,
      );
    await until(false);
    await setClass('red');
    await until(true);
    await setDisplay('none');
    await setClass('');
    await setDisplay('block');
    await until(false);
  });
});

describe('The page for frames', () => {
  test('takes attributes from its address, and tells its height', async () => {
    const page = await figures(`<script>
        addEventListener('message', ({ data }) => { window.told = data; });
      </script>
      <iframe width="500" height="300" src="/dist/figure/frame.html?src=shape:cube&select=f0&query=faceVertices&step=2&controls=player&caption=A%20face"></iframe>`);
    await page.page.waitForFunction(
      () => ((window as unknown as { told?: { height: number } }).told?.height ?? 0) > 350,
    );
    const frame = page.page.frames()[1];
    await frame.waitForSelector('halfedge-figure[state=ready][step="2"]');
    expect(await frame.textContent('[part=sentence]')).toContain('→ vertex');
    expect(await frame.textContent('halfedge-figure [slot=caption]')).toBe('A face');
  });
});
