const FAR_OFF = 2048; // times its own size, as in the readers of other formats

/**
 * A sentence if floats are too coarse for positions so far from the origin, as a node may put them:
 * vertices that are close together then become one place.
 */
export function noteOfCoarse(positions: Float32Array): string[] {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  positions.forEach((x, i) => {
    if (!Number.isFinite(x)) return;
    low[i % 3] = Math.min(low[i % 3], x);
    high[i % 3] = Math.max(high[i % 3], x);
  });
  const size = Math.max(0, ...high.map((x, axis) => x - low[axis]));
  const farthest = Math.max(0, ...low.map((x) => -x), ...high);
  if (farthest <= FAR_OFF * size) return [];
  const step = 2 ** (Math.floor(Math.log2(farthest)) - 23);
  return [
    `The positions are far from the origin for their size: as floats, which are up to ${Number(step.toPrecision(6))} apart there, they lose what is finer.`,
  ];
}
