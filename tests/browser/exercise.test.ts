import type { ExerciseEvents, HalfedgeExercise } from 'halfedge/exercise';
import { STRICT_POLICY } from '../package/support/server.js';
import { seriousFindings } from './support/axe.js';
import {
  closeFigures,
  disconnect,
  type FigurePage,
  type FigurePageSettings,
  figures,
} from './support/figures.js';

afterEach(closeFigures);
afterAll(disconnect);

async function exercise(attributes: string, settings: FigurePageSettings = {}) {
  const body = `<main><h1>Exercises</h1><h2>One</h2><halfedge-exercise seed="5" ${attributes}></halfedge-exercise></main>`;
  const open = await figures(body, { script: 'exercise', width: 1280, height: 900, ...settings });
  await open.page.waitForSelector('halfedge-exercise .cm-content');
  return open;
}

/** Replaces the code as somebody would who types. */
async function type({ page }: FigurePage, code: string): Promise<void> {
  await page.click('halfedge-exercise .cm-content');
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText(code);
}

/** Runs by the keyboard; what the event tells. */
async function run({ page }: FigurePage): Promise<ExerciseEvents['halfedge-result']> {
  const told = page.evaluate(
    () =>
      new Promise((done) => {
        const tell = ({ detail }: CustomEvent) => done(JSON.parse(JSON.stringify(detail)));
        document.addEventListener('halfedge-result', tell as EventListener, { once: true });
      }),
  );
  await page.focus('halfedge-exercise .cm-content');
  await page.keyboard.press('Control+Enter');
  return told as Promise<ExerciseEvents['halfedge-result']>;
}

const text = ({ page }: FigurePage, part: string) =>
  page.textContent(`halfedge-exercise [part~="${part}"]`);

/** The names in the picture. */
async function tags({ page }: FigurePage, look: string): Promise<(string | null)[]> {
  await page.waitForSelector(`halfedge-figure .tag.${look}`);
  return page.$$eval(`halfedge-figure .tag.${look}`, (all) => all.map((it) => it.textContent));
}

const WALK = (step: string) => `function vertexVertices(mesh, v) {
  const ring = [];
  const first = mesh.vertexHalfedge(v);
  if (first === NONE) return ring;
  let h = first;
  do {
    ring.push(mesh.toVertex(h));
    h = ${step};
  } while (h !== first);
  return ring;
}`;

