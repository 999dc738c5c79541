// Answers that are changed arrays of links: first whether they are sound, then whether they are the right ones.

import type { HalfedgeMesh } from '../../api.js';
import { typedArrayName } from '../../arguments.js';
import { type Item, itemName } from '../../teaching/items.js';
import { type Asked, type Finding, finding, namesOf, subjectOf } from './finding.js';
import type { LinkArrays } from './outcome.js';

/** Checks the arrays that a program has left behind, against what the reference makes of the mesh. */
export function judgeLinks(asked: Asked, got: Partial<LinkArrays>): Finding | null {
  const { mesh, task, parameters } = asked;
  const right = mesh.clone();
  const result = mesh.clone();
  try {
    task.reference(right, ...parameters);
    for (const name of Object.keys(mesh.connectivity) as (keyof LinkArrays)[]) {
      const [links, own] = [got?.[name], result.connectivity[name]];
      if (typedArrayName(links) !== 'Int32Array' || links?.length !== own.length) {
        return replaced(name);
      }
      own.set(links);
    }
    return unsound(asked, result, right) ?? otherSurface(result, right, mesh);
  } finally {
    right.dispose();
    result.dispose();
  }
}

function replaced(name: string): Finding {
  return finding({
    code: 'links-replaced',
    title: `links.${name} is no longer the array that it was.`,
    hint: `Write to its elements: links.${name}[h] = …`,
  });
}

function unsound(asked: Asked, result: HalfedgeMesh, right: HalfedgeMesh): Finding | null {
  const { mesh } = asked;
  const errors = result.validate(3).filter(({ severity }) => severity === 'error');
  if (errors.length === 0) return null;
  const [{ code, message, kind, index }] = errors;
  const changed = changedLinks(mesh, result);
  const left = errors.length - 1;
  const more = left > 0 ? ` ${left} more ${left > 1 ? 'do' : 'does'} not fit.` : '';
  const marks: Item[] = errors
    .filter((error) => error.kind !== 'mesh' && error.index >= 0)
    .slice(0, 6)
    .map((error) => ({ kind: error.kind as Item['kind'], index: error.index }));
  return finding({
    code: changed.length === 0 ? 'nothing-changed' : code,
    title: message,
    hint: `${elsewhere(asked, result, right) ?? HINTS[code] ?? 'Go through the links of the items one by one: what does each lead to, and does that lead back?'}${more}`,
    got: someOf(changed),
    marks: kind === 'mesh' || index < 0 ? [] : marks,
  });
}

const MOST_LINKS = 8;

const HINTS: Readonly<Record<string, string>> = {
  'next-prev-mismatch': 'Whenever next[a] = b is set, prev[b] = a has to be set, too.',
  'to-from-mismatch': 'next has to leave the vertex that a halfedge leads to: was toVertex set?',
  'face-mismatch':
    'All halfedges of a loop have the same face: was face set for those that changed sides?',
  'face-halfedge-elsewhere': 'faceHalfedge has to be one of the halfedges that the face has now.',
  'anchor-elsewhere':
    'vertexHalfedge has to leave its vertex: the one that left it before may not do so any more.',
  'interior-anchor': 'At the boundary vertexHalfedge has to be a halfedge without a face.',
};

/** Cut, and counted, where there are many. */
function someOf(changed: readonly string[]): string {
  const first = changed.slice(0, MOST_LINKS).join(', ');
  return changed.length > MOST_LINKS ? `${first}, … (${changed.length})` : first;
}

/** What to say where the program turns other halfedges than those of the edge that it was given. */
function elsewhere(asked: Asked, result: HalfedgeMesh, right: HalfedgeMesh): string | null {
  const subject = subjectOf(asked);
  if (subject?.kind !== 'edge') return null;
  const [old, now, wanted] = [asked.mesh, result, right].map((mesh) => mesh.connectivity.toVertex);
  const wrong = [...old.keys()].filter((h) => wanted[h] === old[h] && now[h] !== old[h]);
  if (wrong.length === 0) return null;
  const h = 2 * subject.index;
  return `toVertex of ${namesOf('halfedge', wrong)} has to stay: the halfedges of ${itemName(subject)} are h${h} and h${h + 1}, which is 2 * e and 2 * e + 1.`;
}

/** What the program has changed: `next[3]: 5 → 7`. */
function changedLinks(before: HalfedgeMesh, after: HalfedgeMesh): string[] {
  const old = before.connectivity as LinkArrays;
  return (Object.entries(after.connectivity) as [keyof LinkArrays, Int32Array][]).flatMap(
    ([name, links]) =>
      [...links].flatMap((value, i) =>
        value === old[name][i] ? [] : [`${name}[${i}]: ${old[name][i]} → ${value}`],
      ),
  );
}

function otherSurface(
  result: HalfedgeMesh,
  right: HalfedgeMesh,
  mesh: HalfedgeMesh,
): Finding | null {
  const [got, expected, before] = [result, right, mesh].map(cornersOf);
  const wrong = got.filter((corners) => !expected.includes(corners));
  const wanted = expected.filter((corners) => !got.includes(corners));
  if (wrong.length === 0 && wanted.length === 0) return null;
  if (changedLinks(mesh, result).length === 0) {
    return finding({
      code: 'nothing-changed',
      title: 'All links are what they were before.',
      hint: 'Write to the elements of the arrays: links.next[h] = … What is done to copies of them, or given back, changes nothing.',
      expected: facesOf(wanted),
    });
  }
  const untouched = got.every((corners) => before.includes(corners));
  return finding({
    code: untouched ? 'nothing-changed' : 'other-surface',
    title: untouched
      ? 'The links are sound, but the faces are what they were before.'
      : 'The links are sound, but the faces are not what they should be.',
    hint: 'Draw both faces before and after, and write down the halfedges of each in their order.',
    got: facesOf(wrong),
    expected: facesOf(wanted),
  });
}

/** The faces by their corners, each from its least vertex on. */
function cornersOf(mesh: HalfedgeMesh): string[] {
  return [...mesh.faces()].map((f) => {
    const corners = [...mesh.faceVertices(f)].map(Number);
    const least = corners.indexOf(Math.min(...corners));
    return namesOf('vertex', [...corners.slice(least), ...corners.slice(0, least)]);
  });
}

function facesOf(faces: readonly string[]): string {
  return faces.length === 0 ? 'no further face' : faces.map((corners) => `(${corners})`).join(' ');
}
