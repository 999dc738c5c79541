import type { Input } from './meshes.js';
import { random } from './random.js';

/** A star-shaped polygon in the plane z = 0, counter-clockwise, with many reflex corners. */
export function concavePolygon(seed: number): Input {
  const next = random(seed);
  const corners = 5 + Math.floor(20 * next());
  const positions: number[] = [];
  for (let i = 0; i < corners; i++) {
    const angle = (2 * Math.PI * (i + 0.6 * next())) / corners;
    const radius = 0.3 + 2 * next();
    positions.push(radius * Math.cos(angle), radius * Math.sin(angle), 0);
  }
  return { positions, faces: [Array.from({ length: corners }, (_, i) => i)] };
}
