import { HalfedgeMesh, init } from 'halfedge';
import { dragonOff } from '../fixtures/dragon.js';

beforeAll(() => init());

test('The full-resolution dragon loads, is valid, and has its 407 boundary loops', () => {
  const { mesh } = HalfedgeMesh.parse(dragonOff());
  expect(mesh.vertexCount).toBe(437_645);
  expect(mesh.faceCount).toBe(871_414);
  expect(mesh.boundaryLoops()).toHaveLength(407);
  expect(mesh.validate().filter(({ severity }) => severity === 'error')).toEqual([]);

  const { offsets, items } = mesh.allVertexVertices();
  expect(items).toHaveLength(mesh.halfedgeCount);
  expect(offsets.at(-1)).toBe(items.length);

  using again = HalfedgeMesh.fromTriangles(mesh.positions, mesh.toTriangles().indices);
  const { next } = mesh.connectivity;
  expect(again.connectivity.next.every((h, i) => h === next[i])).toBe(true);
  mesh.dispose();
});
