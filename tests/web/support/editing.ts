import { HalfedgeError, type HalfedgeMesh, type Refusal } from 'halfedge';

/** Copies of all that a mesh holds: its arrays, counts and attributes. */
export function stateOf(mesh: HalfedgeMesh): Record<string, unknown> {
  const state: Record<string, unknown> = {
    counts: [mesh.vertexCount, mesh.edgeCount, mesh.faceCount],
    positions: bits(mesh.positions),
  };
  for (const [name, links] of Object.entries(mesh.connectivity)) state[name] = links.slice();
  for (const { kind, name } of mesh.attributes.list()) {
    state[`${kind} ${name}`] = bits(mesh.attributes.get(kind, name));
  }
  return state;
}

/** Whether the mesh is in this state again, to the last bit; tells the difference if not. */
export function expectState(mesh: HalfedgeMesh, state: Record<string, unknown>): void {
  const now = stateOf(mesh);
  const names = Object.keys(state);
  const isSame = names.every((name) => equal(now[name], state[name]));
  if (!isSame || Object.keys(now).length !== names.length) expect(now).toEqual(state);
}

/** Much faster than `toEqual`. */
function equal(a: unknown, b: unknown): boolean {
  const list = a as number[];
  const other = b as number[];
  return list.length === other.length && list.every((value, i) => value === other[i]);
}

/** A copy as words, or as bytes where they don't fill words: -0 and NaN are told apart then. */
function bits(view: ArrayBufferView): Uint8Array | Uint32Array {
  const copy = view.buffer.slice(view.byteOffset, view.byteOffset + view.byteLength);
  return copy.byteLength % 4 === 0 ? new Uint32Array(copy) : new Uint8Array(copy);
}

/** The refusal that `call` throws, which must have this code, a sentence and a witness. */
export function expectRefused(call: () => unknown, code: string): Refusal {
  let thrown: unknown;
  try {
    call();
  } catch (error) {
    thrown = error;
  }
  expect(thrown).toBeInstanceOf(HalfedgeError);
  const { message, witness } = thrown as HalfedgeError;
  const { code: given } = thrown as HalfedgeError;
  expect({ code: given, message }).toEqual({
    code,
    message: expect.stringMatching(/^[A-Z].*\.$/),
  });
  return { code: given, message, witness };
}

/** Attributes of each kind, of several types and all policies, with random values. */
export function addAttributes(mesh: HalfedgeMesh, next: () => number): void {
  const { attributes } = mesh;
  attributes.add('vertex', 'normal', { components: 3, onSplit: 'normalize' });
  attributes.add('vertex', 'flag', { type: 'uint8', components: 3, onSplit: 'copy', default: 9 });
  attributes.add('halfedge', 'uv', { components: 2 });
  attributes.add('halfedge', 'mark', { type: 'int16', onSplit: 'copy' });
  attributes.add('edge', 'crease', { type: 'float64' });
  attributes.add('face', 'group', { type: 'int32', onSplit: 'copy', default: -1 });
  attributes.add('face', 'seen', { type: 'uint8', onSplit: 'default' });
  for (const { kind, name } of attributes.list()) {
    const view = attributes.get(kind, name);
    view.forEach((_, i) => {
      view[i] = 100 * next();
    });
  }
}

/** The faces as lists of corners, each from its smallest on, in order. */
export function facesOf(mesh: HalfedgeMesh): number[][] {
  const faces = mesh
    .faces()
    .toArray()
    .map((f) => {
      const corners: number[] = mesh.faceVertices(f).toArray();
      const first = corners.indexOf(Math.min(...corners));
      return [...corners.slice(first), ...corners.slice(0, first)];
    });
  return faces.sort((a, b) => a[0] - b[0] || a[1] - b[1] || a[2] - b[2]);
}

/** The edges as "0-1", in order. */
export function edgesOf(mesh: HalfedgeMesh): string[] {
  const edges = mesh.edges().toArray();
  return edges
    .map((e) =>
      mesh
        .edgeVertices(e)
        .toArray()
        .sort((a, b) => a - b)
        .join('-'),
    )
    .sort();
}
