// Links to states of the explorer, without its page.

import { HalfedgeMesh, init } from 'halfedge';
import { fileName } from '../../web/explorer/app/files.js';
import type { Sight, Viewpoint } from '../../web/explorer/app/share.js';
import { importWithoutSamples } from './support/explorer.js';

let Explorer: typeof import('../../web/explorer/app/explorer.js').Explorer;
let share: typeof import('../../web/explorer/app/share.js');
beforeAll(async () => {
  await init();
  share = await importWithoutSamples(() => import('../../web/explorer/app/share.js'));
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
    const link = share.linkOf(explorer, sightAt(viewpoint));
    expect(new URLSearchParams(link).get('camera')).toBe(text);
  });

  test('whose camera is too far away for any picture is refused, and the camera stays', async () => {
    const sight = sightAt([1, 2, 3, 0, 0, 0]);
    const explorer = new Explorer();
    explorer.openMesh('cube', HalfedgeMesh.cube());
    const link = share.linkOf(explorer, sight).replace('camera=1,', 'camera=1e300,');
    await expect(share.follow(link, explorer, sight)).rejects.toThrow(
      'The camera in it is “1e300,2,3,0,0,0”; expected six numbers.',
    );
    expect(sight.at).toEqual([1, 2, 3, 0, 0, 0]);
  });

  test('has the names of the groups of its mesh, and no others', async () => {
    const explorer = new Explorer();
    const names = { group: ['left, wheel', 'a+b & c=d', 'Räder'], material: [] };
    explorer.openMesh('cube', HalfedgeMesh.cube(), names);
    const link = share.linkOf(explorer, sightAt([1, 2, 3, 0, 0, 0]));
    expect(link).toContain('&words.group=left,%20wheel&');
    explorer.openMesh('other', HalfedgeMesh.cube(), { group: ['other'] });
    await share.follow(link, explorer, sightAt([1, 2, 3, 0, 0, 0]));
    expect(explorer.document.value?.names).toEqual({ group: names.group });
    explorer.openMesh('other', HalfedgeMesh.cube());
    const plain = share.linkOf(explorer, sightAt([1, 2, 3, 0, 0, 0]));
    await share.follow(link, explorer, sightAt([1, 2, 3, 0, 0, 0]));
    await share.follow(plain, explorer, sightAt([1, 2, 3, 0, 0, 0]));
    expect(explorer.document.value?.names).toEqual({});
  });

  test('has the tab and what is picked, unless they are those of a new page', async () => {
    const explorer = new Explorer();
    const sight = sightAt([1, 2, 3, 0, 0, 0]);
    explorer.openMesh('cube', HalfedgeMesh.cube());
    const plain = share.linkOf(explorer, sight);
    expect(plain).not.toMatch(/tab=|pick=/);
    explorer.tab.value = 'records';
    explorer.pickMode.value = 'halfedge';
    const link = share.linkOf(explorer, sight);
    expect(link).toMatch(/&tab=records&pick=halfedge&/);
    await share.follow(plain, explorer, sight);
    expect([explorer.tab.value, explorer.pickMode.value]).toEqual(['circulate', 'auto']);
    await share.follow(link, explorer, sight);
    expect([explorer.tab.value, explorer.pickMode.value]).toEqual(['records', 'halfedge']);
  });

  test('has the speed of the player, unless it is that of a new page', async () => {
    const explorer = new Explorer();
    const sight = sightAt([1, 2, 3, 0, 0, 0]);
    explorer.openMesh('cube', HalfedgeMesh.cube());
    const plain = share.linkOf(explorer, sight);
    expect(plain).not.toContain('speed=');
    const { value: usual } = explorer.walker.speed;
    explorer.walker.speed.value = 4;
    const link = share.linkOf(explorer, sight);
    expect(link).toContain('&speed=4&');
    await share.follow(plain, explorer, sight);
    expect(explorer.walker.speed.value).toBe(usual);
    await share.follow(link, explorer, sight);
    expect(explorer.walker.speed.value).toBe(4);
    const wrong = link.replace('speed=4', 'speed=3');
    await expect(share.follow(wrong, explorer, sight)).rejects.toThrow(
      'It has speed=3; expected one of 0.5, 1, 1.5, 2.5, 4, 8.',
    );
  });

  test('has the axis that points up, unless it is y', async () => {
    const explorer = new Explorer();
    const sight = sightAt([1, 2, 3, 0, 0, 0]);
    explorer.openMesh('cube', HalfedgeMesh.cube());
    const plain = share.linkOf(explorer, sight);
    expect(plain).not.toContain('up=');
    explorer.setUp('z');
    const link = share.linkOf(explorer, sight);
    expect(link).toContain('&up=z&');
    await share.follow(plain, explorer, sight);
    expect(explorer.up.value).toBe('y');
    await share.follow(link, explorer, sight);
    expect(explorer.up.value).toBe('z');
    const wrong = link.replace('up=z', 'up=x');
    await expect(share.follow(wrong, explorer, sight)).rejects.toThrow(
      'It has up=x; expected y or z.',
    );
  });

  test('has the axis of its mesh alone: files to come have the one that was chosen for files', async () => {
    const explorer = new Explorer();
    const sight = sightAt([1, 2, 3, 0, 0, 0]);
    const nextUp = () => {
      explorer.openMesh('next', HalfedgeMesh.cube());
      return explorer.up.value;
    };
    explorer.openMesh('cube', HalfedgeMesh.cube());
    const ofY = share.linkOf(explorer, sight);
    explorer.setUp('z');
    const ofZ = share.linkOf(explorer, sight);
    await share.follow(ofY, explorer, sight);
    expect(explorer.up.value).toBe('y');
    expect(nextUp()).toBe('z');
    explorer.setUp('y');
    await share.follow(ofZ, explorer, sight);
    expect(explorer.up.value).toBe('z');
    expect(nextUp()).toBe('y');
  });

  test('puts away what was said of a file before, as a mesh that is made or brought back does', async () => {
    const explorer = new Explorer();
    const sight = sightAt([1, 2, 3, 0, 0, 0]);
    explorer.openMesh('cube', HalfedgeMesh.cube());
    const link = share.linkOf(explorer, sight);
    const failing = () => {
      explorer.openText('nonsense');
      return explorer.failure.value?.title;
    };
    expect(failing()).toBe('What was pasted is no mesh');
    await share.follow(link, explorer, sight);
    expect(explorer.failure.value).toBeNull();
    expect(failing()).toBeDefined();
    explorer.editor.runKey('M');
    expect(explorer.failure.value).toBeNull();
    expect(failing()).toBeDefined();
    explorer.editor.undo();
    expect(explorer.failure.value).toBeNull();
  });

  test('has the problem that is lit of a sample, not of a file, of which it has the mesh alone', async () => {
    const sight = sightAt([1, 2, 3, 0, 0, 0]);
    const light = (explorer: InstanceType<typeof Explorer>) => {
      const problems = [...(explorer.document.value?.diagnosis?.placed ?? [])];
      explorer.showProblem(problems[1]);
      return problems[1];
    };
    const explorer = new Explorer();
    await share.follow('sample=flipped-patch', explorer, sight);
    const { message } = light(explorer);
    const link = share.linkOf(explorer, sight);
    expect(link).toContain('&problem=1&');
    const other = new Explorer();
    await share.follow(link, other, sight);
    expect(other.problem.value?.message).toBe(message);

    const file = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 2\nf 1 2\nf 1 2 3\n';
    const opened = new Explorer();
    await opened.open(new File([file], 'three.obj'));
    light(opened);
    await share.follow(share.linkOf(opened, sight), other, sight);
    expect(other.document.value?.mesh.faceCount).toBe(1);
    expect(other.problem.value).toBeNull();
  });

  test('counts the problems that have a place in the picture', async () => {
    const explorer = new Explorer();
    const following = share.follow('sample=not-there&problem=4', explorer, sightAt([]));
    await expect(following).rejects.toThrow('It has problem=4; expected 0 to 2.');
    const { diagnosis } = explorer.document.value ?? {};
    expect(diagnosis?.findings.flatMap(({ problems }) => problems)).toHaveLength(4);
  });

  test.each(['three-faces', 'crack'])(
    'without a tab to %s has its problems in front',
    async (id) => {
      const explorer = new Explorer();
      await share.follow(`sample=${id}`, explorer, sightAt([1, 2, 3, 0, 0, 0]));
      expect(explorer.tab.value).toBe('problems');
    },
  );

  test.each([
    [
      '&tab=problems',
      'the tab “problems”; expected one of inspect, circulate, edit, mesh, records.',
    ],
    ['&tab=', 'the tab “”; expected one of'],
    ['&pick=Face', 'It picks “Face”; expected one of auto, vertex, edge, halfedge, face.'],
    ['&problem=0', 'It has problem=0; its mesh has no problems.'],
  ])('with %s is told to be wrong', async (word, sentence) => {
    const explorer = new Explorer();
    explorer.openMesh('cube', HalfedgeMesh.cube());
    const link = share.linkOf(explorer, sightAt([1, 2, 3, 0, 0, 0]));
    const following = share.follow(link + word, explorer, sightAt([1, 2, 3, 0, 0, 0]));
    await expect(following).rejects.toThrow(sentence);
  });

  test.each([
    ['insertEdge h0 h99', 'There is no h99: this mesh has halfedge 0 to 23.'],
    ['insertEdge h99 h0', 'There is no h99: this mesh has halfedge 0 to 23.'],
    ['keepLargestComponents', 'Nothing to do: keep the largest.'],
  ])('with the edit %s tells why that is not done', async (edit, why) => {
    const explorer = new Explorer();
    const sight = sightAt([1, 2, 3, 0, 0, 0]);
    explorer.openMesh('cube', HalfedgeMesh.cube());
    const link = `${share.linkOf(explorer, sight)}&edits=${edit}`;
    await expect(share.follow(link, explorer, sight)).rejects.toThrow(
      `The edit “${edit}” in it could not be done. ${why}`,
    );
  });

  test('of a file leads to a mesh that is saved under the same name, as its dual is', async () => {
    const sight = sightAt([1, 2, 3, 0, 0, 0]);
    const explorer = new Explorer();
    await explorer.open(new File(['v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n'], 'part v1.2.OBJ'));
    const saved = () => explorer.document.value && fileName(explorer.document.value, 'off');
    expect(saved()).toBe('part-v1.2.off');
    await share.follow(share.linkOf(explorer, sight), explorer, sight);
    expect(explorer.document.value?.name).toBe('part v1.2.OBJ');
    expect(saved()).toBe('part-v1.2.off');
    explorer.editor.runKey('M');
    expect(saved()).toBe('Dual-of-part-v1.2.off');
  });
});
