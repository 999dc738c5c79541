import type { Trail } from '../figure/trail-story.js';
import { type Item, itemName } from '../teaching/items.js';
import { deal, type Trial } from './judge/deal.js';
import type { ExerciseTask } from './judge/task.js';
import type { Failure } from './judge/verdict.js';

/** What the figure beside the editor shows. */
export interface Picture {
  /** The mesh, with all its numbers. */
  readonly bytes: Uint8Array;
  /** The item that the call was about. */
  readonly select: string | null;
  readonly overlays: string;
  /** From where it is seen. */
  readonly camera: string;
  readonly trail: Trail;
  /** How many steps of the trail are shown at first. */
  readonly step: number;
  readonly caption: string;
}

/** A trail that goes on for ever is shown so far. */
const MOST_STEPS = 24;

const LABELS: Readonly<Record<Item['kind'], string>> = {
  vertex: 'vertex-labels',
  face: 'face-labels',
  edge: 'edge-labels',
  halfedge: 'halfedge-labels',
};

/** The mesh on which a program has failed, with what it was asked, where it went, and what it missed. */
export function pictureOf(
  task: ExerciseTask,
  { sample, numbering, mesh }: Trial,
  failure: Failure,
): Picture {
  const steps = failure.steps.slice(0, MOST_STEPS);
  const missing = failure.marks.map(itemName);
  const trail: Trail = {
    sentence: failure.title,
    steps: steps.map(({ item, halfedge, words }) => ({
      item: itemName(item),
      ...(halfedge >= 0 ? { halfedge: `h${halfedge}` } : {}),
      sentence: words,
    })),
    missing,
  };
  return {
    bytes: mesh.toBytes(),
    select: failure.item,
    overlays: overlaysFor(task),
    camera: sample.view.join(' '),
    trail,
    step: steps.length,
    caption: `${capital(sample.words)}${numbering === 'shuffled' ? ', shuffled' : ''}: ${sample.trap}.`,
  };
}

/** A mesh of the task, with one of the items that it is about. */
export function exampleOf(task: ExerciseTask): Picture | null {
  const trials = deal(task, 1);
  try {
    const { mesh, calls, sample } = trials.find(({ calls }) => calls.length > 0) ?? trials[0];
    const parameter = calls[Math.min(2, calls.length - 1)]?.[0];
    return {
      bytes: mesh.toBytes(),
      select: typeof parameter === 'object' ? itemName(parameter) : null,
      overlays: overlaysFor(task),
      camera: sample.view.join(' '),
      trail: { steps: [] },
      step: 0,
      caption: `One of the meshes it is tried on: ${sample.words}.`,
    };
  } finally {
    for (const { mesh } of trials) mesh.dispose();
  }
}

function overlaysFor({ answer }: ExerciseTask): string {
  const kind = 'of' in answer ? answer.of : 'vertex';
  return `halfedges boundary ${LABELS[kind]}`;
}

function capital(words: string): string {
  return words.charAt(0).toUpperCase() + words.slice(1);
}
