import { HalfedgeError, HalfedgeMesh, type ItemKind, init } from 'halfedge';
import { Color, Vector3 } from 'three';
import { growMemory } from './support/core.js';
import { expectRefused, stateOf } from './support/editing.js';
import { quadGrid, tetrahedron } from './support/meshes.js';

beforeAll(() => init());

const grid = () => {
  const { positions, faces } = quadGrid();
  return HalfedgeMesh.fromPolygons(positions, faces);
};

test('An attribute has no name that would be another one in a copy', () => {
  using mesh = grid();
  expect(() => mesh.attributes.add('vertex', 'a\ud800')).toThrow(
    new RangeError(
      'name is "a\\ud800"; expected a string of whole characters, without lone surrogates.',
    ),
  );
  mesh.attributes.add('vertex', '😀');
  using copy = mesh.clone();
  expect(copy.attributes.list().map(({ name }) => name)).toEqual(['😀']);
});

describe('The positions', () => {
  test('are the attribute "position" of vertices', () => {
    using mesh = grid();
    mesh.history.enabled = true;
    const { attributes } = mesh;
    expect(attributes.has('vertex', 'position')).toBe(true);
    expect(attributes.has('face', 'position')).toBe(false);
    expect(attributes.get('vertex', 'position')).toBe(mesh.positions);
    expect(attributes.values('vertex', 'position', 1)).toEqual(mesh.position(1));
    const before = mesh.position(2);
    attributes.set('vertex', 'position', 2, [7, 8, 9]);
    expect(mesh.position(2)).toEqual([7, 8, 9]);
    expect(mesh.history.undo()).toBe(true);
    expect(mesh.position(2)).toEqual(before);
    expect(attributes.list()).toEqual([]);
    expectRefused(
      () => attributes.add('vertex', 'position', { components: 3 }),
      'attribute-exists',
    );
    expect(() => attributes.remove('vertex', 'position')).toThrow(RangeError);
    attributes.set('vertex', 'position', 3, new Vector3(1, 2, 3));
    expect(attributes.values('vertex', 'position', 3)).toEqual([1, 2, 3]);
    expect(() => attributes.set('vertex', 'position', 99, [0, 0, 0])).toThrow('item is 99');
    expect(() => attributes.set('vertex', 'position', 0, [0, 0])).toThrow(RangeError);
    attributes.add('face', 'position');
    expect(attributes.get('face', 'position')).toHaveLength(mesh.faceSlots);
  });
});

