import type { AttributeInfo, AttributeNames, HalfedgeMesh } from 'halfedge';
import type { Item } from 'halfedge/teaching';

/** What an item has besides its links: a position, normals, colours, groups, whatever the file had. */
export interface ShownAttribute {
  readonly name: string;
  /** Its type, such as `3 float32`. */
  readonly type: string;
  /** Its values: `(0.5, 1, 0)`, `7`, `2 “steel”`. */
  readonly text: string;
}

/** The position of a vertex, and all attributes of items of its kind. */
export function attributesOf(
  mesh: HalfedgeMesh,
  of: Item,
  names: AttributeNames,
): ShownAttribute[] {
  const shown: ShownAttribute[] = [];
  if (of.kind === 'vertex') {
    shown.push({ name: 'position', type: '3 float32', text: tuple(mesh.position(of.index)) });
  }
  for (const info of mesh.attributes.list()) {
    if (info.kind !== of.kind) continue;
    const values = mesh.attributes.values(info.kind, info.name, of.index);
    shown.push({ name: info.name, type: typeOf(info), text: textOf(values, names[info.name]) });
  }
  return shown;
}

/** `3 float32`. */
export function typeOf({ type, components }: AttributeInfo): string {
  return components === 1 ? type : `${components} ${type}`;
}

/** The values of an item in words. Some are places in a list of names, as those of groups and materials. */
export function textOf(values: readonly number[], names: readonly string[] | undefined): string {
  const name = values.length === 1 ? names?.[values[0]] : undefined;
  return name === undefined ? tuple(values) : `${values[0]} “${name}”`;
}

function tuple(values: ArrayLike<number>): string {
  const texts = fourDigits(Array.from(values)).map(String);
  return texts.length === 1 ? texts[0] : `(${texts.join(', ')})`;
}

/** Fractions rounded to four digits of the largest, so that rounding errors of a zero are shown as 0. */
function fourDigits(values: readonly number[]): number[] {
  const largest = Math.max(...values.map(Math.abs));
  if (!(largest > 0 && largest < Number.POSITIVE_INFINITY)) return [...values];
  const unit = 10 ** Math.min(0, Math.floor(Math.log10(largest)) - 3);
  return values.map((x) => Number((Math.round(x / unit) * unit).toPrecision(9)) + 0);
}
