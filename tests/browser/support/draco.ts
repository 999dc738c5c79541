import { readFileSync } from 'node:fs';
import type { HalfedgeMesh } from 'halfedge';

interface DracoBytes {
  GetValue(i: number): number;
}

/** What is used of Draco's encoder. */
interface Draco {
  readonly POSITION: number;
  readonly MESH_SEQUENTIAL_ENCODING: number;
  readonly Mesh: new () => object;
  readonly DracoInt8Array: new () => DracoBytes;
  readonly MeshBuilder: new () => {
    AddFacesToMesh(mesh: object, faces: number, corners: Uint32Array): boolean;
    AddFloatAttributeToMesh(
      ...all: [mesh: object, kind: number, rows: number, width: number, values: Float32Array]
    ): number;
  };
  readonly Encoder: new () => {
    SetEncodingMethod(method: number): void;
    EncodeMeshToDracoBuffer(mesh: object, to: DracoBytes): number;
  };
}

/**
 * The encoder that older releases of three.js have beside their exporter: a script that sets a variable. What it
 * makes has a `then` that gives the same once more, so that to await it would never end.
 */
async function loadEncoder(): Promise<Draco> {
  const path = 'node_modules/three-oldest/examples/jsm/libs/draco/draco_encoder.js';
  const script = new Function(`${readFileSync(path, 'utf8')}\nreturn DracoEncoderModule;`);
  const module: Draco & { then?: (made: () => void) => void } = script()();
  await new Promise<void>((resolve) => {
    module.then?.(() => {
      delete module.then;
      resolve();
    });
  });
  return module as Draco;
}

/** A glTF document whose triangles Draco has compressed, exactly and in their order. */
export async function dracoGltf(mesh: HalfedgeMesh): Promise<string> {
  const draco = await loadEncoder();
  const { indices } = mesh.toTriangles();
  const compressed = new draco.Mesh();
  const builder = new draco.MeshBuilder();
  builder.AddFacesToMesh(compressed, indices.length / 3, indices);
  const position = builder.AddFloatAttributeToMesh(
    ...[compressed, draco.POSITION, mesh.vertexCount, 3, mesh.positions.slice()],
  );
  const encoder = new draco.Encoder();
  encoder.SetEncodingMethod(draco.MESH_SEQUENTIAL_ENCODING);
  const to = new draco.DracoInt8Array();
  const byteLength = encoder.EncodeMeshToDracoBuffer(compressed, to);
  const bytes = Buffer.from(Array.from({ length: byteLength }, (_, i) => to.GetValue(i)));
  const name = 'KHR_draco_mesh_compression';
  const extensions = { [name]: { bufferView: 0, attributes: { POSITION: position } } };
  return JSON.stringify({
    asset: { version: '2.0' },
    extensionsUsed: [name],
    extensionsRequired: [name],
    buffers: [
      { byteLength, uri: `data:application/octet-stream;base64,${bytes.toString('base64')}` },
    ],
    bufferViews: [{ buffer: 0, byteLength }],
    accessors: [
      { componentType: 5126, count: mesh.vertexCount, type: 'VEC3' },
      { componentType: 5125, count: indices.length, type: 'SCALAR' },
    ],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1, extensions }] }],
  });
}
