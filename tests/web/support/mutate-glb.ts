// GLB files that are nearly right: what the fuzz test of glTF feeds to its reader.

/** Draws numbers in [0, 1). */
type Next = () => number;
type Json = null | boolean | number | string | Json[] | { [key: string]: Json };

const MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;
const BINARY_CHUNK = 0x004e4942;

/** A GLB file of any JSON, and of a binary chunk. */
export function glbOf(json: unknown, binary: Uint8Array): Uint8Array {
  const text = new TextEncoder().encode(typeof json === 'string' ? json : JSON.stringify(json));
  const size = Math.ceil(text.length / 4) * 4;
  const glb = new Uint8Array(28 + size + binary.length);
  const view = new DataView(glb.buffer);
  [MAGIC, 2, glb.length, size, JSON_CHUNK].forEach((word, i) => {
    view.setUint32(4 * i, word, true);
  });
  glb.fill(0x20, 20, 20 + size).set(text, 20);
  view.setUint32(20 + size, binary.length, true);
  view.setUint32(24 + size, BINARY_CHUNK, true);
  glb.set(binary, 28 + size);
  return glb;
}

/** The two chunks of a GLB file that is right. */
export function chunksOf(glb: Uint8Array): { json: Json; binary: Uint8Array } {
  const view = new DataView(glb.buffer, glb.byteOffset, glb.byteLength);
  const size = view.getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + size)));
  return { json, binary: glb.slice(28 + size) };
}

/** Values that files have where others were expected. */
const ODD: readonly Json[] = [
  ...[null, true, -1, 0, 1, 2, 3, 0.5, 7, 255, 65535, 1e9, 2 ** 31, 2 ** 32, 2 ** 53, 1e308, -0.5],
  ...['', '0', 'SCALAR', 'VEC2', 'VEC4', 'MAT4', 'data:,', 'data:;base64,%', '../x.bin', '\ud800'],
  ...[5120, 5121, 5123, 5125, 5126, 33071],
];

/** Words that mean something at other places of a document. */
const KEYS = [
  ...['children', 'mesh', 'matrix', 'scale', 'sparse', 'byteStride', 'byteOffset', 'bufferView'],
  ...['indices', 'mode', 'normalized', 'extensions', 'skin', 'weights', 'targets', 'uri', 'scene'],
  ...['__proto__', 'constructor', 'toString'],
];

const pick = <T>(list: readonly T[], next: Next): T => list[Math.floor(next() * list.length)];

/** An odd value, or one from elsewhere in the document. */
function oddValue(root: Json, next: Next): Json {
  if (next() < 0.6) return pick(ODD, next);
  const { holder, key } = pick(placesIn(root), next);
  const copied = structuredClone(holder[key]);
  return next() < 0.5 ? copied : next() < 0.5 ? [copied, copied] : { [pick(KEYS, next)]: copied };
}

interface Place {
  holder: Record<string, Json>;
  key: string;
}

function placesIn(root: Json): Place[] {
  const found: Place[] = [];
  const visit = (value: Json) => {
    if (typeof value !== 'object' || value === null) return;
    for (const key of Object.keys(value).slice(0, 40)) {
      const holder = value as Record<string, Json>;
      found.push({ holder, key });
      visit(holder[key]);
    }
  };
  visit(root);
  return found;
}

/** Changes, adds or drops one value somewhere; those high up and those deep down alike. */
function changeJson(root: Json, next: Next): void {
  const { holder, key } = pick(placesIn(root), next);
  const value = holder[key];
  const drawn = next();
  if (drawn < 0.15) delete holder[key];
  else if (drawn < 0.3) holder[pick(KEYS, next)] = oddValue(root, next);
  else if (drawn < 0.45 && Array.isArray(value)) value.push(...structuredClone(value.slice(0, 20)));
  else if (drawn < 0.7 && typeof value === 'number')
    holder[key] = value + pick([-1, 1, 3, 4], next);
  else holder[key] = oddValue(root, next);
}

function changeBytes(bytes: Uint8Array, next: Next): void {
  for (let changes = 1 + Math.floor(8 * next() ** 3); changes > 0 && bytes.length > 0; changes--) {
    const at = Math.floor(next() * bytes.length);
    bytes[at] = next() < 0.3 ? pick([0, 1, 127, 128, 255], next) : Math.floor(256 * next());
  }
}

/** A file that is like `glb`, and wrong in a few places. */
export function mutated(glb: Uint8Array, next: Next): Uint8Array {
  const drawn = next();
  if (drawn < 0.1) return glb.slice(0, Math.floor(next() * glb.length));
  if (drawn < 0.2) {
    const bytes = glb.slice();
    changeBytes(next() < 0.5 ? bytes.subarray(0, 28) : bytes, next);
    return bytes;
  }
  const { json, binary } = chunksOf(glb);
  for (let changes = 1 + Math.floor(4 * next() ** 2); changes > 0; changes--) {
    changeJson(json, next);
  }
  if (next() < 0.4) changeBytes(binary, next);
  return glbOf(
    json,
    next() < 0.1 ? binary.subarray(0, Math.floor(next() * binary.length)) : binary,
  );
}
