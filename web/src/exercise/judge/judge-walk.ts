// Lists that are right for another question: another kind of item, or a walk around something else.

import type { HalfedgeMesh } from '../../api.js';
import type { Item } from '../../teaching/items.js';
import { sameCycleEitherWay } from './cycles.js';
import { type Asked, type Finding, namesOf, subjectOf } from './finding.js';
import type { Lists } from './judge-cycle.js';
import { wasGiven } from './judge-zero.js';
import type { Read } from './outcome.js';
import { stepsOf } from './trail.js';

type Part = Pick<Finding, 'code' | 'title'> & Partial<Finding>;

/** Other items of the same walk: halfedges where vertices were asked. */
export function otherLists({ asked, of, expected, got, reads }: Lists): Part | null {
  const subject = subjectOf(asked);
  if (!subject || expected.length < 2) return null;
  for (const [kind, words, take, list] of walksAround(asked.mesh, subject)) {
    if (kind === of || !sameCycleEitherWay(got, list) || !cameFrom(kind, got, reads)) continue;
    const plural = { vertex: 'vertices', halfedge: 'halfedges', edge: 'edges', face: 'faces' };
    return {
      code: `returns-${plural[kind]}`,
      title: `It gives back ${words}; ${plural[of]} were asked.`,
      hint: take[of] ? `Of each halfedge h, take ${take[of]}.` : '',
      got: namesOf(kind, got),
      steps: list.map((index, i) => ({
        item: { kind, index },
        halfedge: kind === 'halfedge' ? index : -1,
        words: `${i + 1}: ${namesOf(kind, [index])}`,
      })),
    };
  }
  return null;
}

/**
 * Whether each number is one that a question for this kind of item was answered with: the numbers of one
 * kind may happen to be those of another.
 */
function cameFrom(kind: Item['kind'], got: readonly unknown[], reads: readonly Read[]): boolean {
  return got.every((value) => wasGiven(kind, value as number, reads));
}

type Taken = Partial<Record<Item['kind'], string>>;
type Walk = readonly [kind: Item['kind'], words: string, take: Taken, list: readonly number[]];

const TAKE: Taken = {
  vertex: 'mesh.toVertex(h)',
  face: 'mesh.face(h)',
  edge: 'mesh.edge(h)',
  halfedge: 'h itself',
};

function walksAround(mesh: HalfedgeMesh, { kind, index }: Item): Walk[] {
  switch (kind) {
    case 'vertex':
      return [
        [
          'halfedge',
          'the halfedges that leave the vertex',
          TAKE,
          [...mesh.vertexOutgoingHalfedges(index)],
        ],
        [
          'halfedge',
          'the halfedges that arrive at the vertex',
          { ...TAKE, vertex: 'mesh.fromVertex(h)' },
          [...mesh.vertexIncomingHalfedges(index)],
        ],
        ['vertex', 'vertices', TAKE, [...mesh.vertexVertices(index)]],
        ['face', 'faces', TAKE, [...mesh.vertexFaces(index)]],
        ['edge', 'edges', TAKE, [...mesh.vertexEdges(index)]],
      ];
    case 'face':
      return [
        ['halfedge', 'the halfedges of the face', TAKE, [...mesh.faceHalfedges(index)]],
        ['vertex', 'vertices', TAKE, [...mesh.faceVertices(index)]],
        ['face', 'the faces beside it', TAKE, [...mesh.faceFaces(index)]],
        ['edge', 'edges', TAKE, [...mesh.faceEdges(index)]],
      ];
    case 'halfedge': {
      const loop = [...mesh.halfedgeLoop(index)];
      return [
        ['halfedge', 'halfedges', TAKE, loop],
        [
          'vertex',
          'the vertices that its halfedges lead to',
          TAKE,
          loop.map((h) => mesh.toVertex(h)),
        ],
        [
          'vertex',
          'the vertices that its halfedges leave',
          TAKE,
          loop.map((h) => mesh.fromVertex(h)),
        ],
        ['edge', 'edges', TAKE, loop.map((h) => mesh.edge(h))],
        ['halfedge', 'the opposites', {}, loop.map((h) => mesh.opposite(h))],
      ];
    }
    case 'edge':
      return [];
  }
}

/** A walk around a face instead of a vertex, the other way about, or around the wrong vertex. */
export function wrongWalk(lists: Lists): Part | null {
  const subject = subjectOf(lists.asked);
  if (subject?.kind === 'vertex') return notAroundVertex(lists, subject.index);
  if (subject?.kind === 'face') return notAroundFace(lists, subject.index);
  if (subject?.kind === 'halfedge') return notAlongLoop(lists, subject.index);
  return null;
}

