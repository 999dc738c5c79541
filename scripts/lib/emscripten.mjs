// Finds the Emscripten to build with: the emsdk of the environment, else the `emcc` on PATH.

import { existsSync, realpathSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { which } from './run.mjs';

const toolchain = 'cmake/Modules/Platform/Emscripten.cmake';

/** The folders that may hold Emscripten's CMake files, the preferred one first. */
function candidates() {
  const folders = [];
  if (process.env.EMSDK) folders.push(join(process.env.EMSDK, 'upstream', 'emscripten'));
  const emcc = which('emcc');
  if (emcc) {
    const folder = dirname(realpathSync(emcc));
    folders.push(folder, join(folder, '..', 'libexec'));
  }
  return folders;
}

/** Emscripten's CMake toolchain file, or undefined where there is no Emscripten. */
export function emscriptenToolchain() {
  return candidates()
    .map((folder) => join(folder, toolchain))
    .find((path) => existsSync(path));
}
