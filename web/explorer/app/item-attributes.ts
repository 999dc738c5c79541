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
    const text = tuple(positionTexts(mesh, of.index));
    shown.push({ name: 'position', type: '3 float32', text });
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
  return name === undefined ? tuple(fourDigits(values).map(String)) : `${values[0]} “${name}”`;
}

/**
 * The coordinates of a vertex: to thousandths, and where edges are short, to so many digits as tell it from its
 * neighbours. One without any has all digits, but for rounding errors of a zero.
 */
export function positionTexts(mesh: HalfedgeMesh, vertex: number): string[] {
  const position = mesh.position(vertex);
  const shortest = shortestEdge(mesh, vertex, position);
  const unit = 10 ** Math.min(-3, Math.floor(Math.log10(shortest)) - 2);
  const error = Math.min(1, Math.max(...position.map(Math.abs))) * ROUNDING;
  return position.map((x) => {
    const digits = fewestDigits(x);
    if (unit > 0) return String(roundedTo(unit, digits));
    return String(Math.abs(x) < error ? 0 : digits);
  });
}

/** Half of the distance from 1 to the next 32-bit float. */
const ROUNDING = 2 ** -24;
/** So many neighbours are looked at: a vertex may have thousands. */
const MOST_NEIGHBOURS = 32;

/** The length of the shortest edge at a vertex; NaN where there is none that has a length. */
function shortestEdge(mesh: HalfedgeMesh, vertex: number, from: readonly number[]): number {
  let shortest = Infinity;
  let left = MOST_NEIGHBOURS;
  for (const neighbour of mesh.vertexVertices(vertex)) {
    const to = mesh.position(neighbour);
    const length = Math.hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
    if (length > 0 && length < shortest) shortest = length;
    left -= 1;
    if (left === 0) break;
  }
  return Number.isFinite(shortest) ? shortest : Number.NaN;
}

function tuple(texts: readonly string[]): string {
  return texts.length === 1 ? texts[0] : `(${texts.join(', ')})`;
}

/** Rounded to four digits of the largest, at least to thousandths: rounding errors of a zero are shown as 0. */
function fourDigits(values: readonly number[]): number[] {
  const largest = Math.max(...values.map(Math.abs));
  if (!(largest > 0 && largest < Infinity)) return [...values];
  const unit = 10 ** (Math.min(0, Math.floor(Math.log10(largest))) - 3);
  return values.map((x) => roundedTo(unit, fewestDigits(x)));
}

function roundedTo(unit: number, x: number): number {
  return Number.isInteger(x) ? x + 0 : Number((Math.round(x / unit) * unit).toPrecision(15)) + 0;
}

/** The number with the fewest digits that is the same 32-bit float; one that is none as it is. */
function fewestDigits(x: number): number {
  if (Math.fround(x) !== x) return x;
  for (let digits = 6; digits < 9; digits++) {
    const short = Number(x.toPrecision(digits));
    if (Math.fround(short) === x) return short;
  }
  return Number(x.toPrecision(9));
}
