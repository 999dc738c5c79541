import { type Direction, HalfedgeMesh, init } from 'halfedge';
import { overlayOf, type Palette } from 'halfedge/scene';
import {
  type Circulator,
  CirculatorPlayer,
  circulators,
  type DialectId,
  dialectOf,
} from 'halfedge/teaching';
import { Color, Vector3 } from 'three';

beforeAll(() => init());

const palette = new Proxy({} as Palette, { get: () => new Color() });
const anchors = { point: () => new Vector3(), side: () => undefined, line: () => undefined };
const nothing = { selected: null, hovered: null, witness: null, first: null };

describe('The trail of a walk around a vertex', () => {
  test.each([
    ['halfedge', 'ccw'],
    ['halfedge', 'cw'],
    ['cgal', 'ccw'],
    ['cgal', 'cw'],
  ] as [DialectId, Direction][])(
    'has the halfedges where the code in the names of %s is, %s',
    (id, direction) => {
      const mesh = HalfedgeMesh.grid(3, 3);
      const circulator = circulators.find(({ name }) => name === 'vertexVertices') as Circulator;
      const player = new CirculatorPlayer(mesh, { circulator, index: 5, direction }, dialectOf(id));
      player.seek(player.count);
      const { marks } = overlayOf({ ...nothing, mesh, visits: player.visits }, palette, anchors);
      const lit = marks
        .filter(({ item }) => item.kind === 'halfedge')
        .map(({ item }) => item.index);
      expect(lit).toHaveLength(player.count);
      const meets = id === 'cgal' ? mesh.toVertex.bind(mesh) : mesh.fromVertex.bind(mesh);
      expect(lit.map(meets)).toEqual(lit.map(() => 5));
      mesh.dispose();
    },
  );
});
