// What a program gives a figure to walk along.

import { beforeAll, describe, expect, test } from '@jest/globals';
import { type Trail, TrailStory } from '../../dist/figure/trail-story.js';
import { HalfedgeMesh, init } from '../../dist/index.js';

beforeAll(() => init());

describe('A trail', () => {
  test('is walked item by item, with the halfedges that led there', () => {
    const story = new TrailStory(HalfedgeMesh.cube(), {
      sentence: 'Off we go.',
      steps: [{ item: 'v1', halfedge: 'h2', sentence: 'First.' }, { item: 'v3' }],
      missing: ['f5'],
    });
    expect([story.count, story.words]).toEqual([2, 'Off we go.']);
    story.seek(1);
    expect([story.words, story.visits[0].halfedge]).toEqual(['First.', 2]);
    story.seek(2);
    expect([story.words, story.visits[1].halfedge]).toEqual(['2 of 2: v3', -1]);
    expect(story.missing).toEqual([{ kind: 'face', index: 5 }]);
  });

  test.each<[wrong: unknown, sentence: string]>([
    [{}, 'trail.steps is undefined; expected an array of { item, halfedge, sentence }.'],
    [{ steps: 'v1 v2' }, 'trail.steps is "v1 v2"; expected an array of'],
    [{ steps: [null] }, 'trail.steps[0].item is undefined; expected an item of this mesh'],
    [{ steps: [{ item: 3 }] }, 'trail.steps[0].item is 3; expected an item of this mesh'],
    [
      { steps: [{ item: 'v1' }, { item: 'v99' }] },
      'trail.steps[1].item is "v99"; expected an item',
    ],
    [
      { steps: [{ item: 'v1', halfedge: 'v2' }] },
      'trail.steps[0].halfedge is "v2"; expected a halfedge of this mesh, such as "h7".',
    ],
    [{ steps: [], missing: 'v1' }, 'trail.missing is "v1"; expected an array of names of items.'],
    [{ steps: [], missing: ['w1'] }, 'trail.missing[0] is "w1"; expected an item of this mesh'],
  ])('%j is told what is wrong with it', (trail, sentence) => {
    expect(() => new TrailStory(HalfedgeMesh.cube(), trail as Trail)).toThrow(sentence);
  });
});
