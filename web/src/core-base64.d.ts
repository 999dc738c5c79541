/** The bytes of core.wasm in base64. The build writes this module: see scripts/build.mjs. */
export const coreBase64: string;
