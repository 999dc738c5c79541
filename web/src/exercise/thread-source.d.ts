/** The script of the worker, bundled, as a text. The build writes this module: see scripts/build.mjs. */
export const threadSource: string;
