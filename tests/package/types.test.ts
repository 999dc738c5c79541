import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { filesBelow } from '../../scripts/lib/files.mjs';
import { install, packed, project, tool, tryNode } from './support/project.js';

const consumer = `
import { type Box, type Circulator, type CirculatorKind, DirectedEdgesMesh, type Edge, type EdgeLike, type Face, type FileFormat, type Halfedge, HalfedgeError, HalfedgeMesh, init, type ItemKind, type ItemLike, type ItemList, type Items, type MeshPart, NONE, type Reference, type Refusal, type ValidationLevel, type Vertex, type WriteOptions, type XYZ } from 'halfedge';
import wasm from 'halfedge/core.wasm';
import { HE_mesh, type PolyhedronHalfedge, Polyhedron, PolyMesh, type VertexHandle } from 'halfedge/dialects';
import { type GltfPart, readGltf, readGltfParts, writeGltf } from 'halfedge/gltf';
import { init as initInline } from 'halfedge/inline';
import { createMeshWorker, parseInWorker } from 'halfedge/worker';

export async function oneRing(positions: Float32Array, indices: Uint32Array): Promise<Vertex[]> {
  await init();
  await init({ wasm });
  await init({ wasm: new URL('https://example.org/core.wasm') });
  await initInline({ wasm: new Uint8Array(8) });
  const mesh = HalfedgeMesh.fromTriangles(positions, indices);
  const h: Halfedge = mesh.vertexHalfedge(0);
  const f: Face = mesh.face(mesh.opposite(h));
  if (f === NONE) return [];
  const links: Int32Array = mesh.connectivity.next;
  const ring: Vertex[] = [...mesh.vertexVertices(mesh.toVertex(links[h]), 'cw')];
  mesh.dispose();
  return ring;
}

export async function elsewhere(bytes: Uint8Array): Promise<number> {
  const { mesh, report } = await parseInWorker(bytes, { format: 'ply', transfer: true });
  const worker = createMeshWorker();
  const soup = await worker.fromSoup(mesh.positions, [[0, 1, 2]], { weld: true });
  worker.terminate();
  return soup.mesh.faceCount + report.vertexMap[0];
}

export async function models(address: URL): Promise<GltfPart[]> {
  const { mesh, report } = await readGltf(address, { weld: 1e-6, repair: false });
  const glb: Uint8Array = await writeGltf(mesh);
  const gltf: string = await writeGltf(mesh, { format: 'gltf' });
  return report.format === 'glb' ? readGltfParts(glb) : readGltfParts(gltf);
}

/** What a Blob takes: bytes that are not shared. */
export async function download(mesh: HalfedgeMesh): Promise<Uint8Array<ArrayBuffer>[]> {
  return [mesh.write('ply'), mesh.toBytes(), await writeGltf(mesh)];
}

export function explain(error: unknown): string {
  return error instanceof HalfedgeError ? error.code + error.witness.faces.join() : '';
}

export function inOtherWords(mesh: HalfedgeMesh): number {
  const om = new PolyMesh(mesh);
  const ring: VertexHandle[] = om.vv_range(om.vertex_handle(0));
  const h: PolyhedronHalfedge = new Polyhedron(mesh).halfedge(0).next_on_vertex();
  return ring.length + h.index + new HE_mesh(mesh).edge(mesh.vertexHalfedge(0)).pair.next.vert.x;
}

export function edit(mesh: HalfedgeMesh, e: Edge): Vertex | Refusal {
  mesh.history.limit({ steps: 10 });
  const normals: Float32Array = mesh.attributes.add('vertex', 'normal', { components: 3, onSplit: 'normalize' });
  const groups: Int32Array = mesh.attributes.add('face', 'group', { type: 'int32', default: -1 });
  const joined: Face | typeof NONE = mesh.removeEdge(e);
  const maps: Int32Array = mesh.compact().halfedges;
  mesh.setPosition(0, [normals[0], groups[0], maps[joined]]);
  return mesh.checkSplitEdge(e) ?? mesh.history.group(() => mesh.splitEdge(e, new Float32Array(3)));
}

/** Items by the name of their kind: as the mesh hands them out, or plain numbers. */
export function byKind(mesh: HalfedgeMesh, directed: DirectedEdgesMesh, v: Vertex, f: Face, words: Uint32Array): Vertex {
  const ring: Circulator<Vertex> = mesh.circulate('vertexVertices', v);
  mesh.circulate('faceFaces', f, 'cw').moveTo(words[0]).moveTo(f).next();
  directed.circulate('halfedgeLoop', mesh.face(3) ^ 1).moveTo(mesh.faceHalfedge(f));
  mesh.attributes.set('face', 'group', f, mesh.attributes.values('vertex', 'group', words[0]));
  if (mesh.checkDeleteComponent('halfedge', mesh.findHalfedge(v, 0)) === null) mesh.deleteComponent('face', f);
  const items: Items = { vertices: [v, 1], edges: words, faces: undefined };
  mesh.link(mesh.star(items));
  mesh.allFaceVertices('cw', mesh.kRing(mesh.vertices(), 2).items);
  mesh.allEdgeFaces([...mesh.vertexEdges(v)]);
  mesh.allEdgeFaces(mesh.vertexEdges(v));
  const part: MeshPart = mesh.extract(new Set([f, 2]));
  const seam: ItemList<EdgeLike> = mesh.vertexEdges(part.vertices[0]);
  const copies: Halfedge[] = mesh.cutEdges(seam);
  mesh.star({ faces: mesh.vertexFaces(mesh.toVertex(copies[0])) });
  const reference: Reference = mesh.generations.reference('face', f);
  mesh.generations.isCurrent({ kind: 'face', index: reference.index, generation: 1 });
  return mesh.generations.reference('vertex', ring.current).index;
}

/** Measures of either kind of mesh. */
export function measure(mesh: HalfedgeMesh | DirectedEdgesMesh, v: Vertex, f: Face): [XYZ, Float64Array, Box | null] {
  const normals: Float32Array = mesh.allVertexNormals();
  const areas: Float64Array = mesh.allFaceAreas(new Float64Array(mesh.faceSlots));
  normals.set(mesh.allVertexNormals(normals));
  return [mesh.vertexNormal(v), areas.fill(mesh.faceArea(f) + mesh.cotanWeight(0)), mesh.boundingBox()];
}

/** A program for whatever has the methods that it needs, and links that may be none. */
type Rings = Pick<HalfedgeMesh, 'vertices' | 'vertexVertices' | 'edgeHalfedges' | 'circulate' | 'position' | 'allEdgeLengths'>;
export function furthest(mesh: Rings): Vertex | typeof NONE {
  let best: Vertex | typeof NONE = NONE;
  for (const v of mesh.vertices()) if (best === NONE || mesh.position(v)[0] > mesh.position(best)[0]) best = v;
  return best;
}
export const ofEither = (mesh: HalfedgeMesh, directed: DirectedEdgesMesh) => [furthest(mesh), furthest(directed)];

/** Kinds that only the program knows. */
export function ofAnyKind<Kind extends ItemKind>(mesh: HalfedgeMesh, kind: Kind, item: ItemLike<Kind>, index: number, name: CirculatorKind): number {
  mesh.deleteComponent(kind, index);
  mesh.attributes.set(kind, 'group', item, mesh.attributes.values(kind, 'group', index));
  const same: Reference = mesh.generations.reference(kind, item);
  mesh.valence(mesh.generations.reference(kind as ItemKind, index).index);
  return mesh.circulate(name, index).moveTo(mesh.face(0)).next() + same.index;
}

/** Options that are handed on, given or not. */
export async function handOn(file: Blob, signal?: AbortSignal, format?: 'obj' | 'ply', size?: number): Promise<HalfedgeMesh> {
  const { mesh } = await parseInWorker(file, { signal, format });
  mesh.stitchBoundaries({ tolerance: size });
  mesh.write('ply', { encoding: undefined });
  mesh.attributes.add('vertex', 'weight', { default: size, onSplit: undefined });
  return size === 0 ? mesh : HalfedgeMesh.cube({ size });
}

/** Levels, formats and encodings that only the program knows. */
export function onDemand(mesh: HalfedgeMesh, either: HalfedgeMesh | DirectedEdgesMesh, format: FileFormat, level: ValidationLevel, options: WriteOptions): (string | Uint8Array)[] {
  for (let links = 0; links <= 4; links++) if (either.validate(links).length + mesh.validate(links).length > 0) return [];
  if (mesh.validate(level).length + mesh.validate('geometry').length + either.validate(3).length > 0) return [];
  const off: Uint8Array = mesh.write('off', { encoding: 'binary-big-endian' });
  const stl: string = mesh.write('stl', { encoding: 'text' });
  return [off, stl, mesh.write(format, options), mesh.write(format, { encoding: 'binary' })];
}

declare const mesh: HalfedgeMesh;
declare const directed: DirectedEdgesMesh;
declare const someFace: Face;
// Each of these must be an error, or tsc objects to the directive above it.
// @ts-expect-error A face is no halfedge.
mesh.next(someFace);
// @ts-expect-error A halfedge is no vertex.
mesh.valence(mesh.faceHalfedge(0));
// @ts-expect-error Vertices are no faces.
mesh.extract(mesh.vertices());
// @ts-expect-error A string is no index.
mesh.next('0');
// @ts-expect-error There are two directions.
mesh.vertexVertices(0, 'clockwise');
// @ts-expect-error Counts are read only.
mesh.faceCount = 3;
// @ts-expect-error Positions come first.
HalfedgeMesh.fromTriangles([0, 1, 2]);
// @ts-expect-error Not an option.
void init({ url: '/core.wasm' });
// @ts-expect-error A vertex handle is no face handle.
new PolyMesh(mesh).fv_range(new PolyMesh(mesh).vertex_handle(0));
// @ts-expect-error There may be no face on that side.
new HE_mesh(mesh).edge(0).face.edge;
// @ts-expect-error An edge is flipped, not a vertex.
mesh.flipEdge(mesh.addVertex());
// @ts-expect-error No such kind of attribute.
mesh.attributes.add('corner', 'uv');
// @ts-expect-error Nor such a type.
mesh.attributes.add('face', 'group', { type: 'int' });
// @ts-expect-error A face has no vertices around it that circulate by that kind.
mesh.circulate('vertexVertices', someFace);
// @ts-expect-error Nor has it later.
mesh.circulate('vertexVertices', 0).moveTo(someFace);
// @ts-expect-error A face is no edge.
directed.circulate('edgeFaces', someFace).moveTo(0);
// @ts-expect-error Nor is it here.
directed.circulate('edgeFaces', 0).moveTo(someFace);
// @ts-expect-error A face is no vertex.
directed.vertexNormal(someFace);
// @ts-expect-error Normals are floats.
directed.allVertexNormals(new Uint32Array(9));
// @ts-expect-error A face is no vertex, whatever the vertex is asked for.
mesh.deleteComponent('vertex', someFace);
// @ts-expect-error As above.
mesh.checkDeleteComponent('halfedge', someFace);
// @ts-expect-error As above.
mesh.attributes.set('edge', 'weight', someFace, 1);
// @ts-expect-error As above.
mesh.attributes.values('vertex', 'weight', someFace);
// @ts-expect-error As above.
mesh.generations.reference('vertex', someFace);
// @ts-expect-error A reference to a vertex has no face.
mesh.degree(mesh.generations.reference('vertex', 0).index);
// @ts-expect-error Faces are no vertices in a list, either.
mesh.allVertexFaces('ccw', [someFace]);
// @ts-expect-error As above.
mesh.allFaceEdges('ccw', [mesh.toVertex(0)]);
// @ts-expect-error As above.
mesh.allEdgeVertices([someFace]);
// @ts-expect-error As above.
mesh.kRing([someFace], 2);
// @ts-expect-error As above.
mesh.star({ vertices: [someFace] });
// @ts-expect-error As above.
mesh.closure({ edges: [someFace] });
// @ts-expect-error As above.
mesh.link({ faces: [mesh.toVertex(0)] });
// @ts-expect-error A mesh is no options of another one.
new HalfedgeMesh(mesh);
// @ts-expect-error There are levels from 0 to 4.
mesh.validate(5);
// @ts-expect-error As above.
directed.validate(-1);
// @ts-expect-error A mesh of directed edges is checked for its links alone.
directed.validate('geometry');
// @ts-expect-error OBJ is text.
mesh.write('obj', { encoding: 'binary' });
// @ts-expect-error Binary STL has one byte order.
mesh.write('stl', { encoding: 'binary-big-endian' });
// @ts-expect-error Internals are not exported.
export { Links } from 'halfedge';
// @ts-expect-error Nor can they be reached by path.
export { Links as Reached } from 'halfedge/dist/links.js';
`;

