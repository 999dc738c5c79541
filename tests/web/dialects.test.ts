import { DirectedEdgesMesh, HalfedgeMesh, init } from 'halfedge';
import { HE_mesh, Polyhedron, PolyMesh, VertexHandle } from 'halfedge/dialects';
import {
  annulus,
  bowTie,
  build,
  pillow,
  quadGrid,
  randomPolygons,
  tetrahedron,
  torus,
  triangleAndIsolatedVertex,
} from './support/meshes.js';

beforeAll(() => init());

const shapes = {
  quadGrid,
  torus,
  tetrahedron,
  annulus,
  bowTie,
  pillow,
  triangleAndIsolatedVertex,
  'random polygons 1': () => randomPolygons(1),
  'random polygons 2': () => randomPolygons(2),
};
const cases = Object.entries(shapes);

test('Dialects of what is no mesh are refused', () => {
  for (const Dialect of [PolyMesh, Polyhedron, HE_mesh]) {
    expect(() => new Dialect({} as never)).toThrow(/^mesh is an Object; expected a HalfedgeMesh/);
    expect(() => new Dialect(undefined as never)).toThrow(TypeError);
  }
});

test("OpenMesh's names, which can set links, are refused of Directed Edges, which lack some", () => {
  using mesh = build(tetrahedron());
  using triangles = DirectedEdgesMesh.fromMesh(mesh);
  expect(() => new PolyMesh(triangles as never)).toThrow(
    new TypeError('mesh is a DirectedEdgesMesh; expected a HalfedgeMesh.'),
  );
});

const idx = (handles: { idx(): number }[]) => handles.map((handle) => handle.idx());

