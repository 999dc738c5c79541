import { HalfedgeError, HalfedgeMesh, init } from 'halfedge';
import { fromBufferGeometry, MeshGeometry, toBufferGeometry } from 'halfedge/three';
import { bytesInUse, withLeft } from './support/core.js';
import { quadGrid, tetrahedron } from './support/meshes.js';

beforeAll(() => init());

const { positions, faces } = tetrahedron();

/** What the error tells to do, or that it isn't WebAssembly which has no room. */
const ADVICE = /ispose of meshes that are no longer needed\.$|JavaScript has\.$/;

function expectOutOfMemory(call: () => unknown): void {
  let thrown: unknown;
  try {
    call();
  } catch (error) {
    thrown = error;
  }
  expect(thrown).toBeInstanceOf(HalfedgeError);
  expect(thrown).toMatchObject({
    code: 'out-of-memory',
    message: expect.stringMatching(ADVICE),
  });
}

/** One face of a large soup. */
const FEW = new Uint32Array([0, 1, 2]);

/**
 * Runs `use` while JavaScript makes no typed array of more than 100 links that isn't a view, but for
 * the first `made`.
 */
function withoutRoomForCopies(use: () => void, made = 0): void {
  const scope = globalThis as unknown as Record<string, unknown>;
  const kinds = { Uint8Array, Uint32Array, Int32Array };
  let asked = 0;
  for (const [name, Kind] of Object.entries(kinds)) {
    scope[name] = new Proxy(Kind, {
      construct(target, given, newTarget) {
        const [source] = given as [unknown];
        const length = ArrayBuffer.isView(source) ? (source as Uint8Array).length : source;
        if (typeof length === 'number' && length > 100 && asked++ >= made) {
          throw new RangeError('Array buffer allocation failed');
        }
        return Reflect.construct(target, given, newTarget);
      },
    });
  }
  try {
    use();
  } finally {
    Object.assign(scope, kinds);
  }
}

/** The module still works, and has lost nothing. */
function expectSound(bytesBefore: number): void {
  expect(bytesInUse()).toBe(bytesBefore);
  using mesh = HalfedgeMesh.fromPolygons(positions, faces);
  expect(mesh.validate()).toEqual([]);
  expect(() => HalfedgeMesh.fromTriangles(positions, [0, 0, 0])).toThrow(/vertex 0/i);
}