describe('An exercise', () => {
  test('takes a right answer that is typed, on all meshes', async () => {
    const page = await exercise('task="vertex-vertices"');
    await type(page, WALK('mesh.next(mesh.opposite(h))'));
    const { passed, meshes, seed } = await run(page);
    expect([passed, meshes.length, seed]).toEqual([true, 16, 5]);
    await page.page.waitForSelector('halfedge-exercise[state=passed]');
    expect(await text(page, 'headline')).toBe('Right.');
    expect(await page.page.$$eval('halfedge-exercise .chip.passed', (it) => it.length)).toBe(8);
    expect(page.complaints).toEqual([]);
  });

  test('runs in a sandboxed frame, which has no origin', async () => {
    const inner = `<script type=module src=/dist/exercise/standalone.js></script>
      <halfedge-exercise seed=5 task=vertex-vertices></halfedge-exercise>`;
    const open = await figures(
      `<iframe sandbox="allow-scripts" width="900" height="600" srcdoc="${inner}"></iframe>`,
      { script: 'exercise', origins: '*' },
    );
    const frame = open.page.frameLocator('iframe');
    await frame.locator('halfedge-exercise .cm-content').press('Control+Enter');
    await frame.locator('halfedge-exercise[state=failed]').waitFor();
    expect(await frame.locator('[part~="headline"]').textContent()).not.toContain('worker');
    expect(await frame.locator('[part~="error"]').count()).toBe(0);
  });

  test('says what is wrong, and shows where the walk went and what it missed', async () => {
    const page = await exercise('task="vertex-vertices"');
    await type(page, WALK('mesh.next(h)'));
    const { failure } = await run(page);
    expect(failure?.code).toBe('walks-face');
    expect(await text(page, 'headline')).toMatch(/^It walks around f\d, not around v0\.$/);
    expect(await text(page, 'facts')).toMatch(/vertexVertices\(mesh, v0\)/);
    const missed = failure?.marks.map(({ index }) => `✕ v${index}`);
    expect(await tags(page, 'witness')).toEqual(missed);
    expect(await tags(page, 'self')).toEqual(['v0']);
    expect(await page.figure(({ step }) => step)).toBe(3);
    await page.page.click('halfedge-figure [aria-label="Step back"]');
    expect(await page.sentence()).toMatch(/^2 of 3: v\d$/);
  });

  test.each([Number.NaN, Infinity])(
    'takes a right answer also where its limit is %p',
    async (limit) => {
      const page = await exercise('task="valence" limit="2000"');
      const passed = await page.page.evaluate(async (milliseconds) => {
        const element = document.querySelector('halfedge-exercise') as HalfedgeExercise;
        element.limit = milliseconds;
        element.reveal();
        element.code += 'Array.from({ length: 2e5 }, Math.random).sort(); // takes its time\n';
        await element.updateComplete;
        return (await element.run()).passed;
      }, limit);
      expect(passed).toBe(true);
    },
  );

  test('tells nothing of a run of the task that it had before', async () => {
    const page = await exercise('task="valence"');
    const told = await page.page.evaluate(async () => {
      const element = document.querySelector('halfedge-exercise') as HalfedgeExercise;
      element.reveal();
      const run = element.run().catch(({ message }) => message);
      element.task = 'previous';
      const end = await run;
      return [end, element.state, element.result];
    });
    expect(told).toEqual(['The exercise was given another task.', 'ready', null]);
    const own = await page.page.evaluate(async () => {
      const element = document.querySelector('halfedge-exercise') as HalfedgeExercise;
      element.task = 'valence';
      const { failure } = await element.run();
      return [failure?.code, element.state];
    });
    expect(own).toEqual(['wrong-number', 'failed']);
  });

  test('tells nothing of a run of the code that was there before', async () => {
    const page = await exercise('task="valence"');
    const told = await page.page.evaluate(async () => {
      const element = document.querySelector('halfedge-exercise') as HalfedgeExercise;
      element.reveal();
      const run = element.run().catch(({ message }) => message);
      element.code = 'function valence() { return 2; }';
      return [await run, element.state, element.result];
    });
    expect(told).toEqual(['The code was changed while it ran.', 'ready', null]);
  });

  test('says what is wrong in a definition', async () => {
    const open = await figures('<halfedge-exercise task="valence"></halfedge-exercise>', {
      script: 'exercise',
    });
    await open.page.waitForSelector('halfedge-exercise .cm-content');
    await open.page.$eval('halfedge-exercise', (it) => {
      const element = it as HalfedgeExercise;
      element.definition = { ...element.exercise, meshes: ['cube'] } as never;
    });
    await open.page.waitForSelector('halfedge-exercise [part=error]');
    expect(await text(open, 'error')).toMatch(
      /^definition\.meshes\[0\] is "cube"; expected one of tetrahedron, /,
    );
  });

  test('says on a telephone what is wrong between the code and the figure, and brings it into sight', async () => {
    const page = await exercise('task="vertex-faces"', { width: 390, height: 700, phone: true });
    await page.page.tap('halfedge-exercise [part~=run]');
    await page.page.waitForSelector('halfedge-exercise[state=failed]');
    const boxOf = async (part: string) => {
      const box = await page.page.locator(`halfedge-exercise ${part}`).boundingBox();
      return box ?? { y: Number.NaN, height: Number.NaN };
    };
    await page.page.waitForFunction(() => {
      const { shadowRoot } = document.querySelector('halfedge-exercise') as Element;
      const { top, bottom } = shadowRoot?.querySelector('.verdict')?.getBoundingClientRect() ?? {};
      return top !== undefined && bottom !== undefined && top >= 0 && bottom <= innerHeight + 1;
    });
    const verdict = await boxOf('[part~=verdict]');
    expect(verdict.y).toBeGreaterThanOrEqual(0);
    expect(verdict.y + verdict.height).toBeLessThanOrEqual(701);
    const [bar, figure] = [await boxOf('[part=bar]'), await boxOf('halfedge-figure')];
    expect(bar.y).toBeLessThan(verdict.y);
    expect(figure.y).toBeGreaterThan(verdict.y);
  });

  test('shows also the other meshes that it failed on', async () => {
    const page = await exercise('task="vertex-faces"');
    const { failure, meshes } = await run(page);
    expect(failure?.code).toBe('null-face');
    expect(meshes.filter(({ passed }) => passed).map(({ mesh }) => mesh)).toContain('torus');
    await page.page.click('halfedge-exercise button.chip:has-text("ring")');
    await page.page.waitForSelector(
      'halfedge-exercise button.chip[aria-pressed=true]:has-text("ring")',
    );
    expect(await page.figure(async (it) => (await it.ready()).faceCount)).toBe(9);
  });

  test('ends a loop that does not end, and marks its line', async () => {
    const page = await exercise('task="vertex-vertices"');
    await type(page, WALK('mesh.next(h)').replace('h !== first', 'h !== NONE'));
    const { failure } = await run(page);
    expect([failure?.code, failure?.line]).toEqual(['endless', 6]);
    expect(await page.page.textContent('halfedge-exercise .cm-line.faulty')).toBe('  do {');
    await page.page.click('halfedge-exercise [part~=line]');
    await page.page.keyboard.type('/');
    expect(await page.page.textContent('halfedge-exercise .cm-activeLine')).toBe('/  do {');
  });

  test('ends what hangs without a loop, and can run again', async () => {
    const page = await exercise('task="valence" limit="700"');
    await type(
      page,
      `function valence(mesh, v) { return /^(a+)+$/.test('a'.repeat(50) + 'b') ? 1 : 2; }`,
    );
    const { failure } = await run(page);
    expect(failure?.title).toBe('Nothing came for 0.7 seconds, and the program was ended.');
    await type(page, 'function valence(mesh, v) { return 3; }');
    expect((await run(page)).failure?.mesh).toBe('cone');
  });

  test('takes no answer for right that it could not judge, and none that only says so', async () => {
    const page = await exercise('task="flip-edge"');
    await type(page, 'function flipEdge(links, e) { links.next = undefined; }');
    const { passed, failure } = await run(page);
    expect([passed, failure?.code]).toEqual([false, 'links-replaced']);

    await page.page.evaluate(() => {
      const element = document.querySelector('halfedge-exercise') as HalfedgeExercise;
      element.task = 'valence';
    });
    const rejected = (code: string) =>
      page.page.evaluate(async (code) => {
        const element = document.querySelector('halfedge-exercise') as HalfedgeExercise;
        await element.updateComplete;
        element.code = code;
        return element.run().then(
          ({ passed }) => `passed: ${passed}`,
          (error) => String(error.message),
        );
      }, code);
    expect(
      await rejected("function valence() { return 3; }\nself.postMessage({ kind: 'done' });"),
    ).toContain('before all calls were made');
    expect(page.complaints).toEqual([]);
  });

  test('leaves the cursor where it is when it is given the same code again, whatever ends its lines', async () => {
    const page = await exercise('task="valence"');
    const give = () =>
      page.page.$eval('halfedge-exercise', (element) => {
        (element as HalfedgeExercise).code = 'let a = 1;\r\nlet b = 2;';
      });
    await give();
    await page.page.click('halfedge-exercise .cm-content');
    await page.page.keyboard.press('Control+Home');
    await page.page.keyboard.press('End');
    await give();
    await page.page.keyboard.type('3');
    const code = await page.page.$eval('halfedge-exercise', (it) => (it as HalfedgeExercise).code);
    expect(code).toBe('let a = 1;3\nlet b = 2;');
    expect(page.complaints).toEqual([]);
  });

  test('keeps code that it is given before it is in a page', async () => {
    const page = await exercise('task="valence"');
    const code = await page.page.evaluate(async () => {
      const element = document.createElement('halfedge-exercise') as HalfedgeExercise;
      element.setAttribute('task', 'valence');
      element.code = 'function valence() { return 6; }';
      document.querySelector('main')?.append(element);
      await element.updateComplete;
      return element.code;
    });
    expect(code).toBe('function valence() { return 6; }');
  });

  test('takes code that was set before its script was there, and then what is typed', async () => {
    const body = `<halfedge-exercise task="valence" seed="5"></halfedge-exercise>
      <script>document.querySelector('halfedge-exercise').code = 'function valence() { return 2; }';</script>`;
    const open = await figures(body, { script: 'exercise' });
    await open.page.waitForSelector('halfedge-exercise .cm-content');
    expect(await open.page.textContent('halfedge-exercise .cm-line')).toContain('return 2;');
    await type(open, 'function valence() { return 4; }');
    expect((await run(open)).failure?.got).toBe('4');
    expect(open.complaints).toEqual([]);
  });

  test('shows what is chosen and the line at fault also where the system forces its colours', async () => {
    const page = await exercise('task="valence"');
    await page.page.emulateMedia({ forcedColors: 'active' });
    await type(page, 'function valence(mesh, v) {\n  return mesh.nxt(v);\n}');
    await run(page);
    const looks = await page.page.evaluate(() => {
      const root = document.querySelector('halfedge-exercise')?.shadowRoot;
      const style = (selector: string) =>
        getComputedStyle(root?.querySelector(selector) as Element);
      const chip = style('.chip[aria-pressed=true]').backgroundColor;
      return [
        chip === style('.chip[aria-pressed=false]').backgroundColor,
        style('.faulty').outlineStyle,
      ];
    });
    expect(looks).toEqual([false, 'solid']);
  });

  test('says nothing of a run that was reset', async () => {
    const page = await exercise('task="valence"');
    await type(page, `function valence() { return /^(a+)+$/.test('a'.repeat(50) + 'b') ? 1 : 2; }`);
    await page.page.focus('halfedge-exercise .cm-content');
    await page.page.keyboard.press('Control+Enter');
    await page.page.waitForSelector('halfedge-exercise[state=running]');
    await page.page.evaluate(() =>
      (document.querySelector('halfedge-exercise') as HalfedgeExercise).reset(),
    );
    await page.page.waitForSelector('halfedge-exercise[state=ready]');
    expect(await page.page.$('halfedge-exercise [part=error]')).toBe(null);
  });

  test('tells a mistake of syntax with its place', async () => {
    const page = await exercise('task="valence"');
    await type(page, 'function valence(mesh, v) {\n  return 3 +;\n}');
    expect((await run(page)).failure?.title).toBe('Line 2, column 13: Unexpected token.');
    expect(await page.page.textContent('halfedge-exercise .cm-line.faulty')).toBe('  return 3 +;');
  });

  test('writes code and English from left to right on a page that is not English', async () => {
    const figure =
      '<halfedge-figure src="shape:cube" select="v0" query="vertexVertices" controls="player code"><span slot="caption" id="caption">שלום</span></halfedge-figure>';
    const open = await figures(
      `<div dir="rtl" lang="he"><halfedge-exercise task="valence"><p slot="statement" id="statement">שלום</p></halfedge-exercise>${figure}</div>`,
      { script: 'exercise' },
    );
    const { page } = open;
    await open.ready();
    const looks = (selectors: string[]) =>
      Promise.all(
        selectors.map((selector) =>
          page
            .locator(selector)
            .last()
            .evaluate((it) => getComputedStyle(it).direction),
        ),
      );
    const ours = ['.cm-content', '[part=title]', '[part=sentence]', '[part=controls]', '.lines'];
    expect(await looks(ours)).toEqual(ours.map(() => 'ltr'));
    expect(await looks(['#caption', '#statement'])).toEqual(['rtl', 'rtl']);
    const english = ['[part=title]', '[part=sentence]', '.lines'];
    for (const selector of english) {
      const lang = await page
        .locator(selector)
        .last()
        .evaluate((it) => it.closest<HTMLElement>('[lang]')?.lang);
      expect([selector, lang]).toEqual([selector, 'en']);
    }
  });

  test('keeps what is typed from the page', async () => {
    const page = await exercise('task="valence"');
    await page.page.evaluate(() => {
      const heard: string[] = [];
      Object.assign(window, { heard });
      document.addEventListener('keydown', ({ key }) => heard.push(key));
    });
    await page.page.focus('halfedge-exercise .cm-content');
    for (const key of ['n', ' ', 'ArrowLeft', 'Escape', 'Control+Alt+s']) {
      await page.page.keyboard.press(key);
    }
    const heard = await page.page.evaluate(() => (window as unknown as { heard: string[] }).heard);
    expect(heard.filter((key) => !/Control|Alt/.test(key))).toEqual(['s']);
  });

  test('lets the keyboard in and out', async () => {
    const page = await exercise('task="valence" solution');
    await page.page.focus('halfedge-exercise .cm-content');
    await page.page.keyboard.press('Tab');
    const focused = () =>
      page.page.evaluate(() => {
        const inner = document.querySelector('halfedge-exercise')?.shadowRoot?.activeElement;
        return inner?.textContent?.trim() ?? '';
      });
    expect(await focused()).toContain('function valence');
    await page.page.keyboard.press('Escape');
    await page.page.keyboard.press('Tab');
    expect(await focused()).toBe('Run');
    await page.page.keyboard.press('Tab');
    expect(await focused()).toBe('Reset');
    await page.page.keyboard.press('Tab');
    expect(await focused()).toBe('Show a solution');
    await page.page.keyboard.press('Enter');
    expect((await run(page)).passed).toBe(true);
  });

  test('keeps the code where it is asked to, until it is reset', async () => {
    const page = await exercise('task="valence" save');
    const code = () => page.page.$eval('halfedge-exercise', (it) => (it as HalfedgeExercise).code);
    const first = await code();
    await type(page, '// mine');
    await page.page.reload();
    await page.page.waitForSelector('halfedge-exercise .cm-content');
    expect(await code()).toBe('// mine');
    await page.page.click('halfedge-exercise [part~=reset]');
    expect(await code()).toBe(first);
    await page.page.reload();
    await page.page.waitForSelector('halfedge-exercise .cm-content');
    expect(await code()).toBe(first);
  });

  test('takes the task of a teacher, and her code to begin with', async () => {
    const body = '<halfedge-exercise></halfedge-exercise>';
    const page = await figures(body, { script: 'exercise' });
    await page.page.$eval('halfedge-exercise', (it) => {
      (it as HalfedgeExercise).definition = {
        name: 'three',
        title: 'Three',
        statement: 'Give back `3`.',
        call: 'three',
        starter: 'const three = () => 2;\n',
        solution: 'const three = () => 3;\n',
        gets: 'mesh',
        uses: [],
        meshes: ['tetrahedron'],
        asks: () => [[]],
        answer: { kind: 'number' },
        reference: () => 3,
      };
    });
    await page.page.waitForSelector('halfedge-exercise [part=title]:has-text("Three")');
    expect((await run(page)).failure?.code).toBe('one-too-few');
  });

  test('says which tasks there are, where it is given another', async () => {
    const open = await figures('<halfedge-exercise task="dance"></halfedge-exercise>', {
      script: 'exercise',
    });
    await open.page.waitForSelector('halfedge-exercise [part=error]');
    expect(await text(open, 'error')).toMatch(/^task is “dance”; expected one of face-vertices, /);
  });

  test.each([
    ['forbids to run what was typed in', `${STRICT_POLICY}; worker-src blob:`, 'forbidden'],
    ['allows it', `${STRICT_POLICY} 'unsafe-eval'; worker-src blob:`, 'one-too-few'],
  ])('works as far as the policy of the page %s', async (_what, policy, code) => {
    const page = await exercise('task="valence"', { policy });
    await type(page, 'function valence(mesh, v) { return mesh.vertexHalfedge(v) < 0 ? 0 : 2; }');
    const { failure } = await run(page);
    expect(failure?.code).toBe(code);
    // To be copied into the policy, so with its own quotes.
    if (code === 'forbidden') expect(failure?.hint).toContain(" 'unsafe-eval' ");
    expect(page.complaints).toEqual([]);
  });
});

