import { HalfedgeMesh, init } from 'halfedge';
import {
  labelsText,
  NO_LABELS,
  nextScope,
  parseLabels,
  withKind,
} from '../../web/explorer/app/captions.js';
import { attributesOf } from '../../web/explorer/app/item-attributes.js';
import { measuresOf } from '../../web/explorer/app/item-measures.js';

beforeAll(() => init());

describe('The choice of names in the picture', () => {
  test('is written as a word, and read again', () => {
    for (const text of ['off:vhf', 'selection:v', 'pointer:', 'all:vehf']) {
      const choice = parseLabels(text);
      expect(choice && labelsText(choice)).toBe(text);
    }
    expect(parseLabels('all:fv')?.kinds).toEqual(['vertex', 'face']);
    for (const text of ['', 'some:v', 'all:x', 'all:v:f']) expect(parseLabels(text)).toBeNull();
  });

  test('goes around all scopes, and keeps the kinds', () => {
    let choice = withKind(NO_LABELS, 'edge', true);
    const scopes = [0, 1, 2, 3].map(() => {
      choice = nextScope(choice);
      return choice.scope;
    });
    expect(scopes).toEqual(['selection', 'pointer', 'all', 'off']);
    expect(choice.kinds).toEqual(['vertex', 'edge', 'halfedge', 'face']);
    expect(withKind(choice, 'vertex', false).kinds).toEqual(['edge', 'halfedge', 'face']);
  });
});

describe('The attributes of an item', () => {
  const texts = (mesh: HalfedgeMesh, kind: 'vertex' | 'face' | 'edge', names = {}) =>
    attributesOf(mesh, { kind, index: 1 }, names).map(({ name, type, text }) =>
      [name, type, text].join(': '),
    );

  test('are the position of a vertex, and what was added for its kind', () => {
    const mesh = HalfedgeMesh.fromPolygons([0, 0, 0, 1.25, 1e-9, -3, 0, 1, 0], [[0, 1, 2]]);
    mesh.attributes.add('vertex', 'colour', { type: 'uint8', components: 3 });
    mesh.attributes.set('vertex', 'colour', 1, [255, 12, 0]);
    mesh.attributes.add('edge', 'crease');
    mesh.attributes.set('edge', 'crease', 1, 1 / 3);
    expect(texts(mesh, 'vertex')).toEqual([
      'position: 3 float32: (1.25, 0, -3)',
      'colour: 3 uint8: (255, 12, 0)',
    ]);
    expect(texts(mesh, 'edge')).toEqual(['crease: float32: 0.3333']);
  });

  test('have the digits of a position that tell it from its neighbours', () => {
    const positions = [0, 0, 0, 4_500_000.5, -100_000.25, 0.001, 1, 1, 0, 1 / 3, -1, -4.371139e-8];
    const mesh = HalfedgeMesh.fromPolygons(positions, [[0, 1, 2]]);
    const positionOf = (index: number) =>
      attributesOf(mesh, { kind: 'vertex', index }, {}).map(({ text }) => text);
    expect(positionOf(1)).toEqual(['(4500000.5, -100000.25, 0.001)']);
    expect(positionOf(3)).toEqual(['(0.33333334, -1, 0)']);
    mesh.setPosition(0, [1.00002, 1.00049, -2e-7]);
    expect(positionOf(0)).toEqual(['(1.00002, 1.00049, 0)']);
    expect(positionOf(2)).toEqual(['(1, 1, 0)']);
    mesh.setPosition(2, [1 / 3, 2 / 3, -0]);
    expect(positionOf(2)).toEqual(['(0.333, 0.667, 0)']);
    mesh.positions.set([1, Infinity, Number.NaN]);
    expect(positionOf(0)).toEqual(['(1, Infinity, NaN)']);
  });

  test('have thousandths of large numbers, as far as 32 bits have them', () => {
    const mesh = HalfedgeMesh.cube();
    mesh.attributes.add('face', 'height');
    const heightOf = (height: number) => {
      mesh.attributes.set('face', 'height', 1, height);
      return texts(mesh, 'face');
    };
    expect(heightOf(100_000.1)).toEqual(['height: float32: 100000.1']);
    expect(heightOf(-100_000.11)).toEqual(['height: float32: -100000.11']);
    expect(heightOf(12.34567)).toEqual(['height: float32: 12.346']);
    expect(heightOf(20_000_000)).toEqual(['height: float32: 20000000']);
  });

  test('have the names of a file where they are places in a list', () => {
    const mesh = HalfedgeMesh.cube();
    mesh.attributes.add('face', 'material', { type: 'int32', default: -1 });
    mesh.attributes.set('face', 'material', 1, 2);
    const names = { material: ['wood', 'glass', 'steel'] };
    expect(texts(mesh, 'face', names)).toEqual(['material: int32: 2 “steel”']);
    mesh.attributes.set('face', 'material', 1, -1);
    expect(texts(mesh, 'face', names)).toEqual(['material: int32: -1']);
    mesh.attributes.set('face', 'material', 1, 1_234_567);
    expect(texts(mesh, 'face', names)).toEqual(['material: int32: 1234567']);
  });
});

test('The measures of an item are those of the package, angles in degrees', () => {
  const mesh = HalfedgeMesh.cube({ size: 2 });
  const measures = (kind: 'vertex' | 'halfedge' | 'edge' | 'face', index = 1) =>
    measuresOf(mesh, { kind, index }).map(({ name, text }) => `${name} ${text}`);
  expect(measures('vertex')).toEqual(['angle defect 90°']);
  expect(measures('halfedge')).toEqual(['corner angle 90°']);
  expect(measures('edge')).toEqual(['length 2', 'dihedral angle 90°']);
  expect(measures('face')).toEqual(['area 4']);
  expect(measuresOf(mesh, { kind: 'edge', index: 1 })[1].type).toBe(
    `dihedralAngle(e) is ${Math.PI / 2}, in radians`,
  );
  mesh.deleteFace(0);
  const [boundary] = mesh.boundaryLoops();
  expect(measures('halfedge', boundary)).toEqual([]);
  expect(measures('edge', boundary >> 1)).toEqual(['length 2']);
});
