import { type InitOptions, moduleFrom, wasmOption } from './compile.js';
import { HalfedgeError } from './errors.js';
import { load } from './loader.js';

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
  await load(() => moduleFrom(wasm ?? besideThisFile()));
}

function besideThisFile(): URL {
  const url = addressOfModule();
  // In development, Vite up to 7 serves packages from copies of their JavaScript alone.
  const copied = url.pathname.includes('/.vite/deps/');
  return copied ? new URL('../../halfedge/dist/core.wasm', url) : url;
}

function addressOfModule(): URL {
  try {
    return new URL('./core.wasm', import.meta.url); // in this form, bundlers recognise an asset
  } catch (cause) {
    throw new HalfedgeError(
      'init-failed',
      "This script has no address (it is a blob: or data: URL, or was bundled as CommonJS), so that core.wasm can't be looked for beside it: " +
        "call init({ wasm }) with an address, or import from 'halfedge/inline'.",
      { cause },
    );
  }
}
