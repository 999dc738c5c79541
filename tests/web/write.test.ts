import { type FileFormat, HalfedgeError, HalfedgeMesh, init, type WriteOptions } from 'halfedge';

beforeAll(() => init());

const positions = new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.1, 2, -1e-7, 7, 8, 9]);
const faces = [
  [2, 3, 0, 1],
  [3, 2, 4],
];
const facesOf = (mesh: HalfedgeMesh) => {
  const { sizes, corners } = mesh.toPolygons();
  let at = 0;
  return Array.from(sizes, (size) => {
    at += size;
    return Array.from(corners.subarray(at - size, at));
  });
};

let mesh: HalfedgeMesh;
beforeEach(() => {
  mesh = HalfedgeMesh.fromPolygons(positions, faces);
});
afterEach(() => mesh.dispose());

describe('write', () => {
  test('writes text as a string', () => {
    expect(mesh.write('obj')).toBe(
      'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.1 2 -1e-7\nv 7 8 9\nf 3 4 1 2\nf 4 3 5\n',
    );
    expect(mesh.write('off')).toMatch(/^OFF\n6 2 0\n0 0 0\n/);
    expect(mesh.write('stl', { encoding: 'text' })).toMatch(/^solid\nfacet normal 0 0 1\n/);
  });

  test('has the type of what it returns', () => {
    const text: string[] = [mesh.write('obj'), mesh.write('off', { attributes: false })];
    const bytes: Uint8Array[] = [mesh.write('ply'), mesh.write('stl', { encoding: 'binary' })];
    expect(text.map((content) => typeof content)).toEqual(['string', 'string']);
    for (const content of bytes) expect(content).toBeInstanceOf(Uint8Array);
    // A Blob doesn't take bytes that may be shared.
    const size = mesh.write('stl').length + mesh.toBytes().length;
    expect(new Blob([mesh.write('stl'), mesh.toBytes()]).size).toBe(size);
  });

  const forms: [FileFormat, WriteOptions][] = [
    ['obj', {}],
    ['off', {}],
    ['off', { encoding: 'binary' }],
    ['ply', { encoding: 'text' }],
    ['ply', {}],
    ['ply', { encoding: 'binary-big-endian' }],
  ];
  test.each(forms)('%s %p reads back as the same mesh', (format, options) => {
    const data = mesh.write(format, options);
    const { mesh: again, report } = HalfedgeMesh.parse(data);
    expect(report.format).toBe(format);
    expect(report.problems.filter(({ code }) => code !== 'isolated-vertex')).toEqual([]);
    expect(Array.from(again.positions)).toEqual(Array.from(positions));
    expect(facesOf(again)).toEqual(faces);
    again.dispose();
  });

  test('cuts polygons into triangles for STL', () => {
    const bytes = mesh.write('stl', { encoding: 'binary' });
    expect(bytes).toBeInstanceOf(Uint8Array);
    expect(bytes).toHaveLength(84 + 3 * 50);
    const { mesh: again } = HalfedgeMesh.parse(bytes);
    expect([again.vertexCount, again.faceCount]).toEqual([5, 3]);
    again.dispose();
  });

  test('cuts polygons for STL along no edge that is there', () => {
    // Two quads that share two edges, and four triangles: the shorter diagonals of both join 1 and 3.
    const points = [0, 0, 0, 1, 0, 0, 3, 1, 0, 0, 1, 0, 3, 1, 1];
    const quads = HalfedgeMesh.fromPolygons(points, [
      [0, 1, 2, 3],
      [0, 3, 4, 1],
      [1, 4, 2],
      [2, 4, 3],
    ]);
    const { mesh: again } = HalfedgeMesh.parse(quads.write('stl'), { repair: false });
    expect([again.faceCount, again.isClosed()]).toEqual([6, true]);
    const triangles = quads.clone();
    triangles.triangulate();
    const { mesh: same } = HalfedgeMesh.parse(triangles.write('stl'), { repair: false });
    const sorted = (mesh: HalfedgeMesh) =>
      facesOf(mesh)
        .map((corners) =>
          corners
            .map((v) => mesh.position(v).join())
            .sort()
            .join(' '),
        )
        .sort();
    expect(sorted(again)).toEqual(sorted(same));
    for (const made of [quads, again, triangles, same]) made.dispose();
  });

  test('cuts a polygon for STL all the same where each diagonal is an edge', () => {
    // Each pair of the corners of the quad is joined.
    const points = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5, 0.5, 1, 0.5, 0.5, -1];
    const quad = HalfedgeMesh.fromPolygons(points, [
      [0, 1, 2, 3],
      [0, 2, 4],
      [1, 3, 5],
    ]);
    expect(quad.checkTriangulate()?.code).toBe('no-triangulation');
    expect(quad.write('stl')).toHaveLength(84 + 4 * 50);
    quad.dispose();
  });

  test('spells names in its notes as they are', () => {
    const mesh = HalfedgeMesh.cube();
    for (const name of ['Größe', '\u202eback', '\\xc3']) mesh.attributes.add('vertex', name);
    const notes: string[] = [];
    mesh.write('obj', { onNote: (sentence) => notes.push(sentence) });
    expect(notes).toEqual(
      ['Größe', '\\xe2\\x80\\xaeback', '\\xc3'].map(
        (name) => `Left out the vertex attribute "${name}": OBJ has no place for it.`,
      ),
    );
    mesh.dispose();
  });

  test('notes the vertices that readers of STL join', () => {
    const notesOf = (points: number[], triangles: number[], format: FileFormat = 'stl') => {
      const notes: string[] = [];
      const made = HalfedgeMesh.fromTriangles(points, triangles);
      made.write(format, { onNote: (sentence) => notes.push(sentence) });
      made.dispose();
      return notes;
    };
    // Tetrahedra that touch in a point; further vertices are isolated, and not written.
    const tips = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, -0, 0, 0, -1, 0, 0, 0, -1, 0, 0, 0, -1];
    const both = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3, 4, 5, 6, 4, 7, 5, 4, 6, 7, 5, 7, 6];
    const one = 'Wrote 1 vertex in the same place as another, with which readers of STL join it.';
    const left = 'Left out 1 vertex without faces: STL has no place for it.';
    expect(notesOf([...tips, 0, 0, 0], both)).toEqual([left, one]);
    const more = 'Left out 2 vertices without faces: STL has no place for them.';
    expect(notesOf([...tips, 0, 0, 0, 1, 1, 1], both)).toEqual([more, one]);
    expect(notesOf(tips, both, 'ply')).toEqual([]);
    expect(notesOf(tips.slice(0, 12), both.slice(0, 12))).toEqual([]);
    const twins = [0, 0, 0, 1, 0, 0, 0, 1, 0];
    expect(notesOf([...twins, ...twins], [0, 1, 2, 3, 5, 4])).toEqual([
      'Wrote 3 vertices in the same place as others, with which readers of STL join them.',
    ]);
  });

  test('notes positions that readers leave out', () => {
    const notesOf = (format: FileFormat) => {
      const notes: string[] = [];
      made.write(format, { onNote: (sentence) => notes.push(sentence) });
      return notes;
    };
    using made = HalfedgeMesh.cube();
    made.positions[7] = Number.NaN;
    for (const format of ['obj', 'off', 'ply'] as const) {
      const one = "Wrote 1 vertex whose position isn't finite: readers leave it out.";
      expect(notesOf(format)).toEqual([one]);
    }
    made.positions.fill(Infinity, 0, 4);
    expect(notesOf('ply')).toEqual([
      "Wrote 3 vertices whose positions aren't finite: readers leave them out.",
    ]);
    made.positions.fill(0);
    expect(notesOf('off')).toEqual([]);
  });

  test('takes the bytes of a mesh without prev', () => {
    const other = HalfedgeMesh.fromPolygons(positions, faces, { storePrev: false });
    expect(other.write('ply')).toEqual(mesh.write('ply'));
    other.dispose();
  });

  test('refuses what a format does not have', () => {
    const writing = (format: string, options?: object) => () =>
      mesh.write(format as FileFormat, options as WriteOptions);
    expect(writing('gif')).toThrow(
      new RangeError(`format is "gif"; expected 'obj', 'off', 'ply' or 'stl'.`),
    );
    expect(writing('ply', { encoding: 'ascii' })).toThrow(
      `options.encoding is "ascii"; expected 'text', 'binary' or 'binary-big-endian'.`,
    );
    expect(writing('obj', { encoding: 'binary' })).toThrow(
      new HalfedgeError('unsupported-format', 'OBJ has no binary form, expected text.'),
    );
    expect(writing('ply', null as never)).toThrow(TypeError);
    mesh.positions[0] = Number.NaN;
    expect(writing('stl')).toThrow(expect.objectContaining({ code: 'non-finite-position' }));
    expect(mesh.write('off')).toContain('\nnan 0 0\n');
  });

  test('refuses a corrupt mesh, and a disposed one', () => {
    mesh.connectivity.toVertex.fill(1000);
    expect(() => mesh.write('obj')).toThrow(
      expect.objectContaining({ code: 'corrupt-connectivity' }),
    );
    mesh.dispose();
    expect(() => mesh.write('obj')).toThrow(/disposed/);
  });
});
