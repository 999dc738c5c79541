import { HalfedgeMesh, init } from 'halfedge';
import {
  bytesInUse,
  growMemory,
  growSilently,
  isDetached,
  memorySize,
  withFullHeap,
  withTaken,
} from './support/core.js';
import { quadGrid, randomPolygons } from './support/meshes.js';

beforeAll(() => init());

const { positions, faces } = quadGrid();
const build = () => HalfedgeMesh.fromPolygons(positions, faces);

describe('After dispose', () => {
  const makers: [string, () => HalfedgeMesh | undefined][] = [
    ['builds from arrays', build],
    [
      'builds from random polygons',
      () => {
        const input = randomPolygons(3);
        return HalfedgeMesh.fromPolygons(input.positions, input.faces);
      },
    ],
    ['empty meshes', () => new HalfedgeMesh()],
    ['files', () => HalfedgeMesh.parse('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nvt 1\n').mesh],
    [
      'clones',
      () => {
        using original = build();
        return original.clone();
      },
    ],
    ['refused builds', () => refused(() => HalfedgeMesh.fromTriangles([0, 0, 0], [0, 0, 0]))],
    ['refused arguments', () => refused(() => HalfedgeMesh.fromTriangles([0, 0, 0], [0, 0, 0.5]))],
    [
      'refused sizes',
      () => refused(() => HalfedgeMesh.fromPolygons([0, 0, 0], { sizes: [9], corners: [0] })),
    ],
    ['broken files', () => refused(() => HalfedgeMesh.parse('v 0 0 x'))],
    [
      'files that make no mesh',
      () => refused(() => HalfedgeMesh.parse('v 0 0 0\nf 1 1 1\nf 1 1 1\n', { repair: false })),
    ],
    ['files that are repaired', () => HalfedgeMesh.parse('v 0 0 0\nf 1 1 1\nf 1 1 1\n').mesh],
    ['files of no known format', () => refused(() => HalfedgeMesh.parse(Uint8Array.of(1, 2, 3)))],
    [
      'a mesh asked everything',
      () => {
        const mesh = build();
        mesh.validate();
        mesh.components();
        mesh.boundaryLoops();
        mesh.genus();
        mesh.toTriangles();
        mesh.allVertexFaces('cw');
        mesh.allFaceFaces('ccw', [1, 2]);
        refused(() => mesh.allFaceFaces('ccw', [99]));
        refused(() => mesh.allFaceFaces('ccw', { length: 2 }));
        refused(() => mesh.allFaceFaces('up' as 'cw'));
        return mesh;
      },
    ],
    [
      'corrupt meshes asked everything',
      () => {
        const mesh = build();
        mesh.connectivity.next.fill(7);
        mesh.connectivity.prev.fill(7);
        mesh.validate();
        for (const ask of [
          () => mesh.components(),
          () => mesh.boundaryLoops(),
          () => mesh.genus(),
          () => mesh.allVertexFaces('cw'),
          () => mesh.allFaceFaces('ccw', [1]),
        ]) {
          refused(ask);
        }
        return mesh;
      },
    ],
  ];
  function refused(call: () => unknown): undefined {
    expect(call).toThrow();
  }

  test.each(makers)('not a byte is left of a thousand %s', (_, make) => {
    make()?.dispose(); // what the first call allocates for good: nothing, but the test is not about it
    const before = bytesInUse();
    for (let i = 0; i < 1000; i++) make()?.dispose();
    expect(bytesInUse()).toBe(before);
  });

  test('not a byte is left of many meshes that lived together', () => {
    const before = bytesInUse();
    const meshes = Array.from({ length: 200 }, (_, i) => {
      const input = randomPolygons(i);
      return HalfedgeMesh.fromPolygons(input.positions, input.faces);
    });
    expect(bytesInUse()).toBeGreaterThan(before + 200 * 500);
    for (const mesh of meshes) mesh.dispose();
    expect(bytesInUse()).toBe(before);
  });

  test('`using` has the same effect', () => {
    const before = bytesInUse();
    let kept: HalfedgeMesh;
    {
      using mesh = build();
      kept = mesh;
      expect(bytesInUse()).toBeGreaterThan(before);
    }
    expect(kept.disposed).toBe(true);
    expect(bytesInUse()).toBe(before);
  });
});

