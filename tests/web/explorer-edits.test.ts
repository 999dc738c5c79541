import { HalfedgeMesh, init } from 'halfedge';
import { Surface } from 'halfedge/scene';
import type { Item } from 'halfedge/teaching';
import {
  checkOperation,
  motionOf,
  type Operation,
  operations,
  operationsFor,
  reversed,
  runOperation,
  stateBefore,
} from 'halfedge/teaching';
import { FaceTree } from 'halfedge/three/picking';
import { Ray, Vector3 } from 'three';
import { digestOf } from '../../web/explorer/app/digest.js';
import { Signal, together } from '../../web/explorer/app/signal.js';
import * as generate from '../../web/explorer/samples/generators.js';

beforeAll(() => init());

/** Rays from all sides towards points near the origin, the same ones each time. */
function rays(count: number): Ray[] {
  let state = 12345;
  const random = () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32 - 0.5;
  };
  return Array.from({ length: count }, () => {
    const origin = new Vector3(random(), random(), random()).setLength(3);
    const target = new Vector3(random(), random(), random());
    return new Ray(origin, target.sub(origin).normalize());
  });
}

describe('signals set together', () => {
  test('tell their listeners once all are set, in the order in which they were', () => {
    const [a, b] = [new Signal(1), new Signal(2)];
    const seen: string[] = [];
    a.subscribe((value) => seen.push(`a ${value} ${b.value}`));
    b.subscribe((value) => seen.push(`b ${value} ${a.value}`));
    seen.length = 0;
    together(() => {
      b.value = 20;
      a.value = 10;
      b.value = 21;
      expect(seen).toEqual([]);
    });
    expect(seen).toEqual(['b 21 10', 'a 10 21']);
    a.value = 11;
    expect(seen.at(-1)).toBe('a 11 21');
  });

  test('are told even when the change throws', () => {
    const a = new Signal(1);
    let told = 0;
    a.subscribe((value) => {
      told = value;
    });
    const change = () =>
      together(() => {
        a.value = 5;
        throw new Error('stop');
      });
    expect(change).toThrow('stop');
    expect(told).toBe(5);
  });
});

describe('the surface after an edit', () => {
  test('names the faces and edges that changed, and no others', () => {
    const mesh = HalfedgeMesh.icoSphere(2);
    const surface = new Surface(mesh);
    const faces = [...mesh.edgeFaces(12)].sort((p, q) => p - q);
    const [a, b] = [mesh.toVertex(24), mesh.toVertex(25)];
    const triangles = faces.flatMap((f) => [...surface.triangleVertices(f)]);
    mesh.flipEdge(12);
    const change = surface.update();
    expect([...(change?.faces ?? [])].sort((p, q) => p - q)).toEqual(faces);
    expect([...(change?.before ?? [])].sort()).toEqual(triangles.sort());
    expect(change?.after).toHaveLength(6);
    const ends = [mesh.toVertex(24), mesh.toVertex(25)];
    expect(change?.edges).toEqual([{ edge: 12, before: [a, b], after: ends }]);
    expect(change?.vertices.size).toBe(0);
    const nothing = surface.update();
    expect([nothing?.faces.size, nothing?.edges, nothing?.vertices.size]).toEqual([0, [], 0]);
  });

  test('tells vertices that come and go, and where they were', () => {
    const mesh = HalfedgeMesh.icoSphere(1);
    mesh.history.enabled = true;
    const surface = new Surface(mesh);
    const v = mesh.splitEdge(7);
    const split = surface.update();
    expect([...(split?.vertices ?? [])]).toEqual([[v, { place: [0, 0, 0], isLive: false }]]);
    expect([split?.faces.size, split?.before.length, split?.after.length]).toEqual([4, 6, 12]);
    expect(surface.isLive(v)).toBe(true);
    const place = [...surface.points.slice(3 * v, 3 * v + 3)];
    mesh.history.undo();
    const undone = surface.update();
    expect([...(undone?.vertices ?? [])]).toEqual([[v, { place, isLive: true }]]);
    expect([undone?.faces.size, undone?.before.length, undone?.after.length]).toEqual([4, 12, 6]);
    expect(surface.isLive(v)).toBe(false);
    mesh.dispose();
  });

  test('does not tell one by one what is another mesh altogether', () => {
    const mesh = HalfedgeMesh.grid(60, 60, { triangles: true });
    const surface = new Surface(mesh);
    for (let v = 0; v < mesh.vertexSlots; v++) mesh.positions[3 * v + 2] = 0.01 * (v % 7);
    expect(surface.update()).toBeNull();
    const fresh = new Surface(mesh);
    expect(surface.triangles.inOrder(mesh)).toEqual(fresh.triangles.inOrder(mesh));
    mesh.dispose();
  });

  test('tells a face whose corner moved', () => {
    const mesh = HalfedgeMesh.cube();
    const surface = new Surface(mesh);
    mesh.positions[0] *= 1.25;
    const change = surface.update();
    expect([...(change?.faces ?? [])].sort()).toEqual([...mesh.vertexFaces(0)].sort());
    expect([...(change?.vertices.keys() ?? [])]).toEqual([0]);
    expect(change?.edges).toEqual([]);
  });

  test('stays in its place in the scene', () => {
    const mesh = HalfedgeMesh.cube();
    const surface = new Surface(mesh);
    const placement = [...surface.placement.elements];
    const points = surface.points.slice(3);
    mesh.positions[0] *= 5;
    surface.update();
    expect(surface.placement.elements).toEqual(placement);
    expect(surface.points.slice(3)).toEqual(points);
  });

  test('is hit by rays where a tree built afresh is hit, edit after edit', () => {
    const mesh = HalfedgeMesh.icoSphere(2);
    const surface = new Surface(mesh);
    let edits = 0;
    const edit = (refusal: object | null, operation: () => void) => {
      if (refusal) return;
      operation();
      surface.update();
      edits += 1;
    };
    for (let e = 0; e < mesh.edgeSlots; e += 7) {
      edit(mesh.checkFlipEdge(e), () => mesh.flipEdge(e));
    }
    for (let f = 0; f < mesh.faceSlots; f += 11) {
      edit(mesh.checkMakeHole(f), () => mesh.makeHole(f));
    }
    expect(edits).toBeGreaterThan(60);
    const fresh = new FaceTree(surface);
    let hits = 0;
    for (const ray of rays(2000)) {
      const [found, expected] = [surface.tree.cast(ray), fresh.cast(ray)];
      expect(found?.face).toBe(expected?.face);
      if (expected) hits += 1;
    }
    expect(hits).toBeGreaterThan(500);
  });
});

