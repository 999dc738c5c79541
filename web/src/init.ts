import { type InitOptions, moduleAt, moduleFrom, wasmOption } from './compile.js';
import { HalfedgeError } from './errors.js';
import { load } from './loader.js';
import { originalOf } from './original.js';

/**
 * Loads the WebAssembly module. Await it once, before the first mesh is made. No options are needed in Node,
 * in a browser, in a worker, or behind a bundler.
 *
 * Idempotent: later calls, including concurrent ones, resolve as soon as the first has loaded the module,
 * whatever source they name themselves. If the first fails, they try their own source; and you can call it
 * again.
 *
 * @throws HalfedgeError `not-webassembly` if the bytes are something else (most often an HTML page),
 * `init-failed` if they can't be loaded or started; TypeError for a wrong argument
 */
export async function init(options: InitOptions = {}): Promise<void> {
  const wasm = wasmOption(options);
  await load(() => (wasm === undefined ? moduleBesideThisFile() : moduleFrom(wasm)));
}

async function moduleBesideThisFile(): Promise<WebAssembly.Module> {
  const url = addressOfModule();
  const original = originalOf('core.wasm', url.href);
  return original === undefined ? moduleAt(url, LEFT_BEHIND) : moduleAt(original, EXCLUDE);
}

const LEFT_BEHIND =
  " Some bundlers (Angular, Bun, esbuild, Rollup) leave core.wasm behind: copy it from halfedge/dist to the folder of the script, or import from 'halfedge/inline'.";
const EXCLUDE = " In Vite up to 7, set optimizeDeps: { exclude: ['halfedge'] }.";

function addressOfModule(): URL {
  try {
    return new URL('./core.wasm', import.meta.url); // in this form, bundlers recognise an asset
  } catch (cause) {
    throw new HalfedgeError(
      'init-failed',
      "This script has no address (it is a blob: or data: URL, or was bundled as something else than a module), so that core.wasm can't be looked for beside it: " +
        "call init({ wasm }) with an address or a compiled module, or import from 'halfedge/inline'.",
      { cause },
    );
  }
}
