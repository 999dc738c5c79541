import { HalfedgeError, HalfedgeMesh, init, type ParseStage } from 'halfedge';
import { parseInWorker } from 'halfedge/worker';
import { bytesInUse } from './support/core.js';

let sphere: HalfedgeMesh;
let files: Record<string, string | Uint8Array>;
beforeAll(async () => {
  await init();
  sphere = HalfedgeMesh.icoSphere(7); // 327,680 faces: some MB in each format
  const text = (format: 'ply' | 'off' | 'stl') => sphere.write(format, { encoding: 'text' });
  files = {
    OBJ: sphere.write('obj'),
    OFF: text('off'),
    'binary OFF': sphere.write('off', { encoding: 'binary' }),
    PLY: text('ply'),
    'binary PLY': sphere.write('ply'),
    'big-endian PLY': sphere.write('ply', { encoding: 'binary-big-endian' }),
    STL: text('stl'),
    'binary STL': sphere.write('stl'),
  };
});
afterAll(() => sphere.dispose());

const formats = [
  'OBJ',
  'OFF',
  'binary OFF',
  'PLY',
  'binary PLY',
  'big-endian PLY',
  'STL',
  'binary STL',
];

/** The faces of the sphere, every tenth of them turned over. */
function clashing(): string {
  const { sizes, corners } = sphere.toPolygons();
  const rows = Array.from(sizes, (_, f) => {
    const [a, b, c] = corners.subarray(3 * f, 3 * f + 3);
    return f % 10 === 0 ? `3 ${a} ${c} ${b}` : `3 ${a} ${b} ${c}`;
  });
  const positions = (files.OFF as string).split('\n').slice(0, 2 + sphere.vertexCount);
  return [...positions, ...rows].join('\n');
}

type Told = [stage: ParseStage, fraction: number];

