import { HalfedgeError, HalfedgeMesh, init } from 'halfedge';
import { expectRefused, stateOf } from './support/editing.js';
import { quadGrid, tetrahedron, torus } from './support/meshes.js';
import { random } from './support/random.js';

beforeAll(() => init());

/** A grid of triangles, whose edge 1-4 can be flipped. */
function triangles(): HalfedgeMesh {
  const { positions } = quadGrid(3, 3);
  return HalfedgeMesh.fromTriangles(
    positions,
    [0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4, 3, 4, 7, 3, 7, 6, 4, 5, 8, 4, 8, 7],
  );
}

describe('History', () => {
  test('is off by default, and then there is nothing to undo', () => {
    using mesh = triangles();
    expect(mesh.history.enabled).toBe(false);
    mesh.flipEdge(mesh.findEdge(1, 5));
    expect(mesh.history).toMatchObject({ canUndo: false, canRedo: false, undoCount: 0, bytes: 0 });
    expect(mesh.history.undo()).toBe(false);
    expect(mesh.history.redo()).toBe(false);
    expect(mesh.findEdge(2, 4)).not.toBe(-1);
  });

  test('takes an operation back to the last word, and does it again', () => {
    using mesh = triangles();
    mesh.history.enabled = true;
    const before = stateOf(mesh);
    mesh.flipEdge(mesh.findEdge(1, 5));
    const after = stateOf(mesh);
    expect(after).not.toEqual(before);
    expect(mesh.history).toMatchObject({ canUndo: true, canRedo: false, undoCount: 1 });
    expect(mesh.history.bytes).toBeGreaterThan(0);
    expect(mesh.history.undo()).toBe(true);
    expect(stateOf(mesh)).toEqual(before);
    expect(mesh.history).toMatchObject({ canUndo: false, canRedo: true, redoCount: 1 });
    expect(mesh.history.redo()).toBe(true);
    expect(stateOf(mesh)).toEqual(after);
    expect(mesh.history.redo()).toBe(false);
  });

  test('changes the version and ends circulators, back and forth', () => {
    using mesh = triangles();
    mesh.history.enabled = true;
    mesh.flipEdge(mesh.findEdge(1, 5));
    const versions = new Set([mesh.version]);
    for (const way of ['undo', 'redo'] as const) {
      const ring = mesh.circulate('vertexVertices', 4);
      mesh.history[way]();
      versions.add(mesh.version);
      expect(() => ring.next()).toThrow('after the connectivity changed');
    }
    expect(versions.size).toBe(3);
  });

  test('of a refused operation has no step', () => {
    using mesh = triangles();
    mesh.history.enabled = true;
    expectRefused(() => mesh.flipEdge(mesh.findEdge(0, 1)), 'boundary-edge');
    expect(mesh.history.undoCount).toBe(0);
  });

  test('forgets what was undone when something else is done', () => {
    using mesh = triangles();
    mesh.history.enabled = true;
    mesh.flipEdge(mesh.findEdge(1, 5));
    mesh.history.undo();
    mesh.setPosition(0, [7, 8, 9]);
    expect(mesh.history).toMatchObject({ undoCount: 1, redoCount: 0 });
  });

  test('notes moves of vertices', () => {
    using mesh = triangles();
    mesh.history.enabled = true;
    const { version } = mesh;
    mesh.setPosition(3, new Float64Array([7, 8, 9]));
    expect(mesh.version).toBe(version);
    expect(mesh.position(3)).toEqual([7, 8, 9]);
    mesh.history.undo();
    expect(mesh.position(3)).toEqual([0, 1, 0]);
  });

  test('is forgotten when it is switched off, and by clear()', () => {
    using mesh = triangles();
    const { history } = mesh;
    history.enabled = true;
    mesh.setPosition(0, [1, 1, 1]);
    history.clear();
    expect(history.undoCount).toBe(0);
    mesh.setPosition(0, [2, 2, 2]);
    history.enabled = true; // it is already
    expect(history.undoCount).toBe(1);
    history.enabled = false;
    history.enabled = true;
    expect(history.undoCount).toBe(0);
  });

  test('reaches as far back as the limits say', () => {
    using mesh = triangles();
    const { history } = mesh;
    history.limit({ steps: 3 });
    history.enabled = true;
    for (let i = 0; i < 10; i++) mesh.setPosition(i % 9, [i, i, i]);
    expect(history.undoCount).toBe(3);
    history.limit({ steps: 2 });
    expect(history.undoCount).toBe(2);
    history.limit({ bytes: 0 });
    expect(history.undoCount).toBe(1); // the last one is kept in any case
    history.limit({});
    for (let i = 0; i < 10; i++) mesh.setPosition(i % 9, [i, 0, i]);
    expect(history.undoCount).toBe(11);
    expect(() => history.limit({ steps: -1 })).toThrow(
      'steps is -1; expected a whole number from 0, or Infinity.',
    );
    expect(() => history.limit({ steps: 1.5 })).toThrow(RangeError);
    expect(() => history.limit({ bytes: Number.NaN })).toThrow(RangeError);
    expect(() => history.limit({ steps: '3' as never })).toThrow(TypeError);
    expect(() => history.limit({ steps: Symbol('x') as never })).toThrow('steps is a symbol;');
    expect(() => history.limit(3 as never)).toThrow(TypeError);
  });

  test('is of one mesh: a clone begins without', () => {
    using mesh = triangles();
    mesh.history.enabled = true;
    mesh.setPosition(0, [1, 1, 1]);
    using copy = mesh.clone();
    expect(copy.history.enabled).toBe(false);
    expect(copy.history.undoCount).toBe(0);
    expect(copy.position(0)).toEqual([1, 1, 1]);
  });

  test('throws after dispose, and for what is no switch', () => {
    const mesh = triangles();
    const { history } = mesh;
    expect(() => {
      history.enabled = 1 as never;
    }).toThrow('enabled is 1; expected true or false.');
    mesh.dispose();
    for (const use of [
      () => history.enabled,
      () => history.undo(),
      () => history.canRedo,
      () => history.bytes,
      () => history.clear(),
      () => history.limit({}),
      () => history.group(() => 1),
    ]) {
      expect(use).toThrow('disposed');
    }
  });

  test('writes nothing to the room behind the last items, however much there is', () => {
    using mesh = HalfedgeMesh.grid(10, 10);
    mesh.reserve(10_000, 60_000, 20_000);
    mesh.history.enabled = true;
    for (const e of [3, 50, 80]) mesh.splitEdge(e);
    let written = 0;
    const { fill } = Int32Array.prototype;
    const counted = import.meta.jest
      .spyOn(Int32Array.prototype, 'fill')
      .mockImplementation(function (this: Int32Array, value, start = 0, end = this.length) {
        written += end - start;
        return fill.call(this, value, start, end);
      });
    while (mesh.history.undo());
    counted.mockRestore();
    expect(written).toBe(3 * (1 + 4 * 2)); // a vertex and the four links of two halfedges each
    expect(mesh.isLiveVertex(mesh.vertexSlots)).toBe(false);
  });
});