describe('A mesh too large for memory', () => {
  // The arrays are never written, so that they take address space and no memory.
  test('because its positions alone exceed 4 GiB is an error', () => {
    const before = bytesInUse();
    expectOutOfMemory(() => HalfedgeMesh.fromTriangles(new Float32Array(3 * 400_000_000), []));
    expectSound(before);
  });

  test('by a size that wraps around at 4 GiB is an error, not a small mesh', () => {
    const before = bytesInUse();
    const count = 2 ** 30 + 3 - ((2 ** 30 + 3) % 3); // bytes: 4 GiB and a little
    expectOutOfMemory(() => HalfedgeMesh.fromTriangles(new Float32Array(count), []));
    expectOutOfMemory(() => HalfedgeMesh.fromTriangles([], new Uint32Array(count)));
    expectSound(before);
  });

  test('because nearly all memory is taken is an error, wherever it runs out', () => {
    const before = bytesInUse();
    const grid = quadGrid(120, 120);
    const points = Float32Array.from(grid.positions);
    const polygons = {
      sizes: new Uint32Array(grid.faces.length).fill(4),
      corners: Uint32Array.from(grid.faces.flat()),
    };
    using whole = HalfedgeMesh.fromPolygons(points, polygons);
    const used = bytesInUse() - before;
    const text = `${grid.positions.map((x, i) => (i % 3 === 0 ? `\nv ${x}` : ` ${x}`)).join('')}\n`;
    let refused = 0;
    for (let room = 0; room < 3 * used; room += Math.ceil(used / 8)) {
      withLeft(room, () => {
        for (const ask of [
          () => HalfedgeMesh.fromPolygons(points, polygons).dispose(),
          () =>
            HalfedgeMesh.fromPolygons(points, {
              ...polygons,
              corners: new Uint32Array(polygons.corners.length),
            }).dispose(),
          () => HalfedgeMesh.parse(text).mesh.dispose(),
          () => HalfedgeMesh.parse(`${text}f 1 1 1\n`).mesh.dispose(),
          () => {
            using copy = whole.clone();
            expect(copy.edgeCount).toBe(whole.edgeCount);
          },
          () => whole.allVertexVertices(),
          () => whole.components(),
          () => whole.boundaryLoops(),
          () => whole.genus(),
          () => HalfedgeMesh.grid(120).dispose(),
          () => HalfedgeMesh.icoSphere(5).dispose(),
          () => whole.dual().dispose(),
          () => whole.extract(whole.faces()).mesh.dispose(),
          () => whole.toTriangles(),
          () => whole.kRing(0, 300),
          () => whole.link({ vertices: [0], faces: [7] }),
          () => HalfedgeMesh.fromBytes(whole.toBytes()).dispose(),
          () => {
            using copy = whole.clone();
            copy.append(whole);
          },
          () => new HalfedgeMesh().dispose(),
        ]) {
          try {
            ask();
          } catch (error) {
            expect(String(error)).toMatch(/^HalfedgeError: /);
            if ((error as HalfedgeError).code !== 'out-of-memory') continue;
            expect(String(error)).toMatch(ADVICE);
            refused += 1;
          }
        }
        for (const level of [4, 'geometry'] as const) {
          const problems = whole.validate(level);
          expect(problems.filter(({ code }) => code !== 'out-of-memory')).toEqual([]);
        }
      });
    }
    expect(refused).toBeGreaterThan(8);
    whole.dispose();
    expectSound(before);
  });

  test('because JavaScript has no room for a report is an error, and frees the mesh', () => {
    const before = bytesInUse();
    const grid = quadGrid(20, 20);
    const text = `OFF\n${grid.positions.length / 3} ${grid.faces.length} 0\n${[
      ...Array.from({ length: grid.positions.length / 3 }, (_, v) =>
        grid.positions.slice(3 * v, 3 * v + 3).join(' '),
      ),
      ...grid.faces.map((face) => `4 ${face.join(' ')}`),
    ].join('\n')}\n`;
    const whole = HalfedgeMesh.fromPolygons(grid.positions, grid.faces);
    const sixty = Uint32Array.from({ length: 60 }, (_, f) => f);
    withoutRoomForCopies(() => {
      expectOutOfMemory(() => HalfedgeMesh.parse(text));
      expectOutOfMemory(() => HalfedgeMesh.parse(text, { repair: false }));
      expectOutOfMemory(() => HalfedgeMesh.fromSoup(Float32Array.from(grid.positions), FEW));
      expectOutOfMemory(() => whole.allVertexVertices());
      expectOutOfMemory(() => whole.components());
      expectOutOfMemory(() => whole.compact());
      expectOutOfMemory(() => whole.toTriangles());
      expectOutOfMemory(() => whole.extract(whole.faces()));
      expectOutOfMemory(() => whole.extract(sixty)); // there is room for the list, not for its edges
    });
    whole.dispose();
    expectSound(before);
  });

  test('because JavaScript has no room for one of the copies is an error, whichever it is', () => {
    const before = bytesInUse();
    using whole = HalfedgeMesh.grid(20);
    whole.attributes.add('halfedge', 'uv', { components: 2 });
    whole.attributes.add('face', 'group', { type: 'int32' });
    const { geometry } = toBufferGeometry(whole);
    const codes: string[] = [];
    for (const call of [
      () => whole.components(),
      () => whole.toPolygons(),
      () => toBufferGeometry(whole),
      () => fromBufferGeometry(geometry).mesh.dispose(),
      () => new MeshGeometry(whole).dispose(),
    ]) {
      for (let made = 0, failed = true; failed; made++) {
        try {
          withoutRoomForCopies(call, made);
          failed = false;
        } catch (error) {
          codes.push((error as HalfedgeError).code ?? `${call}: ${error}`);
        }
      }
    }
    expect(codes.length).toBeGreaterThan(20);
    expect(codes.filter((code) => code !== 'out-of-memory')).toEqual([]);
    whole.dispose();
    expectSound(before);
  });

  test('for the history of a group that throws keeps its changes, and forgets all steps', () => {
    const before = bytesInUse();
    using mesh = HalfedgeMesh.grid(40);
    mesh.history.enabled = true;
    mesh.setPosition(0, [7, 7, 7]);
    const move = () =>
      mesh.history.group(() => {
        for (const v of mesh.vertices()) mesh.setPosition(v, [v, 1, 2]);
        throw new Error('Stop.');
      });
    withLeft(0, () => expect(move).toThrow('Stop.'));
    expect([mesh.position(5), mesh.history.undoCount]).toEqual([[5, 1, 2], 0]);
    mesh.setPosition(5, [0, 0, 0]);
    expect(move).toThrow('Stop.');
    expect([mesh.position(5), mesh.history.undoCount]).toEqual([[0, 0, 0], 1]);
    mesh.dispose();
    expectSound(before);
  });

  test('in the middle of edits refuses them, and leaves a mesh that is whole', () => {
    const before = bytesInUse();
    const grid = quadGrid(40, 40);
    let refused = 0;
    for (let room = 0; room < 400_000; room += 40_000) {
      using mesh = HalfedgeMesh.fromPolygons(grid.positions, grid.faces);
      mesh.attributes.add('vertex', 'normal', { components: 3, onSplit: 'normalize' });
      mesh.attributes.add('halfedge', 'uv', { components: 2 });
      mesh.history.enabled = room % 80_000 === 0;
      withLeft(room, () => {
        for (let i = 0; i < 4000; i++) {
          const { version, edgeCount } = mesh;
          try {
            if (i % 1000 === 999) mesh.triangulate();
            else if (i % 3 === 0) mesh.splitFace(i % grid.faces.length);
            else if (i % 3 === 1) mesh.splitEdge(i);
            else mesh.addVertex();
          } catch (error) {
            expect(String(error)).toMatch(/^HalfedgeError: /);
            if ((error as HalfedgeError).code !== 'out-of-memory') continue;
            refused += 1;
            expect([mesh.version, mesh.edgeCount]).toEqual([version, edgeCount]);
            if (refused % 50 === 0) break;
          }
        }
        for (const ask of [
          () => mesh.attributes.add('face', 'late', { type: 'float64', components: 16 }),
          () => {
            mesh.generations.enabled = true;
          },
          () => mesh.reserve(1e6, 3e6, 2e6),
          () => mesh.compact(),
          () => mesh.keepLargestComponents(),
          () => mesh.reverse(),
        ]) {
          try {
            ask();
          } catch (error) {
            expect(error).toMatchObject({
              code: 'out-of-memory',
              message: expect.stringMatching(ADVICE),
            });
          }
        }
      });
      expect(mesh.validate().filter(({ severity }) => severity === 'error')).toEqual([]);
      while (mesh.history.undo());
      expect(mesh.validate().filter(({ severity }) => severity === 'error')).toEqual([]);
    }
    expect(refused).toBeGreaterThan(8);
    expectSound(before);
  });
});
