// Links to states of the explorer, without its page.

import { HalfedgeMesh, init } from 'halfedge';
import type { Sight, Viewpoint } from '../../web/explorer/app/share.js';
import { importWithoutSamples } from './support/explorer.js';

let Explorer: typeof import('../../web/explorer/app/explorer.js').Explorer;
let linkOf: typeof import('../../web/explorer/app/share.js').linkOf;
beforeAll(async () => {
  await init();
  ({ linkOf } = await importWithoutSamples(() => import('../../web/explorer/app/share.js')));
  ({ Explorer } = await import('../../web/explorer/app/explorer.js'));
});

/** A camera that stands where it was told to. */
function sightAt(viewpoint: Viewpoint): Sight & { at: Viewpoint } {
  return {
    at: viewpoint,
    viewpoint() {
      return this.at;
    },
    lookFrom(next) {
      this.at = next;
    },
    turnTo() {},
  };
}

describe('a link', () => {
  test.each([
    [[3, 4, 5, 0, 0, 0.5], '3,4,5,0,0,0.5'],
    [[1 / 3, 0, 2, 0, 0, 0], '0.3333,0,2,0,0,0'],
    [[4_500_001.25, 2.5, 0, 4_500_000.5, 0, 1e-9], '4500001.25,2.5,0,4500000.5,0,0'],
    [[1 / 3, 0, 2e5, 0, 0, 0], '0,0,200000,0,0,0'],
    [[3.21e-8, 0, 0, 0, 0, 0], '3.21e-8,0,0,0,0,0'],
  ])('has the digits of the camera that matter where it looks: %j', (viewpoint, text) => {
    const explorer = new Explorer();
    explorer.openMesh('cube', HalfedgeMesh.cube());
    const link = linkOf(explorer, sightAt(viewpoint));
    expect(new URLSearchParams(link).get('camera')).toBe(text);
  });
});
