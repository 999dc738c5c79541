import { checkCount } from './checks.js';
import { answer, CHECK_ONLY, done, modeOf, type Refusal, withList } from './edit.js';
import { EulerOperations } from './euler.js';
import type { Edge, EdgeLike, Halfedge, HalfedgeLike, ItemList } from './items.js';
import { linksOf } from './navigation.js';

/**
 * Gluing and cutting along edges, paths and loops. These operations change boundaries, components and genus.
 * The contract is that of `Construction`.
 */
export abstract class Surgery extends EulerOperations {
  /**
   * Makes two boundary edges into one: that of `h`, and that of `g`, which runs the other way. The edge of
   * `h` and its ends stay, with positions and attributes; those of `g` disappear. With `next(h) === g` it
   * closes a gap like a zip.
   *
   * Inverse: `cut(opposite(h))`, if neither of its ends is pinched.
   *
   * @returns the edge of `h`
   * @throws HalfedgeError `not-a-boundary-halfedge`, `repeated-vertex`, `edge-exists`, `duplicate-edge`,
   * `pinched-vertex`
   */
  glue(h: HalfedgeLike, g: HalfedgeLike): Edge {
    const links = linksOf(this);
    links.checkHalfedge(h);
    links.checkHalfedge(g, 'g');
    return done(links, links.core._glue(links.address, modeOf(links), h, g)) as Edge;
  }

  /** Why {@link glue} would be refused, or null. */
  checkGlue(h: HalfedgeLike, g: HalfedgeLike): Refusal | null {
    const links = linksOf(this);
    links.checkHalfedge(h);
    links.checkHalfedge(g, 'g');
    return answer(links, links.core._glue(links.address, CHECK_ONLY, h, g));
  }

  /**
   * Glues `count` edges at once: `h` to `g`, `next(h)` to `prev(g)`, and so on. To glue whole boundary loops,
   * use {@link joinLoop}.
   *
   * Inverse: {@link cutPath} along the same edges, starting from the last, if none of their ends is pinched.
   *
   * @returns the edge of `h`
   * @throws HalfedgeError those of {@link glue}, `not-a-path`
   */
  gluePath(h: HalfedgeLike, g: HalfedgeLike, count: number): Edge {
    const links = linksOf(this);
    links.checkHalfedge(h);
    links.checkHalfedge(g, 'g');
    checkCount('count', count, 1);
    return done(links, links.core._glue_path(links.address, modeOf(links), h, g, count)) as Edge;
  }

  /** Why {@link gluePath} would be refused, or null. */
  checkGluePath(h: HalfedgeLike, g: HalfedgeLike, count: number): Refusal | null {
    const links = linksOf(this);
    links.checkHalfedge(h);
    links.checkHalfedge(g, 'g');
    checkCount('count', count, 1);
    return answer(links, links.core._glue_path(links.address, CHECK_ONLY, h, g, count));
  }

  /**
   * Cuts the surface open along an interior edge that ends on the boundary, which becomes two boundary edges:
   * the edge of `h` keeps the face of `h`, and a copy gets the other face. Each end that lies on the boundary
   * becomes two vertices.
   *
   * Inverse: `glue(opposite(h), returned)`.
   *
   * @returns the new halfedge without a face, which runs in the same direction as `h`
   * @throws HalfedgeError `loop-edge`, `boundary-edge`, `no-boundary-end` (both edges would join the same
   * vertices)
   */
  cut(h: HalfedgeLike): Halfedge {
    const links = linksOf(this);
    links.checkHalfedge(h);
    return done(links, links.core._cut(links.address, modeOf(links), h)) as Halfedge;
  }

  /** Why {@link cut} would be refused, or null. */
  checkCut(h: HalfedgeLike): Refusal | null {
    const links = linksOf(this);
    links.checkHalfedge(h);
    return answer(links, links.core._cut(links.address, CHECK_ONLY, h));
  }

