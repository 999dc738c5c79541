import { readdirSync, readFileSync } from 'node:fs';
import { DirectedEdgesMesh, HalfedgeMesh, init } from 'halfedge';
import { readGltf, readGltfParts, writeGltf } from 'halfedge/gltf';
import {
  BoundaryLoopsHelper,
  CirculatorHelper,
  fromBufferGeometry,
  HalfedgesHelper,
  IndexLabelsHelper,
  MeshGeometry,
  ProblemsHelper,
  toBufferGeometry,
} from 'halfedge/three';
import { FaceTree, MeshPicker } from 'halfedge/three/picking';
import { createMeshWorker, parseInWorker } from 'halfedge/worker';
import { BoxGeometry, Mesh, PerspectiveCamera } from 'three';

await init();

const SOUP = [[0, 0, 0, 1, 0, 0, 0, 1, 0], [[0, 1, 2]]] as const;
const OBJ = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n';
const GLTF = '{ "asset": { "version": "2.0" } }';
const cube = () => HalfedgeMesh.cube();
const picker = () => new MeshPicker(new Mesh(new MeshGeometry(cube())), { worker: () => null });
const faces = { points: new Float32Array(), allTriangles: noTriangles, triangleVertices: () => [] };

function noTriangles() {
  return { points: new Float32Array(9), vertices: new Uint32Array(3), faces: new Uint32Array(1) };
}

/** A function, the type of its options in the declarations, what it is called with, and all of its options. */
type Case = [string, string, (options: never) => unknown, string];

const STORAGE = 'storePrev';
const PARSE = `${STORAGE}, onProgress, signal, format, repair, attributes`;
const SOUP_NAMES = `${STORAGE}, weld, dropIsolated`;
const GLTF_NAMES = `${SOUP_NAMES}, repair, baseUrl, resource, dracoLoader, meshoptDecoder`;
const HELPER = 'color, linewidth, lines, pixel';

