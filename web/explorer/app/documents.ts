import { type AttributeNames, HalfedgeError, HalfedgeMesh, type ProgressOptions } from 'halfedge';
import type { BrokenSample } from '../samples/broken.js';
import type { Sample } from '../samples/index.js';
import { type Diagnosis, diagnose } from './diagnosis.js';
import {
  adviceFor,
  fetching,
  GLTF_READER,
  LARGE_FILE_READER,
  loadPackage,
  ofPage,
} from './fetching.js';

/** A mesh on show, and where it came from. */
export interface MeshDocument {
  readonly name: string;
  /** What a file of it is called, without an extension. */
  readonly stem: string;
  readonly mesh: HalfedgeMesh;
  /** The id of the sample, or null for a file of the user. */
  readonly sample: string | null;
  /** The vertex that is selected first; null for one in the middle of the picture. */
  readonly start: number | null;
  /** What was found wrong in the file; null if nothing was, or there is no file. */
  readonly diagnosis: Diagnosis | null;
  /** Of a broken sample: what is wrong with it, and what to look at. */
  readonly lesson: string | null;
  /** The words for the numbers of its attributes, of an OBJ file. */
  readonly names: AttributeNames;
  /** From where the mesh is first seen. */
  readonly view: readonly [number, number, number];
}

/** A sentence for somebody whose file or sample could not be opened. */
export interface OpenFailure {
  readonly title: string;
  readonly message: string;
  /** Of a broken sample that can't be read: why it is there. */
  readonly lesson: string | null;
  /** What to do, where opening another mesh doesn't help. */
  readonly advice?: string | null;
}

/** What can be opened. */
export type Source = Sample | BrokenSample | File;

/** How it is opened. */
export interface OpenOptions extends ProgressOptions {
  /** Files that came with it, which a glTF file may refer to. */
  readonly companions?: readonly File[];
}

const FORMATS = ['obj', 'off', 'ply', 'stl'] as const;

/** What the page reads, as extensions. */
export const EXTENSIONS = [...FORMATS, 'glb', 'gltf'] as const;

/** The end of the name of such a file. */
const OF_FILE = new RegExp(`\\.(${EXTENSIONS.join('|')})$`, 'i');

/** Files that are larger are read in another thread, so that the page can go on. */
const LARGE_FILE = 2 ** 20;

export async function openSource(source: Source, options: OpenOptions = {}): Promise<MeshDocument> {
  await loadPackage();
  if (source instanceof File) return openFile(source, options);
  return 'load' in source ? openSample(source) : openBrokenSample(source);
}

async function openSample({ id, name, start, view, load }: Sample): Promise<MeshDocument> {
  const mesh = await load();
  return {
    name,
    stem: id,
    mesh,
    sample: id,
    start,
    diagnosis: null,
    lesson: null,
    names: {},
    view,
  };
}

function openBrokenSample({ id, name, view, lesson, file }: BrokenSample): MeshDocument {
  const { extension, content } = file();
  const bytes = typeof content === 'string' ? new TextEncoder().encode(content) : content;
  const opened = openContent(`${id}.${extension}`, bytes);
  return { ...opened, name, sample: id, lesson, view };
}

/** Reads a file; throws what the readers of the package throw, or the reason of the signal. */
async function openFile(file: File, options: OpenOptions): Promise<MeshDocument> {
  if (/\.(glb|gltf)$/i.test(file.name)) return openGltf(file, options);
  try {
    if (file.size >= LARGE_FILE) return await openElsewhere(file, options);
    return openContent(file.name, new Uint8Array(await file.arrayBuffer()));
  } catch (error) {
    if (isOfGltf(error)) return openGltf(file, options);
    throw isOfBuffer(file, error) ? new Error(LONE_BUFFER, { cause: error }) : error;
  }
}

/** Whether the readers of the other formats found glTF, which had another name. */
function isOfGltf(error: unknown): boolean {
  if (!(error instanceof HalfedgeError)) return false;
  return error.code === 'unsupported-format' && /GLB|glTF/.test(error.message);
}

const LONE_BUFFER =
  'It is no mesh by itself. If it is the buffer of a glTF file, choose or drop both together.';

/** Whether it may be the numbers that a glTF file refers to, in which no reader finds a format. */
function isOfBuffer({ name }: File, error: unknown): boolean {
  if (!(error instanceof HalfedgeError && /\.bin$/i.test(name))) return false;
  return error.code === 'unknown-format' || error.code === 'not-text';
}

