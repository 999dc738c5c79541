import { HalfedgeMesh, init } from 'halfedge';
import {
  type Circulator,
  type CirculatorName,
  CirculatorPlayer,
  circulators,
  dialectOf,
} from 'halfedge/teaching';
import { columnsOf, roomOfIndex } from '../../web/explorer/app/record-columns.js';
import { readingOf, rowsOf } from '../../web/explorer/app/records.js';

beforeAll(() => init());

describe('the columns of the records', () => {
  test('are the links of the structure, then the attributes of that kind of items', () => {
    const mesh = HalfedgeMesh.cube();
    mesh.attributes.add('edge', 'crease', { type: 'float32' });
    mesh.attributes.add('halfedge', 'uv', { type: 'float64', components: 2 });
    mesh.attributes.set('edge', 'crease', 5, 0.75);
    mesh.attributes.set('halfedge', 'uv', 3, [0.5, 0.25]);
    const names = (kind: 'vertex' | 'halfedge' | 'edge' | 'face') =>
      columnsOf(mesh, kind, {}).map(({ name }) => name);
    expect(names('vertex')).toEqual(['halfedge', 'x', 'y', 'z']);
    expect(names('halfedge')).toEqual(['to', 'next', 'prev', 'face', 'opposite', 'uv']);
    expect(names('edge')).toEqual(['first', 'second', 'crease']);
    expect(names('face')).toEqual(['halfedge']);
    const cells = columnsOf(mesh, 'edge', {}).map((column) => column.cell(mesh, 5).text);
    expect(cells).toEqual(['h10', 'h11', '0.75']);
    const uv = columnsOf(mesh, 'halfedge', {}).at(-1);
    mesh.setPosition(2, [4_500_000.5, 0, -0.12345678]);
    const xyz = columnsOf(mesh, 'vertex', {}).slice(1, 4);
    expect(xyz.map((column) => column.cell(mesh, 2).text)).toEqual(['4500000.5', '0', '-0.123']);
    expect(uv?.cell(mesh, 3)).toEqual({ text: '(0.5, 0.25)', target: null });
    expect([uv?.meaning, uv?.isAttribute]).toEqual(['attribute: 2 float64', true]);
    mesh.dispose();
  });

  test('have room for their names, and for the longest name of an item of the mesh', () => {
    const small = HalfedgeMesh.cube();
    const rooms = (mesh: HalfedgeMesh) =>
      columnsOf(mesh, 'halfedge', {}).map(({ name, room }) => [name, room]);
    expect(rooms(small)).toEqual([
      ['to', 5],
      ['next', 5],
      ['prev', 5],
      ['face', 5],
      ['opposite', 'opposite'.length],
    ]);
    expect([roomOfIndex(small, 'face'), roomOfIndex(small, 'halfedge')]).toEqual([4, 8]);
    const large = HalfedgeMesh.grid(400, 400);
    const longest = `h${large.halfedgeCount - 1}`.length;
    expect(longest).toBe(7);
    expect(rooms(large).map(([, room]) => room)).toEqual([7, 7, 7, 7, 8]);
    expect(roomOfIndex(large, 'face')).toBe(7);
    small.dispose();
    large.dispose();
  });

  test('say the words of attributes that are places in a list', () => {
    const mesh = HalfedgeMesh.cube();
    mesh.attributes.add('face', 'material', { type: 'int32' });
    mesh.attributes.set('face', 'material', 2, 1);
    const [, material] = columnsOf(mesh, 'face', { material: ['none', 'steel'] });
    expect(material.cell(mesh, 2).text).toBe('1 “steel”');
    expect(material.cell(mesh, 3).text).toBe('0 “none”');
    mesh.dispose();
  });

  test('have no attribute twice, and none of another kind, whatever its name', () => {
    const mesh = HalfedgeMesh.cube();
    mesh.attributes.add('vertex', 'halfedge', { type: 'int32' });
    mesh.attributes.add('face', 'x', { type: 'int32' });
    const columns = columnsOf(mesh, 'vertex', {});
    expect(columns.map(({ name, isAttribute }) => [name, isAttribute])).toEqual([
      ['halfedge', false],
      ['x', false],
      ['y', false],
      ['z', false],
      ['halfedge', true],
    ]);
    expect(columns[0].cell(mesh, 0).target).toEqual({
      kind: 'halfedge',
      index: mesh.vertexHalfedge(0),
    });
    expect(columns[4].cell(mesh, 0).target).toBeNull();
    mesh.dispose();
  });
});

