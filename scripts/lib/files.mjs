// Lists of the project's own files.

import { existsSync, readdirSync, statSync } from 'node:fs';
import { extname, join } from 'node:path';
import { root } from './run.mjs';

/** The paths of all files below a folder, sorted, without links to nothing; none if there is no such folder. */
export function filesBelow(folder) {
  if (!existsSync(folder)) return [];
  return readdirSync(folder, { recursive: true })
    .map((name) => join(folder, name))
    .filter((path) => statSync(path, { throwIfNoEntry: false })?.isFile())
    .sort();
}

/** The C++ files below the given folders of the project. */
export function cppFiles(...folders) {
  return folders
    .flatMap((folder) => filesBelow(join(root, folder)))
    .filter((path) => ['.h', '.cpp'].includes(extname(path)));
}
