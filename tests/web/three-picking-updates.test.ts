// What a picker hits after its mesh has changed: face by face, all at once, and while its tree grows.

import { Worker } from 'node:worker_threads';
import { HalfedgeMesh, init } from 'halfedge';
import { MeshGeometry } from 'halfedge/three';
import { FaceTree, type FaceTreeOptions, MeshPicker } from 'halfedge/three/picking';
import * as THREE from 'three';
import { grownOver, type TreeSeed } from '../../dist/three/triangle-tree.js';
import { above, hitByThree, randomRay, SIZE } from './support/picking.js';
import { random } from './support/random.js';
import { randomEdit, refusalOf } from './support/random-edits.js';

beforeAll(() => init());

/**
 * A tree over a mesh as `shown`, which counts how often all triangles are asked for. `move` puts it below the
 * plane z = 0, and `hit` tells how far from z = 5 a ray hits it.
 */
function moving(mesh: HalfedgeMesh, options: FaceTreeOptions = {}) {
  const { indices, faces } = mesh.toTriangles();
  const shown = {
    asked: 0,
    points: mesh.positions.slice(),
    allTriangles() {
      shown.asked += 1;
      return { points: shown.points.slice(), vertices: indices.slice(), faces: faces.slice() };
    },
    triangleVertices: (face: number) => indices.slice(3 * face, 3 * face + 3),
  };
  const tree = new FaceTree(shown, options);
  const all = mesh.faces().toArray();
  const move = (depth: number, changed: Iterable<number> = all) => {
    for (let i = 2; i < shown.points.length; i += 3) shown.points[i] = -depth;
    tree.update(changed, shown);
  };
  const down = new THREE.Ray(new THREE.Vector3(0.01, 0.02, 5), new THREE.Vector3(0, 0, -1));
  return { tree, shown, move, hit: () => Math.round(tree.cast(down)?.distance as number) };
}

/** Does in its own time what the thread does. */
class FakeWorker {
  isTerminated = false;
  #seed: TreeSeed | undefined;
  #listener: (event: { data: unknown }) => void = () => {};