  /**
   * Cuts the surface open along a path of edges, each of which begins where the one before ends. The path may
   * end where it began. Copies of edges and vertices get the faces on the right of the path. In the interior
   * of the surface, the cut leaves a slit.
   *
   * Inverse: `gluePath(opposite(last of the path), returned, count)`, if the path passes no boundary vertex,
   * and no vertex twice. For a path in the interior that ends where it began: `joinLoop` of the same two
   * halfedges.
   *
   * @returns the copy, without a face, of the last halfedge of the path
   * @throws HalfedgeError `not-a-path`, `loop-edge`, `boundary-edge`, `no-boundary-end`
   */
  cutPath(path: ItemList<HalfedgeLike>): Halfedge {
    const links = linksOf(this);
    const cut = (address: number, count: number) =>
      links.core._cut_path(links.address, modeOf(links), address, count);
    return done(links, withList(links, 'path', path, 'halfedge', cut)) as Halfedge;
  }

  /** Why {@link cutPath} would be refused, or null. */
  checkCutPath(path: ItemList<HalfedgeLike>): Refusal | null {
    const links = linksOf(this);
    const check = (address: number, count: number) =>
      links.core._cut_path(links.address, CHECK_ONLY, address, count);
    return answer(links, withList(links, 'path', path, 'halfedge', check));
  }

  /**
   * Cuts the surface open along a set of interior edges, which may form any graph: paths, trees, cycles,
   * crossings, in one piece or several. Each becomes two boundary edges: itself, with the face of
   * `edgeHalfedge(e)`, and a copy with the other face. A vertex becomes as many as there are fans of faces
   * left at it, so the slit just ends at an interior vertex with only one of the edges. At a pinched vertex,
   * one part of each of its fans stays with the others. The resulting mesh, including the numbering, doesn't
   * depend on the order of the list. An empty list changes nothing. O(n log n + sum of the valences of the
   * ends).
   *
   * Inverse: {@link gluePath} or {@link joinLoop} along the new boundaries.
   *
   * @returns for each edge `e`, in the order of the list, the halfedge of its copy that has no face; it runs in
   * the same direction as `edgeHalfedge(e)`
   * @throws HalfedgeError `loop-edge`, `boundary-edge`, `repeated-edge`, `no-boundary-end` (an edge of which
   * neither end lies on the boundary or at another of the edges: both copies would join the same vertices)
   */
  cutEdges(edges: ItemList<EdgeLike>): Halfedge[] {
    const links = linksOf(this);
    let copies: Halfedge[] = [];
    const cut = (address: number, count: number) => {
      const result = links.core._cut_edges(links.address, modeOf(links), address, count);
      // They are where the edges were. The memory may have grown.
      const written = new Int32Array(links.core.memory.buffer, address, Math.max(0, result));
      copies = Array.from(written) as Halfedge[];
      return result;
    };
    done(links, withList(links, 'edges', edges, 'edge', cut));
    return copies;
  }

  /** Why {@link cutEdges} would be refused, or null. */
  checkCutEdges(edges: ItemList<EdgeLike>): Refusal | null {
    const links = linksOf(this);
    const check = (address: number, count: number) =>
      links.core._cut_edges(links.address, CHECK_ONLY, address, count);
    return answer(links, withList(links, 'edges', edges, 'edge', check));
  }

  /**
   * Cuts the surface open along a cycle of n halfedges, and closes both ends with a face of degree n. This
   * separates the surface, or cuts one of its handles. Copies of vertices and edges belong to the left side;
   * the two faces have default attributes.
   *
   * Inverse: `joinLoop(cycle[0], returned)`.
   *
   * @returns a halfedge of the second new face; the first is that of `cycle[0]`
   * @throws HalfedgeError `not-a-cycle`, `repeated-vertex`
   */
  splitLoop(cycle: ItemList<HalfedgeLike>): Halfedge {
    const links = linksOf(this);
    const split = (address: number, count: number) =>
      links.core._split_loop(links.address, modeOf(links), address, count);
    return done(links, withList(links, 'cycle', cycle, 'halfedge', split)) as Halfedge;
  }

  /** Why {@link splitLoop} would be refused, or null. */
  checkSplitLoop(cycle: ItemList<HalfedgeLike>): Refusal | null {
    const links = linksOf(this);
    const check = (address: number, count: number) =>
      links.core._split_loop(links.address, CHECK_ONLY, address, count);
    return answer(links, withList(links, 'cycle', cycle, 'halfedge', check));
  }

