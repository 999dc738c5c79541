import { inspect } from 'node:util';
import { DirectedEdgesMesh, HalfedgeError, HalfedgeMesh, init } from 'halfedge';
import { HE_mesh, Polyhedron, PolyMesh } from 'halfedge/dialects';
import { CirculatorPlayer, circulators } from 'halfedge/teaching';
import { MeshGeometry } from 'halfedge/three';
import { MeshPicker } from 'halfedge/three/picking';
import { createMeshWorker } from 'halfedge/worker';
import { Mesh as ThreeMesh } from 'three';

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

  test.each([HalfedgeMesh, DirectedEdgesMesh])(
    'is a name that Vue takes for no plain object (%#)',
    (Mesh) => {
      using mesh = Mesh.fromTriangles([0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 2]);
      const nameOf = (it: unknown) => Object.prototype.toString.call(it).slice(8, -1);
      expect(nameOf(mesh)).toBe(Mesh.name);
      for (const it of [mesh.vertexVertices(0), mesh.edgeVertices(0), mesh.faces()])
        expect(nameOf(it)).toMatch(/^\w*(Orbit|Items)$/);
      expect(nameOf(mesh.circulate('vertexVertices', 0))).toMatch(/Circulator$/);
    },
  );

  test('is such a name of all else that has #private', () => {
    using mesh = HalfedgeMesh.cube();
    using worker = createMeshWorker();
    const openMesh = new PolyMesh(mesh);
    const polyhedron = new Polyhedron(mesh);
    const structs = new HE_mesh(mesh);
    const query = { circulator: circulators[0], index: 0, direction: 'ccw' } as const;
    const picker = new MeshPicker(new ThreeMesh(new MeshGeometry(mesh)));
    const objects: unknown[] = [mesh.history, mesh.attributes, mesh.generations, worker, picker];
    objects.push(new CirculatorPlayer(mesh, query), openMesh, polyhedron, structs);
    objects.push(openMesh.vertex_handle(0), openMesh.halfedge_handle(0));
    objects.push(openMesh.edge_handle(0), openMesh.face_handle(0));
    objects.push(polyhedron.halfedge(0), polyhedron.vertex(0), polyhedron.facet(0));
    objects.push(polyhedron.vertex(0).vertex_begin(), polyhedron.facet(0).facet_begin());
    objects.push(structs.edge(0), structs.vert(0), structs.face(0));
    for (const it of objects) {
      expect(Object.prototype.toString.call(it)).toBe(`[object ${Object(it).constructor.name}]`);
    }
    picker.dispose();
  });

  test('of history, attributes, generations and handles: what there is', () => {
    using mesh = HalfedgeMesh.cube();
    expect(inspect(mesh.attributes)).toBe('Attributes []');
    mesh.attributes.add('face', 'group', { type: 'int32' });
    expect(inspect(mesh.attributes)).toMatch(/^Attributes \[\s+{\s+kind: 'face',\s+name: 'group'/);
    mesh.history.enabled = true;
    mesh.splitEdge(0);
    expect(inspect(mesh.history)).toMatch(/^History { enabled: true, undoCount: 1, redoCount: 0, /);
    expect(inspect(mesh.generations)).toBe('Generations { enabled: false }');
    expect(inspect(new PolyMesh(mesh).vertex_handle(3))).toBe('VertexHandle { idx: 3 }');
    const { history } = mesh;
    mesh.dispose();
    expect(inspect(history)).toMatch(/^History { This mesh was disposed/);
  });

  test('of an error with a thousand problems: its sentence, code and witness', () => {
    let error: unknown;
    try {
      HalfedgeMesh.fromTriangles([0, 0, 0], new Uint32Array(30_000));
    } catch (thrown) {
      error = thrown;
    }
    if (!(error instanceof HalfedgeError)) throw error;
    expect(error.problems).toHaveLength(1000);
    const printed = inspect(error);
    expect(printed).toContain(error.message);
    expect(printed).toContain("code: 'repeated-vertex'");
    expect(printed).toContain('witness: { vertices: [ 0 ]');
    expect(printed.split('\n').length).toBeLessThan(40);
    expect(JSON.parse(JSON.stringify(error)).problems).toHaveLength(1000);
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

  test.each([HalfedgeMesh, DirectedEdgesMesh])(
    'is what JSON has of laps, items and circulators',
    (Mesh) => {
      using mesh = Mesh.fromTriangles([0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 2]);
      const around = {
        ring: mesh.vertexVertices(0),
        faces: mesh.faces(),
        ends: mesh.edgeVertices(0),
      };
      const ends = [...mesh.edgeVertices(0)];
      expect(JSON.parse(JSON.stringify(around))).toEqual({ ring: [1, 2], faces: [0], ends });
      const { current, halfedge } = mesh.circulate('vertexVertices', 0);
      expect(JSON.parse(JSON.stringify(mesh.circulate('vertexVertices', 0)))).toEqual({
        current,
        halfedge,
      });
      mesh.dispose();
      expect(() => JSON.stringify(around)).toThrow(/disposed/);
    },
  );

  test('of all items of a large mesh: the first hundred', () => {
    using mesh = HalfedgeMesh.icoSphere(5);
    expect(inspect(mesh.vertices())).toMatch(
      /^LiveItems \[\s+0,[\s\S]*99,\s+\.\.\. 10142 more items\s+\]$/,
    );
  });
});

test('JSON of an error has its sentence', () => {
  using mesh = HalfedgeMesh.tetrahedron();
  const refusal = mesh.checkCollapse(0);
  const thrown: unknown[] = [];
  try {
    mesh.collapse(0);
  } catch (error) {
    thrown.push(error);
  }
  expect(JSON.parse(JSON.stringify(thrown))).toEqual([
    { name: 'HalfedgeError', ...refusal, problems: [] },
  ]);
  expect(Object.keys(thrown[0] as object)).toEqual(['code', 'witness']);
});
