// Lists that go round: the same cycle can be written down from each of its members on.

type List = readonly unknown[];

export function sameList(a: List, b: List): boolean {
  return a.length === b.length && a.every((value, i) => value === b[i]);
}

/** The list from its `k`-th member on. */
export function rotated<T>(list: readonly T[], k: number): T[] {
  return [...list.slice(k), ...list.slice(0, k)];
}

/** The list the other way round, from the same member on. */
export function turned<T>(list: readonly T[]): T[] {
  return list.length === 0 ? [] : [list[0], ...list.slice(1).reverse()];
}

/** Whether these are the same cycle, whatever they begin with. */
export function sameCycle(a: List, b: List): boolean {
  if (a.length !== b.length) return false;
  return a.length === 0 || a.some((_, k) => sameList(rotated(a, k), b));
}

export function sameCycleEitherWay(a: List, b: List): boolean {
  return sameCycle(a, b) || sameCycle(a, turned(b));
}

/** Whether the list is a run of the cycle without a gap, in either direction. */
export function isRun(list: List, cycle: List): boolean {
  return [cycle, turned(cycle)].some((way) =>
    way.some((_, k) => sameList(rotated(way, k).slice(0, list.length), list)),
  );
}