describe('An attribute', () => {
  test.each([
    ['float32', Float32Array],
    ['float64', Float64Array],
    ['int8', Int8Array],
    ['uint8', Uint8Array],
    ['int16', Int16Array],
    ['uint16', Uint16Array],
    ['int32', Int32Array],
    ['uint32', Uint32Array],
  ] as const)('of %s is shown as a live view of its type', (type, View) => {
    using mesh = grid();
    const view = mesh.attributes.add('vertex', 'a', { type, components: 2, default: [3, 4] });
    expect(Object.getPrototypeOf(view)).toBe(View.prototype);
    expect(Array.from(view)).toEqual(Array.from({ length: 32 }, (_, i) => 3 + (i % 2)));
    view[5] = 7;
    expect(mesh.attributes.values('vertex', 'a', 2)).toEqual([3, 7]);
    expect(mesh.attributes.get('vertex', 'a')).toBe(view);
  });

  test.each([
    ['vertex', 16],
    ['halfedge', 48],
    ['edge', 24],
    ['face', 9],
  ] as [ItemKind, number][])('of a %s has a value for each slot', (kind, slots) => {
    using mesh = grid();
    expect(mesh.attributes.add(kind, 'a').length).toBe(slots);
    expect(mesh.attributes.has(kind, 'a')).toBe(true);
    expect(mesh.attributes.list()).toEqual([
      { kind, name: 'a', type: 'float32', components: 1, default: [0], onSplit: 'interpolate' },
    ]);
    for (const other of ['vertex', 'halfedge', 'edge', 'face'] as const) {
      if (other !== kind) expect(mesh.attributes.has(other, 'a')).toBe(false);
    }
  });

  test('takes vectors and colours of three.js, with as many numbers as it has components', () => {
    using mesh = grid();
    const { attributes } = mesh;
    attributes.add('face', 'rgb', { components: 3, default: new Color(0.25, 0.5, 0.75) });
    attributes.set('face', 'rgb', 2, new Color(1, 0.5, 0));
    expect(attributes.values('face', 'rgb', 1)).toEqual([0.25, 0.5, 0.75]);
    expect(attributes.values('face', 'rgb', 2)).toEqual([1, 0.5, 0]);
    attributes.add('vertex', 'uv', { components: 2 });
    expect(() => attributes.set('vertex', 'uv', 0, new Vector3(1, 2, 3))).toThrow(
      new RangeError('values is an array of 3 elements; expected a number, or 2 of them.'),
    );
  });

  test('follows its policy when an edge is split', () => {
    using mesh = grid();
    const { attributes } = mesh;
    const [a, b] = [5, 6];
    const policies = ['interpolate', 'normalize', 'copy', 'default'] as const;
    for (const onSplit of policies) {
      attributes.add('vertex', onSplit, { components: 2, onSplit, default: 5 });
      attributes.set('vertex', onSplit, a, [4, 0]);
      attributes.set('vertex', onSplit, b, [0, 2]);
    }
    const w = mesh.insertVertexOnEdge(mesh.findEdge(a, b));
    const values = (name: string) => attributes.values('vertex', name, w);
    expect(values('interpolate')).toEqual([2, 1]);
    expect(values('normalize')[0]).toBeCloseTo(2 / Math.sqrt(5));
    expect([
      [4, 0],
      [0, 2],
    ]).toContainEqual(values('copy'));
    expect(values('default')).toEqual([5, 5]);
  });

  test.each([
    ['infinite', Infinity],
    ['no number', NaN],
  ])('is not touched by a value that is %s where it has no share', (_, value) => {
    /** A square, of which all but vertex 0 and the corner there have the value. */
    const square = () => {
      const mesh = HalfedgeMesh.fromPolygons([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], [[0, 1, 2, 3]]);
      const atVertex = mesh.attributes.add('vertex', 'a', { default: value });
      const atCorner = mesh.attributes.add('halfedge', 'a', { default: value });
      atVertex[0] = 7;
      for (const h of mesh.vertexIncomingHalfedges(0)) atCorner[h] = 7;
      return mesh;
    };
    const valuesAt = (mesh: HalfedgeMesh, v: number) => [
      mesh.attributes.get('vertex', 'a')[v],
      ...mesh
        .vertexIncomingHalfedges(v)
        .toArray()
        .map((h) => mesh.attributes.get('halfedge', 'a')[h]),
    ];
    using split = square();
    const middle = split.insertVertexOnEdge(split.findEdge(0, 1), split.position(0));
    expect(valuesAt(split, middle)).toEqual([7, 7, 7]);
    using collapsed = square();
    const kept = collapsed.collapse(collapsed.findHalfedge(0, 1), collapsed.position(0));
    expect(valuesAt(collapsed, kept)).toEqual([7, 7, 7]);
    using inset = square();
    const corners = inset.faceVertices(inset.insetFace(0, 0)).toArray();
    expect(corners.map((v) => inset.attributes.get('vertex', 'a')[v])).toEqual([
      7,
      value,
      value,
      value,
    ]);
    using bevelled = HalfedgeMesh.cube();
    bevelled.attributes.add('vertex', 'a', { default: value })[0] = 7;
    const cut = bevelled.faceVertices(bevelled.bevelVertex(0, 0)).toArray();
    expect(cut.map((v) => bevelled.attributes.get('vertex', 'a')[v])).toEqual([7, 7, 7]);
  });

  test('keeps the seam of texture coordinates when an edge is split', () => {
    using mesh = HalfedgeMesh.fromTriangles(
      [0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0],
      [0, 1, 2, 0, 2, 3],
    );
    const uv = mesh.attributes.add('halfedge', 'uv');
    // By the corner where a halfedge ends: 0 to 2 in face 0, 10 to 12 in face 1.
    for (const h of mesh.halfedges()) uv[h] = mesh.toVertex(h) + 10 * mesh.face(h);
    const w = mesh.splitEdge(mesh.findEdge(0, 2));
    const now = mesh.attributes.get('halfedge', 'uv');
    const atW = mesh
      .vertexIncomingHalfedges(w)
      .toArray()
      .map((h) => now[h]);
    expect(atW.sort((a, b) => a - b)).toEqual([1, 1, 11, 11]);
  });

  test('of no items has one view, too, until there are some', () => {
    using mesh = new HalfedgeMesh();
    mesh.addVertex();
    const kept = mesh.attributes.add('face', 'a');
    mesh.setPosition(0, [1, 1, 1]);
    expect(mesh.attributes.get('face', 'a')).toBe(kept);
    mesh.makeLoop();
    expect(mesh.attributes.get('face', 'a')).toHaveLength(2);
  });

  test('has views that are good as long as get returns the same', () => {
    using mesh = grid();
    const kept = mesh.attributes.add('vertex', 'a', { default: 2 });
    mesh.attributes.add('vertex', 'b');
    mesh.setPosition(0, [1, 1, 1]);
    expect(mesh.attributes.get('vertex', 'a')).toBe(kept);
    mesh.addVertex();
    const longer = mesh.attributes.get('vertex', 'a');
    expect(longer).not.toBe(kept);
    expect(Array.from(longer)).toEqual(new Array(17).fill(2));
    growMemory();
    expect(longer.length).toBe(0);
    expect(mesh.attributes.get('vertex', 'a').length).toBe(17);
    mesh.attributes.get('vertex', 'a')[3] = 9;
    for (let i = 0; i < 1000; i++) mesh.addVertex();
    expect(mesh.attributes.get('vertex', 'a')[3]).toBe(9);
    expect(mesh.attributes.get('vertex', 'a').length).toBe(1017);
  });

  test('keeps the memory of a forgotten mesh alive with its view', async () => {
    const view = grid().attributes.add('vertex', 'a', { default: 4 });
    for (let i = 0; i < 5; i++) {
      globalThis.gc?.();
      await new Promise((resolve) => setTimeout(resolve, 2));
    }
    using other = grid(); // which would take freed memory
    other.attributes.add('vertex', 'a', { default: 5 });
    expect(Array.from(view)).toEqual(new Array(16).fill(4));
  });

  test('takes the same memory in history, however many numbers an item has', () => {
    using mesh = grid();
    const { attributes, history } = mesh;
    attributes.add('vertex', 'matrix', { type: 'float64', components: 16 });
    history.enabled = true;
    attributes.set('vertex', 'matrix', 3, 1);
    expect(history.bytes).toBe(16 * 8 + 8); // its own size and 8, as docs/editing.md says
    const before = attributes.values('vertex', 'matrix', 3);
    history.undo();
    expect(attributes.values('vertex', 'matrix', 3)).toEqual(new Array(16).fill(0));
    history.redo();
    expect(attributes.values('vertex', 'matrix', 3)).toEqual(before);
  });

  test('rounds each number of an item in the same way', () => {
    using mesh = grid();
    const { attributes } = mesh;
    const wanted = [
      -1e12, -200.5, -128.5, -2.5, -1.5, -0.5, 0.5, 1.5, 2.5, 0.1, 126.5, 255.5, 1e12,
    ];
    for (const type of [
      'int8',
      'uint8',
      'int16',
      'uint16',
      'int32',
      'uint32',
      'float32',
      'float64',
    ] as const) {
      attributes.add('face', type, { type, components: 2 });
      for (const value of [...wanted, -Infinity, Infinity]) {
        attributes.set('face', type, 0, value); // the core converts the first, the package the second
        const [first, second] = attributes.values('face', type, 0);
        expect([type, value, second]).toEqual([type, value, first]);
      }
    }
  });

  test('is set with a step of history, which writing to the view is not', () => {
    using mesh = grid();
    const { attributes, history } = mesh;
    const view = attributes.add('face', 'rgb', { type: 'uint8', components: 3 });
    history.enabled = true;
    attributes.set('face', 'rgb', 2, [1, 2, 300]);
    expect(attributes.values('face', 'rgb', 2)).toEqual([1, 2, 255]);
    attributes.set('face', 'rgb', 3, 8);
    expect(attributes.values('face', 'rgb', 3)).toEqual([8, 8, 8]);
    expect(history.undoCount).toBe(2);
    view[0] = 77;
    expect(history.undoCount).toBe(2);
    history.undo();
    history.undo();
    expect(Array.from(view)).toEqual([77, ...new Array(26).fill(0)]);
    history.redo();
    expect(attributes.values('face', 'rgb', 2)).toEqual([1, 2, 255]);
    history.group(() => {
      attributes.set('face', 'rgb', 0, 1);
      attributes.set('face', 'rgb', 1, 1);
    });
    expect(history.undoCount).toBe(2);
  });

  test('is removed, and forgotten by history', () => {
    using mesh = grid();
    const { attributes, history } = mesh;
    history.enabled = true;
    attributes.add('edge', 'a');
    attributes.set('edge', 'a', 0, 1);
    expect(attributes.remove('edge', 'a')).toBe(true);
    expect(attributes.remove('edge', 'a')).toBe(false);
    expect(attributes.list()).toEqual([]);
    expect(history.undo()).toBe(true);
    expect(attributes.add('edge', 'a', { default: 3 })[0]).toBe(3);
  });

  test('is added to another mesh as it is listed, with its default', () => {
    using mesh = grid();
    mesh.attributes.add('face', 'label', { type: 'uint8', default: 7, onSplit: 'copy' });
    mesh.attributes.add('halfedge', 'uv', { components: 2, default: [0.1, 300] });
    using other = grid();
    for (const info of mesh.attributes.list()) other.attributes.add(info.kind, info.name, info);
    expect(other.attributes.list()).toEqual(mesh.attributes.list());
    expect(mesh.attributes.list()).toMatchObject([
      { name: 'uv', default: [Math.fround(0.1), 300] },
      { name: 'label', default: [7] },
    ]);
    expect(other.attributes.get('face', 'label')).toEqual(mesh.attributes.get('face', 'label'));
    using copy = mesh.clone(); // whose list comes from the core
    expect(copy.attributes.list()).toEqual(mesh.attributes.list());
  });

  test('goes along with a clone', () => {
    using mesh = grid();
    mesh.attributes.add('vertex', 'é ü', { type: 'int16', components: 2, onSplit: 'copy' })[7] = 6;
    using copy = mesh.clone();
    expect(copy.attributes.list()).toEqual(mesh.attributes.list());
    expect(stateOf(copy)).toEqual(stateOf(mesh));
    copy.attributes.get('vertex', 'é ü')[7] = 1;
    expect(mesh.attributes.get('vertex', 'é ü')[7]).toBe(6);
  });

  test('on an empty mesh is an empty view that grows', () => {
    using mesh = new HalfedgeMesh();
    expect(mesh.attributes.add('vertex', 'a', { default: 1 }).length).toBe(0);
    mesh.addVertex();
    expect(Array.from(mesh.attributes.get('vertex', 'a'))).toEqual([1]);
  });

  test('is refused if it can not be', () => {
    using mesh = grid();
    const { attributes } = mesh;
    attributes.add('vertex', 'a');
    expectRefused(() => attributes.add('vertex', 'a'), 'attribute-exists');
    expectRefused(() => attributes.add('vertex', ''), 'bad-attribute');
    attributes.add('face', 'a');
    attributes.add('edge', 'n', { type: 'int32', default: Infinity });
    expect(attributes.get('edge', 'n')[0]).toBe(2 ** 31 - 1);
    for (const [call, type, message] of [
      [() => attributes.add('faces' as never, 'b'), RangeError, 'kind is "faces"; expected'],
      [() => attributes.add(2 as never, 'b'), TypeError, 'kind is 2'],
      [() => attributes.add('face', 3 as never), TypeError, 'name is 3; expected a string.'],
      [() => attributes.add('face', 'b', null as never), TypeError, 'options is null'],
      [
        () => attributes.add('face', 'b', { type: 'float' as never }),
        RangeError,
        "type is \"float\"; expected 'float32', 'float64'",
      ],
      [() => attributes.add('face', 'b', { components: 17 }), RangeError, 'components is 17'],
      [() => attributes.add('face', 'b', { components: '2' as never }), TypeError, 'components'],
      [() => attributes.add('face', 'b', { default: [1, 2] }), RangeError, 'default is an array'],
      [() => attributes.add('face', 'b', { default: ['1'] as never }), TypeError, 'default[0]'],
      [() => attributes.add('face', 'b', { onSplit: 'mean' as never }), RangeError, 'onSplit is'],
      [
        () => attributes.get('face', 'b'),
        RangeError,
        'expected an attribute of this mesh by face: "a".',
      ],
      [() => attributes.get('edge', 'b'), RangeError, 'by edge: "n".'],
      [
        () => attributes.set('face', 'a', 9, 1),
        RangeError,
        'item is 9; expected a face from 0 to 8.',
      ],
      [
        () => attributes.set('face', 'a', 0, [1, 2]),
        RangeError,
        'values is an array of 2 elements',
      ],
      [
        () => attributes.set('face', 'a', 0, '1' as never),
        TypeError,
        'values is "1"; expected a number',
      ],
      [() => attributes.values('face', 'a', -1), RangeError, 'item is -1'],
      [
        () => attributes.add('face', 'n', { type: 'uint8', default: Number.NaN }),
        RangeError,
        'default is NaN; expected a number that uint8 can hold.',
      ],
      [
        () => attributes.set('edge', 'n', 0, [Number.NaN]),
        RangeError,
        'values[0] is NaN; expected a number that int32 can hold.',
      ],
    ] as [() => unknown, ErrorConstructor, string][]) {
      expect(call).toThrow(type);
      expect(call).toThrow(message);
    }
    expect(attributes.list().length).toBe(3);
  });

  test('of a disposed mesh can not be had', () => {
    const mesh = grid();
    const { attributes } = mesh;
    attributes.add('face', 'a');
    mesh.dispose();
    for (const use of [
      () => attributes.get('face', 'a'),
      () => attributes.list(),
      () => attributes.has('face', 'a'),
      () => attributes.add('face', 'b'),
      () => attributes.remove('face', 'a'),
      () => attributes.set('face', 'a', 0, 1),
    ]) {
      expect(use).toThrow('disposed');
    }
  });

  test('survives values that change the mesh while they are read', () => {
    using mesh = grid();
    const { attributes } = mesh;
    attributes.add('face', 'a');
    const trap = Object.defineProperty([0], 0, {
      get: () => {
        attributes.remove('face', 'a');
        return 1;
      },
    });
    expect(() => attributes.set('face', 'a', 0, trap)).toThrow(RangeError);
    const clearing = Object.defineProperty([0, 0, 0], 1, {
      get: () => {
        mesh.clear();
        return 1;
      },
    });
    expect(() => mesh.setPosition(3, clearing)).toThrow(HalfedgeError);
  });
});

