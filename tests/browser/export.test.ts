import { disconnect, ExplorerPage } from './support/explorer.js';

let explorer: ExplorerPage;
beforeAll(async () => {
  explorer = await ExplorerPage.open();
  await explorer.goTo('v1224');
  await explorer.press('z', '.', '.', '.', '3');
  await explorer.rest();
});
afterEach(() => expect(explorer.complaints).toEqual([]));
afterAll(async () => {
  await explorer.close();
  await disconnect();
});

async function download(format: string): Promise<{ name: string; content: Buffer }> {
  const [file] = await Promise.all([
    explorer.page.waitForEvent('download'),
    explorer.page.click(`.mesh-facts [data-download=${format}]`),
  ]);
  const chunks: Buffer[] = [];
  for await (const chunk of await file.createReadStream()) chunks.push(chunk as Buffer);
  return { name: file.suggestedFilename(), content: Buffer.concat(chunks) };
}

/** How wide the picture is that no panel covers. */
const WIDTH = 1280 - 368;

test('PNG: the picture beside the panel, two pixels to one, with its labels', async () => {
  const { name, content } = await download('png');
  expect(name).toBe('bunny.png');
  expect([content.readUInt32BE(16), content.readUInt32BE(20)]).toEqual([2 * WIDTH, 1600]);
  expect(await explorer.page.textContent('.mesh-facts .outcome')).toMatch(/^Saved bunny.png, /);
  // The label of the selection has a rim in the colour of the selection, on nothing else.
  const tag = await explorer.page.locator('.tag.self').boundingBox();
  const colours = await explorer.page.evaluate(
    async ({ data, box }) => {
      const bitmap = await createImageBitmap(await (await fetch(data)).blob());
      const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
      context?.drawImage(bitmap, 0, 0);
      const [x, y, w, h] = [box.x, box.y, box.width, box.height].map((c) => 2 * c);
      const pixels = context?.getImageData(x, y, w, h).data ?? [];
      const found = new Set<string>();
      for (let i = 0; i < pixels.length; i += 4) found.add([...pixels.slice(i, i + 3)].join());
      return [...found];
    },
    {
      data: `data:image/png;base64,${content.toString('base64')}`,
      box: tag ?? { x: 0, y: 0, width: 1, height: 1 },
    },
  );
  expect(colours).toContain('36,133,247'); // --self
  expect(colours).toContain('255,255,255'); // --raised
});

test('SVG: labels fit their boxes in any font', async () => {
  const { content } = await download('svg');
  const widths = await explorer.page.evaluate((text) => {
    const host = document.createElement('div');
    document.body.append(host);
    const wide = 'font-family="monospace" letter-spacing="0.4em"';
    host.innerHTML = text.replaceAll(/font-family="[^"]*"/g, wide);
    const pairs = [...host.querySelectorAll('g > rect')].map((rect) =>
      [rect, rect.nextElementSibling].map((it) => (it as SVGGraphicsElement).getBBox().width),
    );
    host.remove();
    return pairs;
  }, content.toString());
  expect(widths.length).toBeGreaterThan(3);
  for (const [box, text] of widths) {
    expect(text).toBeGreaterThan(0);
    expect(text).toBeLessThanOrEqual(box);
  }
});

test('SVG: arrows are paths, discs circles and labels text, where the page has them', async () => {
  const { name, content } = await download('svg');
  expect(name).toBe('bunny.svg');
  const labels = await explorer.page.$$eval('.tag:not(.away):not([hidden])', (tags) =>
    tags.map((tag) => {
      const { left, width } = tag.getBoundingClientRect();
      return { text: tag.textContent, x: Math.round(left + width / 2) };
    }),
  );
  const svg = await explorer.page.evaluate((text) => {
    const root = new DOMParser().parseFromString(text, 'image/svg+xml').documentElement;
    const number = (element: Element, name: string) => Number(element.getAttribute(name));
    const paths = [...root.querySelectorAll('path')].map((path) => ({
      stroke: path.getAttribute('stroke'),
      width: number(path, 'stroke-width'),
      d: path.getAttribute('d') ?? '',
    }));
    return {
      size: [number(root, 'width'), number(root, 'height')],
      paths,
      texts: [...root.querySelectorAll('text')].map((label) => ({
        text: label.textContent,
        x: Math.round(number(label, 'x')),
      })),
      circles: root.querySelectorAll('circle').length,
      images: root.querySelectorAll('image').length,
    };
  }, content.toString());
  expect(svg.size).toEqual([WIDTH, 800]);
  expect(svg.texts.reverse()).toEqual(labels);
  expect(labels.map(({ text }) => text)).toContain('v1224');
  expect(svg.circles).toBeGreaterThan(0);
  expect(svg.images).toBe(1);
  const all = svg.paths.map(({ d }) => d).join('');
  expect(all).toMatch(/^(M-?[\d.]+ -?[\d.]+L-?[\d.]+ -?[\d.]+)+$/);
  expect(all.split('M').length).toBeGreaterThan(500);
  // The arrow of the current visit, of two segments, in the colour of the walk.
  const strong = svg.paths.filter(({ width, stroke }) => width === 3.5 && stroke === '#046a53');
  expect(strong.map(({ d }) => d.split('M').length - 1)).toEqual([2]);
});

test('The picture on the page is as it was before', async () => {
  const before = await explorer.page.screenshot();
  await download('png');
  await explorer.rest();
  const [width, height] = await explorer.page.$eval('canvas', (canvas) => [
    (canvas as HTMLCanvasElement).width,
    (canvas as HTMLCanvasElement).height,
  ]);
  expect([width, height]).toEqual([1280, 800]);
  await explorer.page.mouse.move(10, 400);
  expect((await explorer.page.screenshot()).length / before.length).toBeCloseTo(1, 1);
});
