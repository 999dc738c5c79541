import { lengthOf, type NumberArray, typedArrayName } from './arguments.js';
import { HalfedgeError } from './errors.js';
import type { Core } from './loader.js';

/** The most that WebAssembly can address. */
const MAX_BYTES = 2 ** 32 - 1;

const KINDS = {
  Int8Array,
  Uint8Array,
  Uint8ClampedArray,
  Int16Array,
  Uint16Array,
  Int32Array,
  Uint32Array,
  Float32Array,
  Float64Array,
};

/** Numbers in WebAssembly memory. */
export interface Block {
  readonly address: number;
  readonly count: number;
}

/**
 * Runs `use` with a way to copy inputs into WebAssembly memory, in one go each, and frees the copies
 * afterwards, also when something throws.
 */
export function withInputs<T>(core: Core, use: (inputs: Inputs) => T): T {
  const inputs = new Inputs(core);
  try {
    return use(inputs);
  } finally {
    inputs.free();
  }
}

/** Where the numbers of a live view lie, whose memory may grow and leave the view empty. */
interface Place {
  readonly name: keyof typeof KINDS;
  readonly byteOffset: number;
  readonly count: number;
}

export class Inputs {
  #core: Core;
  #addresses: number[] = [];
  #held = new Map<NumberArray, Place>();

  constructor(core: Core) {
    this.#core = core;
  }

  /**
   * Notes where those lie that are live views of some mesh: to allocate room for one can detach the
   * others. Needed before the first of several is copied.
   */
  hold(...sources: readonly (NumberArray | undefined)[]): void {
    const { buffer } = this.#core.memory;
    for (const source of sources) {
      if (source?.buffer !== buffer) continue;
      const name = typedArrayName(source) as keyof typeof KINDS;
      this.#held.set(source, { name, byteOffset: source.byteOffset, count: lengthOf(source) });
    }
  }

  floats(what: string, source: NumberArray): Block {
    return this.#copy(what, source, Float32Array);
  }

  indices(what: string, source: NumberArray): Block {
    return this.#copy(what, source, Uint32Array);
  }

  doubles(what: string, source: Float64Array): Block {
    return this.#copy(what, source, Float64Array);
  }

  bytes(what: string, source: Uint8Array): Block {
    return this.#copy(what, source, Uint8Array);
  }

  free(): void {
    for (const address of this.#addresses) this.#core.free(address);
  }

  #copy(
    what: string,
    source: NumberArray,
    Kind:
      | Float32ArrayConstructor
      | Float64ArrayConstructor
      | Uint32ArrayConstructor
      | Uint8ArrayConstructor,
  ): Block {
    if (!this.#held.has(source)) this.hold(source);
    const place = this.#held.get(source);
    const count = place?.count ?? lengthOf(source);
    const { memory } = this.#core;
    const address = this.#allocate(what, count * Kind.BYTES_PER_ELEMENT);
    const from = place ? new KINDS[place.name](memory.buffer, place.byteOffset, count) : source;
    // A view of exactly this block: nothing can be written outside it.
    new Kind(memory.buffer, address, count).set(from);
    return { address, count };
  }

  #allocate(what: string, bytes: number): number {
    const address = bytes <= MAX_BYTES ? this.#core.allocate(bytes) : 0;
    if (address === 0) throw outOfMemory(`the ${bytes} bytes of ${what}`);
    this.#addresses.push(address);
    return address;
  }
}

/** The error of an exhausted memory, where there is no room for `what`; the module goes on working. */
export function outOfMemory(what: string): HalfedgeError {
  return new HalfedgeError(
    'out-of-memory',
    `There is no room for ${what} in what WebAssembly has left of its 4 GiB: dispose of meshes that are no longer needed.`,
  );
}
