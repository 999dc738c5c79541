// glTF and GLB, through the loader and the exporter of three.js (a peer dependency of this entry alone).

import type { HalfedgeMesh } from '../mesh.js';
import type { OwnBytes } from '../write.js';
import {
  type GltfPart,
  type GltfReport,
  type ReadGltfOptions,
  readParts,
  readWhole,
} from './read.js';
import { type WriteGltfOptions, writeMesh } from './write.js';

export type { GltfResources } from './buffers.js';
export type { GltfDecoders } from './prepare.js';
export type { GltfPart, GltfReport, ReadGltfOptions } from './read.js';
export type { WriteGltfOptions } from './write.js';

/**
 * The triangles of the scene in a glTF or GLB file, as one mesh: those of all nodes, where they stand in
 * the scene. Strips and fans become triangles. Vertices at the same position are welded, and what makes no
 * manifold is mended as by `HalfedgeMesh.fromSoup`.
 *
 * Normals, colours and texture coordinates become the attributes `normal`, `color` and `uv`: of vertices,
 * or of halfedges (corners) where the corners at a vertex differ. Materials, textures, animations, skins
 * and morph targets are not read. Works in Node as well.
 *
 * ```ts
 * import { readGltf } from 'halfedge/gltf';
 * const { mesh, report } = await readGltf(new URL('duck.glb', document.baseURI));
 * ```
 *
 * @param data the content of the file, or its address. Buffers in other files are found by `baseUrl` or
 * `resource`
 * @throws HalfedgeError with what was expected where: `unknown-format`, `not-text`, `parse-error`, `truncated`,
 * `unsupported-format` (compressed geometry without a decoder in the options, ...), `missing-resource`,
 * `too-large`, `missing-dependency` (three.js is not installed), `out-of-memory`, `not-initialised`; with
 * `repair: false` the first thing that would have to be mended. TypeError or RangeError for wrong arguments, and whatever
 * `options.resource` throws
 */
export function readGltf(
  data: URL | string | ArrayBuffer | ArrayBufferView,
  options: ReadGltfOptions = {},
): Promise<{ mesh: HalfedgeMesh; report: GltfReport }> {
  return readWhole(data, options);
}

/**
 * As {@link readGltf}, with a mesh for each primitive of each node.
 *
 * @throws what {@link readGltf} throws; no mesh is left behind then
 */
export function readGltfParts(
  data: URL | string | ArrayBuffer | ArrayBufferView,
  options: ReadGltfOptions = {},
): Promise<GltfPart[]> {
  return readParts(data, options);
}

/**
 * A GLB file of a mesh, or a glTF file with its buffers in it. Positions keep all their bits. Polygons are
 * cut into triangles, as `mesh.triangulate()` does; vertices are doubled where the corners at them have
 * different attributes. `normal`, `uv` and `color` are written, of vertices or of halfedges; `onNote` tells
 * what is left out, and what was changed: normals are brought to length 1. A mesh without faces becomes an empty scene.
 *
 * @throws HalfedgeError `missing-dependency` (three.js is not installed), `out-of-memory`, `disposed`,
 * `non-finite-position`, `no-triangulation` and the like where `mesh.triangulate()` fails, `write-error` where three.js does; TypeError
 * or RangeError for wrong arguments
 */
export function writeGltf(
  mesh: HalfedgeMesh,
  options: WriteGltfOptions & { format: 'gltf' },
): Promise<string>;
export function writeGltf(
  mesh: HalfedgeMesh,
  options?: WriteGltfOptions & { format?: 'glb' | undefined },
): Promise<OwnBytes>;
export function writeGltf(
  mesh: HalfedgeMesh,
  options?: WriteGltfOptions,
): Promise<OwnBytes | string>;
export function writeGltf(
  mesh: HalfedgeMesh,
  options: WriteGltfOptions = {},
): Promise<OwnBytes | string> {
  return writeMesh(mesh, options);
}