describe('Generations', () => {
  const kinds: [ItemKind, (mesh: HalfedgeMesh) => void][] = [
    ['vertex', (mesh) => mesh.deleteVertex(0)],
    ['halfedge', (mesh) => mesh.deleteEdge(0)],
    ['edge', (mesh) => mesh.deleteEdge(0)],
    ['face', (mesh) => mesh.deleteFace(0)],
  ];

  test.each(kinds)('tell a %s from the next one in its slot', (kind, remove) => {
    using mesh = grid();
    mesh.history.enabled = true;
    mesh.generations.enabled = true;
    const reference = mesh.generations.reference(kind, 0);
    expect(reference).toMatchObject({ kind, index: 0 });
    expect(mesh.generations.isCurrent(reference)).toBe(true);
    remove(mesh);
    expect(mesh.generations.isCurrent(reference)).toBe(false);
    mesh.history.group(() => {
      const corners = Array.from({ length: 5 }, () => mesh.addVertex());
      mesh.addFace(corners);
      mesh.triangulate();
      for (let i = 0; i < 20; i++) mesh.splitFace(mesh.faces().toArray()[0]);
    });
    // The slot is taken again, by another one.
    const now = mesh.generations.reference(kind, 0);
    expect(now).not.toEqual(reference);
    expect(mesh.generations.isCurrent(reference)).toBe(false);
    expect(mesh.generations.isCurrent(now)).toBe(true);
    mesh.history.undo();
    const symbol = { ...now, index: Symbol('x') as never };
    expect(() => mesh.generations.isCurrent(symbol)).toThrow('reference.index is a symbol;');
    expect(mesh.generations.isCurrent(now)).toBe(false);
    mesh.history.undo();
    expect(mesh.generations.isCurrent(reference)).toBe(true);
  });

  test('tell an item from one that takes its slot after it was undone', () => {
    using mesh = HalfedgeMesh.icoSphere(1);
    mesh.history.enabled = true;
    mesh.generations.enabled = true;
    mesh.collapse(0);
    const v = mesh.splitEdge(6);
    const undone = mesh.generations.reference('vertex', v);
    mesh.history.undo();
    expect(mesh.generations.isCurrent(undone)).toBe(false);
    mesh.history.redo();
    expect(mesh.generations.isCurrent(undone)).toBe(true);
    mesh.history.undo();
    expect(mesh.splitFace(mesh.faces().toArray()[3])).toBe(v); // in the same slot
    expect(mesh.generations.isCurrent(undone)).toBe(false);
  });

  test('forget what was done before they were switched on', () => {
    using mesh = HalfedgeMesh.cube();
    mesh.history.enabled = true;
    mesh.deleteVertex(0);
    mesh.compact();
    mesh.generations.enabled = true;
    expect([mesh.history.canUndo, mesh.history.undoCount]).toEqual([false, 0]);
    mesh.deleteVertex(1);
    expect(mesh.history.undoCount).toBe(1);
  });

  test('end with compact, and are not among the attributes', () => {
    using mesh = grid();
    mesh.generations.enabled = true;
    const reference = mesh.generations.reference('vertex', 2);
    expect(mesh.attributes.list()).toEqual([]);
    mesh.compact();
    expect(mesh.generations.isCurrent(reference)).toBe(true); // nothing was moved
    mesh.deleteFace(8);
    mesh.compact();
    expect(mesh.generations.isCurrent(reference)).toBe(false);
    const last = mesh.generations.reference('vertex', 14);
    mesh.clear();
    expect(mesh.generations.isCurrent(last)).toBe(false);
  });

  test('are off until they are switched on, and a clone has them too', () => {
    using mesh = grid();
    expect(mesh.generations.enabled).toBe(false);
    const use = () => mesh.generations.reference('face', 0);
    expectRefused(use, 'no-generations');
    mesh.generations.enabled = true;
    const reference = use();
    using copy = mesh.clone();
    expect(copy.generations.enabled).toBe(true);
    expect(copy.generations.isCurrent(reference)).toBe(true);
    mesh.generations.enabled = false;
    expectRefused(() => mesh.generations.isCurrent(reference), 'no-generations');
    expect(() => {
      mesh.generations.enabled = 1 as never;
    }).toThrow('enabled is 1; expected true or false.');
  });

  test('check what they are asked about', () => {
    using mesh = HalfedgeMesh.fromPolygons(tetrahedron().positions, tetrahedron().faces);
    mesh.generations.enabled = true;
    const { generations } = mesh;
    expect(() => generations.reference('face', 4)).toThrow(
      'item is 4; expected a face from 0 to 3.',
    );
    expect(() => generations.reference('ring' as never, 0)).toThrow('kind is "ring"');
    expect(() => generations.isCurrent(5 as never)).toThrow('reference is 5; expected one that');
    expect(() => generations.isCurrent({ kind: 'face', index: 0.5, generation: 0 })).toThrow(
      'reference.index is 0.5',
    );
    expect(generations.isCurrent({ kind: 'face', index: 99, generation: 0 })).toBe(false);
    const picked = { kind: 'face', index: 0 }; // no reference: nobody can tell which face it was
    expect(() => generations.isCurrent(picked as never)).toThrow(
      new TypeError(
        'reference.generation is undefined; expected the number that reference() has given it.',
      ),
    );
    expect(() => generations.isCurrent({} as never)).toThrow('reference.kind is undefined;');
  });

  test('have no name that an attribute could have', () => {
    using mesh = HalfedgeMesh.tetrahedron();
    mesh.generations.enabled = true;
    const reference = mesh.generations.reference('vertex', 2);
    mesh.attributes.add('vertex', 'generation', { type: 'uint32', default: 7 });
    expect(mesh.attributes.get('vertex', 'generation')).toEqual(Uint32Array.of(7, 7, 7, 7));
    expect(mesh.generations.isCurrent(reference)).toBe(true);
    mesh.attributes.remove('vertex', 'generation');
    expect(mesh.attributes.remove('vertex', '')).toBe(false);
    expect(mesh.generations.isCurrent(reference)).toBe(true);
    expectRefused(() => mesh.attributes.add('vertex', ''), 'bad-attribute');
  });
});
