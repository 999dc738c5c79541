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
  const packing = new Packing(document.bufferViews, binary.length);
  const primitives = document.meshes.flatMap((mesh) => mesh.primitives);
  const ofIndices = new Set(primitives.map(({ indices }) => indices));
  const accessors = document.accessors.map((accessor, i): GltfAccessor => {
    const { count, sparse } = accessor;
    const bytes = rowSize(accessor);
    if (sparse === undefined) {
      const isPacked = ofIndices.has(i) || packing.reachesOver(accessor, bytes);
      return isPacked ? packing.pack(accessor, count, bytes) : accessor;
    }
    const { indices, values } = sparse;
    return {
      ...packing.pack(accessor, count, bytes),
      sparse: {
        ...sparse,
        indices: packing.pack(indices, sparse.count, numberSize(indices)),
        values: packing.pack(values, sparse.count, bytes),
      },
    };
  });
  if (packing.isEmpty) return { document, binary };
  const { bufferViews } = packing;
  const packed = packing.copy(binary);
  const buffers = [{ byteLength: packed.length }];
  return { document: { ...document, accessors, bufferViews, buffers }, binary: packed };
}

/** Where rows of numbers are. */
interface Rows {
  readonly bufferView?: number;
  readonly byteOffset?: number;
}

/** Rows of a buffer, and where they are to lie side by side behind its bytes. */
interface Move {
  readonly from: number;
  readonly stride: number;
  readonly to: number;
  readonly count: number;
  /** Of a row. */
  readonly bytes: number;
}

/** Finds room for rows behind the bytes of the one buffer, and copies them there once all have theirs. */
class Packing {
  /** Those of the document, and one for each that was packed. */
  readonly bufferViews: GltfView[];
  readonly #moves: Move[] = [];
  #size: number;

  constructor(bufferViews: readonly GltfView[], size: number) {
    this.bufferViews = [...bufferViews];
    this.#size = size;
  }

  /** Whether nothing has to be copied. */
  get isEmpty(): boolean {
    return this.#moves.length === 0;
  }

  /** Whether a row ends beyond the stride that it begins in. */
  reachesOver({ bufferView, byteOffset = 0 }: Rows, bytes: number): boolean {
    const stride =
      bufferView === undefined ? bytes : (this.bufferViews[bufferView].byteStride ?? bytes);
    return (byteOffset % stride) + bytes > stride;
  }

  /** Where they lie side by side; `rows`, if they do already or are compressed. */
  pack<T extends Rows>(rows: T, count: number, bytes: number): T {
    const { bufferView, byteOffset = 0 } = rows;
    const view = bufferView === undefined ? undefined : this.bufferViews[bufferView];
    const stride = view?.byteStride ?? bytes;
    const isCompressed = Object.keys(view?.extensions ?? {}).length > 0;
    if (view === undefined || stride === bytes || isCompressed) return rows;
    const from = (view.byteOffset ?? 0) + byteOffset;
    const to = this.#size;
    this.#size += Math.ceil((count * bytes) / 8) * 8;
    this.#moves.push({ from, stride, to, count, bytes });
    const own: GltfView = { buffer: 0, byteOffset: to, byteLength: count * bytes };
    return { ...rows, bufferView: this.bufferViews.push(own) - 1, byteOffset: 0 };
  }

  /** The bytes with the packed rows behind them. */
  copy(binary: Uint8Array): Uint8Array {
    if (this.#size > MOST_BYTES) {
      throw fileError(
        'too-large',
        `glTF: rows that have to be laid side by side need ${this.#size} bytes, expected at most ${MOST_BYTES}.`,
      );
    }
    const packed = newArray('the buffers', Uint8Array, this.#size);
    packed.set(binary);
    for (const { from, stride, to, count, bytes } of this.#moves) {
      for (let row = 0; row < count; row++) {
        const begin = from + row * stride;
        packed.set(binary.subarray(begin, begin + bytes), to + row * bytes);
      }
    }
    return packed;
  }
}
