import { HalfedgeMesh } from '../api.js';
import { counted } from '../counted.js';
import { SHAPES } from '../shapes.js';
import { type FaceList, faceListOf } from './build-story.js';

/** Where the mesh of a figure comes from: an address, a shape by its name, or the text of a file. */
export interface Source {
  readonly src: string | null;
  /** The text of a file inside of the element. */
  readonly text: string | null;
  /** What `HalfedgeMesh.toBytes` has written: goes before the others. */
  readonly bytes: Uint8Array | null;
}

const FORMATS = ['obj', 'off', 'ply', 'stl'] as const;
/** One of the static methods of `HalfedgeMesh` that make shapes, and its parameters. */
const SHAPE = /^shape:\s*(\w+)\s*(?:\(([^()]*)\))?\s*$/;

/** How many numbers a shape takes before its options, each of which can be left out; none if it isn't here. */
const NUMBERS: Partial<Record<(typeof SHAPES)[number], number>> = {
  prism: 1,
  cone: 1,
  cylinder: 1,
  grid: 2,
  torus: 2,
  uvSphere: 2,
  icoSphere: 1,
};

/** What could not be reached, for now: it may be later. */
export class Unreached extends Error {
  override readonly name = 'Unreached';
}

/** The mesh of a figure. Throws a sentence where there is none. */
export async function openSource(
  { src, text, bytes }: Source,
  signal: AbortSignal,
): Promise<HalfedgeMesh> {
  if (bytes) return HalfedgeMesh.fromBytes(bytes);
  if (src?.startsWith('shape:')) return shapeOf(src);
  if (src) return fetchMesh(addressOf(src), signal);
  if (text?.trim()) return HalfedgeMesh.parse(text).mesh;
  throw new Error(
    'This figure has no mesh: expected src="…", or the text of an OBJ, OFF, PLY or STL file in a <script type="text/plain"> inside of it.',
  );
}

function addressOf(src: string): URL {
  try {
    return new URL(src, document.baseURI);
  } catch {
    throw new Error(`src is “${src}”; expected the address of a file, or shape: and a shape.`);
  }
}

/** The faces of the source as they are listed there, good or bad. */
export async function openFaces(source: Source, signal: AbortSignal): Promise<FaceList> {
  if (!source.bytes && !source.src && source.text?.trim()) {
    const { positions, faces } = HalfedgeMesh.parseSoup(source.text);
    let at = 0;
    return {
      positions,
      faces: [...faces.sizes].map((size) => {
        at += size;
        return [...faces.corners.subarray(at - size, at)];
      }),
    };
  }
  const mesh = await openSource(source, signal);
  try {
    return faceListOf(mesh);
  } finally {
    mesh.dispose();
  }
}

/**
 * A shape as it would be called: `shape:torus(8, 6)`; options are words or assignments, as in
 * `shape:grid(4, 3, triangles)` and `shape:cylinder(8, rings=2, caps=open)`.
 */
function shapeOf(src: string): HalfedgeMesh {
  const [, name, list = ''] = SHAPE.exec(src) ?? [];
  const shape = SHAPES.find((known) => known === name);
  if (!shape) {
    const begun = SHAPES.find((known) => src.startsWith(`shape:${known}(`));
    const expected = begun ? `shape:${begun}(…), closed` : `shape: and one of ${SHAPES.join(', ')}`;
    throw new Error(`src is “${src}”; expected ${expected}.`);
  }
  const parts: number[] = [];
  const options: Record<string, unknown> = {};
  for (const word of list.split(',').map((it) => it.trim())) {
    const [key, value] = word.split('=').map((it) => it.trim());
    if (word === '') continue;
    if (value !== undefined) options[key] = optionOf(value);
    else if (/^[a-z]\w*$/i.test(key)) options[key] = true;
    else if (Number.isNaN(Number(key))) {
      throw new Error(`src is “${src}”; expected commas between numbers, found “${key}”.`);
    } else parts.push(Number(key));
  }
  const most = NUMBERS[shape] ?? 0;
  if (parts.length > most) {
    const expected = most === 0 ? 'no number' : `${counted(most, 'number')} at most`;
    throw new Error(`src is “${src}”; expected ${expected}.`);
  }
  // Numbers that are left out have defaults.
  const numbers = Array.from({ length: most }, (_, i) => parts[i]);
  const make = HalfedgeMesh[shape] as (...parameters: unknown[]) => HalfedgeMesh;
  try {
    return make.call(HalfedgeMesh, ...numbers, options);
  } catch (cause) {
    throw new Error(`src is “${src}”: ${(cause as Error).message}`, { cause });
  }
}

function optionOf(text: string): unknown {
  if (text === 'true' || text === 'false') return text === 'true';
  return Number.isFinite(Number(text)) ? Number(text) : text;
}

async function fetchContent(address: URL, signal: AbortSignal): Promise<ArrayBuffer> {
  let response: Response;
  try {
    response = await fetch(address, { signal });
  } catch (cause) {
    signal.throwIfAborted();
    throw new Unreached(`${address.href} could not be fetched.`, { cause });
  }
  if (!response.ok) {
    throw new Unreached(
      `${address.href} could not be fetched: the server answered ${response.status}.`,
    );
  }
  const content = await response.arrayBuffer();
  signal.throwIfAborted();
  return content;
}

async function fetchMesh(address: URL, signal: AbortSignal): Promise<HalfedgeMesh> {
  const content = await fetchContent(address, signal);
  if (/\.(glb|gltf)$/i.test(address.pathname)) {
    // Only pages that show such a file load three.js's reader of them.
    const { readGltf } = await import('../gltf/index.js');
    const resource = (uri: string) => fetchContent(new URL(uri, address), signal);
    return (await readGltf(content, { resource })).mesh;
  }
  const extension = address.pathname.slice(address.pathname.lastIndexOf('.') + 1).toLowerCase();
  const format = FORMATS.find((known) => known === extension);
  return HalfedgeMesh.parse(content, format ? { format } : {}).mesh;
}
