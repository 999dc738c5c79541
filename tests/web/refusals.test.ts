import { inspect } from 'node:util';
import { HalfedgeMesh, init, type Refusal } from 'halfedge';
import { bytesInUse, growMemory } from './support/core.js';
import {
  annulus,
  bowTie,
  build,
  type Input,
  pillow,
  quadGrid,
  randomPolygons,
  tetrahedron,
  torus,
  twoTriangles,
} from './support/meshes.js';
import { random } from './support/random.js';
import { randomEdit, refusalOf } from './support/random-edits.js';

beforeAll(() => init());

/** All that a refusal says. */
const read = ({ code, message, witness }: Refusal) => JSON.stringify([code, message, witness]);

const NOTHING = { vertices: [], halfedges: [], edges: [], faces: [] };

/** What some say to the letter, of one item and of several of each kind. */
const SAID: [string, Input, (mesh: HalfedgeMesh) => Refusal | null, Refusal][] = [
  [
    'flipEdge on the boundary',
    quadGrid(),
    (mesh) => mesh.checkFlipEdge(0),
    {
      code: 'boundary-edge',
      message:
        'Edge 0 lies on the boundary: halfedge 1 has no face, expected a face on either side.',
      witness: { ...NOTHING, halfedges: [1], edges: [0] },
    },
  ],
  [
    'flipEdge of a tetrahedron',
    tetrahedron(),
    (mesh) => mesh.checkFlipEdge(mesh.findEdge(0, 1)),
    {
      code: 'edge-exists',
      message:
        'Vertex 3 and vertex 2 are joined by edge 5 already, expected two vertices without an edge between them.',
      witness: { ...NOTHING, vertices: [3, 2], edges: [5] },
    },
  ],
  [
    'collapse of a tetrahedron',
    tetrahedron(),
    (mesh) => mesh.checkCollapse(0),
    {
      code: 'leaves-pillow',
      message:
        'Without edge 0, face 1 and face 2 would have the same corners and lie upon each other, expected another face between them.',
      witness: { ...NOTHING, edges: [0], faces: [1, 2] },
    },
  ],
  [
    'insertEdge from a corner to itself',
    twoTriangles(),
    (mesh) => mesh.checkInsertEdge(0, 0),
    {
      code: 'same-corner',
      message: 'Halfedge 0 and halfedge 0 both lead to vertex 1, expected two different vertices.',
      witness: { ...NOTHING, vertices: [1], halfedges: [0, 0] },
    },
  ],
  [
    'addFace with one corner',
    twoTriangles(),
    (mesh) => mesh.checkAddFace([3]),
    {
      code: 'degree-below-three',
      message: 'The face would have degree 1, expected 3 at least.',
      witness: { ...NOTHING, vertices: [3] },
    },
  ],
  [
    'removeEdge of a pillow',
    pillow(),
    (mesh) => mesh.checkRemoveEdge(0),
    {
      code: 'faces-share-edges',
      message: 'Face 0 and face 1 share 3 edges, expected edge 0 to be the only one.',
      witness: { ...NOTHING, edges: [0, 2, 1], faces: [0, 1] },
    },
  ],
  [
    'append, in a sentence without a full stop in the core',
    twoTriangles(),
    (mesh) => {
      using other = build(twoTriangles());
      other.connectivity.next[3] = 99;
      return mesh.checkAppend(other);
    },
    {
      code: 'corrupt-connectivity',
      message:
        'The next of halfedge 3 is no live item, which breaks the invariants of a mesh: validate names what is wrong.',
      witness: NOTHING,
    },
  ],
];

describe('A refusal', () => {
  test.each(SAID)('says to the letter: %s', (_, input, ask, said) => {
    using mesh = build(input);
    expect(ask(mesh)).toEqual(said);
  });

  test('lists all items, however many, and leaves nothing in the core', () => {
    const loop = Array.from({ length: 5000 }, (_, v) => v);
    using mesh = HalfedgeMesh.fromFaces([loop, [...loop].reverse()]);
    const before = bytesInUse();
    const refusal = mesh.checkRemoveEdge(0) as Refusal;
    expect(bytesInUse()).toBe(before);
    expect(refusal.message).toContain('share 5000 edges');
    expect([...refusal.witness.edges].sort((a, b) => a - b)).toEqual(loop);
  });

  test('is a plain object that cannot be changed, for consoles, JSON, copies and other threads', () => {
    using mesh = build(quadGrid());
    const refusal = mesh.checkFlipEdge(0) as Refusal;
    const said = SAID[0][3];
    expect(Object.isFrozen(refusal)).toBe(true);
    expect(Object.getPrototypeOf(refusal)).toBe(Object.prototype);
    expect(Object.entries(Object.getOwnPropertyDescriptors(refusal))).toMatchObject(
      Object.entries(said).map(([name, value]) => [name, { value, enumerable: true }]),
    );
    expect(refusal.witness).toBe(refusal.witness);
    expect(inspect(refusal)).toBe(inspect(said));
    expect(JSON.stringify(refusal)).toBe(JSON.stringify(said));
    expect(structuredClone(refusal)).toEqual(said);
    expect({ ...refusal }).toStrictEqual(said);
  });

  test('shares nothing with others', () => {
    using mesh = build(quadGrid());
    const [first, second] = [mesh.checkFlipEdge(0), mesh.checkFlipEdge(0)] as Refusal[];
    (first.witness.edges as number[]).push(7);
    (first.witness.faces as number[]).push(7);
    expect(second).toEqual(SAID[0][3]);
    expect(mesh.checkFlipEdge(0)).toEqual(SAID[0][3]);
  });
});

describe('Read late', () => {
  const shapes: [string, Input][] = [
    ['a tetrahedron', tetrahedron()],
    ['a torus', torus()],
    ['an annulus', annulus()],
    ['a pinched vertex', bowTie()],
    ['a pillow', pillow()],
    ...[1, 2, 3, 4].map((seed): [string, Input] => [`polygons ${seed}`, randomPolygons(seed)]),
  ];
  const cases = shapes.map(([name, input], i) => ({ name, input, seed: 500 + i }));
  const codes = new Set<string>();

  test.each(cases)('each says what it did at once: $name, seed $seed', ({ input, seed }) => {
    const next = random(seed);
    const mesh = build(input, { storePrev: seed % 2 === 0 });
    const unread: { name: string; refusal: Refusal; said: string }[] = [];
    for (let i = 0; i < 400; i++) {
      const edit = randomEdit(mesh, next);
      const refusal = edit.check?.();
      const same = edit.check?.();
      if (refusal && same) unread.push({ name: edit.name, refusal, said: read(same) });
      const thrown = refusalOf(edit);
      if (refusal)
        expect([edit.name, thrown && read(thrown)]).toEqual([edit.name, same && read(same)]);
      if (i % 100 === 50) growMemory();
    }
    mesh.dispose();
    growMemory();
    using other = build(quadGrid());
    other.checkFlipEdge(0);
    expect(unread.length).toBeGreaterThan(50);
    for (const { name, refusal, said } of unread) {
      expect([name, read(refusal)]).toEqual([name, said]);
      expect(refusal.message).toMatch(/^[A-Z][ -~]*[^.]\.$/);
      codes.add(refusal.code);
    }
  });

  test('these have nearly all codes that edits at random come upon', () => {
    expect([...codes].filter((code) => !/^[a-z]+(-[a-z]+)+$/.test(code))).toEqual([]);
    expect(codes.size).toBeGreaterThanOrEqual(30);
  });
});
