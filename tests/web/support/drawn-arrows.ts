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

/** The arrows of two segments each that a card draws, sorted. */
export function drawnArrows(card: Card, geometry: LineSegmentsGeometry): string[] {
  const lines = linesInSight(card, geometry);
  const drawn: string[] = [];
  for (let i = 0; i < lines.length; i += 2) {
    const [shaft, barb] = [lines[i], lines[i + 1]];
    const arrow = describeArrow([...shaft.slice(0, 6), ...barb.slice(3, 6)], shaft.slice(6));
    const again = describeArrow([...shaft.slice(0, 3), ...barb.slice(0, 6)], barb.slice(6));
    // A barb begins where its shaft ends, in the colour of it.
    drawn.push(arrow === again ? arrow : `${arrow} is not ${again}`);
  }
  return drawn.sort();
}
