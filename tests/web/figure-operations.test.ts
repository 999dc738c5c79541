// The operations of a figure, step by step. They are a part of the package that no entry exports.

import { beforeAll, describe, expect, test } from '@jest/globals';
import { DeedStory } from '../../dist/figure/deed-story.js';
import { HalfedgeMesh, init } from '../../dist/index.js';

beforeAll(() => init());

/** The operations on a grid, and what it is before and after each of them. */
function told(operation: string, prepare = (_: HalfedgeMesh) => {}) {
  const mesh = HalfedgeMesh.grid(4, 3, { triangles: true });
  const story = new DeedStory(mesh, operation);
  prepare(mesh);
  const states = [mesh.toBytes()];
  while (states.length <= story.count) {
    story.seek(states.length);
    states.push(mesh.toBytes());
  }
  expect(story.refusal).toBe(null);
  return { mesh, story, states };
}

describe('Operations, step by step', () => {
  test.each([
    'triangulate',
    'triangulate f0',
    'compact',
    'orientOutward',
    'stitchBoundaries',
    'keepLargestComponents',
    'deleteIsolatedVertices',
  ])('are taken back one by one, also where %s has nothing to do', (idle) => {
    const { mesh, story, states } = told(`flip e5, ${idle}, split e9, ${idle}`);
    for (let step = story.count; step-- > 0; ) {
      story.seek(step);
      expect(mesh.toBytes()).toEqual(states[step]);
    }
    expect(story.words).toBe('Before: flip e5.');
  });

  test('tell of new numbers wherever one of several steps made them', () => {
    const { story } = told('deleteFace f3, compact, flip e5');
    expect(story.seek(2)?.renumbers).toBe(false);
    expect(story.seek(0)?.renumbers).toBe(true);
    expect(story.seek(3)?.renumbers).toBe(true);
  });

  test('are taken back with what a program has done since', () => {
    const { mesh, story, states } = told('flip e5, split e9');
    mesh.poke(0);
    mesh.poke(1);
    expect(story.seek(1)?.renumbers).toBe(true); // there is no telling which item came from where
    expect(mesh.toBytes()).toEqual(states[1]);
    expect(story.words).toBe('Done: flip e5.');
  });

  test('are not taken back twice where a program has undone them', () => {
    const { mesh, story, states } = told('flip e5, split e9');
    mesh.history.undo();
    story.seek(1);
    expect(mesh.toBytes()).toEqual(states[1]);
    story.seek(0);
    expect(mesh.toBytes()).toEqual(states[0]);
  });

  test('are taken back as far as a limit of the history lets them', () => {
    const { mesh, story, states } = told(
      'flip e5, triangulate, split e9, extrude f2, inset f3',
      (it) => it.history.limit({ steps: 2 }),
    );
    for (const step of [4, 3]) {
      story.seek(step);
      expect(mesh.toBytes()).toEqual(states[step]);
    }
    story.seek(0);
    expect(mesh.toBytes()).toEqual(states[3]);
  });
});
