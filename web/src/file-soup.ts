// What a file holds, without a mesh: for those who only read.

import { newArray } from './arguments.js';
import { type AttributeType, type AttributeView, TYPE_NAMES, TYPES } from './attributes.js';
import type { Polygons } from './build.js';
import { checkFlag } from './checks.js';
import type { RawColumn, RawWords } from './core.js';
import { contentOf, unwrapFile } from './file-content.js';
import { nameIn } from './letters.js';
import { type Core, core } from './loader.js';
import { withInputs } from './memory.js';
import { checkOptions, type OptionNames } from './options.js';
import {
  type AttributeNames,
  claimOf,
  type FileFormat,
  FORMATS,
  namesIn,
  type ParseOptions,
} from './parse.js';
import { sentence } from './reports.js';

/** How to read a file without making a mesh of it. */
export interface FileSoupOptions extends Pick<ParseOptions, 'format' | 'attributes'> {
  /**
   * Whether positions that an STL file repeats become one vertex. With false, corner k of triangle i is
   * vertex 3 i + k, as in the file, which is faster. Default: true.
   */
  weld?: boolean | undefined;
}

const FILE_SOUP_OPTIONS: OptionNames<FileSoupOptions> = {
  format: true,
  attributes: true,
  weld: true,
};

/** A column of numbers that a file has in addition to its polygons. */
export interface FileAttribute {
  /** The name that {@link HalfedgeMesh.parse} gives to the attribute: `normal`, `color`, `uv`, ... */
  readonly name: string;
  /** Corners are counted face after face, as in `faces.corners`. */
  readonly item: 'vertex' | 'corner' | 'face';
  readonly type: AttributeType;
  /** Numbers for each item. */
  readonly components: number;
  /** The values of item i begin at `components * i`; 0 where the file says nothing. */
  readonly values: AttributeView;
}

/** What a file holds, before a mesh is made of it: its faces as they are, good or bad. */
export interface FileSoup {
  /** xyz of each vertex. */
  readonly positions: Float32Array;
  /** Corners may refer to vertices that don't exist, and faces may have any number of corners. */
  readonly faces: Polygons & { readonly sizes: Uint32Array; readonly corners: Uint32Array };
  /** What else the file says. */
  readonly attributes: readonly FileAttribute[];
  /** The names behind the numbers of attributes, as in the report of {@link HalfedgeMesh.parse}. */
  readonly names: AttributeNames;
  /** The format of the content. */
  readonly format: FileFormat;
  /** What was ignored, in one sentence each. */
  readonly notes: readonly string[];
}

/** In the order of the enum SoupItem in C++. */
const ITEMS = ['vertex', 'corner', 'face'] as const;
/** The row of an item that has none. */
const NO_ROW = 0xffffffff;

/** The polygons of a file. */
export function parseSoup(data: unknown, options: unknown): FileSoup {
  const { format, attributes = true, weld = true } = checkOptions(options, FILE_SOUP_OPTIONS);
  const claimed = claimOf(format);
  checkFlag('options.attributes', attributes);
  checkFlag('options.weld', weld);
  const bytes = contentOf(data);
  const wasm = core();
  const raw = withInputs(wasm, (inputs) => {
    const { address, count } = inputs.bytes('data', bytes);
    return wasm.parseSoup(address, count, claimed, weld, attributes);
  });
  const file = unwrapFile(raw);
  const columns = file.attributes;
  try {
    const positions = copyOf(wasm, Float32Array, file.positions);
    const corners = copyOf(wasm, Uint32Array, file.corners);
    const sizes =
      file.sizes.count > 0
        ? copyOf(wasm, Uint32Array, file.sizes)
        : newArray('sizes', Uint32Array, corners.length / 3).fill(3);
    const counts = [positions.length / 3, corners.length, sizes.length];
    return {
      positions,
      faces: { sizes, corners },
      attributes: columns.map((column) => attributeOf(wasm, column, counts[column.item])),
      names: namesIn(file.names),
      format: FORMATS[file.format],
      notes: file.notes.map(sentence),
    };
  } finally {
    const lists = columns.flatMap(({ values, rows }) => [values, rows]);
    for (const { address } of [file.positions, file.sizes, file.corners, ...lists]) {
      wasm.free(address);
    }
  }
}

type Kind<T> = {
  new (length: number): T;
  new (buffer: ArrayBufferLike, address: number, count: number): T;
};

function copyOf<T extends { set(from: T): void }>(
  { memory }: Core,
  Kind: Kind<T>,
  { address, count }: RawWords,
): T {
  const copy = newArray('the file', Kind, count);
  copy.set(new Kind(memory.buffer, address, count));
  return copy;
}

/** A column with a row for each of `count` items. */
function attributeOf({ memory }: Core, column: RawColumn, count: number): FileAttribute {
  const { components } = column;
  const name = nameIn(column.name);
  const type = TYPE_NAMES[column.type];
  const Kind = TYPES[type] as Kind<AttributeView> & { BYTES_PER_ELEMENT: number };
  const size = column.values.count / Kind.BYTES_PER_ELEMENT;
  const given = new Kind(memory.buffer, column.values.address, size);
  const rows = new Uint32Array(memory.buffer, column.rows.address, column.rows.count);
  const values = newArray(`the attribute ${name}`, Kind, components * count);
  if (rows.length === 0) values.set(given);
  for (let i = 0; i < rows.length; i++) {
    if (rows[i] === NO_ROW) continue;
    for (let k = 0; k < components; k++)
      values[components * i + k] = given[components * rows[i] + k];
  }
  return { name, item: ITEMS[column.item], type, components, values };
}
