import { checkOptions, describe } from '../arguments.js';
import { HalfedgeError } from '../errors.js';
import { messageOf } from '../loader.js';
import { HalfedgeMesh } from '../mesh.js';
import { linksOf } from '../navigation.js';
import { buffersOf } from './corners.js';
import { loadExporter, loadThree } from './three.js';

/** How to write a glTF file. */
export interface WriteGltfOptions {
  /** `'glb'`, or `'gltf'` for JSON with the buffers in it. Default: 'glb'. */
  format?: 'glb' | 'gltf';
}

/** The bytes of a GLB file, or the text of a glTF file. */
export async function writeMesh(
  mesh: unknown,
  options: WriteGltfOptions,
): Promise<Uint8Array | string> {
  const { format = 'glb' } = checkOptions(options) as WriteGltfOptions;
  if (format !== 'glb' && format !== 'gltf') {
    throw new TypeError(`options.format is ${describe(format)}; expected 'glb' or 'gltf'.`);
  }
  if (!(mesh instanceof HalfedgeMesh)) {
    throw new TypeError(`mesh is ${describe(mesh)}; expected a HalfedgeMesh.`);
  }
  linksOf(mesh).checkAlive();
  const triangles = mesh.isTriangleMesh() ? mesh : mesh.clone();
  let buffers: ReturnType<typeof buffersOf>;
  try {
    if (triangles !== mesh) triangles.triangulate();
    buffers = buffersOf(triangles); // now: the mesh may change while three.js is loaded
  } finally {
    if (triangles !== mesh) triangles.dispose();
  }
  const scene = await sceneOf(buffers);
  const { GLTFExporter } = await loadExporter();
  try {
    const written = await withFileReader(() =>
      new GLTFExporter().parseAsync(scene, { binary: format === 'glb', onlyVisible: false }),
    );
    return written instanceof ArrayBuffer ? new Uint8Array(written) : JSON.stringify(written);
  } catch (cause) {
    throw new HalfedgeError('write-error', `three.js can't write the mesh: ${messageOf(cause)}.`, {
      cause,
    });
  }
}

async function sceneOf({ positions, indices, attributes }: ReturnType<typeof buffersOf>) {
  const { BufferAttribute, BufferGeometry, Mesh, MeshStandardMaterial, Scene } = await loadThree();
  const scene = new Scene();
  if (indices.length === 0) return scene;
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  for (const { name, components, values } of attributes) {
    const isInteger = !(values instanceof Float32Array);
    geometry.setAttribute(name, new BufferAttribute(values, components, isInteger));
  }
  geometry.setIndex(new BufferAttribute(indices, 1));
  return scene.add(new Mesh(geometry, new MeshStandardMaterial()));
}

let writing = 0;

/** three.js's exporter reads blobs by a class that Node doesn't have: there it gets one meanwhile. */
async function withFileReader<T>(use: () => Promise<T>): Promise<T> {
  const scope = globalThis as { FileReader?: unknown };
  if (writing === 0 && scope.FileReader !== undefined && scope.FileReader !== BlobReader)
    return use();
  scope.FileReader = BlobReader;
  writing += 1;
  try {
    return await use();
  } finally {
    writing -= 1;
    if (writing === 0) delete scope.FileReader;
  }
}

/** As much of a FileReader as the exporter uses. */
class BlobReader {
  result: ArrayBuffer | string | null = null;
  onloadend: (() => void) | null = null;

  readAsArrayBuffer(blob: Blob): void {
    void blob.arrayBuffer().then((buffer) => this.#end(buffer));
  }

  readAsDataURL(blob: Blob): void {
    void blob.arrayBuffer().then((buffer) => {
      const bytes = new Uint8Array(buffer);
      let text = '';
      for (let i = 0; i < bytes.length; i += 0x8000) {
        text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
      }
      this.#end(`data:${blob.type};base64,${btoa(text)}`);
    });
  }

  #end(result: ArrayBuffer | string): void {
    this.result = result;
    this.onloadend?.();
  }
}
