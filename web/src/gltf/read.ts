import type { InstancedMesh, Mesh } from 'three';
import { checkCallback, checkFlag, refuse } from '../checks.js';
import { HalfedgeError } from '../errors.js';
import { contentOf } from '../file-content.js';
import { messageOf } from '../loader.js';
import { HalfedgeMesh } from '../mesh.js';
import { type OptionNames, takeOptions } from '../options.js';
import {
  type RepairReport,
  refuseMended,
  SOUP_OPTIONS,
  type SoupOptions,
  soupOptions,
} from '../repair.js';
import { fileReport } from '../reports.js';
import { type GltfResources, joinBuffers, load } from './buffers.js';
import { noteOfCoarse } from './coarse.js';
import { fileError, makeGlb, openGltf } from './container.js';
import { addAttributes } from './corners.js';
import { checkDocument, type GltfDocument } from './document.js';
import { cornersLeft, join, type Triangles, trianglesOf, unfitting } from './geometry.js';
import { isCompressed } from './meshopt.js';
import { type GltfDecoders, prepare } from './prepare.js';
import { packRows } from './rows.js';
import { loadLoader, loadMeshoptDecoder, loadThree } from './three.js';

/** How to read a glTF file. */
export interface ReadGltfOptions extends SoupOptions, GltfResources, GltfDecoders {
  /**
   * As for `HalfedgeMesh.fromSoup`, except that exact welding is the default, because buffers repeat the
   * vertices along the seams of normals, colours and texture coordinates.
   */
  weld?: boolean | number | undefined;
  /**
   * Whether faces that don't form a manifold are repaired and reported; otherwise they are an error. Default:
   * true.
   */
  repair?: boolean | undefined;
}

const READ_GLTF_OPTIONS: OptionNames<ReadGltfOptions> = {
  ...SOUP_OPTIONS,
  repair: true,
  baseUrl: true,
  resource: true,
  dracoLoader: true,
  meshoptDecoder: true,
};

/**
 * What reading a file has found. Vertices and faces of the input are those of its buffers, one after the
 * other.
 */
export interface GltfReport extends RepairReport {
  readonly format: 'glb' | 'gltf';
}

/** One primitive of a file. */
export interface GltfPart {
  /** The name of its mesh in the file; empty if it has none. */
  readonly name: string;
  readonly mesh: HalfedgeMesh;
  readonly report: GltfReport;
}

/** All triangles of a file as one mesh. */
export async function readWhole(
  data: unknown,
  given: ReadGltfOptions,
): Promise<{ mesh: HalfedgeMesh; report: GltfReport }> {
  const options = takeReadOptions(given);
  const { format, parts, notes } = await loadParts(data, options);
  const whole = join(
    parts.map(({ triangles }) => triangles),
    (sentence) => notes.push(sentence),
  );
  return meshOf('the scene', whole, format, notes, options);
}

/** A mesh for each primitive of a file. */
export async function readParts(data: unknown, given: ReadGltfOptions): Promise<GltfPart[]> {
  const options = takeReadOptions(given);
  const { format, parts, notes } = await loadParts(data, options);
  const made: GltfPart[] = [];
  try {
    for (const { name, triangles } of parts) {
      const what = `part ${made.length}`;
      made.push({ name, ...meshOf(what, triangles, format, notes, options) });
    }
  } catch (error) {
    for (const { mesh } of made) mesh.dispose();
    throw error;
  }
  return made;
}

const isUrl = (value: unknown): value is URL =>
  Object.prototype.toString.call(value) === '[object URL]';

interface Loaded {
  readonly format: 'glb' | 'gltf';
  readonly parts: { readonly name: string; readonly triangles: Triangles }[];
  readonly notes: string[];
}

const CONTENT = 'a URL, or the content of a glTF file as a string, an ArrayBuffer or a Uint8Array';

async function loadParts(data: unknown, options: ReadGltfOptions): Promise<Loaded> {
  const bytes = isUrl(data) ? await load(data) : contentOf(data, CONTENT);
  const file = openGltf(bytes);
  const { document, notes } = prepare(checkDocument(file.json), options, bytes.length);
  const base = isUrl(data) ? { baseUrl: data } : {};
  const joined = await joinBuffers(document, file, { ...base, ...options });
  const packed = packRows(joined.document, joined.binary);
  const glb = makeGlb(packed.document, packed.binary);
  const { scene, parser } = await loadScene(glb, await decodersFor(document, options));
  const { Matrix4 } = await loadThree();
  const parts: Loaded['parts'] = [];
  scene.updateMatrixWorld(true);
  const meshes: Mesh[] = [];
  scene.traverse((object) => {
    if ('isMesh' in object) meshes.push(object as Mesh);
  });
  checkCorners(meshes);
  const left = meshes.reduce((sum, { geometry }) => sum + cornersLeft(geometry), 0);
  if (left > 0) notes.push(`Ignored corners behind the last triangle of a primitive (${left}).`);
  for (const name of new Set(meshes.flatMap(({ geometry }) => unfitting(geometry)))) {
    const count = meshes.filter(({ geometry }) => unfitting(geometry).includes(name)).length;
    notes.push(`Ignored ${name} of primitives where it does not fit the positions (${count}).`);
  }
  for (const mesh of meshes) {
    const which = parser.associations.get(mesh)?.meshes ?? -1;
    const name = document.meshes[which]?.name ?? ''; // three.js changes it to what may be in a path
    for (let i = 0; i < instancesOf(mesh); i++) {
      const matrix = new Matrix4();
      if (isInstanced(mesh)) mesh.getMatrixAt(i, matrix);
      parts.push({ name, triangles: trianglesOf(mesh, matrix.premultiply(mesh.matrixWorld)) });
    }
  }
  return { format: file.format, parts, notes };
}