describe("OpenMesh's names", () => {
  // The orders that OpenMesh 9 gives for the example of the specification.
  test('list in its default directions', () => {
    using mesh = build(quadGrid());
    const om = new PolyMesh(mesh);
    const ends = (handles: ReturnType<typeof om.voh_range>) =>
      handles.map((h) => `${om.from_vertex_handle(h).idx()}>${om.to_vertex_handle(h).idx()}`);
    const [v1, v5] = [om.vertex_handle(1), om.vertex_handle(5)];
    expect(ends(om.voh_range(v5))).toEqual(['5>6', '5>1', '5>4', '5>9']);
    expect(ends(om.voh_range(v1))).toEqual(['1>0', '1>5', '1>2']);
    expect(ends(om.voh_ccw_range(v1))).toEqual(['1>2', '1>5', '1>0']);
    expect(ends(om.vih_range(v1))).toEqual(['0>1', '5>1', '2>1']);
    expect(idx(om.vv_range(v1))).toEqual([0, 5, 2]);
    expect(idx(om.vv_ccw_range(v1))).toEqual([2, 5, 0]);
    expect(idx(om.vf_range(v1))).toEqual([0, 1]);
    expect(idx(om.fv_range(om.face_handle(0)))).toEqual([0, 1, 5, 4]);
    expect(idx(om.ff_range(om.face_handle(4)))).toEqual([3, 1, 5, 7]);
  });

  test.each(cases)('tell the same of %s as ours', (_, shape) => {
    using mesh = build(shape());
    const om = new PolyMesh(mesh);
    expect(om.n_vertices()).toBe(mesh.vertexCount);
    expect(om.n_edges()).toBe(mesh.edgeCount);
    expect(om.n_halfedges()).toBe(mesh.halfedgeCount);
    expect(om.n_faces()).toBe(mesh.faceCount);
    for (const v of om.vertices()) {
      const i = v.idx();
      expect(idx(om.vv_cw_range(v))).toEqual([...mesh.vertexVertices(i, 'cw')]);
      expect(idx(om.voh_cw_range(v))).toEqual([...mesh.vertexOutgoingHalfedges(i, 'cw')]);
      expect(idx(om.vih_cw_range(v))).toEqual([...mesh.vertexIncomingHalfedges(i, 'cw')]);
      expect(idx(om.vih_ccw_range(v))).toEqual([...mesh.vertexIncomingHalfedges(i, 'ccw')]);
      expect(idx(om.ve_range(v))).toEqual([...mesh.vertexEdges(i, 'cw')]);
      expect(idx(om.ve_cw_range(v))).toEqual([...mesh.vertexEdges(i, 'cw')]);
      expect(idx(om.ve_ccw_range(v))).toEqual([...mesh.vertexEdges(i, 'ccw')]);
      expect(idx(om.vf_cw_range(v))).toEqual([...mesh.vertexFaces(i, 'cw')]);
      expect(idx(om.vf_ccw_range(v))).toEqual([...mesh.vertexFaces(i, 'ccw')]);
      expect(om.is_boundary(v)).toBe(mesh.isBoundaryVertex(i));
      expect(om.is_isolated(v)).toBe(mesh.isIsolatedVertex(i));
      expect(om.is_manifold(v)).toBe(mesh.isManifoldVertex(i));
      expect(om.valence(v)).toBe(mesh.valence(i));
      expect(om.halfedge_handle(v).idx()).toBe(mesh.vertexHalfedge(i));
      expect(om.halfedge_handle(v).is_valid()).toBe(!mesh.isIsolatedVertex(i));
    }
    for (const h of om.halfedges()) {
      const i = h.idx();
      expect(om.next_halfedge_handle(h).idx()).toBe(mesh.next(i));
      expect(om.prev_halfedge_handle(h).idx()).toBe(mesh.prev(i));
      expect(om.opposite_halfedge_handle(h).idx()).toBe(mesh.opposite(i));
      expect(om.face_handle(h).idx()).toBe(mesh.face(i));
      expect(om.opposite_face_handle(h).idx()).toBe(mesh.face(mesh.opposite(i)));
      expect(om.edge_handle(h).idx()).toBe(mesh.edge(i));
      expect(om.cw_rotated_halfedge_handle(h).idx()).toBe(mesh.rotateCw(i));
      expect(om.ccw_rotated_halfedge_handle(h).idx()).toBe(mesh.rotateCcw(i));
      expect(om.is_boundary(h)).toBe(mesh.isBoundaryHalfedge(i));
      expect(om.is_boundary(om.edge_handle(h))).toBe(mesh.isBoundaryEdge(mesh.edge(i)));
      expect(om.halfedge_handle(om.edge_handle(h), (i & 1) as 0 | 1)).toBe(h);
      expect(om.find_halfedge(om.from_vertex_handle(h), om.to_vertex_handle(h))).toBe(h);
      for (const [direction, leaving, arriving] of [
        ['cw', om.voh_cw_range(h), om.vih_cw_range(h)],
        ['ccw', om.voh_ccw_range(h), om.vih_ccw_range(h)],
      ] as const) {
        const [from, to] = [mesh.fromVertex(i), mesh.toVertex(i)];
        expect(idx(leaving)).toEqual([...mesh.vertexOutgoingHalfedges(from, direction, i)]);
        expect(idx(arriving)).toEqual([...mesh.vertexIncomingHalfedges(to, direction, i ^ 1)]);
      }
      expect(idx(om.voh_range(h))).toEqual(idx(om.voh_cw_range(h)));
      expect(idx(om.vih_range(h))).toEqual(idx(om.vih_cw_range(h)));
      expect(idx(om.hl_range(h))).toEqual([...mesh.halfedgeLoop(i, 'ccw')]);
      expect(idx(om.hl_ccw_range(h))).toEqual([...mesh.halfedgeLoop(i, 'ccw')]);
      expect(idx(om.hl_cw_range(h))).toEqual([...mesh.halfedgeLoop(i, 'cw')]);
    }
    for (const f of om.faces()) {
      const i = f.idx();
      expect(idx(om.fv_ccw_range(f))).toEqual([...mesh.faceVertices(i, 'ccw')]);
      expect(idx(om.fv_cw_range(f))).toEqual([...mesh.faceVertices(i, 'cw')]);
      expect(idx(om.fh_range(f))).toEqual([...mesh.faceHalfedges(i, 'ccw')]);
      expect(idx(om.fh_ccw_range(f))).toEqual([...mesh.faceHalfedges(i, 'ccw')]);
      expect(idx(om.fh_cw_range(f))).toEqual([...mesh.faceHalfedges(i, 'cw')]);
      expect(idx(om.fe_range(f))).toEqual([...mesh.faceEdges(i, 'ccw')]);
      expect(idx(om.fe_ccw_range(f))).toEqual([...mesh.faceEdges(i, 'ccw')]);
      expect(idx(om.fe_cw_range(f))).toEqual([...mesh.faceEdges(i, 'cw')]);
      expect(idx(om.ff_ccw_range(f))).toEqual([...mesh.faceFaces(i, 'ccw')]);
      expect(idx(om.ff_cw_range(f))).toEqual([...mesh.faceFaces(i, 'cw')]);
      expect(om.is_boundary(f)).toBe(mesh.isBoundaryFace(i));
      const corners = [...mesh.faceVertices(i)];
      const touches = corners.some((v) => mesh.isBoundaryVertex(v));
      expect(om.is_boundary(f, true)).toBe(touches || mesh.isBoundaryFace(i));
      expect(om.valence(f)).toBe(mesh.degree(i));
      expect(om.halfedge_handle(f).idx()).toBe(mesh.faceHalfedge(i));
    }
  });

  test('move a face by low-level functions, and then adjust outgoing halfedges', () => {
    using mesh = build(torus(4, 3));
    // No gap to move it to: so first one is made.
    const { sizes, corners } = mesh.toPolygons();
    using open = HalfedgeMesh.fromPolygons(mesh.positions, {
      sizes: sizes.slice(1),
      corners: corners.slice(sizes[0]),
    });
    const om = new PolyMesh(open);
    const f = om.face_handle(6);
    const gap = om.hl_range(om.halfedge_handle(open.boundaryLoops()[0] as number));
    const left = om.fh_range(f);
    for (const h of left) om.set_boundary(h);
    for (const h of gap) om.set_face_handle(h, f);
    om.set_halfedge_handle(f, gap[0] as (typeof gap)[0]);
    const behind = left.map((h) => om.to_vertex_handle(h));
    expect(behind.every((v) => om.is_boundary(v))).toBe(false);
    expect(open.validate().map(({ code }) => code)).toContain('interior-anchor');
    for (const v of om.vertices()) om.adjust_outgoing_halfedge(v);
    expect(behind.every((v) => om.is_boundary(v))).toBe(true);
    expect(open.validate()).toEqual([]);
    expect(idx(om.fv_range(f))).toEqual(gap.map((h) => om.to_vertex_handle(h).idx()));
  });

  // OpenMesh's second parameter, which asks the corners too.
  test('find a face that only touches the boundary with a corner', () => {
    using mesh = build(quadGrid());
    mesh.triangulate();
    const om = new PolyMesh(mesh);
    const touching = om.faces().filter((f) => om.is_boundary(f, true) && !om.is_boundary(f));
    expect(touching.length).toBeGreaterThan(0);
    for (const f of touching) {
      expect(om.is_boundary(f, false)).toBe(false);
      expect(om.fv_range(f).some((v) => om.is_boundary(v))).toBe(true);
      expect(om.ff_range(f)).toHaveLength(om.valence(f));
    }
  });

  test('set links and points, and refuse items that are not there', () => {
    using mesh = build(tetrahedron());
    const om = new PolyMesh(mesh);
    const [a, b] = [om.halfedge_handle(0), om.halfedge_handle(2)];
    om.set_next_halfedge_handle(a, b);
    expect([mesh.next(0), mesh.prev(2)]).toEqual([2, 0]);
    om.set_vertex_handle(a, om.vertex_handle(3));
    expect(mesh.toVertex(0)).toBe(3);
    om.set_isolated(om.vertex_handle(1));
    expect([om.is_isolated(om.vertex_handle(1)), mesh.vertexHalfedge(1)]).toEqual([true, -1]);
    expect(() => om.set_isolated(PolyMesh.InvalidVertexHandle)).toThrow(RangeError);
    om.set_point(om.vertex_handle(2), [7, 8, 9]);
    expect(om.point(om.vertex_handle(2))).toEqual([7, 8, 9]);
    expect(() => om.vertex_handle(4)).toThrow(RangeError);
    expect(() => om.halfedge_handle(12)).toThrow(RangeError);
    expect(() => om.edge_handle(6)).toThrow(RangeError);
    expect(() => om.face_handle(-1)).toThrow(RangeError);
    expect(() => om.set_boundary(PolyMesh.InvalidHalfedgeHandle)).toThrow(RangeError);
    expect(() => om.set_face_handle(a, PolyMesh.InvalidFaceHandle)).toThrow(RangeError);
    expect(() => om.point(PolyMesh.InvalidVertexHandle)).toThrow(RangeError);
    expect(() => om.is_boundary(PolyMesh.InvalidEdgeHandle)).toThrow(RangeError);
    expect(PolyMesh.InvalidVertexHandle.is_valid()).toBe(false);
    expect(new VertexHandle().idx()).toBe(-1); // as in OpenMesh
  });

  test('move points in steps that can be undone', () => {
    using mesh = build(tetrahedron());
    mesh.history.enabled = true;
    const om = new PolyMesh(mesh);
    const v = om.vertex_handle(2);
    const before = om.point(v);
    om.set_point(v, [7, 8, 9]);
    expect(mesh.history.undo()).toBe(true);
    expect(om.point(v)).toEqual(before);
  });

  test('refuse what is no handle of the kind, and no point, in a sentence', () => {
    using mesh = build(tetrahedron());
    const om = new PolyMesh(mesh);
    const [v, h] = [om.vertex_handle(0), om.halfedge_handle(0)];
    const [e, f] = [om.edge_handle(0), om.face_handle(0)];
    const refused = (call: () => unknown, message: string) =>
      expect(call).toThrow(new TypeError(message));
    refused(() => om.vv_range(0 as never), 'v is 0; expected a VertexHandle.');
    refused(() => om.vv_range(f as never), 'v is a FaceHandle; expected a VertexHandle.');
    const reference = { kind: 'vertex', index: 0, generation: 0 };
    refused(() => om.vv_range(reference as never), 'v is an Object; expected a VertexHandle.');
    refused(() => om.fv_range(v as never), 'f is a VertexHandle; expected a FaceHandle.');
    refused(() => om.voh_range(f as never), 'h is a FaceHandle; expected a HalfedgeHandle.');
    refused(
      () => om.next_halfedge_handle(undefined as never),
      'h is undefined; expected a HalfedgeHandle.',
    );
    refused(() => om.find_halfedge(v, 1 as never), 'b is 1; expected a VertexHandle.');
    refused(() => om.is_boundary(0 as never), 'item is 0; expected a handle.');
    refused(
      () => om.valence(e as never),
      'item is an EdgeHandle; expected a VertexHandle or a FaceHandle.',
    );
    refused(
      () => om.set_next_halfedge_handle(h, v as never),
      'next is a VertexHandle; expected a HalfedgeHandle.',
    );
    refused(
      () => om.set_halfedge_handle(e as never, h),
      'of is an EdgeHandle; expected a VertexHandle or a FaceHandle.',
    );
    expect(mesh.validate()).toEqual([]);
    // A fourth number would be x of the next vertex.
    expect(() => om.set_point(v, [7, 8, 9, 10])).toThrow(
      'point is an array of 4 elements; expected three numbers, x, y and z.',
    );
    expect(om.point(om.vertex_handle(1))).toEqual([1, 0, 0]);
  });
});

