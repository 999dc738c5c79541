import { type FileFormat, HalfedgeMesh, init, type WriteOptions } from 'halfedge';

beforeAll(() => init());

/** A square of two triangles and a quad beside it, with a seam between them. */
function sample(): HalfedgeMesh {
  return HalfedgeMesh.fromPolygons(
    [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0],
    [
      [0, 1, 2],
      [0, 2, 3],
      [1, 4, 5, 2],
    ],
  );
}

/** What a mesh has, in plain values; of halfedges only those with a face. */
function attributesOf(mesh: HalfedgeMesh) {
  return mesh.attributes.list().map((info) => {
    const items =
      info.kind === 'halfedge'
        ? [...mesh.faces()].flatMap((f) => [...mesh.faceHalfedges(f)])
        : Array.from(mesh.attributes.get(info.kind, info.name), (_, i) => i).slice(
            0,
            mesh.attributes.get(info.kind, info.name).length / info.components,
          );
    const values = items.map((item) => mesh.attributes.values(info.kind, info.name, item));
    return { ...info, values };
  });
}

function fill(mesh: HalfedgeMesh, kind: 'vertex' | 'halfedge' | 'face', name: string): void {
  mesh.attributes.get(kind, name).forEach((_, i, view) => {
    view[i] = (i * 37) % 101;
  });
}

function roundTrip(mesh: HalfedgeMesh, format: FileFormat, options: WriteOptions) {
  const notes: string[] = [];
  const data = mesh.write(format, { ...options, onNote: (note) => notes.push(note) });
  const { mesh: again, report } = HalfedgeMesh.parse(data);
  expect(report.problems).toEqual([]);
  const attributes = attributesOf(again);
  again.dispose();
  return { attributes, notes };
}