describe('The page of exercises', () => {
  test.each([
    ['a desktop, light', 'light', { width: 1280, height: 900 }],
    ['a desktop, dark', 'dark', { width: 1280, height: 900, dark: true }],
    ['a telephone, light', 'narrow', { width: 390, height: 844 }],
    ['a telephone, dark', 'narrow-dark', { width: 390, height: 844, dark: true }],
  ])('is without fault for axe, solved and not: %s', async (_name, look, settings) => {
    const page = await figures('', {
      ...settings,
      path: 'docs/exercises.html',
      script: 'exercise',
    });
    const states = await page.page.$$eval('halfedge-exercise', async (all) => {
      const states: string[] = [];
      for (const [i, one] of (all as HalfedgeExercise[]).entries()) {
        await one.updateComplete;
        if (i === 1) one.code = one.exercise?.solution ?? '';
        if (i !== 3) await one.run();
        states.push(one.state);
      }
      return states;
    });
    expect(states).toEqual(['failed', 'passed', 'failed', 'ready', 'failed']);
    expect(
      await page.page.evaluate(() => document.documentElement.scrollWidth - innerWidth),
    ).toBeLessThanOrEqual(0);
    await page.still();
    expect(await seriousFindings(page.page)).toEqual([]);
    expect(page.complaints).toEqual([]);
    await page.screenshot(`exercises-${look}`);
  });
});