describe("CGAL's names", () => {
  test.each(cases)('tell the same of %s as ours', (_, shape) => {
    using mesh = build(shape());
    const polyhedron = new Polyhedron(mesh);
    expect(polyhedron.size_of_vertices()).toBe(mesh.vertexCount);
    expect(polyhedron.size_of_facets()).toBe(mesh.faceCount);
    expect(polyhedron.size_of_halfedges()).toBe(mesh.halfedgeCount);
    let border = 0;
    for (const h of polyhedron.halfedges()) {
      const i = h.index;
      expect(h.next().index).toBe(mesh.next(i));
      expect(h.prev().index).toBe(mesh.prev(i));
      expect(h.opposite().opposite()).toBe(h);
      expect(h.vertex().index).toBe(mesh.toVertex(i));
      expect(h.facet()?.index ?? -1).toBe(mesh.face(i));
      expect(h.face()).toBe(h.facet());
      expect(h.is_border()).toBe(h.facet() === null);
      expect(h.is_border_edge()).toBe(mesh.isBoundaryEdge(mesh.edge(i)));
      expect(h.next_on_vertex()).toBe(h.next().opposite());
      expect(h.prev_on_vertex()).toBe(h.opposite().prev());
      expect(h.vertex_degree()).toBe(mesh.valence(mesh.toVertex(i)));
      const corners = [...mesh.halfedgeLoop(i)].length;
      expect(h.facet_degree()).toBe(corners);
      expect([h.is_triangle(), h.is_quad()]).toEqual([corners === 3, corners === 4]);
      const around = mesh.valence(mesh.toVertex(i));
      for (const at of [h, h.vertex()]) {
        expect([at.is_bivalent(), at.is_trivalent()]).toEqual([around === 2, around === 3]);
      }
      border += h.is_border() ? 1 : 0;
    }
    expect(polyhedron.size_of_border_halfedges()).toBe(border);
    expect(polyhedron.size_of_border_edges()).toBe(border);
    expect(polyhedron.is_closed()).toBe(border === 0);
    const degrees = [...mesh.faces()].map((f) => mesh.degree(f));
    expect(polyhedron.is_pure_triangle()).toBe(degrees.every((degree) => degree === 3));
    expect(polyhedron.is_pure_quad()).toBe(degrees.every((degree) => degree === 4));
    const sides = [...mesh.edges()].map((e) => mesh.edgeHalfedge(e));
    expect(polyhedron.edges().map(({ index }) => index)).toEqual(sides);
    for (const v of polyhedron.vertices()) {
      expect(v.degree()).toBe(mesh.valence(v.index));
      const c = v.vertex_begin();
      if (c === null) {
        expect(v.halfedge()).toBe(null);
        continue;
      }
      const begin = c.halfedge;
      const arriving: number[] = [];
      do arriving.push(c.halfedge.index);
      while (c.next() !== begin);
      expect(arriving).toEqual([...mesh.vertexIncomingHalfedges(v.index, 'cw')]);
      const back: number[] = [];
      do back.push(c.prev().index);
      while (c.halfedge !== begin);
      expect(back).toEqual(arriving.reverse());
    }
    for (const f of polyhedron.facets()) {
      const c = f.facet_begin();
      const begin = c.halfedge;
      const around: number[] = [];
      do around.push(c.halfedge.vertex().index);
      while (c.next() !== begin);
      expect(around).toEqual([...mesh.faceVertices(f.index)]);
      const back: number[] = [];
      do back.push(c.prev().vertex().index);
      while (c.halfedge !== begin);
      expect(back).toEqual(around.reverse());
      expect(f.facet_degree()).toBe(around.length);
      expect([f.is_triangle(), f.is_quad()]).toEqual([around.length === 3, around.length === 4]);
    }
  });

  test('read positions, and refuse items that are not there', () => {
    using mesh = build(tetrahedron());
    const polyhedron = new Polyhedron(mesh);
    expect(polyhedron.vertex(1).point()).toEqual([1, 0, 0]);
    expect(polyhedron.facet(2)).toBe(polyhedron.facet(2));
    expect(() => polyhedron.vertex(4)).toThrow(RangeError);
    expect(() => polyhedron.halfedge(-1)).toThrow(RangeError);
    expect(() => polyhedron.facet(4)).toThrow(RangeError);
  });

  test('refuse to tell the point of a vertex that is gone', () => {
    using mesh = build(tetrahedron());
    const vertex = new Polyhedron(mesh).vertex(3);
    mesh.deleteVertex(3);
    expect(() => vertex.point()).toThrow('v is vertex 3, which was deleted');
    mesh.compact();
    expect(() => vertex.point()).toThrow('v is 3');
  });
});

