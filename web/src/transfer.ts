import { bytesOf, newArray, noRoomHere } from './arguments.js';
import { refuse } from './checks.js';
import type { RawWords } from './core.js';
import { modeOf } from './edit.js';
import { Links, listOfItems } from './links.js';
import { type Core, core } from './loader.js';
import { withInputs } from './memory.js';
import type { ItemSet } from './neighbourhoods.js';
import { unwrap } from './reports.js';
import { take, takeItems } from './rings.js';
import type { OwnBytes } from './write.js';

/**
 * Where the items of a mesh went when it was appended to another: the new index by slot, -1 for deleted ones.
 */
export interface AppendMaps {
  readonly vertices: Int32Array;
  readonly halfedges: Int32Array;
  readonly edges: Int32Array;
  readonly faces: Int32Array;
}

/** Adds a copy of `other` to a mesh. */
export function appendLinks(links: Links, other: Links): AppendMaps {
  const { core } = links;
  const result = core.append(links.address, other.address, modeOf(links));
  links.update(); // also after a failure: arrays may have moved
  return takeMaps(core, unwrap(result));
}

/** Copies of the maps that the core hands over, which it keeps of vertices, edges and faces. */
export function takeMaps(
  core: Core,
  raw: { vertices: RawWords; edges: RawWords; faces: RawWords },
): AppendMaps {
  const [vertices, edges, faces] = take(core, raw.vertices, raw.edges, raw.faces).map(
    (map) => new Int32Array(map.buffer),
  ) as [Int32Array, Int32Array, Int32Array];
  const halfedges = newArray('the map of halfedges', Int32Array, 2 * edges.length);
  for (let h = 0; h < halfedges.length; h++) {
    const e = edges[h >> 1];
    halfedges[h] = e < 0 ? -1 : 2 * e + (h & 1);
  }
  return { vertices, halfedges, edges, faces };
}

/** Faces of a mesh as one of their own, and the items that it is a copy of. */
export function extractLinks(links: Links, value: unknown): { part: Links; items: ItemSet } {
  links.checkAlive();
  const { core } = links;
  const faces = listOfItems(links, 'face', 'faces', value);
  const raw = withInputs(core, (inputs) => {
    const { address, count } = inputs.indices('faces', faces);
    return unwrap(core.extract(links.address, address, count));
  });
  const part = new Links(core, raw.mesh);
  try {
    return { part, items: takeItems(core, raw) };
  } catch (error) {
    part.dispose();
    throw error;
  }
}

/** The dual of a mesh. */
export function dualLinks({ core, address }: Links): Links {
  return new Links(core, unwrap(core.dual(address)).mesh);
}

/** The bytes of a mesh. */
export function bytesOfLinks({ core, address: mesh }: Links): OwnBytes {
  const { address, count } = unwrap(core.toBytes(mesh)).bytes;
  try {
    return new Uint8Array(core.memory.buffer, address, count).slice();
  } catch (cause) {
    throw noRoomHere(`A copy of the mesh needs room for ${count} bytes`, cause);
  } finally {
    core.free(address);
  }
}

/**
 * The mesh in bytes. Those of another thread that runs this package (`isOurs`) are not checked, which
 * takes most of the time.
 */
export function linksOfBytes(source: unknown, isOurs = false): Links {
  const bytes = bytesOf('bytes', source);
  if (bytes === undefined) refuse('bytes', source, 'an ArrayBuffer or a Uint8Array');
  const wasm = core();
  const raw = withInputs(wasm, (inputs) => {
    const { address, count } = inputs.bytes('bytes', bytes);
    return wasm.fromBytes(address, count, isOurs);
  });
  return new Links(wasm, unwrap(raw).mesh);
}