function notAroundVertex({ asked: { mesh }, of, got }: Lists, v: number): Part | null {
  if (mesh.isIsolatedVertex(v)) return null;
  const name = namesOf('vertex', [v]);
  const all = got.every((value) => value === got[0]);
  if (of === 'vertex' && got.length > 0 && all && got[0] === v) {
    return {
      code: 'takes-centre',
      title: `It takes ${name} itself, ${got.length} ${got.length > 1 ? 'times' : 'time'}.`,
      hint: 'Of a halfedge that leaves the vertex, the neighbour is where it leads: toVertex. Of one that arrives there, it is where it comes from: fromVertex.',
    };
  }
  if (got.length < 3) return null;
  const anchor = mesh.vertexHalfedge(v);
  if (of === 'vertex' && all) {
    return {
      code: 'turns-elsewhere',
      title: `It turns around ${namesOf('vertex', [got[0]])}, not around ${name}.`,
      hint: TURNS,
    };
  }
  const loop = [...mesh.halfedgeLoop(anchor)];
  const takes = [(h: number) => mesh.toVertex(h), (h: number) => mesh.fromVertex(h)];
  const corners = takes.map((take) => loop.map(take));
  const walked =
    of === 'face' ? [loop.map((h) => mesh.face(h))] : of === 'vertex' ? corners : [loop];
  if (!walked.some((list) => sameCycleEitherWay(got, list))) return null;
  const face = mesh.face(anchor);
  const around = face < 0 ? 'along a boundary loop' : `around ${namesOf('face', [face])}`;
  return {
    code: 'walks-face',
    title: `It walks ${around}, not around ${name}.`,
    hint: 'next and prev alone stay in one face. To turn around the vertex that h leaves, cross its edge: opposite(prev(h)), or next(opposite(h)).',
  };
}

function notAroundFace({ asked: { mesh }, of, got, reads }: Lists, f: number): Part | null {
  if (got.length < 2 || of === 'face') return null;
  const first = mesh.faceHalfedge(f);
  const left = reads.some(({ name }) => name === 'opposite');
  if (of === 'vertex' && got.every((value) => value === got[0])) {
    return {
      code: 'turns-elsewhere',
      title: `It turns around ${namesOf('vertex', [got[0]])}, not around the face.`,
      hint: LEAVES_FACE,
    };
  }
  // The ring of a vertex may be the corners of another face.
  if (!left) return aroundAnotherFace(mesh, of, got, f);
  for (const v of [mesh.fromVertex(first), mesh.toVertex(first)]) {
    const ring = [...mesh.vertexOutgoingHalfedges(v)];
    const lists = of === 'vertex' ? [ring.map((h) => mesh.toVertex(h))] : [ring];
    if (!lists.some((list) => sameCycleEitherWay(got, list))) continue;
    return {
      code: 'walks-vertex',
      title: `It turns around ${namesOf('vertex', [v])}, not around the face.`,
      hint: LEAVES_FACE,
    };
  }
  return null;
}

function aroundAnotherFace(
  mesh: HalfedgeMesh,
  of: Item['kind'],
  got: readonly unknown[],
  f: number,
): Part | null {
  const other = [...mesh.faces()].find((face) => {
    const own = walksAround(mesh, { kind: 'face', index: face });
    return (
      face !== f && own.some(([kind, , , list]) => kind === of && sameCycleEitherWay(got, list))
    );
  });
  if (other === undefined) return null;
  return {
    code: 'walks-face',
    title: `It walks around ${namesOf('face', [other])}, not around ${namesOf('face', [f])}.`,
    hint: 'An index of a face is none of a halfedge: mesh.faceHalfedge(f) is the halfedge where to begin.',
  };
}

/** How to turn around a vertex, and around which one. */
export const TURNS =
  'opposite(next(h)) turns around the vertex that h leads to. Around the one that it leaves, it is opposite(prev(h)) or next(opposite(h)).';

const LEAVES_FACE = 'With opposite the walk leaves the face. next alone stays in it.';

/** The vertex around which a program has turned in place of the one that was asked about; -1 for none. */
export function turnedAround(asked: Asked, reads: readonly Read[]): number {
  const { mesh } = asked;
  const subject = subjectOf(asked);
  if (subject?.kind !== 'vertex' || mesh.isIsolatedVertex(subject.index)) return -1;
  const other = mesh.toVertex(mesh.vertexHalfedge(subject.index));
  const walked = stepsOf(mesh, reads).map(({ halfedge }) => halfedge);
  const ends = walked.map((h) => [mesh.fromVertex(h), mesh.toVertex(h)]);
  // Both ways of turning around a vertex stay with the halfedges that meet it.
  return walked.length > 4 && ends.every((pair) => pair.includes(other)) ? other : -1;
}

function notAlongLoop({ asked: { mesh }, got }: Lists, h: number): Part | null {
  const other = mesh.opposite(h);
  if (mesh.face(other) < 0 || got.length < 2) return null;
  const across = [...mesh.halfedgeLoop(other)];
  if (!sameCycleEitherWay(got, across)) return null;
  return {
    code: 'walks-face',
    title: `It walks around ${namesOf('face', [mesh.face(other)])}, on the other side of the edge.`,
    hint: 'The boundary loop is on the side of the given halfedge: opposite leads away from it.',
  };
}