/** What is wrong in it is told as far as the report does: its polygons are not those of a text. */
async function openGltf(file: File, { companions = [] }: OpenOptions): Promise<MeshDocument> {
  // Only pages that open such a file load three.js's reader of them.
  const readers = Promise.all([
    import('halfedge/gltf'),
    import('three/addons/loaders/DRACOLoader.js'),
  ]);
  const [{ readGltf }, { DRACOLoader }] = await fetching(GLTF_READER, readers);
  const dracoLoader = new DRACOLoader(); // it loads its decoder where it is needed
  const content = await file.arrayBuffer();
  const resource = (uri: string) => companionOf(uri, companions);
  const { mesh, report } = await readGltf(content, { resource, dracoLoader }).finally(() =>
    dracoLoader.dispose(),
  );
  const isRepaired = report.problems.some(({ severity }) => severity !== 'info');
  return { ...newDocument(file.name, mesh), lesson: isRepaired ? report.summary : null };
}

function companionOf(uri: string, companions: readonly File[]): Promise<ArrayBuffer> {
  const names = [uri, decoded(uri)].map((each) => each.split('/').at(-1));
  const found = companions.find(({ name }) => names.includes(name));
  if (found) return found.arrayBuffer();
  throw new Error(`This glTF file needs its buffer “${uri}”: choose or drop both together.`);
}

/** As it stands, where it was not written as an address: `50%.bin`. */
function decoded(uri: string): string {
  try {
    return decodeURIComponent(uri);
  } catch {
    return uri;
  }
}

async function openElsewhere(
  file: File,
  { signal, onProgress }: OpenOptions,
): Promise<MeshDocument> {
  const { parseInWorker } = await fetching(LARGE_FILE_READER, import('halfedge/worker'));
  const format = formatOf(file.name);
  const { mesh, report } = await parseInWorker(file, {
    ...(format ? { format } : {}),
    ...(signal ? { signal } : {}),
    ...(onProgress ? { onProgress } : {}),
  });
  const { names, problems } = report;
  try {
    const content = problems.length > 0 ? await file.arrayBuffer() : new ArrayBuffer(0);
    const diagnosis = diagnose(new Uint8Array(content), format, report);
    return { ...newDocument(file.name, mesh), names, diagnosis };
  } catch (error) {
    mesh.dispose();
    throw error;
  }
}

/** Mends what makes no manifold. */
function openContent(name: string, content: Uint8Array): MeshDocument {
  const format = formatOf(name);
  const { mesh, report } = HalfedgeMesh.parse(content, format ? { format } : {});
  const { names } = report;
  try {
    return { ...newDocument(name, mesh), names, diagnosis: diagnose(content, format, report) };
  } catch (error) {
    mesh.dispose();
    throw error;
  }
}

function formatOf(name: string): (typeof FORMATS)[number] | undefined {
  const extension = name.slice(name.lastIndexOf('.') + 1).toLowerCase();
  return FORMATS.find((known) => known === extension);
}

/** A mesh that comes from no sample. */
export function newDocument(name: string, mesh: HalfedgeMesh): MeshDocument {
  const dot = name.lastIndexOf('.');
  return {
    name,
    stem: dot > 0 ? name.slice(0, dot) : name,
    mesh,
    sample: null,
    start: null,
    diagnosis: null,
    lesson: null,
    names: {},
    view: [0.35, 0.3, 1],
  };
}

/** What a file of a mesh is called that was made of a file, or came from one by a link: `Dual of scan` of `Dual of scan.ply`. */
export function stemOfMade(name: string): string {
  return name.replace(OF_FILE, '') || name;
}

/** The text of a mesh as a file, by what it begins with; null if it is none. */
export function fileOfText(text: string): File | null {
  const line = text.split(/\r?\n/).find((each) => /^\s*[^\s#]/.test(each)) ?? '';
  const beginnings: [RegExp, string][] = [
    [/^\s*ply\b/i, 'ply'],
    [/^\s*(ST)?(C)?(N)?(4)?n?OFF\b/i, 'off'],
    [/^\s*solid\b/i, 'stl'],
    [/^\s*\{\s*("|$)/, 'gltf'],
    [/^\s*(v|vt|vn|vp|f|l|p|o|g|mtllib|usemtl|s)\s/, 'obj'],
  ];
  const extension = beginnings.find(([beginning]) => beginning.test(line))?.[1];
  return extension ? new File([text], `Pasted mesh.${extension}`) : null;
}

export function failureOf(
  thrown: unknown,
  source: Source | { readonly name: string },
): OpenFailure {
  const error = ofPage(thrown);
  const message = ofAllFormats(error instanceof Error ? error.message : String(error));
  const lesson = 'lesson' in source ? source.lesson : null;
  const title = `“${source.name}” was not opened`;
  return { title, message, lesson, advice: adviceFor(error) };
}

/** A sentence of the readers of text formats and STL, with glTF, which the page reads as well. */
function ofAllFormats(message: string): string {
  return message.replace('an OBJ, OFF, PLY or STL file', 'an OBJ, OFF, PLY, STL, GLB or glTF file');
}
