import { type InitOptions, moduleFrom, wasmOption } from './compile.js';
import { coreBase64 } from './core-base64.js';
import { bytesIn } from './letters.js';
import { load } from './loader.js';

export * from './api.js';
export type { InitOptions } from './compile.js';

/**
 * Like `init` of the main entry, but with the WebAssembly module embedded in the JavaScript, so nothing is
 * fetched. The module takes a third more space. For single-file pages and places without a server.
 */
export async function init(options: InitOptions = {}): Promise<void> {
  const wasm = wasmOption(options);
  await load(() =>
    wasm === undefined
      ? moduleFrom(bytesIn(atob(coreBase64)), 'halfedge/inline')
      : moduleFrom(wasm),
  );
}
