// The collection of test meshes, which lies beside the repository, or where HALFEDGE_DATA says.
import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const folder =
  process.env.HALFEDGE_DATA ?? fileURLToPath(new URL('../../../../shared/data', import.meta.url));

export interface Collected {
  /** Paths, in the order of their names; none where there is no collection. */
  readonly files: readonly string[];
  /** `test`; where there are no files it skips, and a line has said so. */
  readonly test: typeof test;
}

/** The files of one part of the collection, or of several. */
export function collected(
  parts: 'good' | 'nasty' | readonly string[],
  pattern = /\.(obj|off|ply|stl)$/i,
): Collected {
  const files = [parts].flat().flatMap((part) => filesOf(join(folder, part), pattern));
  return { files, test: files.length > 0 ? test : (test.skip as typeof test) };
}

function filesOf(path: string, pattern: RegExp): string[] {
  let files: string[] = [];
  try {
    files = readdirSync(path).filter((file) => pattern.test(file));
  } catch {
    // There is no such folder: as if it were empty.
  }
  if (files.length === 0) {
    console.log(
      `Skipped: no file in ${path} fits ${pattern}; HALFEDGE_DATA names the folder above.`,
    );
  }
  return files.map((file) => join(path, file));
}
