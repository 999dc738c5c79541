import type { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import type { Card } from './card.js';
import { drawLines } from './lines-on-card.js';

/** What lies farther away than this is never in sight. */
const FAR = 1e8;

/** The segments of a batch of lines that a card draws somewhere in sight. */
export function linesInSight(card: Card, geometry: LineSegmentsGeometry): number[][] {
  return drawLines(card, geometry).filter((segment) => segment[0] < FAR);
}

/** An arrow and its colour as text, to be compared. */
export function describeArrow(floats: ArrayLike<number>, color: ArrayLike<number>): string {
  return [...Array.from(floats), '|', ...Array.from(color, Math.fround)].join(' ');
}

/** The arrows that a card draws, sorted: the first geometry has their shafts, the second their barbs. */
export function drawnArrows(card: Card, geometries: readonly LineSegmentsGeometry[]): string[] {
  const [shafts, barbs] = geometries.map((geometry) => linesInSight(card, geometry));
  const drawn = shafts.map((shaft, i) => {
    const barb = barbs[i];
    const arrow = describeArrow([...shaft.slice(0, 6), ...barb.slice(3, 6)], shaft.slice(6));
    const again = describeArrow([...shaft.slice(0, 3), ...barb.slice(0, 6)], barb.slice(6));
    // A barb begins where its shaft ends, in the colour of it.
    return arrow === again ? arrow : `${arrow} is not ${again}`;
  });
  return drawn.sort();
}
