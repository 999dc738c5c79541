import { HalfedgeMesh } from '../../api.js';
import { plainOf, type Read } from './outcome.js';

/** No more questions than these are noted: they are the trail that the picture shows. */
const MOST_READS = 240;

/**
 * What a student's function gets as the mesh: the real one, but only with what the exercise allows, and
 * every question is noted. Throws a sentence for anything else.
 */
export function offered(mesh: HalfedgeMesh, uses: readonly string[], reads: Read[]): object {
  const ask =
    (name: string) =>
    (...parameters: unknown[]) => {
      const read = { name, of: plainOf(parameters[0]), gave: null as Read['gave'] };
      if (reads.length < MOST_READS) reads.push(read);
      const method = Reflect.get(mesh, name, mesh) as (...all: unknown[]) => unknown;
      const gave = method.apply(mesh, parameters);
      read.gave = typeof gave === 'number' || typeof gave === 'boolean' ? gave : undefined;
      return gave;
    };
  const methods = new Map(uses.map((name) => [name, ask(name)]));
  return new Proxy(Object.freeze({}), {
    get(_, name) {
      if (typeof name === 'symbol') return undefined;
      if (!uses.includes(name)) throw new TypeError(refusal(name, uses));
      const counted = Reflect.get(mesh, name, mesh);
      return typeof counted === 'function' ? methods.get(name) : counted;
    },
    set(_, name) {
      throw new TypeError(`mesh.${String(name)} can't be set: the mesh is there to be read.`);
    },
  });
}

function refusal(name: string, uses: readonly string[]): string {
  const known = name in HalfedgeMesh.prototype;
  const why = known ? 'is not to be used in this exercise' : 'does not exist';
  return `mesh.${name} ${why}: the mesh has ${uses.join(', ')} here.`;
}
