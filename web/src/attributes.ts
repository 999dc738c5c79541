import { describe, lengthOfArrayLike, listFrom } from './arguments.js';
import { indexOfChoice, refuse } from './checks.js';
import { checkGivenPosition, done, KINDS, kindIndex, modeOf } from './edit.js';
import { HalfedgeError } from './errors.js';
import { printed } from './inspect.js';
import type { ItemKind, ItemLike } from './items.js';
import { nameIn } from './letters.js';
import { checkItem, type Links, slotCount } from './links.js';
import type { Core } from './loader.js';
import { withInputs } from './memory.js';
import { checkOptions, type OptionNames } from './options.js';
import { unwrap } from './reports.js';

/** The types of the numbers of an attribute; in the order of the enum Scalar in C++. */
export const TYPES = {
  float32: Float32Array,
  float64: Float64Array,
  int8: Int8Array,
  uint8: Uint8Array,
  int16: Int16Array,
  uint16: Uint16Array,
  int32: Int32Array,
  uint32: Uint32Array,
};
/** In the order of the enum OnSplit in C++. */
const POLICIES = ['interpolate', 'normalize', 'copy', 'default', 'copy-corner'] as const;
export const TYPE_NAMES = Object.keys(TYPES) as AttributeType[];

/** The type of the numbers of an attribute. */
export type AttributeType = keyof typeof TYPES;
/**
 * The value that an operation gives to an item that it makes out of others: the weighted mean, the mean
 * scaled to length 1 (for normals), the value of the item with the largest weight ('copy', or 'copy-corner'
 * where values of halfedges are those of corners, such as labels with seams), or the default.
 */
export type OnSplit = (typeof POLICIES)[number];
/** The typed array that shows an attribute. */
export type AttributeView<Type extends AttributeType = AttributeType> = InstanceType<
  (typeof TYPES)[Type]
>;

/** How an attribute is defined when it is added. */
export interface AttributeOptions<Type extends AttributeType = AttributeType> {
  /** Default: 'float32'. */
  type?: Type | undefined;
  /** Numbers for each item, 1 to 16. Default: 1. */
  components?: number | undefined;
  /** The value of new items: one number for all components, or one for each. Default: 0. */
  default?: number | ArrayLike<number> | Iterable<number> | undefined;
  /** Default: 'interpolate'. */
  onSplit?: OnSplit | undefined;
  /** Ignored, so that you can pass an entry of {@link Attributes.list}, of this mesh or another one. */
  kind?: ItemKind | undefined;
  /** Ignored. */
  name?: string | undefined;
}

const ATTRIBUTE_OPTIONS: OptionNames<AttributeOptions> = {
  type: true,
  components: true,
  default: true,
  onSplit: true,
  kind: true,
  name: true,
};

/** An attribute as it was added. */
export interface AttributeInfo {
  readonly kind: ItemKind;
  readonly name: string;
  readonly type: AttributeType;
  readonly components: number;
  /** The value of new items, as rounded to the type. */
  readonly default: readonly number[];
  readonly onSplit: OnSplit;
}

/** A column as JavaScript knows it: `address` names it to the core; its view is made when asked for. */
interface Column {
  readonly info: AttributeInfo;
  readonly address: number;
  view: AttributeView;
  /** The value of `links.changes` up to which the view is known to be good. */
  changes: number;
}

/** By kind and name, in the order added. */
type Columns = Readonly<Record<ItemKind, Map<string, Column>>>;

/**
 * Named columns of numbers on the vertices, halfedges, edges or faces of a mesh. They follow every edit: new
 * items get what `onSplit` says, deleted slots are kept in step, and undo restores values.
 *
 * With 'interpolate', 'normalize' and 'copy-corner', the value of a halfedge belongs to the corner where it
 * ends, in its face, like texture coordinates with seams. With the other policies, it belongs to the halfedge itself.
 *
 * The positions are the vertex attribute `position`, which always exists and is not listed.
 *
 * ```ts
 * const colors = mesh.attributes.add('vertex', 'color', { components: 3, default: 1 });
 * colors[3 * v] = 0.5;
 * ```
 */
export class Attributes {
  readonly #links: Links;
  #columns: Columns | undefined;

  /** @internal */
  constructor(links: Links) {
    this.#links = links;
  }