  /**
   * Glues the loop of `h` to that of `g`, which runs the other way. The loops are faces or boundary loops
   * with equally many edges. Their faces disappear, as do the vertices and edges of the loop of `g`. Within
   * one component, this adds a handle; it makes two components into one.
   *
   * Inverse: {@link splitLoop} along the loop of `h`, then {@link makeHole} where there was no face.
   *
   * @returns `h`
   * @throws HalfedgeError `same-loop`, `different-degrees`, `repeated-vertex`, `edge-without-face`,
   * `edge-exists`, `duplicate-edge`, `last-edge` (for a segment)
   */
  joinLoop(h: HalfedgeLike, g: HalfedgeLike): Halfedge {
    const links = linksOf(this);
    links.checkHalfedge(h);
    links.checkHalfedge(g, 'g');
    return done(links, links.core._join_loop(links.address, modeOf(links), h, g)) as Halfedge;
  }

  /** Why {@link joinLoop} would be refused, or null. */
  checkJoinLoop(h: HalfedgeLike, g: HalfedgeLike): Refusal | null {
    const links = linksOf(this);
    links.checkHalfedge(h);
    links.checkHalfedge(g, 'g');
    return answer(links, links.core._join_loop(links.address, CHECK_ONLY, h, g));
  }

  /**
   * Joins the loops of `h` and `g`, faces or boundary loops of n edges each, by a tube of n quads, of which
   * the first is between `h` and `g`. The two faces disappear. The quads get the attributes of the face of
   * `h` or, if there is none, of `g`.
   *
   * Inverse: `removeBridge(returned)`, then `makeHole` where there was no face.
   *
   * @returns the new halfedge from `toVertex(h)` to `fromVertex(g)`
   * @throws HalfedgeError `same-loop`, `different-degrees`, `repeated-vertex`, `edge-exists`
   */
  bridge(h: HalfedgeLike, g: HalfedgeLike): Halfedge {
    const links = linksOf(this);
    links.checkHalfedge(h);
    links.checkHalfedge(g, 'g');
    return done(links, links.core._bridge(links.address, modeOf(links), h, g)) as Halfedge;
  }

  /** Why {@link bridge} would be refused, or null. */
  checkBridge(h: HalfedgeLike, g: HalfedgeLike): Refusal | null {
    const links = linksOf(this);
    links.checkHalfedge(h);
    links.checkHalfedge(g, 'g');
    return answer(links, links.core._bridge(links.address, CHECK_ONLY, h, g));
  }

  /**
   * Removes a ring of quads, together with the edges between them, one of which is that of `s`, and closes
   * both ends with a face.
   *
   * Inverse: `bridge(returned, next(s) as it was before)`.
   *
   * @returns the halfedge that was before `s`: one of the first new face
   * @throws HalfedgeError `boundary-edge`, `not-a-quad`, `degree-below-three`, `repeated-vertex`
   */
  removeBridge(s: HalfedgeLike): Halfedge {
    const links = linksOf(this);
    links.checkHalfedge(s, 's');
    return done(links, links.core._remove_bridge(links.address, modeOf(links), s)) as Halfedge;
  }

  /** Why {@link removeBridge} would be refused, or null. */
  checkRemoveBridge(s: HalfedgeLike): Refusal | null {
    const links = linksOf(this);
    links.checkHalfedge(s, 's');
    return answer(links, links.core._remove_bridge(links.address, CHECK_ONLY, s));
  }

  /**
   * Reverses all orientations: each face and each boundary loop runs the other way. Attributes of corners
   * stay with their corners. Values that are directions, such as normals, are not reversed. O(slots).
   *
   * Inverse: itself.
   */
  reverse(): void {
    const links = linksOf(this);
    done(links, links.core._reverse(links.address, modeOf(links)));
  }

  /** Why {@link reverse} would be refused: never, so null. */
  checkReverse(): Refusal | null {
    linksOf(this).checkAlive();
    return null;
  }

  /**
   * Like {@link reverse}, for the connected component of `h`.
   *
   * @returns the number of edges in it
   */
  reverseComponent(h: HalfedgeLike): number {
    const links = linksOf(this);
    links.checkHalfedge(h);
    return done(links, links.core._reverse_component(links.address, modeOf(links), h));
  }

  /** Why {@link reverseComponent} would be refused: never, so null. */
  checkReverseComponent(h: HalfedgeLike): Refusal | null {
    linksOf(this).checkHalfedge(h);
    return null;
  }
}
