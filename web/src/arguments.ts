/** A short name for any value, for the sentence of an error. Never throws, never long. */
export function describe(value: unknown): string {
  switch (typeof value) {
    case 'string':
      return value.length <= 40 ? JSON.stringify(value) : `a string of ${value.length} characters`;
    case 'bigint':
      return `the bigint ${shorten(`${value}n`)}`;
    case 'symbol':
      return 'a symbol';
    case 'function':
      return 'a function';
    case 'number':
      return Object.is(value, -0) ? '-0' : String(value);
    case 'object':
      return value === null ? 'null' : describeObject(value);
    default:
      return String(value);
  }
}

function describeObject(value: object): string {
  const typed = typedArrayName(value);
  if (typed !== undefined) return `${withArticle(typed)} of ${(value as Uint8Array).length} elements`;
  try {
    if (Array.isArray(value)) return `an array of ${value.length} elements`;
    return withArticle(Object.prototype.toString.call(value).slice(8, -1));
  } catch {
    return 'an object'; // a revoked proxy, or a getter that throws
  }
}

const shorten = (text: string) => (text.length <= 40 ? text : `${text.slice(0, 37)}...`);
const withArticle = (name: string) => (/^[AEIOU]/.test(name) ? `an ${name}` : `a ${name}`);

const typedArrayTag = Object.getOwnPropertyDescriptor(
  Object.getPrototypeOf(Int8Array.prototype),
  Symbol.toStringTag,
)?.get;

/**
 * "Float32Array" and so on for a typed array, also one of another realm (a frame, a worker's
 * sandbox), where `instanceof` fails; undefined for anything else.
 */
export function typedArrayName(value: unknown): string | undefined {
  return typedArrayTag?.call(value) as string | undefined;
}