describe('The garbage collector', () => {
  const collect = async () => {
    if (globalThis.gc === undefined) throw new Error('Run Node with --expose-gc.');
    for (let i = 0; i < 10; i++) {
      globalThis.gc();
      await new Promise((resolve) => setTimeout(resolve, 5));
    }
  };

  test('frees meshes that were forgotten', async () => {
    await collect();
    const before = bytesInUse();
    (() => {
      for (let i = 0; i < 50; i++) build();
    })();
    expect(bytesInUse()).toBeGreaterThan(before);
    await collect();
    expect(bytesInUse()).toBe(before);
  });

  test('does not free a mesh twice that was disposed of', async () => {
    await collect();
    const before = bytesInUse();
    (() => build().dispose())();
    using other = build();
    await collect();
    expect(other.validate()).toEqual([]);
    other.dispose();
    expect(bytesInUse()).toBe(before);
  });

  test('leaves the memory of a forgotten mesh alone while one of its views is kept', async () => {
    await collect();
    const before = bytesInUse();
    // In a function of their own, so that no register of this one keeps a mesh.
    let [view, points] = (() => [build().connectivity.toVertex, build().positions])() as [
      Int32Array | undefined,
      Float32Array | undefined,
    ];
    const copies = [Array.from(view ?? []), Array.from(points ?? [])];
    await collect();
    expect(bytesInUse()).toBeGreaterThan(before);
    const other = randomPolygons(7);
    const reusing = Array.from({ length: 20 }, () =>
      HalfedgeMesh.fromPolygons(other.positions, other.faces),
    );
    expect([Array.from(view ?? []), Array.from(points ?? [])]).toEqual(copies);
    for (const mesh of reusing) mesh.dispose();
    view = points = undefined;
    await collect();
    expect(bytesInUse()).toBe(before);
  });
});

describe('Views', () => {
  test('are the same object until something makes them stale', () => {
    using mesh = build();
    const { connectivity, positions: points } = mesh;
    mesh.validate();
    mesh.allVertexVertices();
    expect(mesh.connectivity).toBe(connectivity);
    expect(mesh.positions).toBe(points);
  });

  test('are fresh after room was made for more slots, needed or not', () => {
    using mesh = build();
    const kept = mesh.connectivity;
    const points = mesh.positions;
    mesh.reserve(1000, 1000, 1000);
    expect(mesh.connectivity).not.toBe(kept);
    expect(mesh.positions).not.toBe(points);
    expect(Array.from(mesh.positions)).toEqual(positions);
  });

  test('are fresh after growth of the memory, which leaves kept ones empty', () => {
    using mesh = build();
    const { connectivity, positions: points } = mesh;
    const copy = Array.from(connectivity.next);
    growMemory();
    expect(connectivity.next).toHaveLength(0);
    expect(points).toHaveLength(0);
    expect(mesh.connectivity).not.toBe(connectivity);
    expect(Array.from(mesh.connectivity.next)).toEqual(copy);
    expect(Array.from(mesh.positions)).toEqual(positions);
    expect(mesh.connectivity).toBe(mesh.connectivity);
  });

  test('of all meshes are replaced at once when the memory grows', () => {
    using mesh = build();
    using other = HalfedgeMesh.icoSphere(2);
    using gone = mesh.clone();
    gone.dispose();
    growMemory();
    expect([mesh, other].map(isDetached)).toEqual([false, false]);
    for (const h of [0, 5, 10, 15]) {
      expect(() => gone.next(h)).toThrow(expect.objectContaining({ code: 'disposed' }));
    }
    growSilently();
    expect([mesh, other].map(isDetached)).toEqual([true, true]);
  });

  test('can be given several at once, where room for the first detaches the others', () => {
    using mesh = HalfedgeMesh.grid(200, 200, { triangles: true });
    const corners = mesh.attributes.add('face', 'corners', { type: 'uint32', components: 3 });
    corners.set(mesh.toTriangles().indices);
    using copy = withFullHeap(() =>
      HalfedgeMesh.fromTriangles(mesh.positions, mesh.attributes.get('face', 'corners')),
    );
    expect(copy.faceCount).toBe(mesh.faceCount);
    expect(copy.positions).toEqual(mesh.positions);
    const { mesh: mended } = withFullHeap(() =>
      HalfedgeMesh.fromSoup(mesh.positions, mesh.attributes.get('face', 'corners')),
    );
    expect(mended.faceCount).toBe(mesh.faceCount);
    mended.dispose();
    const ids = mesh.attributes.add('face', 'id', { type: 'uint32' });
    ids.forEach((_, f) => {
      ids[f] = f;
    });
    const vertices = Uint32Array.from({ length: mesh.vertexSlots }, (_, v) => v);
    const star = withFullHeap(() =>
      mesh.star({ vertices, faces: mesh.attributes.get('face', 'id') }),
    );
    expect(star.faces).toHaveLength(mesh.faceCount);
  });

  test('can be replaced while an operation is at work on their mesh', () => {
    using mesh = HalfedgeMesh.icoSphere(5);
    using twin = mesh.clone();
    const size = memorySize();
    for (let v = 0; size === memorySize() || v < 100; v++) {
      for (const each of [mesh, twin]) each.splitFace(v % 20000, [v, 0, 1]);
    }
    expect(mesh.validate().filter(({ severity }) => severity === 'error')).toEqual([]);
    expect([...mesh.vertexVertices(7)]).toEqual([...twin.vertexVertices(7)]);
  });

  const reads: [string, (mesh: HalfedgeMesh) => unknown][] = [
    ['next', (mesh) => mesh.next(3)],
    ['prev', (mesh) => mesh.prev(3)],
    ['opposite', (mesh) => mesh.opposite(3)],
    ['edge', (mesh) => mesh.edge(3)],
    ['face', (mesh) => mesh.face(3)],
    ['toVertex', (mesh) => mesh.toVertex(3)],
    ['fromVertex', (mesh) => mesh.fromVertex(3)],
    ['rotateCcw', (mesh) => mesh.rotateCcw(3)],
    ['rotateCw', (mesh) => mesh.rotateCw(3)],
    ['nextOnVertex', (mesh) => mesh.nextOnVertex(3)],
    ['prevOnVertex', (mesh) => mesh.prevOnVertex(3)],
    ['vertexHalfedge', (mesh) => mesh.vertexHalfedge(3)],
    ['faceHalfedge', (mesh) => mesh.faceHalfedge(3)],
    ['edgeHalfedge', (mesh) => mesh.edgeHalfedge(3)],
    ['findHalfedge', (mesh) => mesh.findHalfedge(3, 2)],
    ['isBoundaryVertex', (mesh) => mesh.isBoundaryVertex(3)],
    ['isBoundaryEdge', (mesh) => mesh.isBoundaryEdge(3)],
    ['isBoundaryFace', (mesh) => mesh.isBoundaryFace(3)],
    ['isManifoldVertex', (mesh) => mesh.isManifoldVertex(3)],
    ['valence', (mesh) => mesh.valence(3)],
    ['degree', (mesh) => mesh.degree(3)],
    ['vertexCount', (mesh) => mesh.vertexCount],
    ['connectivity', (mesh) => mesh.connectivity.next[3]],
    ['positions', (mesh) => mesh.positions[3]],
  ];
  test.each(reads)('are mended by the first %s if nobody was told of growth', (_, read) => {
    using mesh = build();
    const before = read(mesh);
    growSilently();
    expect(read(mesh)).toBe(before);
  });

  test('of positions can be written to, and the mesh sees it', () => {
    using mesh = build();
    const { version } = mesh;
    mesh.positions.set([7, 8, 9], 3);
    using copy = mesh.clone();
    expect(Array.from(copy.positions.subarray(3, 6))).toEqual([7, 8, 9]);
    expect(mesh.version).toBe(version);
  });
});

