import { newArray } from '../arguments.js';
import { fileError } from './container.js';
import { type GltfDocument, type GltfView, rowSize } from './document.js';

/** More than that of rows which are given anew: views of a small file may be used by very many. */
const MOST_BYTES = 2 ** 31;

/**
 * three.js takes the rows under a sparse accessor for lying side by side. Where they are interleaved
 * with others they get a view of their own, behind the bytes of the one buffer.
 */
export function packSparse(
  document: GltfDocument,
  binary: Uint8Array,
): { document: GltfDocument; binary: Uint8Array } {
  const bufferViews = [...document.bufferViews];
  const copies: (() => void)[] = [];
  let size = binary.length;
  let packed = binary;
  const accessors = document.accessors.map((accessor) => {
    const { bufferView, byteOffset = 0, count, sparse } = accessor;
    const bytes = rowSize(accessor);
    const view = bufferView === undefined ? undefined : bufferViews[bufferView];
    const stride = view?.byteStride ?? bytes;
    const isCompressed = Object.keys(view?.extensions ?? {}).length > 0;
    if (sparse === undefined || view === undefined || stride === bytes || isCompressed) {
      return accessor;
    }
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
    return { ...accessor, bufferView: bufferViews.push(own) - 1, byteOffset: 0 };
  });
  if (copies.length === 0) return { document, binary };
  if (size > MOST_BYTES) {
    throw fileError(
      'too-large',
      `glTF: the rows of the sparse accessors need ${size} bytes, expected at most ${MOST_BYTES}.`,
    );
  }
  packed = newArray('the buffers', Uint8Array, size);
  packed.set(binary);
  for (const copy of copies) copy();
  const buffers = [{ byteLength: size }];
  return { document: { ...document, accessors, bufferViews, buffers }, binary: packed };
}