  /**
   * Adds an attribute, with its default for each item. History forgets steps that could be redone; undo doesn't
   * remove the attribute again, and a group that throws leaves it.
   *
   * ```ts
   * for (const info of other.attributes.list()) mesh.attributes.add(info.kind, info.name, info);
   * ```
   *
   * @returns its live view, like {@link get}
   * @throws HalfedgeError `attribute-exists`, `bad-attribute` (its name is empty), `out-of-memory`;
   * RangeError for components that don't fit, and for a name with half a character (a lone surrogate)
   */
  add<Type extends AttributeType = 'float32'>(
    kind: ItemKind,
    name: string,
    options: AttributeOptions<Type> = {},
  ): AttributeView<Type> {
    checkName(kind, name);
    const { type, components, onSplit, defaults } = settingsOf(options);
    const { core } = this.#links;
    if (/\p{Surrogate}/u.test(name)) {
      refuse('name', name, 'a string of whole characters, without lone surrogates', 'string');
    }
    const columns = this.#all()[kind];
    if (kind === 'vertex' && name === POSITION) {
      throw new HalfedgeError(
        'attribute-exists',
        'Every mesh has the attribute "position" of vertices: its positions.',
      );
    }
    if (columns.has(name)) {
      throw new HalfedgeError(
        'attribute-exists',
        `There is a ${kind} attribute ${describe(name)} already.`,
      );
    }
    const { attribute } = withInputs(core, (inputs) => {
      const text = inputs.bytes('name', new TextEncoder().encode(name));
      const values = inputs.doubles('default', Float64Array.from(defaults));
      return unwrap(
        core.addAttribute(
          this.#links.address,
          KINDS.indexOf(kind),
          text.address,
          text.count,
          TYPE_NAMES.indexOf(type),
          components,
          POLICIES.indexOf(onSplit),
          values.address,
          values.count,
        ),
      );
    });
    columns.set(name, newColumn(core, { kind, name, type, components, onSplit }, attribute));
    return this.get(kind, name) as AttributeView<Type>;
  }

  /**
   * The live values of an attribute, zero-copy: `components` numbers for each slot, in an array of the
   * attribute's type. Write to it to set them. It becomes stale in the same way as `positions`: when the
   * number of slots changes or room is made for more of them, when the WebAssembly memory grows, or when the
   * mesh is disposed of. It is good exactly as long as the next `get` returns the same array.
   *
   * @throws RangeError if there is no such attribute
   */
  get<Type extends AttributeType = AttributeType>(
    kind: ItemKind,
    name: string,
  ): AttributeView<Type> {
    if (this.#isPosition(kind, name))
      return this.#links.positions as AttributeView as AttributeView<Type>;
    return this.#view(this.#find(kind, name)) as AttributeView<Type>;
  }

  /** Whether this attribute exists. */
  has(kind: ItemKind, name: string): boolean {
    return this.#isPosition(kind, name) || this.#all()[kind].has(name);
  }

  /**
   * Removes an attribute; its views are then stale. Undo doesn't bring it back, nor does a group that throws.
   *
   * @returns whether it existed
   * @throws RangeError for the positions, which every mesh has
   */
  remove(kind: ItemKind, name: string): boolean {
    if (this.#isPosition(kind, name)) {
      refuse('name', name, 'an attribute that was added, as a mesh keeps its positions', 'string');
    }
    const columns = this.#all()[kind];
    const column = columns.get(name);
    if (column === undefined) return false;
    const { core, address } = this.#links;
    core.removeAttribute(address, column.address);
    return columns.delete(name);
  }

  /**
   * All attributes that were added: first those of vertices, then of halfedges, edges and faces, each in the
   * order added.
   */
  list(): AttributeInfo[] {
    const columns = this.#all();
    return KINDS.flatMap((kind) => Array.from(columns[kind].values(), ({ info }) => info));
  }

  /**
   * Sets the values of one item: one number, or one for each component, as an array, or as a vector or colour
   * of three.js. Like writing to the view, except that history records it. For integer types, numbers are
   * rounded and clamped to the range; NaN is refused.
   */
  set<Kind extends ItemKind>(
    kind: Kind,
    name: string,
    item: ItemLike<Kind>,
    values: number | ArrayLike<number> | Iterable<number>,
  ): void {
    const links = this.#links;
    if (this.#isPosition(kind, name)) {
      const [x, y, z] = checkGivenPosition(
        typeof values === 'number' ? [values, values, values] : values,
        'values',
      );
      links.checkVertex(item, 'item');
      done(links, links.core._set_position(links.address, modeOf(links), item, x, y, z));
      return;
    }
    const { components, type } = this.#find(kind, name).info;
    const numbers = numbersOf('values', values, components, type);
    const column = this.#find(kind, name); // again: reading the values may have removed it
    checkItem(links, kind, item);
    const { core, address } = links;
    done(links, core._set_attribute(address, modeOf(links), column.address, item, 0, numbers[0]));
    // History has noted all numbers of the item together with the first: noting it again for each of the
    // others would take as much memory each time.
    const view = this.#view(column);
    for (let i = 1; i < components; i++) view[components * item + i] = rounded(type, numbers[i]);
  }

  /** A copy of the values of one item. */
  values<Kind extends ItemKind>(kind: Kind, name: string, item: ItemLike<Kind>): number[] {
    if (this.#isPosition(kind, name)) {
      this.#links.checkVertex(item, 'item');
      return Array.from(this.#links.positions.subarray(3 * item, 3 * item + 3));
    }
    const column = this.#find(kind, name);
    checkItem(this.#links, kind, item);
    const { components } = column.info;
    const view = this.#view(column);
    const values: number[] = []; // many times as fast as an array of a subarray
    for (let i = 0; i < components; i++) values.push(view[components * item + i]);
    return values;
  }

  /** Whether it is the positions that are asked for: no column, unless one of a file has that name. */
  #isPosition(kind: ItemKind, name: string): boolean {
    checkName(kind, name);
    return kind === 'vertex' && name === POSITION && !this.#all().vertex.has(POSITION);
  }

  #all(): Columns {
    const { core, address } = this.#links; // throws if disposed
    if (this.#columns === undefined) {
      const columns = { vertex: new Map(), halfedge: new Map(), edge: new Map(), face: new Map() };
      for (const raw of core.listAttributes(address)) {
        const info = {
          kind: KINDS[raw.kind],
          name: nameIn(raw.name),
          type: TYPE_NAMES[raw.type],
          components: raw.components,
          onSplit: POLICIES[raw.onSplit],
        };
        columns[info.kind].set(info.name, newColumn(core, info, raw.attribute));
      }
      this.#columns = columns;
    }
    return this.#columns;
  }

  #find(kind: ItemKind, name: string): Column {
    const columns = this.#all()[kind];
    const column = columns.get(name);
    if (column !== undefined) return column;
    const known = [...columns.keys()].map((other) => describe(other)).join(', ') || 'none';
    throw new RangeError(
      `name is ${describe(name)}; expected an attribute of this mesh by ${kind}: ${known}.`,
    );
  }

