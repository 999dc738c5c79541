import { type Direction, HalfedgeMesh, init } from 'halfedge';
import {
  checkOperation,
  circulators,
  deedName,
  deedTitle,
  dialectOf,
  isLive,
  itemSlots,
  operations,
  parseDeed,
  programOf,
  run,
  runOperation,
  visit,
} from 'halfedge/teaching';

beforeAll(() => init());

/** Two triangles that share one vertex only, and a quad beside one of them. */
const pinched = () =>
  HalfedgeMesh.fromPolygons(
    [0, 0, 0, 1, 0, 0, 1, 1, 0, -1, 0, 0, -1, -1, 0, 2, 0, 0, 2, 1, 0],
    [
      [0, 1, 2],
      [0, 3, 4],
      [1, 5, 6, 2],
    ],
  );

describe('A walk without code', () => {
  test.each([
    ['a closed mesh', () => HalfedgeMesh.icosahedron()],
    ['a mesh with a boundary', () => HalfedgeMesh.grid(3, 2)],
    ['a pinched vertex', pinched],
    ['isolated vertices', () => HalfedgeMesh.fromPolygons([0, 0, 0, 1, 1, 1], [])],
  ])('visits what the code visits, on %s', (_name, make) => {
    const mesh = make();
    let walks = 0;
    for (const circulator of circulators) {
      for (let index = 0; index < itemSlots(mesh, circulator.around); index++) {
        if (!isLive(mesh, { kind: circulator.around, index })) continue;
        for (const direction of ['ccw', 'cw'] as Direction[]) {
          const query = { circulator, index, direction };
          for (const id of ['halfedge', 'cgal'] as const) {
            const dialect = dialectOf(id);
            const ran = [...run(programOf(query, dialect), mesh, query, dialect)];
            const walked = [...visit(mesh, query, dialect)];
            const bare = ran.map((hop) => ({ ...hop, ran: [] }));
            const what = `${circulator.name}(${index}, ${direction}) of ${id}`;
            expect({ what, walked }).toEqual({ what, walked: bare });
            walks += 1;
          }
        }
      }
    }
    expect(walks).toBeGreaterThan(0);
  });
});

describe('A deed', () => {
  test.each([
    ['flip e3', 'flipEdge e3', 'flip e3'],
    ['flipEdge e3', 'flipEdge e3', 'flip e3'],
    ['split f2', 'splitFace f2', 'poke f2'],
    ['collapse h5', 'collapse h5', 'collapse h5'],
    ['insertEdge h3 h9', 'insertEdge h3 h9', 'insert edge h3, h9'],
    [' reverse ', 'reverse', 'reverse'],
  ])('is read from “%s”', (text, name, title) => {
    const deed = parseDeed(text);
    expect(deedName(deed)).toBe(name);
    expect(deedTitle(deed)).toBe(title);
    expect(parseDeed(name)).toEqual(deed);
  });

  test.each([
    ['melt e3', '“melt e3” is no operation on an edge: expected one of flipEdge, splitEdge'],
    ['flip q3', '“q3” is no item: expected such as v12, h31, e15 or f7.'],
    ['flip v3', '“flip v3” is no operation on a vertex'],
    ['flip e3 e4', '“flip e3 e4” has other items than flipEdge takes: expected one edge.'],
    [
      'insertEdge h3',
      '“insertEdge h3” has other items than insertEdge takes: expected a halfedge and a second halfedge.',
    ],
    ['flip', '“flip” is done to an edge: expected such as “flip e0”.'],
    ['flipEdge', '“flipEdge” is done to an edge: expected such as “flipEdge e0”.'],
    ['collapse', '“collapse” is done to a halfedge: expected such as “collapse h0”.'],
    ['split', '“split” is done to an edge or a face'],
    ['melt', '“melt” is no operation on a mesh'],
    ['', '“” is no operation on a mesh'],
  ])('is not read from “%s”', (text, sentence) => {
    expect(() => parseDeed(text)).toThrow(sentence);
  });
});

test('What is no operation, no item or no text is told so', () => {
  const mesh = HalfedgeMesh.cube();
  const item = { kind: 'edge', index: 0 } as const;
  const [operation] = operations;
  for (const call of [runOperation, checkOperation] as ((...list: unknown[]) => unknown)[]) {
    expect(() => call('flipEdge', { mesh, item })).toThrow(
      'operation is "flipEdge"; expected one of `operations`.',
    );
    expect(() => call({ ...operation, stem: 'melt' }, { mesh, item })).toThrow(
      'operation.stem is "melt"; expected a method of HalfedgeMesh.',
    );
    expect(() => call(operation, { item })).toThrow(
      'operands.mesh is undefined; expected a HalfedgeMesh.',
    );
  }
  expect(() => parseDeed(3 as never)).toThrow(
    'text is 3; expected an operation such as "flip e3".',
  );
  expect(isLive(mesh, {} as never)).toBe(false);
  expect(isLive(mesh, { kind: 'face', index: -1 })).toBe(false);
});
