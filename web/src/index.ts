export * from './api.js';
export type { InitOptions } from './compile.js';
export { init } from './init.js';