  #view(column: Column): AttributeView {
    const links = this.#links;
    const { info, view } = column;
    const length = info.components * slotCount(links, info.kind);
    if (column.changes === links.changes && view.length === length) return view;
    const { core } = links;
    const address = core._attribute_values(column.address) >>> 0;
    const isThere = view.byteOffset === address && view.buffer === core.memory.buffer;
    const isGood = view.length === length && (length === 0 || isThere);
    column.changes = links.changes;
    if (!isGood) {
      const View = TYPES[info.type];
      const fresh = length === 0 ? new View(0) : new View(core.memory.buffer, address, length);
      column.view = links.own(fresh);
    }
    return column.view;
  }
}

printed('Attributes', Attributes, (attributes) => attributes.list());

function newColumn(core: Core, info: Omit<AttributeInfo, 'default'>, address: number): Column {
  const View = TYPES[info.type];
  const at = core._attribute_default(address) >>> 0;
  const value = Object.freeze(Array.from(new View(core.memory.buffer, at, info.components)));
  const { kind, name, type, components, onSplit } = info;
  return {
    info: Object.freeze({ kind, name, type, components, default: value, onSplit }),
    address,
    view: new View(0),
    changes: -1,
  };
}

/** What the positions are called among the attributes of vertices. */
const POSITION = 'position';

/** Throws a sentence for what is no kind or no name. */
function checkName(kind: unknown, name: unknown): void {
  kindIndex(kind);
  if (typeof name !== 'string') refuse('name', name, 'a string');
}

function settingsOf(options: AttributeOptions) {
  const {
    type = 'float32' as AttributeType,
    components = 1,
    default: given = 0,
    onSplit = 'interpolate',
  } = checkOptions(options, ATTRIBUTE_OPTIONS);
  indexOfChoice('type', type, TYPE_NAMES);
  indexOfChoice('onSplit', onSplit, POLICIES);
  if (!(Number.isInteger(components) && components >= 1 && components <= 16)) {
    refuse('components', components, 'an integer from 1 to 16', 'number');
  }
  return { type, components, onSplit, defaults: numbersOf('default', given, components, type) };
}

/** One number for each component, of an array or of a single number for all. */
function numbersOf(
  argument: string,
  given: unknown,
  components: number,
  type: AttributeType,
): number[] {
  if (typeof given === 'number') {
    if (!canHold(type, given)) refuseNumber(argument, given, type);
    return new Array(components).fill(given);
  }
  const expected = `a number, or ${components === 1 ? 'an array of one' : `${components} of them`}`;
  const list = listFrom(given) as ArrayLike<unknown>;
  if (lengthOfArrayLike(argument, list, expected) !== components) {
    throw new RangeError(`${argument} is ${describe(list)}; expected ${expected}.`);
  }
  const numbers: number[] = [];
  for (let i = 0; i < components; i++) {
    const value = list[i];
    if (!canHold(type, value)) refuseNumber(`${argument}[${i}]`, value, type);
    numbers.push(value);
  }
  return numbers;
}

/** Whether the type can hold it, rounded or at its end where need be. */
function canHold(type: AttributeType, value: unknown): value is number {
  return typeof value === 'number' && (!Number.isNaN(value) || type.startsWith('float'));
}

/** As the core converts numbers: to the nearest integer, of two the even one, and no further than the type goes. */
function rounded(type: AttributeType, value: number): number {
  if (type.startsWith('float')) return value;
  const bits = 8 * TYPES[type].BYTES_PER_ELEMENT;
  const least = type.startsWith('u') ? 0 : -(2 ** (bits - 1));
  const near = Math.round(value);
  const even = near - value === 0.5 && near % 2 !== 0 ? near - 1 : near;
  return Math.min(Math.max(even, least), least + 2 ** bits - 1);
}

function refuseNumber(argument: string, value: unknown, type: AttributeType): never {
  if (typeof value !== 'number') refuse(argument, value, 'a number');
  refuse(argument, value, `a number that ${type} can hold`, 'number');
}
