// What Node prints of the objects of this package by `console.log`, and what JSON has of those that show
// something. Otherwise a mesh would look empty, and a lap would be all arrays of its mesh.

const INSPECT = Symbol.for('nodejs.util.inspect.custom');

/** Has objects of a class go by its name, and printed as that and what `shown` says of them. */
export function printed<T extends object>(
  name: string,
  { prototype }: { prototype: T },
  shown: (it: T) => object,
): void {
  function inspect(
    this: T,
    _: number,
    options: object,
    inspectAs: (it: object, o: object) => string,
  ) {
    try {
      return `${name} ${inspectAs(shown(this), options)}`;
    } catch (error) {
      return `${name} { ${(error as Error).message} }`; // one that is over
    }
  }
  Object.defineProperty(prototype, INSPECT, { value: inspect });
  named({ [name]: { prototype } });
}

/**
 * Has objects of classes go by their names, which minifiers change. What has a name of its own is no plain
 * object for Vue: it would wrap it in a proxy, which has no #private.
 */
export function named(types: Readonly<Record<string, { prototype: object }>>): void {
  for (const [value, { prototype }] of Object.entries(types)) {
    Object.defineProperty(prototype, Symbol.toStringTag, { value });
  }
}

/** As `printed`; and JSON has what is `shown`, too. */
export function displayed<T extends object>(
  name: string,
  type: { prototype: T },
  shown: (it: T) => object,
): void {
  printed(name, type, shown);
  function toJSON(this: T) {
    return shown(this);
  }
  Object.defineProperty(type.prototype, 'toJSON', { value: toJSON });
}
