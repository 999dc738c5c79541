import { HalfedgeMesh, init } from 'halfedge';
import {
  labelsText,
  NO_LABELS,
  nextScope,
  parseLabels,
  withKind,
} from '../../web/explorer/app/captions.js';
import { attributesOf } from '../../web/explorer/app/item-attributes.js';

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
