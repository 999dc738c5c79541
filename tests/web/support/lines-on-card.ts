import type { BufferAttribute, InterleavedBufferAttribute } from 'three';
import type { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import type { Card } from './card.js';

/** Draws the segments of a batch of lines: the card takes up what has changed, and these are what it has then. */
export function drawLines(card: Card, geometry: LineSegmentsGeometry): number[][] {
  const [starts, ends, colors] = ['instanceStart', 'instanceEnd', 'instanceColorStart'].map(
    (name) => {
      const { data, offset } = geometry.attributes[name] as InterleavedBufferAttribute;
      const buffer = data as unknown as BufferAttribute;
      card.upload(buffer);
      const numbers = card.read(buffer);
      return (i: number) => [0, 1, 2].map((k) => numbers[data.stride * i + offset + k]);
    },
  );
  return Array.from({ length: geometry.instanceCount }, (_, i) => [
    ...starts(i),
    ...ends(i),
    ...colors(i),
  ]);
}
