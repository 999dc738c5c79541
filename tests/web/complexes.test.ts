import { HalfedgeMesh, init } from 'halfedge';
import { tetrahedron } from './support/meshes.js';

beforeAll(() => init());

const codes = (mesh: HalfedgeMesh, level: number) => mesh.validate(level).map(({ code }) => code);

describe.each([true, false])('With storePrev: %s,', (storePrev) => {
  test('a loop is one edge, one vertex and two faces', () => {
    using mesh = new HalfedgeMesh({ storePrev });
    const h = mesh.makeLoop();
    expect([mesh.vertexCount, mesh.edgeCount, mesh.faceCount]).toEqual([1, 1, 2]);
    expect(mesh.next(h)).toBe(h);
    expect(mesh.prev(h)).toBe(h);
    expect(mesh.toVertex(h)).toBe(mesh.fromVertex(h));
    expect(mesh.face(h)).not.toBe(mesh.face(mesh.opposite(h)));
    expect([...mesh.positions]).toEqual([0, 0, 0]);
    expect(mesh.eulerCharacteristic()).toBe(2);
    for (const level of [0, 1, 2, 3]) expect(codes(mesh, level)).toEqual([]);
    expect(codes(mesh, 4)).toContain('degree-below-three');
  });

  test('a segment is one edge, two vertices and one face', () => {
    using mesh = new HalfedgeMesh({ storePrev });
    const h = mesh.makeSegment();
    expect([mesh.vertexCount, mesh.edgeCount, mesh.faceCount]).toEqual([2, 1, 1]);
    expect(mesh.next(h)).toBe(mesh.opposite(h));
    expect(mesh.prev(h)).toBe(mesh.opposite(h));
    expect(mesh.face(h)).toBe(mesh.face(mesh.opposite(h)));
    expect([...mesh.faceVertices(mesh.face(h))].sort()).toEqual([0, 1]);
    expect(codes(mesh, 3)).toEqual([]);
    expect(codes(mesh, 4)).not.toEqual([]);
  });
});

test('Complexes are added to what is there, and circulators notice', () => {
  const { positions, faces } = tetrahedron();
  using mesh = HalfedgeMesh.fromPolygons(positions, faces);
  const circulator = mesh.circulate('vertexVertices', 0);
  const kept = mesh.connectivity;
  const h = mesh.makeSegment();
  expect(mesh.makeLoop()).toBe(h + 2);
  expect(() => circulator.next()).toThrow(/changed/);
  expect(mesh.connectivity).not.toBe(kept);
  expect([mesh.vertexCount, mesh.edgeCount, mesh.faceCount]).toEqual([7, 8, 7]);
  expect([...mesh.positions.slice(0, 12)]).toEqual(positions);
  expect(mesh.components()).toHaveLength(3);
  expect(codes(mesh, 3)).toEqual([]);
  // The faces beside a loop have one corner, and no triangle.
  using alone = HalfedgeMesh.fromPolygons(positions, faces);
  expect(mesh.toTriangles()).toEqual(alone.toTriangles());
});

test('A disposed mesh takes none', () => {
  const mesh = new HalfedgeMesh();
  mesh.dispose();
  expect(() => mesh.makeLoop()).toThrow(/disposed/);
});
