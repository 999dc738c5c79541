// The files of the collection for the benchmark of readers: the good ones that three.js reads too.

import { readdirSync, readFileSync } from 'node:fs';
import { extname, join } from 'node:path';
import { env } from 'node:process';
import { fileURLToPath } from 'node:url';
import { readersOf } from './files-readers.mjs';

const data = env.HALFEDGE_DATA ?? fileURLToPath(new URL('../../../shared/data', import.meta.url));
const folder = join(data, 'good');

const FORMATS = ['obj', 'off', 'ply', 'stl'];
/** What is read so quickly that the call itself is to be seen. */
const SMALL = 100_000;

/**
 * The files of each format: all, the largest, and the small ones, of which the mean is wanted
 * (`each`). `told` says what was taken, or that there is no collection.
 */
export function groupsOfCollection() {
  const files = filesOf(folder);
  if (files.length === 0) return { groups: [], told: `No file in ${folder}: nothing to compare.` };
  const taken = files.filter(isReadByBoth);
  const groups = FORMATS.flatMap((format) =>
    groupsOf(
      format,
      taken.filter((file) => file.format === format),
    ),
  );
  const others = files.filter((file) => !taken.includes(file)).map(({ name }) => name);
  const without =
    others.length === 0 ? '' : ` but ${others.join(', ')}, which three.js reads otherwise`;
  return { groups, told: `${taken.length} files of the collection: all good ones${without}` };
}

function groupsOf(format, files) {
  const bytesOf = (some) => some.map(({ bytes }) => bytes);
  const largest = files.reduce((a, b) => (b.bytes.length > a.bytes.length ? b : a), files[0]);
  const small = files.filter(({ bytes }) => bytes.length < SMALL);
  const groups = [
    [`${format.toUpperCase()}, all ${files.length}`, bytesOf(files)],
    [`– the largest, ${largest?.name}`, files.length > 0 ? [largest.bytes] : []],
    [`– one of ${small.length} under 100 kB, on average`, bytesOf(small), true],
  ];
  return groups
    .filter(([, list]) => list.length > 0)
    .map(([title, list, each = false]) => ({ title, format, files: list, each }));
}

/** Whether three.js finds as many triangles as we do: it leaves out polygons of some files. */
function isReadByBoth({ format, bytes }) {
  const { read, load } = readersOf(format);
  return load === undefined || load(bytes) === read(bytes);
}

function filesOf(path) {
  try {
    return readdirSync(path).flatMap((name) => {
      const format = extname(name).slice(1).toLowerCase();
      if (!FORMATS.includes(format)) return [];
      return [{ name, format, bytes: new Uint8Array(readFileSync(join(path, name))) }];
    });
  } catch {
    return []; // there is no such folder
  }
}
