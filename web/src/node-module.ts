import type { WorkerLike } from './connection.js';

/** What is used of Node's modules: its own types are no dependency of the package. */
interface NodeModules {
  'node:fs/promises': { readFile(path: URL): Promise<Uint8Array> };
  'node:url': { pathToFileURL(path: string): URL };
  'node:worker_threads': { Worker: new (script: URL) => WorkerLike; parentPort: unknown };
}

/**
 * One of Node's modules; undefined elsewhere. Without a `node:` import, which a bundler would follow (webpack
 * fails on it).
 */
export function nodeModule<Name extends keyof NodeModules>(
  name: Name,
): NodeModules[Name] | undefined {
  const { process } = globalThis as { process?: { getBuiltinModule?(name: string): unknown } };
  return process?.getBuiltinModule?.(name) as NodeModules[Name] | undefined;
}