  addEventListener(type: string, listener: (event: { data: unknown }) => void): void {
    if (type === 'message') this.#listener = listener;
  }
  postMessage(seed: TreeSeed): void {
    this.#seed = seed;
  }
  answer(data: unknown = structuredClone(grownOver(this.#seed as TreeSeed).grown)): void {
    this.#listener({ data });
  }
  terminate(): void {
    this.isTerminated = true;
  }
}

describe('After edits, MeshPicker', () => {
  test.each([1, 2])('hits what three.js hits: seed %i', (seed) => {
    const next = random(seed);
    const mesh = HalfedgeMesh.icoSphere(3);
    mesh.history.enabled = true;
    const object = new THREE.Mesh(new MeshGeometry(mesh, seed % 2 ? {} : { normals: 'flat' }));
    const picker = new MeshPicker(object);
    const done: string[] = [];
    for (let i = 0; i < 40; i++) {
      const way = next();
      if (way < 0.1) done.push(`undo ${mesh.history.undo()}`);
      else if (way < 0.15) mesh.compact();
      else if (way < 0.3 && mesh.vertexCount > 0) {
        const [v] = mesh.vertices();
        for (let k = 0; k < 3; k++) mesh.positions[3 * v + k] *= 1.1;
      } else {
        const edit = randomEdit(mesh, next);
        refusalOf(edit);
        done.push(edit.name);
      }
      object.geometry.update();
      for (let r = 0; r < 4; r++) {
        const ray = randomRay(next);
        const [hit, expected] = [picker.cast(ray), hitByThree(object, ray)];
        const what = `seed ${seed}, step ${i}: ${done.slice(-3).join('; ')}`;
        // Where two faces lie upon each other, either will do.
        expect([what, hit?.distance]).toEqual([
          what,
          expected && expect.closeTo(expected.distance, 4),
        ]);
        if (hit) expect(mesh.connectivity.faceHalfedge[hit.face]).toBeGreaterThanOrEqual(0);
      }
    }
    picker.dispose();
    mesh.dispose();
  });

  test.each([1, 2, 3])('hits what three.js hits where most faces move: seed %i', (seed) => {
    const next = random(seed);
    const mesh = HalfedgeMesh.icoSphere(4); // of more faces than are kept beside the tree
    mesh.history.enabled = true;
    const object = new THREE.Mesh(new MeshGeometry(mesh, seed % 2 ? {} : { normals: 'flat' }));
    const picker = new MeshPicker(object);
    let hits = 0;
    for (let i = 0; i < 30; i++) {
      const way = next();
      if (way < 0.7) {
        const { positions } = mesh;
        for (let k = 0; k < positions.length; k++) positions[k] += 0.02 * (next() - 0.5);
      } else if (way < 0.8) {
        const flips = mesh.edges().toArray();
        for (const e of flips) if (next() < 0.5 && !mesh.checkFlipEdge(e)) mesh.flipEdge(e);
      } else if (way < 0.9) refusalOf(randomEdit(mesh, next));
      else mesh.history.undo();
      object.geometry.update();
      if (next() < 0.5) continue;
      for (let r = 0; r < 10; r++) {
        const ray = randomRay(next);
        const [hit, expected] = [picker.cast(ray), hitByThree(object, ray)];
        expect([seed, i, hit?.distance]).toEqual([
          seed,
          i,
          expected && expect.closeTo(expected.distance, 4),
        ]);
        if (hit) hits += 1;
      }
    }
    expect(hits).toBeGreaterThan(20);
    picker.dispose();
    mesh.dispose();
  });

  test('waits for a ray where most faces move, and then takes them up once', () => {
    const { tree, shown, move, hit } = moving(HalfedgeMesh.grid(60, 60, { triangles: true }));
    expect(shown.asked).toBe(1);
    for (let i = 1; i <= 10; i++) move(i);
    expect(shown.asked).toBe(1);
    expect([hit(), hit()]).toEqual([5 + 10, 5 + 10]);
    expect(shown.asked).toBe(2);
    move(20);
    move(30, [0]); // while the others are not taken up yet
    expect(hit()).toBe(5 + 30);
    move(40);
    tree.update(null, shown);
    expect(hit()).toBe(5 + 40);
    expect(shown.asked).toBe(4);
  });
});

describe('Of many faces, MeshPicker', () => {
  const ROWS = 180; // of more triangles than are taken up at once

  function many(worker: () => never, others: { begin?: () => Promise<void> } = {}) {
    const mesh = HalfedgeMesh.grid(ROWS, ROWS, { width: 2, height: 2, triangles: true });
    const object = new THREE.Mesh(new MeshGeometry(mesh, { normals: 'none' }));
    const picker = new MeshPicker(object, { worker, ...others });
    const view = above(0, 2);
    /** In one half of a square of the grid, in pixels. */
    const faceAt = (column: number, row: number) =>
      picker.pick((SIZE * (column + 0.6)) / ROWS, SIZE * (1 - (row + 0.3) / ROWS), view, {
        mode: 'face',
      })?.index;
    return { mesh, object, picker, faceAt };
  }

  test('finds the one that is there, before and after an edit', () => {
    const { mesh, object, picker, faceAt } = many(() => null as never);
    const face = faceAt(100, 90) as number;
    expect(face >> 1).toBe(90 * ROWS + 100);
    mesh.makeHole(face);
    object.geometry.update();
    expect(faceAt(100, 90)).toBe(undefined);
    expect((faceAt(101, 90) as number) >> 1).toBe(90 * ROWS + 101);
    picker.dispose();
    mesh.dispose();
  });

  test('works before a worker has grown the tree, and takes up edits made meanwhile', async () => {
    const thread = new FakeWorker();
    const { mesh, object, picker, faceAt } = many(() => thread as never);
    mesh.history.enabled = true;
    const face = faceAt(100, 90) as number;
    expect(face >> 1).toBe(90 * ROWS + 100);
    mesh.makeHole(face);
    object.geometry.update();
    expect(faceAt(100, 90)).toBe(undefined);
    expect(thread.isTerminated).toBe(false);
    thread.answer();
    await picker.ready;
    expect(thread.isTerminated).toBe(true);
    expect(faceAt(100, 90)).toBe(undefined);
    expect((faceAt(101, 90) as number) >> 1).toBe(90 * ROWS + 101);
    mesh.history.undo();
    object.geometry.update();
    expect(faceAt(100, 90)).toBe(face);
    picker.dispose();
    mesh.dispose();
  });

  describe('when all of them change at once,', () => {
    function changing() {
      const threads: FakeWorker[] = [];
      const { mesh, object, picker } = many(() => {
        threads.push(new FakeWorker());
        return threads.at(-1) as never;
      });
      const next = random(7);
      const hitsWhatThreeHits = (what: string) => {
        for (let r = 0; r < 4; r++) {
          const origin = new THREE.Vector3(next() - 0.5, next() - 0.5, 4);
          const to = new THREE.Vector3(next() - 0.5, (next() - 0.5) / 20, 0);
          const ray = new THREE.Ray(origin, to.sub(origin).normalize());
          const [hit, expected] = [picker.cast(ray), hitByThree(object, ray)];
          const distance = expected && expect.closeTo(expected.distance, 4);
          expect([what, hit?.distance, hit?.face]).toEqual([what, distance, expected?.face]);
        }
      };
      const move = (to: (x: number, y: number) => [number, number, number]) => {
        const { positions } = mesh;
        for (let i = 0; i < positions.length; i += 3) {
          positions.set(to(positions[i], positions[i + 1]), i);
        }
        object.geometry.update();
      };
      const grow = () => {
        threads.at(-1)?.answer();
        return picker.ready;
      };
      const end = () => {
        picker.dispose();
        mesh.dispose();
      };
      return { mesh, object, threads, hitsWhatThreeHits, move, grow, end };
    }

    test('keeps the tree of those that only move, while it grows and after', async () => {
      const { threads, hitsWhatThreeHits, move, grow, end } = changing();
      move((x, y) => [x, y, Math.sin(7 * x)]);
      hitsWhatThreeHits('a wave, before the tree has grown');
      await grow(); // over the plane that it was
      hitsWhatThreeHits('the wave');
      move((x, y) => [-y, x, Math.cos(5 * y)]);
      hitsWhatThreeHits('a wave across');
      move((x, y) => [x + 5, y, 0]);
      hitsWhatThreeHits('out of reach');
      move((x, y) => [x - 5, y, 2 + x * y]);
      hitsWhatThreeHits('a saddle');
      expect(threads.length).toBe(1);
      end();
    });

    test('grows another tree over other triangles', async () => {
      const { mesh, object, threads, hitsWhatThreeHits, move, grow, end } = changing();
      await grow();
      for (let f = 0; f < 8000; f += 2) {
        for (const e of [...mesh.faceEdges(f)]) {
          const [one, other] = mesh.edgeFaces(e);
          if (one + other === f + (f + 1)) mesh.flipEdge(e); // between the two of a square
        }
      }
      object.geometry.update();
      hitsWhatThreeHits('as many others');
      expect(threads.length).toBe(2);
      await grow();
      mesh.deleteFace(77);
      object.geometry.update();
      move((x, y) => [x, y, Math.sin(7 * x)]);
      hitsWhatThreeHits('a wave with a hole');
      expect(threads.length).toBe(3);
      await grow();
      mesh.compact(); // to the same triangles, of faces with other numbers
      object.geometry.update();
      hitsWhatThreeHits('the same of other faces');
      expect(threads.length).toBe(4);
      end();
    });

    test('forgets those beside the tree', async () => {
      const { mesh, object, threads, hitsWhatThreeHits, move, grow, end } = changing();
      await grow();
      const middle = mesh.faceCount / 2;
      const pokes = [...mesh.faces()].slice(middle - 1000, middle + 1000);
      while (pokes.length > 0) {
        for (const f of pokes.splice(-1000)) mesh.poke(f);
        object.geometry.update();
      }
      hitsWhatThreeHits('few at a time');
      expect(threads.length).toBe(2); // over which a tree grows now
      move((x, y) => [x, y, Math.sin(7 * x)]);
      hitsWhatThreeHits('a wave');
      await grow();
      hitsWhatThreeHits('a wave with a tree');
      expect(threads.length).toBe(3);
      end();
    });
  });

  test('grows the tree itself where the worker answers something else', async () => {
    const thread = new FakeWorker();
    const { mesh, picker, faceAt } = many(() => thread as never);
    thread.answer(null);
    await picker.ready;
    expect(thread.isTerminated).toBe(true);
    expect((faceAt(100, 90) as number) >> 1).toBe(90 * ROWS + 100);
    picker.dispose();
    mesh.dispose();
  });

  test('follows faces that move while a worker grows the tree, and grows another in time', async () => {
    const threads: FakeWorker[] = [];
    const worker = () => {
      threads.push(new FakeWorker());
      return threads.at(-1) as never;
    };
    const mesh = HalfedgeMesh.grid(ROWS, ROWS, { triangles: true });
    const { tree, move, hit } = moving(mesh, { worker });
    move(1);
    expect(hit()).toBe(6);
    expect(tree.isGrown).toBe(false);
    move(2);
    threads[0].answer();
    await tree.ready;
    expect(tree.isGrown).toBe(true);
    expect(hit()).toBe(7);
    expect(threads.length).toBe(1);
    for (let i = 0; i < 100; i++) {
      move(i);
      expect(hit()).toBe(5 + i);
    }
    expect(threads.length).toBe(2);
    move(3);
    expect(hit()).toBe(8);
    threads[1].answer();
    expect(hit()).toBe(8);
    move(4);
    expect(hit()).toBe(9);
    move(5);
    tree.dispose();
    expect(hit()).toBe(9);
    mesh.dispose();
  });

  test('lets a worker begin when it may', async () => {
    const thread = new FakeWorker();
    let asked = 0;
    const begin = () => {
      asked += 1;
      return Promise.resolve();
    };
    const { mesh, picker } = many(() => thread as never, { begin });
    expect(asked).toBe(1);
    picker.dispose();
    mesh.dispose();
  });

  test('grows the tree itself where what is to come first fails', async () => {
    const thread = new FakeWorker();
    const begin = () => Promise.reject(new Error('No picture.'));
    const { mesh, picker, faceAt } = many(() => thread as never, { begin });
    await picker.ready;
    expect([thread.isTerminated, (faceAt(100, 90) as number) >> 1]).toEqual([
      true,
      90 * ROWS + 100,
    ]);
    picker.dispose();
    mesh.dispose();
  });

  test('has its tree grown by a worker of Node', async () => {
    const script = new URL('../../dist/three/picking-thread.js', import.meta.url);
    let worker: Worker | undefined;
    const { mesh, picker, faceAt } = many(() => {
      worker = new Worker(script);
      return worker as never;
    });
    const ended = new Promise((resolve) => worker?.on('exit', resolve));
    const told = new Promise((resolve) => worker?.on('message', resolve));
    await picker.ready;
    expect(await told).toMatchObject({ roots: expect.anything() });
    await ended;
    expect((faceAt(100, 90) as number) >> 1).toBe(90 * ROWS + 100);
    picker.dispose();
    mesh.dispose();
  });
});
