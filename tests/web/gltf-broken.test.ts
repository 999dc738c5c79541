import { HalfedgeError, HalfedgeMesh, init } from 'halfedge';
import { readGltf, writeGltf } from 'halfedge/gltf';
import { FLOAT, rejection, square } from './support/gltf.js';
import { random } from './support/random.js';

beforeAll(() => init());

describe('A glTF file that is none', () => {
  const changed = (change: (json: ReturnType<typeof square>) => void) => {
    const json = square();
    change(json);
    return JSON.stringify(json);
  };
  const set = (path: string, value: unknown) =>
    changed((json) => {
      const keys = path.split('.');
      const last = keys.pop() as string;
      const at = keys.reduce(
        (object, key) => (object as Record<string, object>)[key],
        json as object,
      );
      (at as Record<string, unknown>)[last] = value;
    });

  const broken = [
    ['', 'unknown-format', 'The file is empty (0 bytes)'],
    ['{"asset":', 'parse-error', 'Byte 0: what follows is not the JSON of a glTF file: '],
    [
      '[]',
      'parse-error',
      'glTF: The JSON of the file is an array of 0 elements, expected an object.',
    ],
    ['{}', 'parse-error', 'glTF: asset is undefined, expected an object.'],
    [set('asset.version', '1.0'), 'unsupported-format', 'asset.version is "1.0"'],
    [set('asset.minVersion', '2.1'), 'unsupported-format', 'minVersion is "2.1", expected "2.0".'],
    [set('meshes', 7), 'parse-error', 'glTF: meshes is 7, expected an array.'],
    [
      set('meshes.0.primitives.0.attributes.POSITION', 9),
      'parse-error',
      'attributes.POSITION is 9, expected an index from 0 to 1.',
    ],
    [set('meshes.0.primitives.0.mode', 7), 'parse-error', 'mode is 7'],
    [set('nodes.0.mesh', 3), 'parse-error', 'nodes[0].mesh is 3'],
    [set('nodes', [{ children: [1] }, { children: [0] }]), 'parse-error', 'below itself'],
    [set('nodes', [{ children: [0] }]), 'parse-error', 'nodes[0] is a child of nodes'],
    [set('nodes', [{ children: [1, 1] }, {}]), 'parse-error', 'expected one parent'],
    [set('nodes.0.scale', [1, 'x', 1]), 'parse-error', 'nodes[0].scale is an array of 3 elements'],
    [
      set('accessors.0.count', 5),
      'truncated',
      'accessors[0] has 5 rows, which need 60 bytes, but bufferViews[0] has 48.',
    ],
    [set('accessors.0.count', -1), 'parse-error', 'accessors[0].count is -1'],
    [set('accessors.0.count', 2 ** 60), 'parse-error', 'accessors[0].count is 1152921504606847000'],
    [set('accessors.0.componentType', 5124), 'parse-error', 'componentType is 5124'],
    [set('accessors.0.type', 'toString'), 'parse-error', 'accessors[0].type is "toString"'],
    [set('accessors.0.type', 'a b\n'), 'parse-error', 'accessors[0].type is "a b\\n", expected'],
    [set('accessors.0.byteOffset', 2), 'parse-error', 'byteOffset is 2, expected a multiple of 4'],
    [
      set('accessors.0', { componentType: FLOAT, count: 4e9, type: 'VEC3' }),
      'too-large',
      'accessors[0] has 4000000000 rows of zeros',
    ],
    [set('bufferViews.0.byteLength', 4000), 'parse-error', 'bufferViews[0] is bytes 0 to 4000'],
    [set('buffers.0.byteLength', 4000), 'truncated', 'buffers[0] has 60 bytes, expected 4000'],
    [
      set('buffers.0.uri', 'data:;base64,*'),
      'parse-error',
      'buffers[0].uri is a broken data: address',
    ],
    [set('buffers.0.uri', undefined), 'truncated', 'buffers[0] has no address'],
    [
      set('extensionsRequired', ['KHR_draco_mesh_compression']),
      'unsupported-format',
      "it needs three.js's DRACOLoader as options.dracoLoader.",
    ],
    [
      changed((json) => {
        const extensions = { KHR_draco_mesh_compression: { bufferView: 0, attributes: {} } };
        const primitive = { attributes: { POSITION: 0 }, indices: 1, extensions };
        Object.assign(json, { meshes: [{ primitives: [primitive] }] });
        Object.assign(json.accessors[0], { bufferView: undefined });
      }),
      'unsupported-format',
      'the geometry is compressed (KHR_draco_mesh_compression)',
    ],
    [
      set('extensionsRequired', ['ACME_points']),
      'unsupported-format',
      'requires the extension "ACME_points"',
    ],
  ];
  const bySentence = broken.map(([text, code, sentence]) => [sentence, code, text]);

  test.each(bySentence)('is told: %s (%s)', async (sentence, code, text) => {
    const error = await rejection(readGltf(text));
    expect(error).toBeInstanceOf(HalfedgeError);
    expect(error.message).toContain(sentence);
    expect(error.code).toBe(code);
  });

  test('is told on one line, also where names or text are quoted', async () => {
    const texts = ['v 0 0 0\nv 1 0 0\n', '{"asset":\n\x1b[2J\n', set('extensionsUsed', 'a\nb c')];
    texts.push(set('meshes.0.primitives.0.attributes', { 'POSITION\n': 9 }));
    for (const text of texts) {
      expect((await rejection(readGltf(text))).message).not.toMatch(/\p{Cc}/u);
    }
  });

  test('is told from what is no file', async () => {
    expect((await rejection(readGltf('duck.glb'))).message).toBe(
      'data is "duck.glb", the name of a file; expected what is in it, so fetch or read it first.',
    );
    expect((await rejection(readGltf(new Blob() as never))).message).toBe(
      'data is a Blob; expected a URL, or the content of a glTF file as a string, an ArrayBuffer or a Uint8Array: await its arrayBuffer().',
    );
  });

  test('is told when a GLB file is cut, at every byte', async () => {
    const glb = await writeGltf(HalfedgeMesh.tetrahedron());
    for (let length = 0; length < glb.length; length++) {
      const error = await rejection(readGltf(glb.subarray(0, length)));
      expect(error).toBeInstanceOf(HalfedgeError);
      expect(['truncated', 'parse-error', 'unknown-format', 'not-text']).toContain(error.code);
    }
  });

  test('gives a mesh or a HalfedgeError whatever is changed in it', async () => {
    const quiet = ['warn', 'error'].map((name) =>
      import.meta.jest.spyOn(console, name as 'warn').mockImplementation(() => {}),
    );
    const original = await writeGltf(HalfedgeMesh.icoSphere(1));
    const seed = 20;
    const next = random(seed);
    const endings = new Set<string>();
    for (let round = 0; round < 400; round++) {
      const bytes = original.slice();
      const changes = 1 + Math.floor(4 * next());
      for (let i = 0; i < changes; i++) {
        // Mostly in the header and the JSON.
        const range = next() < 0.8 ? Math.min(900, bytes.length) : bytes.length;
        bytes[Math.floor(range * next())] = Math.floor(256 * next());
      }
      try {
        const { mesh } = await readGltf(bytes);
        const errors = mesh.validate().filter(({ severity }) => severity === 'error');
        expect({ seed, round, errors }).toEqual({ seed, round, errors: [] });
        mesh.dispose();
        endings.add('mesh');
      } catch (error) {
        if (!(error instanceof HalfedgeError))
          throw new Error(`Seed ${seed}, round ${round}`, { cause: error });
        endings.add(error.code);
      }
    }
    expect(endings).toContain('mesh');
    expect(endings.size).toBeGreaterThan(2);
    for (const spy of quiet) spy.mockRestore();
  });
});