test('the rows of an item are its own, those of its halfedges, or that of its edge', () => {
  expect(rowsOf({ kind: 'edge', index: 4 }, 'halfedge')).toEqual([8, 9]);
  expect(rowsOf({ kind: 'edge', index: 4 }, 'edge')).toEqual([4]);
  expect(rowsOf({ kind: 'halfedge', index: 9 }, 'edge')).toEqual([4]);
  expect(rowsOf({ kind: 'vertex', index: 9 }, 'edge')).toEqual([]);
  expect(rowsOf(null, 'vertex')).toEqual([]);
});

test('what a step passes over is read, too', () => {
  const mesh = HalfedgeMesh.grid(3, 3);
  /** The cells that are read up to the first visit. */
  const readFirst = (name: CirculatorName, index: number, direction: 'ccw' | 'cw'): string[] => {
    const circulator = circulators.find((each) => each.name === name) as Circulator;
    const player = new CirculatorPlayer(mesh, { circulator, index, direction });
    player.forward();
    return [...readingOf(mesh, { player, position: 1, playing: false }).cells].sort();
  };
  const e = [...mesh.edges()].find((each) => mesh.isBoundaryHalfedge(2 * each)) as number;
  const [outer, inner] = [2 * e, 2 * e + 1];
  expect(readFirst('edgeFaces', e, 'ccw')).toEqual([
    `halfedge ${outer} face`,
    `halfedge ${outer} opposite`,
    `halfedge ${inner} face`,
  ]);
  const v = mesh.fromVertex(outer); // its anchor is at the boundary, where a lap has no face to show
  expect(mesh.vertexHalfedge(v)).toBe(outer);
  expect(readFirst('vertexFaces', v, 'cw')).toEqual(
    [
      `vertex ${v} halfedge`,
      `halfedge ${outer} face`,
      `halfedge ${outer} opposite`,
      `halfedge ${inner} next`,
      `halfedge ${mesh.next(inner)} face`,
    ].sort(),
  );
});

test('what a step reads in the names of CGAL is what its code says, and it is where that is', () => {
  const mesh = HalfedgeMesh.grid(3, 3);
  const v = 5; // inside
  const circulatorOf = (name: CirculatorName) =>
    circulators.find((each) => each.name === name) as Circulator;
  const readingAt = (name: CirculatorName, position: number, start?: number) => {
    const options = start === undefined ? {} : { start };
    const query = {
      circulator: circulatorOf(name),
      index: v,
      direction: 'cw',
      ...options,
    } as const;
    const player = new CirculatorPlayer(mesh, query, dialectOf('cgal'));
    player.seek(position);
    const { cells, at } = readingOf(mesh, { player, position, playing: false });
    return { cells: [...cells].sort(), at, cursor: player.current?.cursor, words: player.words };
  };
  const cell = (h: number, column: string) => `halfedge ${h} ${column}`;

  const first = mesh.opposite(mesh.vertexHalfedge(v));
  const passed = mesh.next(first);
  const second = mesh.opposite(passed);
  expect(mesh.toVertex(first)).toBe(v);
  const begun = readingAt('vertexVertices', 1);
  expect(begun).toMatchObject({ at: first, cursor: first });
  expect(begun.cells).toEqual(
    [
      `vertex ${v} halfedge`,
      cell(mesh.opposite(first), 'opposite'),
      cell(first, 'opposite'),
      cell(mesh.opposite(first), 'to'),
    ].sort(),
  );
  const hopped = readingAt('vertexVertices', 2);
  expect(hopped.words).toContain(`h${first}->next()->opposite() = h${second}`);
  expect(hopped).toMatchObject({ at: second, cursor: second });
  expect(hopped.cells).toEqual(
    [
      cell(first, 'next'),
      cell(passed, 'opposite'),
      cell(second, 'opposite'),
      cell(passed, 'to'),
    ].sort(),
  );
  const incoming = readingAt('vertexIncomingHalfedges', 2);
  expect(incoming.cells).toEqual([cell(first, 'next'), cell(passed, 'opposite')].sort());
  const chosen = readingAt('vertexOutgoingHalfedges', 1, passed);
  expect(chosen).toMatchObject({ at: second });
  expect(chosen.cells).toEqual([cell(passed, 'opposite'), cell(second, 'opposite')].sort());
  mesh.dispose();
});

test('a walk around a face is where it is in all names', () => {
  const mesh = HalfedgeMesh.cube();
  const circulator = circulators.find(({ name }) => name === 'faceVertices') as Circulator;
  const readings = (['halfedge', 'cgal'] as const).map((dialect) => {
    const query = { circulator, index: 2, direction: 'ccw' } as const;
    const player = new CirculatorPlayer(mesh, query, dialectOf(dialect));
    player.seek(2);
    const { cells, at } = readingOf(mesh, { player, position: 2, playing: false });
    return { cells: [...cells], at };
  });
  expect(readings[1]).toEqual(readings[0]);
  mesh.dispose();
});
