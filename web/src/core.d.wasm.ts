import type { InitOptions } from './compile.js';

/**
 * What importing `halfedge/core.wasm` gives is up to the bundler (its address, its bytes, or the
 * compiled module), but always something for `init({ wasm })`.
 */
declare const wasm: NonNullable<InitOptions['wasm']>;
export default wasm;