describe('onProgress', () => {
  test.each(formats)('tells how much of a file is read: %s', (format) => {
    const file = files[format];
    const told: Told[] = [];
    const { mesh } = HalfedgeMesh.parse(file, {
      onProgress: (fraction, stage) => told.push([stage, fraction]),
    });
    expect(mesh.faceCount).toBe(sphere.faceCount);
    mesh.dispose();
    const read = told.filter(([stage]) => stage === 'read').map(([, fraction]) => fraction);
    const megabytes = file.length / 2 ** 20;
    expect(read.length).toBeGreaterThan(megabytes * 0.8 - 2);
    expect(read.length).toBeLessThanOrEqual(megabytes);
    expect(read).toEqual([...read].sort((a, b) => a - b));
    expect(read.every((fraction) => fraction > 0 && fraction <= 1)).toBe(true);
    expect(read.at(-1)).toBeGreaterThan(1 - 1.3 / megabytes);
    const build: Told[] = [
      ['build', 0],
      ['build', 1],
    ];
    expect(told.slice(read.length)).toEqual(build);
  });

  test('tells of repairs where they are necessary', () => {
    const stages: ParseStage[] = [];
    const { mesh } = HalfedgeMesh.parse(clashing(), {
      onProgress: (_, stage) => {
        if (stages.at(-1) !== stage) stages.push(stage);
      },
    });
    mesh.dispose();
    expect(stages).toEqual(['read', 'build', 'repair', 'build']);
  });

  test('is told of a strict build, too', () => {
    const told: Told[] = [];
    const options = { repair: false, onProgress: (f: number, s: ParseStage) => told.push([s, f]) };
    HalfedgeMesh.parse('OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n', options).mesh.dispose();
    expect(told).toEqual([
      ['build', 0],
      ['build', 1],
    ]);
  });

  test.each(formats)('cancels with false, and leaves nothing behind: %s', (format) => {
    const before = bytesInUse();
    let calls = 0;
    const parse = () =>
      HalfedgeMesh.parse(files[format], {
        onProgress: (fraction) => {
          calls += 1;
          return fraction < 0.3;
        },
      });
    expect(parse).toThrow(
      new HalfedgeError('cancelled', 'Reading was cancelled, as onProgress returned false.'),
    );
    expect(calls).toBeLessThan(2 + (0.4 * files[format].length) / 2 ** 20);
    expect(bytesInUse()).toBe(before);
  });

  test.each(['repair', 'build'])('cancels in the stage %s', (last) => {
    const before = bytesInUse();
    const file = clashing();
    const onProgress = (_: number, stage: ParseStage) => stage !== last;
    expect(() => HalfedgeMesh.parse(file, { onProgress })).toThrow('Reading was cancelled');
    if (last === 'build') {
      expect(() => HalfedgeMesh.parse(file, { onProgress, repair: false })).toThrow('cancelled');
    }
    expect(bytesInUse()).toBe(before);
  });

  test('what it throws is thrown, and what aborts the signal', () => {
    const before = bytesInUse();
    const mine = new Error('Mine.');
    const throwing = () => {
      throw mine;
    };
    expect(() => HalfedgeMesh.parse(files.OBJ, { onProgress: throwing })).toThrow(mine);
    const controller = new AbortController();
    const { signal } = controller;
    const onProgress = () => controller.abort(mine);
    expect(() => HalfedgeMesh.parse(files.OBJ, { onProgress, signal })).toThrow(mine);
    expect(() => HalfedgeMesh.parse('OFF 0 0 0', { signal })).toThrow(mine); // from the start
    expect(bytesInUse()).toBe(before);
  });

  test('is heard at each call, the last one as well, with repair and without', () => {
    const before = bytesInUse();
    const file = sphere.write('stl') as Uint8Array;
    for (const repair of [true, false]) {
      let calls = 0;
      const count = () => {
        calls += 1;
      };
      HalfedgeMesh.parse(file, { repair, onProgress: count }).mesh.dispose();
      expect(calls).toBeGreaterThan(3);
      for (let ended = 0; ended < calls; ended++) {
        const at = (index: number, end: () => unknown) => {
          let call = 0;
          return () => (call++ === index ? end() : undefined);
        };
        const parse = (end: () => unknown, signal?: AbortSignal) => () =>
          HalfedgeMesh.parse(file, {
            repair,
            onProgress: at(ended, end),
            ...(signal ? { signal } : {}),
          });
        const mine = new Error(`Mine, in call ${ended} of ${calls}.`);
        const throwing = () => {
          throw mine;
        };
        const controller = new AbortController();
        expect(parse(throwing)).toThrow(mine);
        expect(parse(() => false)).toThrow('Reading was cancelled');
        expect(parse(() => controller.abort(mine), controller.signal)).toThrow(mine);
      }
    }
    expect(bytesInUse()).toBe(before);
  });

  test('may use the library meanwhile', () => {
    const { mesh } = HalfedgeMesh.parse(files['binary PLY'], {
      onProgress: () => HalfedgeMesh.icoSphere(5).dispose(),
    });
    expect(mesh.validate()).toEqual([]);
    mesh.dispose();
  });

  test('must be a function', () => {
    const parse = () => HalfedgeMesh.parse('OFF 0 0 0', { onProgress: 7 as never });
    expect(parse).toThrow('options.onProgress is 7; expected a function.');
  });
});

describe('onProgress of a worker', () => {
  test('is told here, in order', async () => {
    const told: Told[] = [];
    const { mesh } = await parseInWorker(files.OBJ, {
      onProgress: (fraction, stage) => told.push([stage, fraction]),
    });
    mesh.dispose();
    const here: Told[] = [];
    HalfedgeMesh.parse(files.OBJ, {
      onProgress: (fraction, stage) => here.push([stage, fraction]),
    }).mesh.dispose();
    expect(told).toEqual(here);
  });

  test('cancels with false, and with what it throws', async () => {
    const rejected = (onProgress: () => unknown) =>
      parseInWorker(files.OBJ, { onProgress }).then(
        () => 'resolved',
        (error) => error,
      );
    expect(await rejected(() => false)).toMatchObject({ code: 'cancelled' });
    const mine = new Error('Mine.');
    const throwing = () => {
      throw mine;
    };
    expect(await rejected(throwing)).toBe(mine);
    expect(await rejected(7 as never)).toMatchObject({
      message: 'options.onProgress is 7; expected a function.',
    });
  });
});
