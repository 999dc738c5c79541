// Only in debug builds: Emscripten's glue for Node expects the variables of a CommonJS module.
const nodeModule = globalThis.process?.getBuiltinModule?.('node:module');
// biome-ignore lint/correctness/noUnusedVariables: the glue, which follows, calls it
var require = nodeModule?.createRequire(import.meta.url);
var __filename = new URL(import.meta.url).pathname;
var __dirname = new URL('.', import.meta.url).pathname;
