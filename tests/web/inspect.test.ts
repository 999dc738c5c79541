import { inspect } from 'node:util';
import { DirectedEdgesMesh, HalfedgeMesh, init } from 'halfedge';

beforeAll(() => init());

describe('What Node prints', () => {
  test.each([HalfedgeMesh, DirectedEdgesMesh])('of a mesh: how many items it has', (Mesh) => {
    using mesh = Mesh.fromTriangles([0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 2]);
    expect(inspect(mesh)).toBe(`${Mesh.name} { vertexCount: 3, edgeCount: 3, faceCount: 1 }`);
    expect(inspect({ mesh })).toContain('vertexCount: 3');
    mesh.dispose();
    expect(inspect(mesh)).toBe(`${Mesh.name} { disposed: true }`);
    expect(() => inspect(Mesh.prototype)).not.toThrow();
  });

  test('of the properties of a mesh: none, since they would drag in all of the memory', () => {
    using mesh = HalfedgeMesh.icoSphere(1);
    expect(Object.keys(mesh)).toEqual([]);
    expect(JSON.stringify(mesh)).toBe('{}');
    expect(structuredClone(mesh)).toEqual({});
  });

  test.each([
    ['', HalfedgeMesh],
    ['Directed', DirectedEdgesMesh],
  ])('of laps, items and circulators: what they show (%s)', (prefix, Mesh) => {
    using mesh = Mesh.fromTriangles([0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 2]);
    const lap = mesh.vertexVertices(0);
    expect(inspect(lap)).toMatch(new RegExp(`^${prefix}Orbit \\[ 1, 2 \\]$`));
    expect(inspect(mesh.faces())).toMatch(/Items \[ 0 \]$/);
    const { current, halfedge } = mesh.circulate('vertexVertices', 0);
    expect(inspect(mesh.circulate('vertexVertices', 0))).toBe(
      `${prefix}Circulator { current: ${current}, halfedge: ${halfedge} }`,
    );
    mesh.dispose();
    expect(inspect(lap)).toMatch(/^\w+ \{ This mesh was disposed: .*\. \}$/);
  });

  test('of all items of a large mesh: the first hundred', () => {
    using mesh = HalfedgeMesh.icoSphere(5);
    expect(inspect(mesh.vertices())).toMatch(
      /^LiveItems \[\s+0,[\s\S]*99,\s+\.\.\. 10142 more items\s+\]$/,
    );
  });
});