const isInstanced = (mesh: Mesh): mesh is InstancedMesh => 'isInstancedMesh' in mesh;
const instancesOf = (mesh: Mesh) => (isInstanced(mesh) ? mesh.count : 1);

/** A few bytes of a file can place a mesh once more, which takes as much memory as the mesh. */
function checkCorners(meshes: readonly Mesh[]): void {
  let count = 0;
  for (const mesh of meshes) {
    const { index, attributes } = mesh.geometry;
    count += instancesOf(mesh) * Math.max(index?.count ?? 0, attributes.position.count);
  }
  if (count <= MOST_CORNERS) return;
  throw fileError(
    'too-large',
    `glTF: the scene has ${count} corners, those of a mesh as often as nodes place it, expected at most ${MOST_CORNERS}.`,
  );
}

/** With 64 bytes for each, which is little, all memory of WebAssembly is used up. */
const MOST_CORNERS = 2 ** 26;

/** Before anything is fetched; `HalfedgeMesh.fromSoup` checks them once more. */
function takeReadOptions(given: ReadGltfOptions): ReadGltfOptions {
  const options = takeOptions(given, READ_GLTF_OPTIONS);
  const { repair = true, baseUrl = '', resource } = options;
  checkFlag('options.repair', repair);
  if (typeof baseUrl !== 'string' && !isUrl(baseUrl)) {
    refuse('options.baseUrl', baseUrl, 'a URL or a string');
  }
  checkCallback('options.resource', resource);
  checkDecoder('options.dracoLoader', options.dracoLoader, 'preload', 'a DRACOLoader of three.js');
  checkDecoder('options.meshoptDecoder', options.meshoptDecoder, 'supported', 'a MeshoptDecoder');
  soupOptions(options);
  return options;
}

/** Throws unless it has what three.js asks of it first, or is nothing. */
function checkDecoder(argument: string, decoder: unknown, has: string, expected: string): void {
  if (decoder !== undefined && !(has in Object(decoder))) refuse(argument, decoder, expected);
}

/** Those that were given, and three.js's where a file needs one that comes as a module. */
async function decodersFor(
  { bufferViews }: GltfDocument,
  { dracoLoader, meshoptDecoder }: GltfDecoders,
): Promise<GltfDecoders> {
  if (meshoptDecoder !== undefined || !bufferViews.some(isCompressed)) {
    return { dracoLoader, meshoptDecoder };
  }
  return { dracoLoader, meshoptDecoder: await loadMeshoptDecoder() };
}

/** The scene, as three.js's own loader makes it. */
async function loadScene(glb: ArrayBuffer, { dracoLoader, meshoptDecoder }: GltfDecoders) {
  const { GLTFLoader } = await loadLoader();
  const loader = new GLTFLoader();
  if (dracoLoader !== undefined) loader.setDRACOLoader(dracoLoader as never);
  if (meshoptDecoder !== undefined) loader.setMeshoptDecoder(meshoptDecoder as never);
  try {
    return await loader.parseAsync(glb, '');
  } catch (cause) {
    const why = messageOf(cause).replace(/^THREE\.GLTFLoader: /, '');
    throw new HalfedgeError('parse-error', `glTF: three.js can't read the file: ${why}.`, {
      cause,
    });
  }
}

function meshOf(
  what: string,
  { positions, indices, attributes }: Triangles,
  format: GltfReport['format'],
  notes: string[],
  { repair = true, weld = true, dropIsolated = false, storePrev = true }: ReadGltfOptions,
): { mesh: HalfedgeMesh; report: GltfReport } {
  const settings = { weld, dropIsolated, storePrev };
  const { mesh, report } = HalfedgeMesh.fromSoup(positions, indices, settings);
  try {
    if (!repair) refuseMended(report, `glTF: ${what}`);
    addAttributes(mesh, report, indices, attributes);
  } catch (error) {
    mesh.dispose();
    throw error;
  }
  const name = format === 'glb' ? 'GLB' : 'glTF';
  const allNotes = [...notes, ...noteOfCoarse(positions)];
  return { mesh, report: { ...fileReport(name, mesh, report, allNotes), format } };
}