describe('attributes of files', () => {
  test.each(['text', 'binary', 'binary-big-endian'] as const)(
    'come back in PLY, %s',
    (encoding) => {
      const mesh = sample();
      mesh.attributes.add('vertex', 'normal', { components: 3, onSplit: 'normalize' });
      mesh.attributes.add('vertex', 'color', { type: 'uint8', components: 4 });
      mesh.attributes.add('vertex', 'quality', { type: 'float64' });
      mesh.attributes.add('halfedge', 'uv', { components: 2 });
      mesh.attributes.add('face', 'label', { type: 'int16', onSplit: 'copy' });
      for (const { kind, name } of mesh.attributes.list()) fill(mesh, kind as 'vertex', name);
      mesh.attributes.get('vertex', 'quality')[1] = 0.1;
      const { attributes, notes } = roundTrip(mesh, 'ply', { encoding });
      expect(attributes).toEqual(attributesOf(mesh));
      expect(notes).toEqual([]);
      mesh.dispose();
    },
  );

  test.each(['utf8', 'latin1'] as const)('have the names of a file in %s', (encoding) => {
    const names = ['Grün', 'é', 'Österreichische Stahlträger', 'aÿ', 'plain'];
    const lines = names.map((name, i) => `usemtl ${name}\nf ${i + 1} ${i + 2} ${i + 3}\n`);
    const text = `mtllib Möbel.mtl\n${'v 0 0 0\n'.repeat(7)}${lines.join('')}`;
    const data = Uint8Array.from(Buffer.from(text, encoding));
    const { mesh, report } = HalfedgeMesh.parse(data);
    expect(report.names).toEqual({ material: ['', ...names], library: ['Möbel.mtl'] });
    expect(HalfedgeMesh.parseSoup(data).names).toEqual(report.names);
    const again = mesh.write('obj', { names: report.names });
    expect(HalfedgeMesh.parse(again).report.names).toEqual(report.names);
  });

  test('have the byte-order marks that begin names', () => {
    const text = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl \ufeffoak\nf 1 2 3\n';
    const { mesh, report } = HalfedgeMesh.parse(text);
    expect(report.names).toEqual({ material: ['', '\ufeffoak'] });
    expect(mesh.write('obj', { names: report.names })).toBe(text);
  });

  test('come back in OBJ, with names and seams', () => {
    const mesh = sample();
    mesh.attributes.add('vertex', 'color', { components: 3 });
    mesh.attributes.add('halfedge', 'uv', { components: 2 });
    mesh.attributes.add('halfedge', 'normal', { components: 3, onSplit: 'normalize' });
    mesh.attributes.add('face', 'material', { type: 'int32', onSplit: 'copy' });
    for (const { kind, name } of mesh.attributes.list()) fill(mesh, kind as 'vertex', name);
    mesh.attributes.get('vertex', 'color')[0] = 0.5; // whole numbers would be read as bytes
    mesh.attributes.get('face', 'material').set([1, 1, 2]);
    const numbered = roundTrip(mesh, 'obj', {});
    expect(numbered).toEqual({ attributes: attributesOf(mesh), notes: [] });
    const names = { material: ['', 'oak', 'elm tree'], library: ['trees.mtl'] };
    const text = mesh.write('obj', { names });
    expect(text).toMatch(/^mtllib trees\.mtl\n/);
    expect(text.match(/usemtl.*/g)).toEqual(['usemtl oak', 'usemtl elm tree']);
    const { mesh: again, report } = HalfedgeMesh.parse(text);
    expect(report.names).toEqual(names);
    expect(attributesOf(again)).toEqual(attributesOf(mesh));
    again.dispose();
    mesh.dispose();
  });

  test('come back in OBJ, where a face without a material follows one with it', () => {
    const mesh = sample();
    const numbers = [1, 0, 2];
    mesh.attributes.add('face', 'material', { type: 'int32', onSplit: 'copy' }).set(numbers);
    const names = { material: ['', 'oak', 'elm'] };
    const text = mesh.write('obj', { names });
    expect(text.match(/usemtl.*/g)).toEqual(['usemtl oak', 'usemtl (null)', 'usemtl elm']);
    const { mesh: again, report } = HalfedgeMesh.parse(text);
    expect(report.names).toEqual(names);
    expect([...again.attributes.get('face', 'material')]).toEqual(numbers);
    again.dispose();
    mesh.dispose();
  });

  test.each(['text', 'binary'] as const)('come back in OFF, %s', (encoding) => {
    const mesh = sample();
    mesh.attributes.add('vertex', 'normal', { components: 3, onSplit: 'normalize' });
    mesh.attributes.add('vertex', 'color', { components: 4 });
    mesh.attributes.add('vertex', 'uv', { components: 2 });
    mesh.attributes.add('face', 'color', { components: 3 });
    for (const { kind, name } of mesh.attributes.list()) fill(mesh, kind as 'vertex', name);
    expect(roundTrip(mesh, 'off', { encoding })).toEqual({
      attributes: attributesOf(mesh),
      notes: [],
    });
    mesh.dispose();
  });

  test('come back in STL', () => {
    const mesh = HalfedgeMesh.fromTriangles(
      [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0],
      [0, 1, 2, 2, 1, 3],
    );
    const options = { type: 'uint16', onSplit: 'copy' } as const;
    mesh.attributes.add('face', 'attribute', options).set([0x7fff, 0]);
    mesh.attributes.add('vertex', 'color', { components: 3 });
    const { attributes, notes } = roundTrip(mesh, 'stl', {});
    expect(attributes).toEqual(attributesOf(mesh).filter(({ kind }) => kind === 'face'));
    expect(notes).toEqual(['Left out the vertex attribute "color": STL has no place for it.']);
    mesh.dispose();
  });

  test('are named where a format has no place for them', () => {
    const mesh = sample();
    mesh.attributes.add('edge', 'crease');
    mesh.attributes.add('face', 'two words');
    const { attributes, notes } = roundTrip(mesh, 'ply', {});
    expect(attributes).toEqual([]);
    expect(notes).toEqual([
      'Left out the face attribute "two words": a name in PLY is one word.',
      'Left out the edge attribute "crease": PLY has none by edge.',
    ]);
    const silent: string[] = [];
    mesh.write('ply', { attributes: false, onNote: (note) => silent.push(note) });
    expect(silent).toEqual([]);
    mesh.dispose();
  });

  test('follow what a repair does', () => {
    // The second face runs the wrong way, and the third has a vertex that isn't there.
    const { mesh, report } = HalfedgeMesh.parse(
      'ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n' +
        'property float z\nproperty uchar id\nelement face 4\n' +
        'property list uchar int vertex_indices\nproperty list uchar float texcoord\n' +
        'property int id\nend_header\n' +
        '0 0 0 10\n1 0 0 11\n1 1 0 12\n0 1 0 13\n' +
        '3 0 1 2 6 0 0 1 0 1 1 20\n3 0 1 9 6 9 9 9 9 9 9 21\n' +
        '3 2 0 3 6 7 7 5 5 6 6 22\n3 3 2 0 0 23\n',
    );
    expect(report.counts).toMatchObject({ 'index-out-of-range': 1, 'opposite-orientation': 1 });
    expect(Array.from(mesh.attributes.get('face', 'id'))).toEqual([20, 22]);
    expect(Array.from(mesh.attributes.get('vertex', 'id'))).toEqual([10, 11, 12, 13]);
    const uv = mesh.attributes.get('halfedge', 'uv');
    for (const f of mesh.faces()) {
      for (const h of mesh.faceHalfedges(f)) {
        const v = mesh.toVertex(h);
        const expected = f === 0 ? [v > 0 ? 1 : 0, v > 1 ? 1 : 0] : Array(2).fill([5, 0, 7, 6][v]);
        expect(Array.from(uv.subarray(2 * h, 2 * h + 2))).toEqual(expected);
      }
    }
    mesh.dispose();
  });

  test('of PLY may have names in UTF-8 or Latin-1, which stay the same in copies', () => {
    const named = (name: string, encoding: BufferEncoding) =>
      Buffer.concat([
        Buffer.from(
          'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n' +
            'property float z\nproperty float ',
        ),
        Buffer.from(name, encoding),
        Buffer.from(
          '\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n' +
            '0 0 0 1\n1 0 0 2\n0 1 0 3\n3 0 1 2\n',
        ),
      ]);
    for (const encoding of ['utf8', 'latin1'] as const) {
      for (const name of ['Höhe', 'ÿ', 'Ãÿ', 'größe_der_Löcher_in_mm']) {
        const bytes = named(name, encoding);
        expect(HalfedgeMesh.parseSoup(bytes).attributes.map((it) => it.name)).toEqual([name]);
        using mesh = HalfedgeMesh.parse(bytes).mesh;
        using copy = HalfedgeMesh.fromBytes(mesh.toBytes());
        for (const { attributes } of [mesh, copy]) {
          expect(attributes.list().map((it) => it.name)).toEqual([name]);
          expect([...attributes.get('vertex', name)]).toEqual([1, 2, 3]);
          expect(() => attributes.add('vertex', name)).toThrow(
            `There is a vertex attribute ${JSON.stringify(name)} already.`,
          );
        }
        const back = HalfedgeMesh.parseSoup(mesh.write('ply'));
        expect(back.attributes.map((it) => it.name)).toEqual([name]);
        expect(mesh.attributes.remove('vertex', name)).toBe(true);
        using without = mesh.clone();
        expect(without.attributes.list()).toEqual([]);
      }
    }
  });

  test('of OBJ have names without control characters, and a note says of how many', () => {
    using mesh = HalfedgeMesh.cube();
    mesh.attributes.add('face', 'material', { type: 'int32', onSplit: 'copy' }).set([1, 2, 3]);
    const notes: string[] = [];
    const names = { material: ['', 'a\nb', 'c\0d', 'e\tf', 'unused\n'] };
    const text = mesh.write('obj', { names, onNote: (note) => notes.push(note) });
    expect(text.match(/usemtl.*/g)?.slice(0, 3)).toEqual([
      'usemtl a_b',
      'usemtl c_d',
      'usemtl e_f',
    ]);
    expect(notes[0]).toContain(' with 3 of its 3 names changed: control characters');
  });

  test('are left out on demand', () => {
    const mesh = sample();
    mesh.attributes.add('vertex', 'quality');
    const { mesh: bare } = HalfedgeMesh.parse(mesh.write('ply'), { attributes: false });
    expect(bare.attributes.list()).toEqual([]);
    bare.dispose();
    mesh.dispose();
  });

  test('refuses wrong options', () => {
    const mesh = sample();
    const write = (options: unknown) => () => mesh.write('ply', options as never);
    expect(write({ attributes: 0 })).toThrow('options.attributes is 0; expected true or false.');
    expect(write({ names: 'oak' })).toThrow('options.names is "oak"; expected a plain object');
    expect(write({ names: { material: 'oak' } })).toThrow('options.names.material is "oak"');
    for (const names of [new Map([['material', ['oak']]]), [['material', 'oak']]]) {
      expect(write({ names })).toThrow(
        /^options\.names is an? .*; expected a plain object of lists/,
      );
    }
    expect(write({ onNote: [] })).toThrow('options.onNote is an array of 0 elements; expected');
    mesh.dispose();
  });
});
