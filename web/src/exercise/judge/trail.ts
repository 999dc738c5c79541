import type { HalfedgeMesh } from '../../api.js';
import { type Item, isLive, itemName } from '../../teaching/items.js';
import { type Asked, isIndex, subjectOf, type TrailStep } from './finding.js';
import type { Read } from './outcome.js';

/** More steps than these make no picture. */
const MOST_STEPS = 60;

/** The members of a list as steps, each with the halfedge that carries it where there is one. */
export function stepsTo(asked: Asked, of: Item['kind'], list: readonly unknown[]): TrailStep[] {
  const { mesh } = asked;
  const subject = subjectOf(asked);
  return list
    .filter(isIndex)
    .map((index) => ({ kind: of, index }))
    .filter((item) => isLive(mesh, item))
    .slice(0, MOST_STEPS)
    .map((item, i, { length }) => ({
      item,
      halfedge: carrierOf(mesh, subject, item),
      words: `${i + 1} of ${length}: ${itemName(item)}`,
    }));
}

/** The halfedge that leads from what is asked about to the item; -1 for none. */
function carrierOf(mesh: HalfedgeMesh, subject: Item | null, { kind, index }: Item): number {
  if (kind === 'halfedge') return index;
  if (kind === 'vertex' && subject?.kind === 'vertex')
    return mesh.findHalfedge(subject.index, index);
  if (kind === 'vertex' && subject?.kind === 'face') {
    return [...mesh.faceHalfedges(subject.index)].find((h) => mesh.toVertex(h) === index) ?? -1;
  }
  return -1;
}

/** The halfedges that a program went to, one step for each of its questions that led to one. */
export function stepsOf(mesh: HalfedgeMesh, reads: readonly Read[]): TrailStep[] {
  const steps: TrailStep[] = [];
  for (const { name, of, gave } of reads) {
    if (!LEADS.has(name) || !isIndex(gave) || !isLive(mesh, { kind: 'halfedge', index: gave })) {
      continue;
    }
    const from = name === 'vertexHalfedge' ? 'v' : name === 'faceHalfedge' ? 'f' : 'h';
    steps.push({
      item: { kind: 'halfedge', index: gave },
      halfedge: gave,
      words: `${name}(${from}${String(of)}) = h${gave}`,
    });
    if (steps.length >= MOST_STEPS) break;
  }
  return steps;
}

/** Those questions whose answer is a halfedge. */
const LEADS = new Set(['next', 'prev', 'opposite', 'vertexHalfedge', 'faceHalfedge']);