const CASES: Case[] = [
  ['new HalfedgeMesh', 'StorageOptions', (o) => new HalfedgeMesh(o), STORAGE],
  [
    'fromTriangles',
    'BuildOptions',
    (o) => HalfedgeMesh.fromTriangles(SOUP[0], [0, 1, 2], o),
    STORAGE,
  ],
  ['fromPolygons', 'BuildOptions', (o) => HalfedgeMesh.fromPolygons(...SOUP, o), STORAGE],
  [
    'fromFaces',
    'FaceOptions',
    (o) => HalfedgeMesh.fromFaces(SOUP[1], o),
    `${STORAGE}, vertexCount`,
  ],
  ['fromSoup', 'SoupOptions', (o) => HalfedgeMesh.fromSoup(...SOUP, o), SOUP_NAMES],
  ['parse', 'ParseOptions', (o) => HalfedgeMesh.parse(OBJ, o), PARSE],
  [
    'parseSoup',
    'FileSoupOptions',
    (o) => HalfedgeMesh.parseSoup(OBJ, o),
    'format, attributes, weld',
  ],
  ['write', 'WriteOptions', (o) => cube().write('obj', o), 'encoding, attributes, names, onNote'],
  ['tetrahedron', 'SphereOptions', (o) => HalfedgeMesh.tetrahedron(o), `${STORAGE}, radius`],
  ['octahedron', 'SphereOptions', (o) => HalfedgeMesh.octahedron(o), `${STORAGE}, radius`],
  ['icosahedron', 'SphereOptions', (o) => HalfedgeMesh.icosahedron(o), `${STORAGE}, radius`],
  ['dodecahedron', 'SphereOptions', (o) => HalfedgeMesh.dodecahedron(o), `${STORAGE}, radius`],
  ['icoSphere', 'SphereOptions', (o) => HalfedgeMesh.icoSphere(1, o), `${STORAGE}, radius`],
  ['cube', 'CubeOptions', (o) => HalfedgeMesh.cube(o), `${STORAGE}, size`],
  ['prism', 'PrismOptions', (o) => HalfedgeMesh.prism(3, o), `${STORAGE}, radius, height`],
  ['cone', 'ConeOptions', (o) => HalfedgeMesh.cone(3, o), `${STORAGE}, radius, height, base`],
  [
    'cylinder',
    'CylinderOptions',
    (o) => HalfedgeMesh.cylinder(3, o),
    `${STORAGE}, radius, height, triangles, rings, caps`,
  ],
  [
    'grid',
    'GridOptions',
    (o) => HalfedgeMesh.grid(1, 1, o),
    `${STORAGE}, triangles, width, height`,
  ],
  [
    'torus',
    'TorusOptions',
    (o) => HalfedgeMesh.torus(3, 3, o),
    `${STORAGE}, triangles, radius, tube`,
  ],
  [
    'uvSphere',
    'UvSphereOptions',
    (o) => HalfedgeMesh.uvSphere(3, 2, o),
    `${STORAGE}, triangles, radius`,
  ],
  [
    'circulate',
    'CirculateOptions',
    (o) => cube().circulate('vertexFaces', 0, o),
    'direction, start',
  ],
  [
    'circulate, Directed Edges',
    'CirculateOptions',
    (o) => DirectedEdgesMesh.fromTriangles(SOUP[0], [0, 1, 2]).circulate('vertexFaces', 0, o),
    'direction, start',
  ],
  ['deleteFace', 'DeleteOptions', (o) => cube().deleteFace(0, o), 'keepIsolatedVertices'],
  ['deleteEdge', 'DeleteOptions', (o) => cube().deleteEdge(0, o), 'keepIsolatedVertices'],
  ['collapse', 'CollapseOptions', (o) => cube().collapse(0, undefined, o), 'permissive'],
  ['checkCollapse', 'CollapseOptions', (o) => cube().checkCollapse(0, undefined, o), 'permissive'],
  [
    'splitVertex',
    'SplitVertexOptions',
    (o) => {
      const mesh = cube();
      const h = mesh.vertexHalfedge(0) as number;
      return mesh.splitVertex(h, mesh.next(mesh.opposite(h)), undefined, o);
    },
    'left, right',
  ],
  [
    'attributes.add',
    'AttributeOptions',
    (o) => cube().attributes.add('face', 'heat', o),
    'type, components, default, onSplit, kind, name',
  ],
  ['history.limit', 'HistoryLimits', (o) => cube().history.limit(o), 'steps, bytes'],
  ['stitchBoundaries', 'StitchOptions', (o) => cube().stitchBoundaries(o), 'tolerance'],
  ['orientOutward', 'OrientOptions', (o) => cube().orientOutward(o), 'open, nested'],
  [
    'dropSmallComponents',
    'DropOptions',
    (o) => cube().dropSmallComponents(o),
    'faces, area, diagonal',
  ],
  [
    'removeDegenerateFaces',
    'DegenerateOptions',
    (o) => cube().removeDegenerateFaces(o),
    'tolerance',
  ],
  ['fillHoles', 'FillOptions', (o) => cube().fillHoles(o), 'maxEdges, maxAngle'],
  ['createMeshWorker', 'MeshWorkerOptions', (o) => createMeshWorker(o).terminate(), 'worker'],
  [
    'parseInWorker',
    'MeshWorkerOptions',
    (o) => parseInWorker(OBJ, o),
    `${PARSE}, transfer, worker`,
  ],
  [
    'MeshWorker.parse',
    'JobOptions',
    (o) => inWorker((worker) => worker.parse(OBJ, o)),
    `${PARSE}, transfer`,
  ],
  [
    'MeshWorker.fromSoup',
    'JobOptions',
    (o) => inWorker((worker) => worker.fromSoup(...SOUP, o)),
    `${SOUP_NAMES}, signal, transfer`,
  ],
  ['readGltf', 'ReadGltfOptions', (o) => readGltf(GLTF, o), GLTF_NAMES],
  ['readGltfParts', 'ReadGltfOptions', (o) => readGltfParts(GLTF, o), GLTF_NAMES],
  ['writeGltf', 'WriteGltfOptions', (o) => writeGltf(cube(), o), 'format, onNote'],
  [
    'fromBufferGeometry',
    'FromGeometryOptions',
    (o) => fromBufferGeometry(new BoxGeometry(), o),
    `${SOUP_NAMES}, repair`,
  ],
  ['MeshGeometry', 'GeometryOptions', (o) => new MeshGeometry(cube(), o), 'normals, attributes'],
  [
    'toBufferGeometry',
    'ToGeometryOptions',
    (o) => toBufferGeometry(cube(), o),
    'normals, attributes, groups',
  ],
  [
    'HalfedgesHelper',
    'HalfedgesOptions',
    (o) => new HalfedgesHelper(cube(), o),
    `${HELPER}, boundaryColor, faces`,
  ],
  ['BoundaryLoopsHelper', 'HelperOptions', (o) => new BoundaryLoopsHelper(cube(), o), HELPER],
  [
    'CirculatorHelper',
    'CirculatorOptions',
    (o) => new CirculatorHelper(cube(), 'vertexFaces', 0, o),
    `${HELPER}, direction, steps, currentColor`,
  ],
  [
    'ProblemsHelper',
    'ProblemsOptions',
    (o) => new ProblemsHelper(cube(), o),
    `${HELPER}, problems`,
  ],
  [
    'IndexLabelsHelper',
    'LabelsOptions',
    (o) => new IndexLabelsHelper(cube(), o),
    'kinds, most, className, pixel',
  ],
  [
    'MeshPicker',
    'FaceTreeOptions',
    (o) => new MeshPicker(new Mesh(new MeshGeometry(cube())), o).dispose(),
    'worker, begin',
  ],
  ['FaceTree', 'FaceTreeOptions', (o) => new FaceTree(faces, o), 'worker, begin'],
  [
    'pick',
    'PickOptions',
    (o) => picker().pick(0, 0, { camera: new PerspectiveCamera(), width: 1, height: 1 }, o),
    'mode, reach, boundary',
  ],
];

