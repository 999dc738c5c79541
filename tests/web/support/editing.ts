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
  expect({ code: (thrown as HalfedgeError).code, message }).toEqual({
    code,
    message: expect.stringMatching(/^[A-Z].*\.$/),
  });
  return { code, message, witness };
}
