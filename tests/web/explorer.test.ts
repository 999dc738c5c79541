import { HalfedgeMesh, init, NONE } from 'halfedge';
import {
  CirculatorPlayer,
  circulators,
  type Dialect,
  dialects,
  factsOf,
  type Item,
  itemName,
  itemSlots,
  linksOf,
  parseItemName,
  type Query,
  queriesFor,
  queryCode,
} from 'halfedge/teaching';
import * as generate from '../../web/explorer/samples/generators.js';

beforeAll(() => init());

/** 4 × 4 vertices, row by row, and 9 quads. */
const grid = () => generate.openGrid(3);

const query = (name: string, index: number, direction: 'ccw' | 'cw', start?: number): Query => {
  const circulator = circulators.find((candidate) => candidate.name === name);
  if (!circulator) throw new Error(`There is no circulator ${name}.`);
  return { circulator, index, direction, ...(start === undefined ? {} : { start }) };
};

/** What the package itself lists for a query. */
function range(mesh: HalfedgeMesh, { circulator, index, direction, start }: Query): number[] {
  const method = mesh[circulator.name] as (i: number, d: string, s?: number) => Iterable<number>;
  return [...method.call(mesh, index, direction, start)];
}

describe('generated samples', () => {
  test.each([
    ['truncated icosahedron', generate.truncatedIcosahedron, 2, 0],
    ['star prism', generate.starPrism, 2, 0],
    ['open grid', () => generate.openGrid(6), 1, 1],
    ['annulus', () => generate.annulus(14), 0, 2],
  ])('%s is valid, with the topology that it is shown for', (_name, make, chi, loops) => {
    const mesh = make();
    expect(mesh.validate()).toEqual([]);
    expect(mesh.eulerCharacteristic()).toBe(chi);
    expect([...mesh.boundaryLoops()]).toHaveLength(loops);
    expect(mesh.components()).toHaveLength(1);
  });

  test('closed ones have their normals outside', () => {
    for (const make of [generate.truncatedIcosahedron, generate.starPrism]) {
      const mesh = make();
      const { indices } = mesh.toTriangles();
      let volume = 0;
      for (let i = 0; i < indices.length; i += 3) {
        const [[a, b, c], [d, e, f], [g, h, k]] = [0, 1, 2].map((j) =>
          mesh.position(indices[i + j]),
        );
        volume += a * (e * k - f * h) - b * (d * k - f * g) + c * (d * h - e * g);
      }
      expect(volume).toBeGreaterThan(0);
    }
  });

  test('the pinched vertex has three fans in one cycle', () => {
    const mesh = generate.pinchedVertex();
    expect(mesh.validate().filter(({ severity }) => severity === 'error')).toEqual([]);
    expect(mesh.isManifoldVertex(0)).toBe(false);
    expect(mesh.valence(0)).toBe(15);
  });
});

describe('names of items', () => {
  test('are read in every form that a user may write', () => {
    expect(parseItemName('v12')).toEqual({ kind: 'vertex', index: 12 });
    expect(parseItemName(' Halfedge 3 ')).toEqual({ kind: 'halfedge', index: 3 });
    expect(parseItemName('E0')).toEqual({ kind: 'edge', index: 0 });
    expect(parseItemName('face7')).toEqual({ kind: 'face', index: 7 });
    for (const text of ['', '12', 'v', 'v-1', 'v1.5', 'x3', 'v12 h3']) {
      expect(parseItemName(text)).toBeNull();
    }
  });

  test('show an empty link as ∅, never as -1', () => {
    const mesh = grid();
    for (const h of mesh.halfedges()) {
      for (const { name, target } of linksOf(mesh, { kind: 'halfedge', index: h })) {
        expect(itemName(target)).toMatch(name === 'face' ? /^(f\d+|∅)$/ : /^[vhe]\d+$/);
      }
    }
    const boundary = [...mesh.halfedges()].find((h) => mesh.face(h) === NONE) as number;
    const links = linksOf(mesh, { kind: 'halfedge', index: boundary });
    expect(links.find(({ name }) => name === 'face')?.target).toBeNull();
  });
});