test('the tree over many triangles grows when the picture is drawn, of the mesh as it is then', async () => {
  const mesh = HalfedgeMesh.grid(180, 180, { triangles: true });
  const sent: { vertices: Uint32Array }[] = [];
  const worker = {
    postMessage: (seed: { vertices: Uint32Array }) => sent.push(seed),
    addEventListener: () => {},
    terminate: () => {},
  };
  let draw = () => {};
  const begin = () => new Promise<void>((resolve) => (draw = resolve));
  const surface = new Surface(mesh, { worker: () => worker as never, begin });
  mesh.deleteFace(7);
  surface.update();
  await Promise.resolve();
  expect(sent).toEqual([]);
  draw();
  await Promise.resolve();
  expect(sent).toHaveLength(1);
  // A face that is gone has no area in it.
  expect([...sent[0].vertices.subarray(21, 24)]).toEqual([0, 0, 0]);
  expect(new Set(sent[0].vertices.subarray(24, 27)).size).toBe(3);
  expect(surface.tree.isGrown).toBe(false);
  surface.tree.dispose();
  mesh.dispose();
});

describe('the motion of an edit', () => {
  const item: Item = { kind: 'face', index: 4 };
  const operation: Operation = {
    stem: 'splitFace',
    on: 'face',
    label: '',
    meaning: '',
    key: '',
    grows: true,
  };

  test('lets new vertices come out of the nearest corner, and slide back when it is undone', () => {
    const mesh = generate.openGrid(3);
    const corners = [...mesh.faceVertices(4)];
    const state = stateBefore(operation, { mesh, item, second: null });
    const v = mesh.splitFace(4, mesh.positions.slice(3 * corners[2], 3 * corners[2] + 3));
    const edit = motionOf(operation, state, mesh);
    expect([...edit.grows]).toEqual([[v, corners[2]]]);
    expect(edit.slides.size).toBe(0);
    expect([...reversed(edit).slides]).toEqual([[v, corners[2]]]);
  });

  test('is none where the operation names none', () => {
    const mesh = generate.openGrid(3);
    const still = { ...operation, grows: false };
    const state = stateBefore(still, { mesh, item, second: null });
    mesh.splitFace(4);
    expect(motionOf(still, state, mesh)).toEqual({
      slides: new Map(),
      grows: new Map(),
      renumbers: false,
    });
  });
});

