import { type HalfedgeMesh, init, NONE } from 'halfedge';
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

type Code = (mesh: HalfedgeMesh, v: number) => Iterable<number>;

const listing = () => explorer.page.$$eval('.listing li', (all) => all.map((li) => li.textContent));
const lit = () => explorer.page.$$eval('.listing .ran', (all) => all.map((li) => li.textContent));
const current = () => explorer.page.textContent('.listing [aria-current]');

describe('The code beside the picture', () => {
  test('is a whole function, and the lines that ran are lit', async () => {
    await explorer.goTo('v1224');
    expect(await listing()).toEqual([
      'function* vertexVertices(mesh, v) {',
      '  const first = mesh.vertexHalfedge(v);',
      '  if (first === NONE) return; // isolated',
      '  let h = first;',
      '  do {',
      '    h = mesh.opposite(mesh.prev(h));',
      '    yield mesh.toVertex(h);',
      '  } while (h !== first);',
      '}',
    ]);
    expect(await lit()).toEqual([]);
    await explorer.press('.');
    expect(await lit()).toHaveLength(5);
    await explorer.press('.');
    const [step, visit, again] = (await listing()).slice(5, 8);
    expect(await lit()).toEqual([step, visit, again]);
    expect(await current()).toBe(visit);
    await explorer.press(',', ',');
    expect(await lit()).toEqual([]);
  });

  test('stays where it is while it is stepped', async () => {
    await explorer.goTo('v1224');
    const place = async () => (await explorer.page.locator('.listing-box').boundingBox())?.y;
    const before = await place();
    for (let position = 1; position <= 6; position++) {
      await explorer.press('.');
      await explorer.until('position', String(position));
      expect(await place()).toBe(before);
    }
  });

  test('runs in a page by itself and yields what the page visits', async () => {
    await explorer.goTo('v1224');
    await explorer.press('End');
    const code = (await listing()).join('\n');
    const run = new Function('NONE', `return ${code}`)(NONE) as Code;
    const expected = [...run(mesh, 1224)].map((v) => `v${v}`);
    expect(await explorer.visited()).toEqual(expected);
  });

  test('is written anew for another query and direction', async () => {
    await explorer.goTo('f7');
    await explorer.page.check('[value=faceFaces]');
    expect(await listing()).toContain('    if (other !== NONE) yield other;');
    expect(await listing()).toContain('    h = mesh.next(h);');
    await explorer.press('c');
    expect(await listing()).toContain('    h = mesh.prev(h);');
    await explorer.press('c');
  });

  test('changes its names with the dialect, and stays where it is', async () => {
    await explorer.goTo('v1224');
    await explorer.press('.', '.', '.');
    const visited = await explorer.visited();
    for (const [dialect, line, link] of [
      ['openmesh', '    yield om.to_vertex_handle(h);', 'halfedge_handle(v)'],
      ['cgal', '    yield h.opposite().vertex();', 'halfedge()->opposite()'],
      ['mcguire', '    yield edge.vert;', 'vert->edge'],
      ['halfedge', '    yield mesh.toVertex(h);', 'vertexHalfedge'],
    ]) {
      await explorer.page.selectOption('[name=dialect]', dialect);
      expect(await current()).toBe(line);
      expect(await explorer.page.textContent('.links .api')).toBe(link);
      expect(await explorer.visited()).toEqual(visited);
      expect(await explorer.state('position')).toBe('3');
    }
  });

  test('tells the hops in the names of the dialect', async () => {
    const [first, second] = mesh.vertexOutgoingHalfedges(1224);
    await explorer.goTo('v0');
    await explorer.goTo('v1224');
    await explorer.page.selectOption('[name=dialect]', 'cgal');
    await explorer.press('.', '.');
    const hop = (await explorer.page.textContent('.hop'))?.replaceAll('\u00a0', ' ');
    const arrives = (h: number) => `h${mesh.opposite(h)}`;
    expect(hop).toBe(
      `${arrives(first)}->opposite()->prev() = ${arrives(second)} → its start, vertex ${mesh.toVertex(second)}`,
    );
    await explorer.screenshot('code-cgal-1280-light');
    await explorer.page.selectOption('[name=dialect]', 'halfedge');
  });
});
