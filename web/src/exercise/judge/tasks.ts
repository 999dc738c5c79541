import type { ExerciseTask } from './task.js';
import {
  boundaryLoop,
  faceVertices,
  oneRing,
  previous,
  vertexFaces,
  vertexVertices,
} from './tasks-around.js';
import {
  countBoundaryLoops,
  eulerCharacteristic,
  isBoundaryVertex,
  valence,
} from './tasks-counting.js';
import { flipEdge } from './tasks-links.js';

/** The exercises that the package has, in the order of a course. */
export const tasks: readonly ExerciseTask[] = [
  faceVertices,
  vertexVertices,
  oneRing,
  vertexFaces,
  valence,
  isBoundaryVertex,
  previous,
  boundaryLoop,
  countBoundaryLoops,
  eulerCharacteristic,
  flipEdge,
];

/** The task of that name. Throws a sentence where there is none. */
export function taskNamed(name: string): ExerciseTask {
  const found = tasks.find((task) => task.name === name);
  if (found) return found;
  const known = tasks.map((task) => task.name).join(', ');
  throw new Error(`task is “${name}”; expected one of ${known}.`);
}