const strict = {
  strict: true,
  exactOptionalPropertyTypes: true,
  noUncheckedIndexedAccess: false,
  // The package's types are checked, TypeScript's own are not: that takes seconds.
  skipLibCheck: false,
  skipDefaultLibCheck: true,
  noEmit: true,
  target: 'es2022',
  types: [] as string[],
};

/** What single entries need. */
const PEERS = ['@codemirror', '@lezer', 'acorn', 'lit', 'three', 'three-mesh-bvh'];

/** Compiles the consumer; returns what tsc says, which is nothing if all is well. */
async function compile(
  name: string,
  options: object,
  source = consumer,
  packages: readonly string[] = [],
  compiler = 'typescript',
): Promise<string> {
  const folder = project(name, {
    'package.json': '{ "type": "module", "private": true }',
    'tsconfig.json': JSON.stringify({
      compilerOptions: { ...strict, ...options },
      files: ['consumer.ts'],
    }),
    'consumer.ts': source,
  });
  install(folder, packages);
  const { output } = await tryNode(folder, tool(`${compiler}/bin/tsc`), '-p', '.');
  return output.trim();
}

describe('The types, installed, under strict,', () => {
  test('serve a consumer behind a bundler and refuse wrong uses', async () => {
    expect(await compile('types-bundler', { module: 'esnext', moduleResolution: 'bundler' })).toBe(
      '',
    );
  });

  test('serve one with the oldest TypeScript that the README names', async () => {
    const options = { module: 'esnext', moduleResolution: 'bundler' };
    const source = consumer.replaceAll('Uint8Array<ArrayBuffer>', 'Uint8Array'); // from 5.7 on
    expect(await compile('types-oldest', options, source, [], 'typescript-oldest')).toBe('');
  });

  test('serve a consumer in Node, without the types of the browser', async () => {
    // Of all that Node's own types declare, ours need this; to check those too would take seconds.
    const url =
      'declare global { class URL { constructor(address: string); href: string; } interface AbortSignal {} interface Blob {} }';
    const options = { module: 'nodenext', moduleResolution: 'nodenext', lib: ['es2022'] };
    expect(await compile('types-nodenext', options, url + consumer)).toBe('');
  });

  test('serve a consumer of each entry, who checks them', async () => {
    const { exports } = JSON.parse(
      readFileSync(join(packed.folder, 'installed/node_modules/halfedge/package.json'), 'utf8'),
    );
    const entries = Object.keys(exports).filter((path) => !path.endsWith('.json'));
    const source = entries
      .map((path, i) => `export * as entry${i} from 'halfedge${path.slice(1)}';`)
      .join('\n');
    const options = {
      module: 'esnext',
      moduleResolution: 'bundler',
      exactOptionalPropertyTypes: false, // three.js's own types don't go together under it
    };
    expect(await compile('types-entries', options, source, ['@types/three', ...PEERS])).toBe('');
  });

  test('let React know the figure, as its page says', async () => {
    const page = readFileSync('docs/figure.md', 'utf8');
    const [, declaration] = /## In React.*?```ts\n(.*?)```/s.exec(page) ?? [];
    const source = `
import { createRef, type JSX } from 'react';
type Figure = JSX.IntrinsicElements['halfedge-figure'];
export const figure: Figure = {
  ref: createRef<HalfedgeFigure>(),
  src: 'shape:cube',
  'onhalfedge-select': ({ detail }) => detail.item?.startsWith('v'),
};
// @ts-expect-error: it is an address
export const wrong: Figure = { src: 3 };
${declaration}`;
    const options = { module: 'esnext', moduleResolution: 'bundler', skipLibCheck: true };
    const peers = [...PEERS, '@types/three', '@types/react', 'react', 'csstype'];
    expect(await compile('types-react', options, source, peers)).toBe('');
  });

  test('are ones that TypeScript before 5.7 reads, where no typed array has a parameter', () => {
    const folder = join(packed.folder, 'installed/node_modules/halfedge/dist');
    const telling = filesBelow(folder)
      .filter((path) => /\.d\.(m|wasm\.)?ts$/.test(path))
      .filter((path) => /Array<ArrayBuffer/.test(readFileSync(path, 'utf8')));
    expect(telling).toEqual([]);
  });

  test('have names in the declarations of a program that exports what it gets', async () => {
    const source = `
import { DirectedEdgesMesh, HalfedgeMesh, type ItemKind } from 'halfedge';
export const parts = (mesh: HalfedgeMesh) => ({
  ring: mesh.vertexVertices(0), faces: mesh.faces(), face: mesh.face(0), edge: mesh.findEdge(0, 1),
  circulator: mesh.circulate('vertexFaces', 0), rows: mesh.allFaceFaces(), star: mesh.star({ vertices: [0] }),
  links: mesh.connectivity, attributes: mesh.attributes, view: mesh.attributes.get('vertex', 'normal'),
  history: mesh.history, maps: mesh.compact(), bytes: mesh.toBytes(), ply: mesh.write('ply'),
  problems: mesh.validate(), refusal: mesh.checkFlipEdge(0), report: mesh.fillHoles(), components: mesh.components(),
});
export const directed = (mesh: DirectedEdgesMesh) => [mesh.circulate('faceFaces', 0), mesh.faces(), mesh.connectivity];
export const read = (text: string) => [HalfedgeMesh.parse(text), HalfedgeMesh.parseSoup(text), HalfedgeMesh.fromSoup([], [])];
export const reference = (mesh: HalfedgeMesh, v: number) => mesh.generations.reference('vertex', v);
export const referenceOf = <Kind extends ItemKind>(mesh: HalfedgeMesh, kind: Kind, i: number) => mesh.generations.reference(kind, i);
`;
    const emit = { noEmit: false, declaration: true, emitDeclarationOnly: true, outDir: 'out' };
    expect(await compile('types-declared', { module: 'nodenext', ...emit }, source)).toBe('');
  });

  test('let `using` end the life of a mesh', async () => {
    const source = `
import { HalfedgeMesh } from 'halfedge';
export function count(): number {
  using mesh = new HalfedgeMesh();
  return mesh.vertexCount;
}
`;
    const options = { module: 'nodenext', lib: ['es2022', 'dom', 'esnext.disposable'] };
    expect(await compile('types-using', options, source)).toBe('');
  });

  test('are what tsc reads: a wrong use that is not expected fails', async () => {
    const source = "import { HalfedgeMesh } from 'halfedge';\nnew HalfedgeMesh().next('0');\n";
    const output = await compile('types-wrong', { module: 'nodenext' }, source);
    expect(output).toMatch(/^consumer\.ts\(2,25\): error TS2345: Argument of type 'string'/);
    expect(output.split('error TS')).toHaveLength(2);
  });
});