async function inWorker<T>(use: (worker: ReturnType<typeof createMeshWorker>) => Promise<T>) {
  const worker = createMeshWorker();
  try {
    return await use(worker);
  } finally {
    worker.terminate();
  }
}

/** The texts of all declarations of the package. */
function declarations(): string[] {
  const dist = new URL('../../dist/', import.meta.url);
  return readdirSync(dist, { recursive: true, encoding: 'utf8' })
    .filter((path) => path.endsWith('.d.ts'))
    .map((path) => readFileSync(new URL(path, dist), 'utf8'));
}

/** What a call throws, at once or later. */
async function errorOf(call: () => unknown): Promise<unknown> {
  try {
    await call();
  } catch (error) {
    return error;
  }
  return undefined;
}

describe('A misspelt option', () => {
  test.each(CASES)('of %s is named, and all that there are', async (_, __, call, names) => {
    const list = names.split(', ');
    const expected =
      list.length > 1 ? `${list.slice(0, -1).join(', ')} or ${list.at(-1)}` : list[0];
    const options = { [list[0]]: undefined, [`${list[0]}s`]: 1 };
    const error = (await errorOf(() => call(options as never))) as Error;
    expect(error).toBeInstanceOf(TypeError);
    const argument = names === 'steps, bytes' ? 'limits' : 'options';
    const sorted = (text: string) => text.split(/, | or /).sort();
    const [, found, known] = /^(.*); expected (.*)\.$/.exec(error.message) ?? [];
    expect(found).toBe(`${argument} has the name "${list[0]}s"`);
    expect(sorted(known)).toEqual(sorted(expected));
  });

  test.each(CASES)('is none of those of %s', async (_, __, call, names) => {
    const options = Object.fromEntries(names.split(', ').map((name) => [name, undefined]));
    expect(String(await errorOf(() => call(options as never)))).not.toContain('has the name');
  });

  test('is found where an object has inherited it', () => {
    const options = Object.create({ storePref: false });
    expect(() => HalfedgeMesh.cube(options)).toThrow('options has the name "storePref"');
  });

  test('is none that a page has given to all objects', () => {
    const prototype = Object.prototype as { extend?: () => void };
    prototype.extend = () => {};
    try {
      expect(HalfedgeMesh.cube({ size: 2 }).faceCount).toBe(6);
      expect(cube().circulate('vertexFaces', 0, { direction: 'cw' }).current).toBeGreaterThan(-1);
    } finally {
      delete prototype.extend;
    }
  });

  test('is quoted, however long', () => {
    const options = { ['x'.repeat(1000)]: 1, '\n': 1 };
    expect(() => HalfedgeMesh.cube(options as never)).toThrow(
      'options has the name a string of 1000 characters; expected storePrev or size.',
    );
  });

  test('is looked for wherever there are options', () => {
    const known = new Set(CASES.map(([, type]) => type));
    // Of init.test.ts, and internal.
    const others = ['CoreOptions', 'EditorOptions', 'InitOptions', 'RunOptions'];
    const found = declarations()
      .flatMap((text) => [
        ...text.matchAll(/\b(?:options|limits)\??: ((?:\w+ & )*)(\w+(?:Options|Limits))\b/g),
      ])
      .map(([, , type]) => type);
    expect(found.length).toBeGreaterThan(60);
    expect([...new Set(found)].filter((type) => !known.has(type)).sort()).toEqual(others);
  });
});

/** Interfaces of options, also those that others extend; and lists of items, which may be left out as well. */
const INTERFACE =
  /^export interface (\w+(?:Options|Limits|Resources|Decoders)|Items)\b[^{]*\{\n(.*?)^\}/gms;

test('An option that is undefined counts as not given for the compiler, too', () => {
  const interfaces = declarations().flatMap((text) => [...text.matchAll(INTERFACE)]);
  const options = interfaces
    .filter(([, type]) => type !== 'EditorOptions' && type !== 'RunOptions')
    .flatMap(([, type, body]) =>
      [...body.matchAll(/^ {4}(?:readonly )?(\w+)\?: (.*);$/gm)].map(
        ([, name, value]) => [`${type}.${name}`, value] as const,
      ),
    );
  expect(options.length).toBeGreaterThan(80);
  const strict = options.filter(([, value]) => !value.endsWith(' | undefined'));
  expect(strict).toEqual([]);
});
