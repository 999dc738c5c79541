import { Circulation } from './circulation.js';
import {
  answer,
  CHECK_ONLY,
  checkPosition,
  done,
  modeOf,
  type Position,
  type Refusal,
} from './edit.js';
import type { Edge, EdgeLike, VertexLike } from './items.js';
import { linksOf } from './navigation.js';

/**
 * Operations on the surface. A mesh that is valid stays valid through all of them.
 *
 * What can't be done is refused, and then nothing has changed: the operation throws a HalfedgeError with
 * a code, a sentence, and the items that make it impossible as its `witness`. `check` and the name of an
 * operation tells beforehand: null, or the refusal. Wrong arguments (an index that is out of range or
 * deleted, a position that is none) are a RangeError or a TypeError of both.
 *
 * Live items keep their indices. New items take deleted slots first, and have defined positions and
 * attributes: their docs say which. Each edit ends circulators, orbits and lists of items: get new ones.
 */
export abstract class EulerOperations extends Circulation {
  /**
   * Turns `e` counter-clockwise in the quad of its two triangles: the diagonal 0-2 of the quad 0123
   * becomes 1-3. The edge and both faces keep their indices and attributes. O(valence).
   *
   * Inverse: the same three times; twice turns the edge around.
   *
   * @throws HalfedgeError `boundary-edge`, `not-a-triangle`, `same-vertex` (if the corners opposite to
   * it are one vertex), `edge-exists` (if they are joined already)
   */
  flipEdge(e: EdgeLike): Edge {
    const links = linksOf(this);
    links.checkEdge(e, 'e');
    return done(links, links.core._flip_edge(links.address, modeOf(links), e)) as Edge;
  }

  /** Why {@link flipEdge} would be refused, or null. */
  checkFlipEdge(e: EdgeLike): Refusal | null {
    const links = linksOf(this);
    links.checkEdge(e, 'e');
    return answer(links, links.core._flip_edge(links.address, CHECK_ONLY, e));
  }

  /** A copy of the position of `v`: x, y, z. */
  position(v: VertexLike): [x: number, y: number, z: number] {
    const links = linksOf(this);
    links.checkVertex(v);
    const { positions } = links;
    return [positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]];
  }

  /**
   * Moves `v`, as writing to `positions` does; but history notes this. It is no change of connectivity.
   */
  setPosition(v: VertexLike, position: Position): void {
    const links = linksOf(this);
    links.checkVertex(v);
    const p = checkPosition(position);
    done(links, links.core._set_position(links.address, modeOf(links), v, p[0], p[1], p[2]));
  }
}
