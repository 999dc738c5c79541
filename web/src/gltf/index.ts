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
 * Reads the scene of a glTF or GLB file as one mesh: the triangles of all nodes, where they are in the scene.
 * Strips and fans become triangles. Vertices at the same position are welded, and triangles that don't form a
 * manifold are repaired as by `HalfedgeMesh.fromSoup`.
 *
 * Normals, colours and texture coordinates become the attributes `normal`, `color` and `uv`: of vertices, or
 * of halfedges (corners) where the corners at a vertex differ. Materials, textures, animations, skins and
 * morph targets are not read. Works in Node as well.
 *
 * ```ts
 * import { readGltf } from 'halfedge/gltf';
 * const { mesh, report } = await readGltf(new URL('duck.glb', document.baseURI));
 * ```
 *
 * @param data the content of the file, or its address. Buffers in other files are found with `baseUrl` or
 * `resource`
 * @throws HalfedgeError with what was expected where: `unknown-format`, `not-text`, `parse-error`,
 * `truncated`, `unsupported-format` (compressed geometry without a decoder in the options, ...),
 * `missing-resource`, `too-large`, `missing-dependency` (three.js is not installed), `out-of-memory`,
 * `not-initialised`; with `repair: false` the first thing that would have to be repaired. TypeError or
 * RangeError for wrong arguments, and whatever `options.resource` throws
 */
export function readGltf(
  data: URL | string | ArrayBuffer | ArrayBufferView,
  options: ReadGltfOptions = {},
): Promise<{ mesh: HalfedgeMesh; report: GltfReport }> {
  return readWhole(data, options);
}

/**
 * Like {@link readGltf}, but with a mesh for each primitive of each node.
 *
 * @throws what {@link readGltf} throws; in that case, no mesh is left behind
 */
export function readGltfParts(
  data: URL | string | ArrayBuffer | ArrayBufferView,
  options: ReadGltfOptions = {},
): Promise<GltfPart[]> {
  return readParts(data, options);
}

/**
 * Writes a mesh as a GLB file, or as a glTF file with embedded buffers. Positions keep all their bits.
 * Polygons are cut into triangles, as by `mesh.toTriangles()`; vertices are repeated if their corners have
 * different attributes. The attributes `normal`, `uv` and `color` of vertices or halfedges are written.
 * `onNote` is told what is left out, and what was changed: normals are scaled to length 1, and colours brought
 * between 0 and 1. A mesh without faces becomes an empty scene.
 *
 * @throws HalfedgeError `missing-dependency` (three.js is not installed), `out-of-memory`, `disposed`,
 * `non-finite-position`, `write-error` if three.js fails; TypeError or RangeError for wrong arguments
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