describe('links of an item', () => {
  test('carry the numbers (1) to (7) of the figure and lead where the mesh says', () => {
    const mesh = grid();
    expect(linksOf(mesh, { kind: 'vertex', index: 5 })).toMatchObject([
      { number: 1, target: { kind: 'halfedge', index: mesh.vertexHalfedge(5) } },
    ]);
    expect(linksOf(mesh, { kind: 'face', index: 4 })).toMatchObject([
      { number: 2, target: { kind: 'halfedge', index: mesh.faceHalfedge(4) } },
    ]);
    const h = mesh.faceHalfedge(4);
    expect(linksOf(mesh, { kind: 'halfedge', index: h })).toMatchObject([
      { number: 3, target: { kind: 'vertex', index: mesh.toVertex(h) } },
      { number: 4, target: { kind: 'face', index: 4 } },
      { number: 5, target: { kind: 'halfedge', index: mesh.next(h) } },
      { number: 6, target: { kind: 'halfedge', index: mesh.opposite(h) } },
      { number: 7, target: { kind: 'halfedge', index: mesh.prev(h) } },
      { name: 'fromVertex', target: { kind: 'vertex', index: mesh.fromVertex(h) } },
      { name: 'edge', target: { kind: 'edge', index: mesh.edge(h) } },
    ]);
    expect(linksOf(mesh, { kind: 'edge', index: 3 })).toMatchObject([
      { target: { kind: 'halfedge', index: 6 } },
      { target: { kind: 'halfedge', index: 7 } },
    ]);
  });

  test('have one key each', () => {
    const mesh = grid();
    for (const kind of ['vertex', 'halfedge', 'edge', 'face'] as const) {
      const keys = linksOf(mesh, { kind, index: 0 }).map(({ key }) => key);
      expect(new Set(keys).size).toBe(keys.length);
    }
  });

  test('facts tell boundary, valence and degree', () => {
    const mesh = grid();
    expect(factsOf(mesh, { kind: 'vertex', index: 5 })).toEqual(['interior', 'valence 4']);
    expect(factsOf(mesh, { kind: 'vertex', index: 0 })).toEqual(['boundary', 'valence 2']);
    expect(factsOf(mesh, { kind: 'face', index: 4 })).toEqual(['interior', 'degree 4']);
    expect(factsOf(mesh, { kind: 'face', index: 0 })).toEqual(['at the boundary', 'degree 4']);
    const alone = HalfedgeMesh.fromPolygons([0, 0, 0], []);
    expect(factsOf(alone, { kind: 'vertex', index: 0 })).toEqual(['isolated', 'valence 0']);
    const [anchor] = linksOf(alone, { kind: 'vertex', index: 0 });
    expect(anchor).toMatchObject({ target: null, hint: 'none: an isolated vertex' });
  });
});

/** Everything that can be asked of any item of a mesh, in both directions. */
function* allQueries(mesh: HalfedgeMesh): Iterable<Query> {
  for (const kind of ['vertex', 'halfedge', 'edge', 'face'] as const) {
    for (let index = 0; index < itemSlots(mesh, kind); index++) {
      for (const group of queriesFor(mesh, { kind, index })) {
        for (const { name } of group.circulators) {
          yield query(name, group.index, 'ccw', group.start);
          yield query(name, group.index, 'cw', group.start);
        }
      }
    }
  }
}

/** What a player has visited after every step of a lap forward, and of the lap back. */
function played(
  mesh: HalfedgeMesh,
  asked: Query,
  dialect: Dialect,
): { count: number; states: number[][] } {
  const player = new CirculatorPlayer(mesh, asked, dialect);
  const states: number[][] = [];
  const note = () => states.push(player.visits.map(({ item }: { item: Item }) => item.index));
  while (player.forward()) note();
  while (player.back()) note();
  player.seek(player.count - 1);
  note();
  return { count: player.count, states };
}