describe('A group', () => {
  test('is one step, with all groups in it, and returns what its function does', () => {
    using mesh = triangles();
    const { history } = mesh;
    history.enabled = true;
    const before = stateOf(mesh);
    const result = history.group(() => {
      mesh.flipEdge(mesh.findEdge(1, 5));
      history.group(() => mesh.setPosition(0, [3, 3, 3]));
      mesh.setPosition(1, [4, 4, 4]);
      return 'done';
    });
    expect(result).toBe('done');
    expect(history.undoCount).toBe(1);
    history.undo();
    expect(stateOf(mesh)).toEqual(before);
    history.redo();
    expect(mesh.position(1)).toEqual([4, 4, 4]);
  });

  test('without a change is no step', () => {
    using mesh = triangles();
    mesh.history.enabled = true;
    mesh.history.group(() => undefined);
    expect(mesh.history.undoCount).toBe(0);
  });

  test('whose function throws has changed nothing, and passes the error on', () => {
    using mesh = triangles();
    const { history } = mesh;
    history.enabled = true;
    mesh.setPosition(2, [9, 9, 9]);
    const before = stateOf(mesh);
    expectRefused(
      () =>
        history.group(() => {
          mesh.flipEdge(mesh.findEdge(1, 5));
          mesh.flipEdge(mesh.findEdge(0, 1));
        }),
      'boundary-edge',
    );
    expect(stateOf(mesh)).toEqual(before);
    expect(history).toMatchObject({ undoCount: 1, redoCount: 0 });
    expect(() =>
      history.group(() => {
        throw new Error('of the user');
      }),
    ).toThrow('of the user');
    expect(history.undoCount).toBe(1); // not the step before it
    mesh.flipEdge(mesh.findEdge(1, 5)); // steps end again
    expect(history.undoCount).toBe(2);
  });

  test('whose function goes on later is refused, and has changed nothing', () => {
    using mesh = triangles();
    mesh.history.enabled = true;
    const before = stateOf(mesh);
    const laterInAPromise = async () => void mesh.splitFace(0);
    const laterInAThenable = () => {
      mesh.splitFace(0);
      return new (class {
        // biome-ignore lint/suspicious/noThenProperty: that it is like a promise is the point
        then() {}
      })();
    };
    for (const edit of [laterInAPromise, laterInAThenable]) {
      expect(() => mesh.history.group(edit as never)).toThrow(TypeError);
      expect(() => mesh.history.group(edit as never)).toThrow(
        /^edit returned a Promise; expected a function that is done when it returns/,
      );
    }
    expect(stateOf(mesh)).toEqual(before);
    expect(mesh.history.canUndo).toBe(false);
  });

  test('leaves nothing behind of a promise that it refused', async () => {
    using mesh = triangles();
    let rejections = 0;
    const count = () => {
      rejections += 1;
    };
    process.on('unhandledRejection', count);
    const edit = async () => {
      throw new Error('of the user');
    };
    expect(() => mesh.history.group(edit as never)).toThrow(TypeError);
    await new Promise((resolve) => setTimeout(resolve, 10));
    process.off('unhandledRejection', count);
    expect(rejections).toBe(0);
  });

  test('whose function throws costs no earlier step, whatever the limits are', () => {
    using mesh = triangles();
    const { history } = mesh;
    history.enabled = true;
    for (const limits of [{ steps: 3 }, { bytes: 100 }]) {
      history.limit(limits);
      for (let x = 1; x <= 3; x++) mesh.setPosition(0, [x, 0, 0]);
      const { undoCount, bytes } = history;
      const failing = () => {
        for (let x = 10; x < 30; x++) mesh.setPosition(0, [x, 0, 0]);
        throw new Error('of the user');
      };
      expect(() => history.group(failing)).toThrow('of the user');
      expect(history).toMatchObject({ undoCount, bytes });
      expect(mesh.position(0)).toEqual([3, 0, 0]);
      history.undo();
      expect(mesh.position(0)).toEqual([2, 0, 0]);
    }
  });

  test('keeps what was changed where history is off', () => {
    using mesh = triangles();
    expect(() =>
      mesh.history.group(() => {
        mesh.setPosition(0, [1, 2, 3]);
        throw new Error('of the user');
      }),
    ).toThrow('of the user');
    expect(mesh.position(0)).toEqual([1, 2, 3]);
  });

  test('within another takes nothing back by itself', () => {
    using mesh = triangles();
    const { history } = mesh;
    history.enabled = true;
    const before = stateOf(mesh);
    const failing = () =>
      history.group(() => {
        mesh.setPosition(0, [1, 2, 3]);
        throw new Error('of the user');
      });
    history.group(() => expect(failing).toThrow('of the user'));
    expect(mesh.position(0)).toEqual([1, 2, 3]);
    history.undo();
    expect(stateOf(mesh)).toEqual(before);
  });

  test.each(['undo', 'redo', 'throw'])(
    'that grew and then closed gaps leaves no ghosts beyond the last item: %s',
    (way) => {
      using mesh = triangles();
      mesh.reserve(100, 100, 100); // so that no array moves
      mesh.history.enabled = true;
      const normals = mesh.allVertexNormals();
      const edit = () => {
        for (const f of mesh.faces().toArray()) mesh.poke(f, 1);
        for (const f of mesh
          .faces()
          .toArray()
          .slice(0, way === 'redo' ? 4 : 20))
          mesh.deleteFace(f);
        mesh.compact();
        if (way === 'throw') throw new Error('no');
      };
      if (way === 'throw') expect(() => mesh.history.group(edit)).toThrow('no');
      else mesh.history.group(edit);
      if (way !== 'throw') mesh.history.undo();
      if (way === 'redo') mesh.history.redo();
      else expect(mesh.allVertexNormals()).toEqual(normals);
      const { vertexSlots, halfedgeSlots, edgeSlots, faceSlots } = mesh;
      expect(mesh.isLiveVertex(vertexSlots)).toBe(false);
      expect(mesh.isLiveEdge(edgeSlots)).toBe(false);
      expect(mesh.isLiveFace(faceSlots)).toBe(false);
      expect(() => mesh.next(halfedgeSlots)).toThrow(RangeError);
      expect(() => mesh.vertexHalfedge(vertexSlots)).toThrow(RangeError);
      expect(() => mesh.degree(faceSlots)).toThrow(RangeError);
    },
  );

  test.each([1, 2, 3, 4, 5, 6])(
    'leaves no ghosts after random edits and travels (seed %i)',
    (seed) => {
      const below = random(seed);
      using mesh = HalfedgeMesh.icosahedron();
      const { history } = mesh;
      mesh.reserve(400, 2400, 800); // so that no array moves
      history.enabled = true;
      const any = <T>(items: readonly T[]) => items[Math.floor(below() * items.length)];
      const edit = () => {
        const faces = mesh.faces().toArray();
        if (faces.length === 0 || mesh.faceSlots > 200) return void mesh.compact();
        const kind = below();
        if (kind < 0.6) mesh.poke(any(faces), 0.1);
        else if (kind < 0.9) mesh.deleteFace(any(faces));
        else mesh.compact();
      };
      const several = () => {
        for (let i = 0; i < 12; i++) edit();
      };
      const failing = () => {
        several();
        throw new Error('no');
      };
      for (let i = 0; i < 150; i++) {
        const kind = below();
        if (kind < 0.3) edit();
        else if (kind < 0.4) history.group(several);
        else if (kind < 0.5) expect(() => history.group(failing)).toThrow('no');
        else if (kind < 0.8) history.undo();
        else history.redo();
        let ghosts = 0;
        for (let v = mesh.vertexSlots; v < 400; v++) if (mesh.isLiveVertex(v)) ghosts += 1;
        for (let h = mesh.halfedgeSlots; h < 2400; h++) if (mesh.isLiveHalfedge(h)) ghosts += 1;
        for (let f = mesh.faceSlots; f < 800; f++) if (mesh.isLiveFace(f)) ghosts += 1;
        expect(ghosts).toBe(0);
      }
      expect(mesh.validate().filter(({ severity }) => severity === 'error')).toEqual([]);
    },
  );

  test('may dispose of the mesh', () => {
    const mesh = triangles();
    mesh.history.enabled = true;
    mesh.history.group(() => mesh.dispose());
    expect(mesh.disposed).toBe(true);
  });

  test('can not be undone from within', () => {
    using mesh = triangles();
    const { history } = mesh;
    history.enabled = true;
    for (const use of [
      () => history.undo(),
      () => history.redo(),
      () => history.clear(),
      () => mesh.clear(),
      () => history.limit({ steps: 1 }),
      () => {
        history.enabled = false;
      },
    ]) {
      expect(() => history.group(use)).toThrow(HalfedgeError);
      expect(() => history.group(use)).toThrow(/inside of group\(\)/);
    }
    expect(() => history.group(7 as never)).toThrow('edit is 7; expected a function.');
  });
});

