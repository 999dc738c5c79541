import { HalfedgeMesh, init } from 'halfedge';
import { Loading } from '../../dist/figure/loading.js';
import type { FigureModel } from '../../dist/figure/model.js';
import { startWith } from '../../dist/figure/start.js';

/** What became of a figure with such a source. */
async function outcomeOf(
  src: string,
): Promise<{ message: string; isUnreached: boolean } | 'opened'> {
  const taken: (HalfedgeMesh | null)[] = [];
  const model = { take: (mesh: HalfedgeMesh | null) => taken.push(mesh) };
  return new Promise((settle) => {
    void new Loading(model as unknown as FigureModel, {
      source: () => ({ src, text: null, bytes: null }),
      isBuilt: () => false,
      async opened() {
        expect(taken).toEqual([expect.any(HalfedgeMesh)]);
        taken[0]?.dispose();
        settle('opened');
      },
      failed: (error, isUnreached) => settle({ message: (error as Error).message, isUnreached }),
    }).load();
  });
}

let hasModule = false;
startWith(async () => {
  if (!hasModule) throw new Error('core.wasm could not be fetched.');
  await init();
});
// There is no page here, whose address others are relative to.
Object.assign(globalThis, { document: { baseURI: 'http://figures.test/' } });

test('A figure that lacks the library can be tried again, and then shows its mesh', async () => {
  const message = 'core.wasm could not be fetched.';
  expect(await outcomeOf('shape:cube')).toEqual({ message, isUnreached: true });
  hasModule = true;
  expect(await outcomeOf('shape:cube')).toBe('opened');
});

describe('A figure that has the library', () => {
  const { fetch } = globalThis;
  const gltf = JSON.stringify({
    asset: { version: '2.0' },
    meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
    accessors: [
      {
        bufferView: 0,
        componentType: 5126,
        count: 3,
        type: 'VEC3',
        min: [0, 0, 0],
        max: [1, 1, 0],
      },
    ],
    bufferViews: [{ buffer: 0, byteLength: 36 }],
    buffers: [{ uri: 'triangle.bin', byteLength: 36 }],
    nodes: [{ mesh: 0 }],
    scenes: [{ nodes: [0] }],
    scene: 0,
  });
  const answers: Record<string, () => Response> = {
    'broken.off': () => new Response('OFF\n4 x 0\n'),
    'triangle.gltf': () => new Response(gltf),
  };

  beforeAll(() => {
    hasModule = true;
    globalThis.fetch = async (address) => {
      const name = String(address).split('/').at(-1) ?? '';
      if (name === 'far.off') throw new TypeError('fetch failed');
      return answers[name]?.() ?? new Response(null, { status: 404 });
    };
  });
  afterAll(() => {
    globalThis.fetch = fetch;
  });

  test.each([
    ['far.off', 'far.off could not be fetched.', true],
    ['gone.off', 'the server answered 404', true],
    ['triangle.gltf', 'triangle.bin', true],
    ['broken.off', 'Line 2', false],
    ['shape:sphere', 'shape: and one of', false],
  ])('tells of %s whether it can be tried again', async (src, sentence, isUnreached) => {
    expect(await outcomeOf(src)).toEqual({
      message: expect.stringContaining(sentence),
      isUnreached,
    });
  });
});