describe('the operations that the page offers', () => {
  test('are all in the package', () => {
    const methods = new HalfedgeMesh() as unknown as Record<string, unknown>;
    const missing = operations.filter(({ stem }) => typeof methods[stem] !== 'function');
    expect(missing.map(({ stem }) => stem)).toEqual([]);
  });

  test('have a check, and a key of their own', () => {
    const mesh = HalfedgeMesh.cube();
    const methods = mesh as unknown as Record<string, unknown>;
    for (const kind of ['vertex', 'edge', 'halfedge', 'face'] as const) {
      const offered = operationsFor({ kind, index: 0 });
      expect(offered.filter(({ on }) => on === kind).length).toBeGreaterThanOrEqual(2);
      const keys = offered.flatMap(({ key }) => key ?? []);
      expect(new Set(keys).size).toBe(keys.length);
      const unchecked = offered
        .filter(({ on, stem }) => on !== 'mesh' && !stem.endsWith('Component'))
        .map(({ stem }) => `check${stem[0].toUpperCase()}${stem.slice(1)}`)
        .filter((check) => typeof methods[check] !== 'function');
      expect(unchecked).toEqual([]);
    }
  });
});

test('a digest tells meshes apart by their faces and by their positions', () => {
  const mesh = HalfedgeMesh.icoSphere(1);
  const before = digestOf(mesh);
  expect(digestOf(HalfedgeMesh.icoSphere(1))).toBe(before);
  mesh.flipEdge(3);
  const flipped = digestOf(mesh);
  expect(flipped).not.toBe(before);
  mesh.positions[4] += 1e-6;
  expect(digestOf(mesh)).not.toBe(flipped);
});

describe('the paths of operations with two halfedges', () => {
  const operation = (stem: string) => {
    const found = operations.find((candidate) => candidate.stem === stem);
    if (!found) throw new Error(`There is no operation ${stem}.`);
    return found;
  };
  const half = (index: number): Item => ({ kind: 'halfedge', index });

  test('cut the surface open from one to another, and glue it again as far as it goes', () => {
    const mesh = HalfedgeMesh.grid(6, 6);
    const [a, b] = [mesh.findHalfedge(15, 16), mesh.findHalfedge(18, 19)];
    const cut = operation('cutPath');
    const operands = { mesh, item: half(a), second: half(b) };
    expect(cut.arguments?.(operands)).toEqual([
      [a, mesh.findHalfedge(16, 17), mesh.findHalfedge(17, 18), b],
    ]);
    const edges = mesh.edgeCount;
    const copy = runOperation(cut, operands) as number;
    expect(mesh.validate(4)).toEqual([]);
    expect(mesh.edgeCount).toBe(edges + 4);
    expect(mesh.boundaryLoops()).toHaveLength(2);
    const back = { mesh, item: half(mesh.opposite(b)), second: half(copy) };
    expect(operation('gluePath').arguments?.(back)).toEqual([mesh.opposite(b), copy, 4]);
    runOperation(operation('gluePath'), back);
    expect(mesh.edgeCount).toBe(edges);
    expect(mesh.boundaryLoops()).toHaveLength(1);
    expect(mesh.validate(4)).toEqual([]);
  });

  test('split a torus along a cycle through both, and leave a sphere', () => {
    const mesh = HalfedgeMesh.torus(8, 6);
    const h = mesh.faceHalfedge(0);
    // Straight on over the vertices of valence 4: once around the tube, or along it.
    const along = [h];
    const onward = (g: number) => mesh.next(mesh.opposite(mesh.next(g)));
    while (onward(along[along.length - 1]) !== h) along.push(onward(along[along.length - 1]));
    const middle = along[along.length >> 1];
    const operands = { mesh, item: half(h), second: half(middle) };
    expect(operation('splitLoop').arguments?.(operands)).toEqual([along]);
    runOperation(operation('splitLoop'), operands);
    expect(mesh.validate(4)).toEqual([]);
    expect(mesh.genus()).toBe(0);
    expect(mesh.isClosed()).toBe(true);
  });

  test('are refused in a sentence where nothing joins the two', () => {
    const mesh = HalfedgeMesh.cube();
    mesh.append(HalfedgeMesh.cube());
    const far = mesh.halfedgeSlots - 1;
    for (const stem of ['cutPath', 'splitLoop']) {
      const refusal = checkOperation(operation(stem), { mesh, item: half(0), second: half(far) });
      expect(refusal?.code).toMatch(/^not-a-(path|cycle)$/);
      expect(refusal?.message).toMatch(/\.$/);
    }
  });

  test('are refused before the second where none would do', () => {
    const mesh = HalfedgeMesh.grid(2, 2);
    const [boundary] = mesh.boundaryLoops();
    for (const stem of ['glue', 'gluePath']) {
      const check = (h: number) =>
        checkOperation(operation(stem), { mesh, item: half(h), second: null });
      expect(check(boundary)).toBeNull();
      const refusal = check(mesh.opposite(boundary));
      expect(refusal?.code).toBe('not-a-boundary-halfedge');
      expect(refusal?.witness.halfedges).toEqual([mesh.opposite(boundary)]);
    }
  });
});