describe('the circulator player', () => {
  test.each([
    ['an open grid', () => generate.openGrid(3)],
    ['a pinched vertex', generate.pinchedVertex],
    ['pentagons and hexagons', generate.truncatedIcosahedron],
    ['an annulus', () => generate.annulus(5)],
  ])('visits what the package lists, forward and back, on %s', (_name, make) => {
    const mesh = make();
    let asked = 0;
    for (const one of allQueries(mesh)) {
      const lap = range(mesh, one);
      const first = (length: number) => lap.slice(0, length);
      const forward = lap.map((_, i) => first(i + 1));
      const back = lap.map((_, i) => first(lap.length - 1 - i));
      const states = [...forward, ...back, first(Math.max(0, lap.length - 1))];
      const code = queryCode(one);
      for (const dialect of dialects) {
        const expected = { code, count: lap.length, states };
        expect({ code, ...played(mesh, one, dialect) }).toEqual(expected);
      }
      asked += 1;
    }
    expect(asked).toBeGreaterThan(100);
  });

  /** The sentences of a whole lap. */
  function told(mesh: HalfedgeMesh, asked: Query): string[] {
    const player = new CirculatorPlayer(mesh, asked);
    const words: string[] = [];
    while (player.forward()) words.push(player.words);
    return words;
  }

  test('says in words where it starts and what each hop did', () => {
    const mesh = grid();
    const between = (a: number, b: number) => mesh.findHalfedge(a, b);
    const anchor = mesh.vertexHalfedge(5);
    expect(told(mesh, query('vertexVertices', 5, 'cw'))).toEqual([
      `vertexHalfedge(5) = h${between(5, 6)} → vertex 6`,
      `next(opposite(h${between(5, 6)})) = h${between(5, 1)} → vertex 1`,
      `next(opposite(h${between(5, 1)})) = h${between(5, 4)} → vertex 4`,
      `next(opposite(h${between(5, 4)})) = h${between(5, 9)} → vertex 9`,
    ]);
    expect(told(mesh, query('vertexVertices', 5, 'ccw')).slice(0, 2)).toEqual([
      `anchor h${anchor}: opposite(prev(h${anchor})) = h${between(5, 9)} → vertex 9`,
      `opposite(prev(h${between(5, 9)})) = h${between(5, 4)} → vertex 4`,
    ]);
    expect(told(mesh, query('faceEdges', 4, 'ccw'))[0]).toBe(
      `faceHalfedge(4) = h${mesh.faceHalfedge(4)} → edge ${mesh.faceHalfedge(4) >> 1}`,
    );
    expect(told(mesh, query('halfedgeLoop', 7, 'cw'))[0]).toBe('starts at h7 itself');
    expect(told(mesh, query('edgeVertices', 3, 'ccw'))[1]).toBe(
      `opposite(h6) = h7 → vertex ${mesh.toVertex(7)}`,
    );
  });

  test('tells of the halfedges without a face that it skips', () => {
    const mesh = grid();
    const [outside, inside, last] = [0, 5, 2].map((w) => mesh.findHalfedge(1, w));
    expect(told(mesh, query('vertexFaces', 1, 'cw'))).toEqual([
      `vertexHalfedge(1) = h${outside}, no face there: skipped; next(opposite(h${outside})) = h${inside} → face 0`,
      `next(opposite(h${inside})) = h${last} → face 1`,
    ]);
    const started = told(mesh, query('vertexFaces', 1, 'ccw', outside));
    expect(started[0]).toBe(
      `starts at the chosen h${outside}, no face there: skipped; opposite(prev(h${outside})) = h${last} → face 1`,
    );
    expect(told(mesh, query('vertexFaces', 1, 'ccw', inside))[1]).toBe(
      `opposite(prev(h${inside})) = h${outside}, no face there: skipped; opposite(prev(h${outside})) = h${last} → face 1`,
    );
  });

  test('tells of the side of an edge that it skips', () => {
    const mesh = grid();
    const e = [...mesh.edges()].find((each) => mesh.isBoundaryHalfedge(2 * each)) as number;
    const end = `opposite(h${2 * e}) = h${2 * e + 1} → face ${mesh.face(2 * e + 1)}`;
    expect(told(mesh, query('edgeFaces', e, 'ccw'))).toEqual([
      `edgeHalfedge(${e}, 0) = h${2 * e}, no face there: skipped; ${end}`,
    ]);
  });

  test('tells of the whole lap where the anchor comes last and is all that there is to show', () => {
    const mesh = HalfedgeMesh.fromFaces([
      [1, 2, 0],
      [1, 0, 3],
    ]);
    const h = mesh.faceHalfedge(0); // 0→1, at the other face
    const [b, c] = [mesh.prev(h), mesh.next(h)];
    const skipped = 'no face across it: skipped';
    expect(told(mesh, query('faceFaces', 0, 'cw'))).toEqual([
      `faceHalfedge h${h}: prev(h${h}) = h${b}, ${skipped}; prev(h${b}) = h${c}, ${skipped}; prev(h${c}) = h${h} → across it, face 1`,
    ]);
  });

  test('says nothing of a step that is not so', () => {
    const mesh = grid();
    const steps = ['next', 'prev', 'opposite'] as const;
    const anchors = ['vertexHalfedge', 'faceHalfedge', 'edgeHalfedge'] as const;
    /** `next(opposite(h12))`, `edgeHalfedge(3, 0)`. */
    const resultOf = (expression: string): number => {
      const [, name, inner] = /^(\w+)\((.*)\)$/.exec(expression) ?? [];
      const step = steps.find((each) => each === name);
      if (step) return mesh[step](resultOf(inner));
      const anchor = anchors.find((each) => each === name);
      if (anchor) return mesh[anchor](Number.parseInt(inner, 10) as never);
      return Number(/^h(\d+)$/.exec(expression)?.[1]);
    };
    let checked = 0;
    for (const asked of allQueries(mesh)) {
      for (const words of told(mesh, asked)) {
        for (const [, expression, result] of words.matchAll(/(\w+\((?:[^=:;]*)\)) = h(\d+)/g)) {
          expect([queryCode(asked), words, resultOf(expression)]).toEqual([
            queryCode(asked),
            words,
            Number(result),
          ]);
          checked += 1;
        }
      }
    }
    expect(checked).toBeGreaterThan(1000);
  });

  test('says what CGAL’s halfedges show, which arrive where ours leave', () => {
    const mesh = grid();
    const cgal = dialects.find(({ id }) => id === 'cgal') as Dialect;
    const h = mesh.vertexHalfedge(5);
    const g = mesh.opposite(h);
    const first = (name: string, start?: number): string => {
      const player = new CirculatorPlayer(mesh, query(name, 5, 'cw', start), cgal);
      player.forward();
      return player.words;
    };
    expect(first('vertexIncomingHalfedges')).toBe(`v5->halfedge() = h${g}`);
    expect(first('vertexOutgoingHalfedges')).toBe(`v5->halfedge() = h${g} → its opposite h${h}`);
    expect(first('vertexVertices')).toBe(
      `v5->halfedge() = h${g} → its start, vertex ${mesh.toVertex(h)}`,
    );
    expect(first('vertexFaces')).toBe(`v5->halfedge() = h${g} → across it, face ${mesh.face(h)}`);
    expect(first('vertexEdges')).toBe(`v5->halfedge() = h${g} → edge ${mesh.edge(h)}`);
    expect(first('vertexIncomingHalfedges', h)).toBe(`chosen h${h}->opposite() = h${g}`);
  });

  test('has nothing to visit around an isolated vertex', () => {
    const alone = HalfedgeMesh.fromPolygons([0, 0, 0], []);
    const player = new CirculatorPlayer(alone, query('vertexVertices', 0, 'ccw'));
    expect(player.count).toBe(0);
    expect(player.forward()).toBe(false);
    expect(player.words).toBe('');
  });

  test('shows the query as the code that asks it', () => {
    expect(queryCode(query('vertexVertices', 12, 'ccw'))).toBe("mesh.vertexVertices(12, 'ccw')");
    expect(queryCode(query('faceEdges', 3, 'cw', 8))).toBe("mesh.faceEdges(3, 'cw', 8)");
    expect(queryCode(query('edgeFaces', 3, 'cw'))).toBe('mesh.edgeFaces(3)');
  });
});
