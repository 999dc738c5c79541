import { checkCallback, indexOfChoice, refuse } from '../checks.js';
import { counted } from '../counted.js';
import { HalfedgeError } from '../errors.js';
import { messageOf } from '../loader.js';
import { HalfedgeMesh } from '../mesh.js';
import { linksOf } from '../navigation.js';
import { checkOptions, type OptionNames } from '../options.js';
import { triangulateFaces } from '../three/triangulate.js';
import type { OwnBytes } from '../write.js';
import { base64Of } from './base64.js';
import { withAlpha } from './colors.js';
import { makeGlb } from './container.js';
import type { Buffers, Note } from './corners.js';
import { loadExporter, loadThree } from './three.js';
import { checkPositions, writableBuffers } from './writable.js';

/** How to write a glTF file. */
export interface WriteGltfOptions {
  /** `'glb'`, or `'gltf'` for JSON with embedded buffers. Default: 'glb'. */
  format?: 'glb' | 'gltf' | undefined;
  /** Called with a sentence for each thing that is missing or changed in the file. */
  onNote?: ((sentence: string) => void) | undefined;
}

const WRITE_GLTF_OPTIONS: OptionNames<WriteGltfOptions> = { format: true, onNote: true };

/** The bytes of a GLB file, or the text of a glTF file. */
export async function writeMesh(
  mesh: unknown,
  options: WriteGltfOptions,
): Promise<OwnBytes | string> {
  if (!(mesh instanceof HalfedgeMesh)) refuse('mesh', mesh, 'a HalfedgeMesh');
  linksOf(mesh).checkAlive();
  const { format = 'glb', onNote } = checkOptions(options, WRITE_GLTF_OPTIONS);
  indexOfChoice('options.format', format, ['glb', 'gltf']);
  checkCallback('options.onNote', onNote);
  const notes: string[] = [];
  // Now: the mesh may change while three.js is loaded.
  const note: Note = (sentence) => notes.push(sentence);
  const buffers = triangleBuffers(mesh, note);
  const scene = await sceneOf(buffers, note);
  // A GLB file without bytes has no chunk for them; three.js would write an empty one.
  const binary = format === 'glb' && buffers.indices.length > 0;
  const { GLTFExporter } = await loadExporter();
  let content: OwnBytes | string;
  try {
    const written = await withFileReader(() =>
      new GLTFExporter().parseAsync(scene, { binary, onlyVisible: false }),
    );
    if (written instanceof ArrayBuffer) content = new Uint8Array(written);
    else content = format === 'glb' ? new Uint8Array(makeGlb(written)) : JSON.stringify(written);
  } catch (cause) {
    throw new HalfedgeError('write-error', `three.js can't write the mesh: ${messageOf(cause)}.`, {
      cause,
    });
  }
  for (const note of notes) onNote?.(note);
  return content;
}

/** The buffers of a mesh, whose faces are cut into triangles, each for itself. */
function triangleBuffers(mesh: HalfedgeMesh, note: Note): Buffers {
  if (mesh.faceCount === 0) {
    if (mesh.vertexCount > 0) {
      note(`Left out ${counted(mesh.vertexCount, 'vertex', 'vertices')}: there are no faces.`);
    }
    return writableBuffers(mesh, () => {}); // of which nothing is written, so that notes would be false
  }
  checkPositions(mesh);
  if (mesh.isTriangleMesh()) return writableBuffers(mesh, note);
  const { halfedges, faces } = triangulateFaces(mesh);
  const cut = counted(mesh.faceCount, 'face', 'faces');
  note(`Cut ${cut} into ${counted(faces.length, 'triangle')}: glTF has no polygons.`);
  return writableBuffers(mesh, note, halfedges);
}

async function sceneOf({ positions, indices, attributes }: Buffers, note: Note) {
  const { BufferAttribute, BufferGeometry, Mesh, MeshStandardMaterial, Scene, REVISION } =
    await loadThree();
  const scene = new Scene();
  if (indices.length === 0) return scene;
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  const padsRows = Number.parseInt(REVISION, 10) >= PADS_ROWS;
  for (const attribute of attributes) {
    const { name, components, values } = attribute;
    const isInteger = !(values instanceof Float32Array);
    const isOdd = (components * values.BYTES_PER_ELEMENT) % 4 !== 0;
    if (isOdd && !padsRows) {
      note(`Wrote the attribute ${name} with an alpha of 1: three.js ${REVISION} needs it.`);
      geometry.setAttribute(name, new BufferAttribute(withAlpha(attribute), 4, isInteger));
    } else {
      geometry.setAttribute(name, new BufferAttribute(values, components, isInteger));
    }
  }
  geometry.setIndex(new BufferAttribute(indices, 1));
  return scene.add(new Mesh(geometry, new MeshStandardMaterial()));
}

/** From this release on three.js writes rows of integers as glTF wants them, each from a multiple of four bytes on. */
const PADS_ROWS = 163;

/** Ends each call that goes on now with what its file couldn't be read for. */
const running = new Set<(cause: unknown) => void>();

/** three.js's exporter reads blobs by a class that Node doesn't have: there it gets one meanwhile. */
async function withFileReader<T>(use: () => Promise<T>): Promise<T> {
  const scope = globalThis as { FileReader?: unknown };
  if (running.size === 0 && scope.FileReader !== undefined) return use();
  let fail: (cause: unknown) => void = () => {};
  const failure = new Promise<never>((_, reject) => {
    fail = reject;
  });
  scope.FileReader = BlobReader;
  running.add(fail);
  try {
    return await Promise.race([use(), failure]);
  } finally {
    running.delete(fail);
    if (running.size === 0) delete scope.FileReader;
  }
}

/** As much of a FileReader as the exporter uses. */
class BlobReader {
  result: ArrayBuffer | string | null = null;
  onloadend: (() => void) | null = null;

  readAsArrayBuffer(blob: Blob): void {
    this.#read(blob, (buffer) => buffer);
  }

  readAsDataURL(blob: Blob): void {
    this.#read(blob, (buffer) => `data:${blob.type};base64,${base64Of(new Uint8Array(buffer))}`);
  }

  /**
   * The exporter asks for no errors, and throws out of `onloadend` where it has no memory: its promise
   * would never settle. Whose blob it was isn't known here, so all that is being written fails.
   */
  #read(blob: Blob, as: (buffer: ArrayBuffer) => ArrayBuffer | string): void {
    blob
      .arrayBuffer()
      .then((buffer) => {
        this.result = as(buffer);
        this.onloadend?.();
      })
      .catch((cause) => {
        for (const fail of running) fail(cause);
      });
  }
}
