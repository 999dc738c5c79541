import { newArray } from '../arguments.js';
import { fileError } from './container.js';
import {
  type GltfAccessor,
  type GltfDocument,
  type GltfView,
  numberSize,
  rowSize,
} from './document.js';

/** More than that of rows which are given anew: views of a small file may be used by very many. */
const MOST_BYTES = 2 ** 31;

/**
 * three.js takes the rows of indices, and those of and under a sparse accessor, for lying side by side; of
 * others that reach over the end of a stride it doesn't find the end of the last. Where they are interleaved,
 * they get a view of their own, behind the bytes of the one buffer.
 */
export function packRows(
  document: GltfDocument,
  binary: Uint8Array,
): { document: GltfDocument; binary: Uint8Array } {
  const bufferViews = [...document.bufferViews];
  const copies: (() => void)[] = [];
  let size = binary.length;
  let packed = binary;

  /** Where they lie side by side; `rows`, if they do already or are compressed. */
  function pack<T extends Rows>(rows: T, count: number, bytes: number): T {
    const { bufferView, byteOffset = 0 } = rows;
    const view = bufferView === undefined ? undefined : bufferViews[bufferView];
    const stride = view?.byteStride ?? bytes;
    const isCompressed = Object.keys(view?.extensions ?? {}).length > 0;
    if (view === undefined || stride === bytes || isCompressed) return rows;
    const from = (view.byteOffset ?? 0) + byteOffset;
    const to = size;
    size += Math.ceil((count * bytes) / 8) * 8;
    copies.push(() => {
      for (let row = 0; row < count; row++) {
        const begin = from + row * stride;
        packed.set(binary.subarray(begin, begin + bytes), to + row * bytes);
      }
    });
    const own: GltfView = { buffer: 0, byteOffset: to, byteLength: count * bytes };
    return { ...rows, bufferView: bufferViews.push(own) - 1, byteOffset: 0 };
  }

  const primitives = document.meshes.flatMap((mesh) => mesh.primitives);
  const ofIndices = new Set(primitives.map(({ indices }) => indices));
  const accessors = document.accessors.map((accessor, i): GltfAccessor => {
    const { bufferView, byteOffset = 0, count, sparse } = accessor;
    const bytes = rowSize(accessor);
    const stride = bufferView === undefined ? bytes : (bufferViews[bufferView].byteStride ?? bytes);
    const reachesOver = (byteOffset % stride) + bytes > stride;
    if (sparse === undefined) {
      return ofIndices.has(i) || reachesOver ? pack(accessor, count, bytes) : accessor;
    }
    const { indices, values } = sparse;
    return {
      ...pack(accessor, count, bytes),
      sparse: {
        ...sparse,
        indices: pack(indices, sparse.count, numberSize(indices)),
        values: pack(values, sparse.count, bytes),
      },
    };
  });
  if (copies.length === 0) return { document, binary };
  if (size > MOST_BYTES) {
    throw fileError(
      'too-large',
      `glTF: rows that have to be laid side by side need ${size} bytes, expected at most ${MOST_BYTES}.`,
    );
  }
  packed = newArray('the buffers', Uint8Array, size);
  packed.set(binary);
  for (const copy of copies) copy();
  const buffers = [{ byteLength: size }];
  return { document: { ...document, accessors, bufferViews, buffers }, binary: packed };
}

/** Where rows of numbers are. */
interface Rows {
  readonly bufferView?: number;
  readonly byteOffset?: number;
}