test('History works without prev, and on a closed surface', () => {
  const { positions, faces } = tetrahedron();
  using mesh = HalfedgeMesh.fromPolygons(positions, faces, { storePrev: false });
  mesh.history.enabled = true;
  mesh.setPosition(0, [3, 4, 5]);
  mesh.history.undo();
  expect(mesh.position(0)).toEqual([0, 0, 0]);
  using quads = HalfedgeMesh.fromPolygons(torus().positions, torus().faces);
  quads.history.enabled = true;
  expectRefused(() => quads.flipEdge(0), 'not-a-triangle');
});

test('The bytes of meshes tell whether they are the same, as bundlers.md says of tests', () => {
  using mesh = HalfedgeMesh.grid(3, 3);
  using other = HalfedgeMesh.grid(3, 3);
  const same = () => Buffer.compare(mesh.toBytes(), other.toBytes()) === 0;
  expect(same()).toBe(true);
  other.history.enabled = true;
  for (const change of [() => other.setPosition(0, [9, 9, 9]), () => other.deleteFace(4)]) {
    change();
    expect(same()).toBe(false);
    other.history.undo();
    expect(same()).toBe(true);
  }
  for (const one of [mesh, other]) one.deleteFace(4);
  expect(same()).toBe(true);
  other.attributes.add('vertex', 'weight', { type: 'float32' });
  expect(same()).toBe(false);
  other.attributes.remove('vertex', 'weight');
  expect(same()).toBe(true);
  other.compact();
  expect([same(), other.toPolygons()]).toEqual([false, mesh.toPolygons()]);
});
