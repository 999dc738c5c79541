import type { HalfedgeError } from 'halfedge';
import { readGltf } from 'halfedge/gltf';

export const base64 = (...arrays: ArrayBufferView[]) =>
  Buffer.concat(
    arrays.map(({ buffer, byteOffset, byteLength }) => Buffer.from(buffer, byteOffset, byteLength)),
  ).toString('base64');

export const FLOAT = 5126;
export const SHORT = 5123;
export const BYTE = 5121;

export interface Column {
  values: Float32Array | Uint16Array | Uint8Array;
  type: string;
  normalized?: boolean;
}

/** A glTF document with a view and an accessor for each column, and whatever else it has. */
export function document(columns: Column[], rest: object) {
  let size = 0;
  const views = columns.map(({ values }) => {
    const view = { buffer: 0, byteOffset: size, byteLength: values.byteLength };
    size += Math.ceil(values.byteLength / 4) * 4;
    return view;
  });
  const bytes = new Uint8Array(size);
  columns.forEach(({ values }, i) => {
    bytes.set(new Uint8Array(values.buffer), views[i].byteOffset);
  });
  return {
    asset: { version: '2.0' },
    buffers: [{ byteLength: size, uri: `data:application/octet-stream;base64,${base64(bytes)}` }],
    bufferViews: views,
    accessors: columns.map(({ values, type, normalized = false }, i) => ({
      bufferView: i,
      componentType: { Float32Array: FLOAT, Uint16Array: SHORT, Uint8Array: BYTE }[
        values.constructor.name
      ] as number,
      count: values.length / { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 }[type as 'VEC3'],
      type,
      normalized,
    })),
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }] as object[],
    ...rest,
  };
}

export const SQUARE = new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]);
export const CORNERS = new Uint16Array([0, 1, 2, 0, 2, 3]);

/** A square of two triangles, with changes. */
export const square = (rest: object = {}) =>
  document(
    [
      { values: SQUARE, type: 'VEC3' },
      { values: CORNERS, type: 'SCALAR' },
    ],
    {
      meshes: [{ name: 'Square.001', primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
      ...rest,
    },
  );

export const read = (json: object, options = {}) => readGltf(JSON.stringify(json), options);

export async function rejection(promise: Promise<unknown>): Promise<HalfedgeError> {
  return promise.then(
    () => {
      throw new Error('It resolved.');
    },
    (error) => error,
  );
}