describe("McGuire's names", () => {
  test('refuse to tell, and to move, a vertex that is gone', () => {
    using mesh = build(tetrahedron());
    const vert = new HE_mesh(mesh).vert(3);
    vert.x = 4;
    expect([vert.x, vert.y, vert.z]).toEqual([4, 0, 1]);
    mesh.deleteVertex(3);
    expect(() => vert.x).toThrow('v is vertex 3, which was deleted');
    mesh.compact();
    expect(() => vert.z).toThrow('v is 3');
    expect(() => {
      vert.y = 1;
    }).toThrow(RangeError);
  });

  test.each(cases)('run the loops of the article over %s as printed', (_, shape) => {
    using mesh = build(shape());
    const he = new HE_mesh(mesh);
    for (const v of mesh.vertices()) {
      const vert = he.vert(v);
      if (vert.edge === null) {
        expect(mesh.isIsolatedVertex(v)).toBe(true);
        continue;
      }
      const ring: number[] = [];
      let edge = vert.edge;
      do {
        ring.push(edge.vert.index);
        edge = edge.pair.next;
      } while (edge !== vert.edge);
      expect(ring).toEqual([...mesh.vertexVertices(v, 'cw')]);
    }
    for (const f of mesh.faces()) {
      const face = he.face(f);
      const loop: number[] = [];
      let edge = face.edge;
      do {
        loop.push(edge.index);
        expect(edge.face).toBe(face);
        edge = edge.next;
      } while (edge !== face.edge);
      expect(loop).toEqual([...mesh.faceHalfedges(f)]);
    }
    for (const h of mesh.halfedges()) expect(he.edge(h).face?.index ?? -1).toBe(mesh.face(h));
  });

  test('read and move vertices, and refuse items that are not there', () => {
    using mesh = build(tetrahedron());
    const he = new HE_mesh(mesh);
    const vert = he.vert(1);
    expect([vert.x, vert.y, vert.z]).toEqual([1, 0, 0]);
    [vert.x, vert.y, vert.z] = [4, 5, 6];
    expect([...mesh.positions.slice(3, 6)]).toEqual([4, 5, 6]);
    expect([vert.x, vert.y, vert.z]).toEqual([4, 5, 6]);
    expect(() => he.vert(4)).toThrow(RangeError);
    expect(() => he.edge(12)).toThrow(RangeError);
    expect(() => he.face(-1)).toThrow(RangeError);
  });
});
