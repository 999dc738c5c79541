import createCore, { type RawCore } from './core.js';
import { HalfedgeError } from './errors.js';
import { announceGrowth } from './growth.js';

/** The functions of the WebAssembly module, and its memory. */
export interface Core extends RawCore {
  readonly memory: WebAssembly.Memory;
}

let loaded: Core | undefined;
let compiled: WebAssembly.Module | undefined;
let loading: Promise<void> | undefined;

/** The loaded module. Throws if there is none yet. */
export function core(): Core {
  if (loaded === undefined) {
    throw new HalfedgeError(
      'not-initialised',
      'The WebAssembly module is not loaded yet: call `await init()` once, before any mesh is made.',
    );
  }
  return loaded;
}

/** What the loaded module was compiled to, for another thread. Throws if there is none yet. */
export function compiledModule(): WebAssembly.Module {
  core();
  return compiled as WebAssembly.Module;
}

/**
 * Loads the module that `compile` makes, unless one is loaded. Who comes while another one is being loaded
 * waits for that, and tries in its own way if that fails. A failure is not kept.
 */
export async function load(compile: () => Promise<WebAssembly.Module>): Promise<void> {
  while (loading !== undefined) await loading.catch(() => {});
  if (loaded !== undefined) return;
  loading = compile()
    .then(async (module) => {
      loaded = await instantiate(module);
      compiled = module;
    })
    .finally(() => {
      loading = undefined;
    });
  await loading;
}

/**
 * The glue gets an instance made here. It would never settle if its `instantiateWasm` threw, so
 * that nothing may escape from there but through `reject`.
 */
function instantiate(module: WebAssembly.Module): Promise<Core> {
  return new Promise<Core>((resolve, reject) => {
    const fail = (cause: unknown) =>
      reject(
        new HalfedgeError(
          'init-failed',
          `The WebAssembly module can't be started: ${messageOf(cause)}. Does core.wasm belong to this version of the package?`,
          { cause },
        ),
      );
    let memory: WebAssembly.Memory | undefined;
    createCore({
      instantiateWasm(imports, receive) {
        WebAssembly.instantiate(module, imports as WebAssembly.Imports)
          .then((instance) => {
            memory = memoryOf(instance);
            if (memory !== undefined) announceGrowth(memory);
            receive(instance);
          })
          .catch(fail);
        return {};
      },
    }).then((raw) => {
      if (memory === undefined) fail('it exports no memory');
      else resolve(Object.assign(raw, { memory }));
    }, fail);
  });
}

/** Found by its type: optimised builds shorten the names of exports. */
function memoryOf(instance: WebAssembly.Instance): WebAssembly.Memory | undefined {
  for (const value of Object.values(instance.exports)) {
    if (value instanceof WebAssembly.Memory) return value;
  }
  return undefined;
}

/** The message of whatever was thrown, without a full stop. */
export function messageOf(cause: unknown): string {
  const { message } = Object(cause) as { message?: unknown };
  return (typeof message === 'string' ? message : String(cause)).replace(/\.\s*$/, '');
}