describe('Beyond 2 GiB', () => {
  test('meshes are made, read, refused and freed as anywhere', () => {
    withTaken([2 ** 31 + 2 ** 20], () => {
      const before = bytesInUse();
      const large = new Float32Array(3 * 100_000); // does not fit into what is free below
      const meshes = Array.from({ length: 10 }, () => HalfedgeMesh.fromTriangles(large, []));
      expect(memorySize()).toBeGreaterThan(2 ** 31);
      expect(meshes.at(-1)?.positions.byteOffset).toBeGreaterThan(2 ** 31);
      const input = randomPolygons(5);
      const high: HalfedgeMesh[] = [];
      do high.push(HalfedgeMesh.fromPolygons(input.positions, input.faces));
      while ((high.at(-1)?.connectivity.next.byteOffset ?? 0) < 2 ** 31);
      const mesh = high.at(-1) as HalfedgeMesh;
      expect(mesh.toPolygons().corners).toEqual(Uint32Array.from(input.faces.flat()));
      expect(mesh.next(mesh.prev(3))).toBe(3);
      expect(mesh.validate().filter(({ severity }) => severity === 'error')).toEqual([]);
      expect(mesh.allVertexVertices('cw', [1])).toBeDefined();
      expect(mesh.components().length).toBeGreaterThan(0);
      expect(() => HalfedgeMesh.parse('v 0 0 0\nf 1 2 x\n')).toThrow('Line 2');
      expect(() => mesh.allVertexVertices('cw', [9999])).toThrow('vertices[0] is 9999');
      for (const made of [...high, ...meshes]) made.dispose();
      expect(bytesInUse()).toBe(before);
    });
  });
});
