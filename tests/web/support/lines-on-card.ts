import type { BufferAttribute, InterleavedBufferAttribute } from 'three';
import type { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import type { Card } from './card.js';

/** Draws the segments of a batch of lines: the card takes up what has changed, and these are what it has then. */
export function drawLines(card: Card, geometry: LineSegmentsGeometry): number[][] {
  const [positions, colors] = ['instanceStart', 'instanceColorStart'].map((name) => {
    const { data } = geometry.attributes[name] as InterleavedBufferAttribute;
    const buffer = data as unknown as BufferAttribute;
    card.upload(buffer);
    return card.read(buffer);
  });
  return Array.from({ length: geometry.instanceCount }, (_, i) => [
    ...Array.from({ length: 6 }, (_, k) => positions[6 * i + k]),
    ...Array.from({ length: 3 }, (_, k) => colors[3 * i + k]),
  ]);
}
