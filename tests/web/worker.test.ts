import { HalfedgeError, HalfedgeMesh, init } from 'halfedge';
import { createMeshWorker, MeshWorker, parseInWorker } from 'halfedge/worker';
import { bytesInUse } from './support/core.js';

beforeAll(() => init());

const threadScript = new URL('../../dist/worker-thread.js', import.meta.url).href;

const SQUARE = 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n';
/** The second face runs along the common edge in the same direction as the first. */
const CLASHING = SQUARE.replace('3 0 2 3', '3 0 3 2');

/** A mesh and its report, for comparison with another. */
function shown({ mesh, report }: { mesh: HalfedgeMesh; report: object }) {
  const { problems, ...rest } = report as { problems: object[] };
  return { bytes: Buffer.from(mesh.toBytes()).toString('base64'), problems, ...rest };
}

async function rejection(promise: Promise<unknown>): Promise<Error & { code?: string }> {
  return promise.then(
    () => {
      throw new Error('It resolved.');
    },
    (error) => error,
  );
}

describe('parseInWorker', () => {
  const sphere = () => HalfedgeMesh.icoSphere(3).write('stl') as Uint8Array<ArrayBuffer>;

  test.each([
    ['a string', () => CLASHING],
    ['a typed array', sphere],
    ['a buffer', () => sphere().buffer],
    ['a Blob', () => new Blob([sphere()])],
    ['a file of Node', () => Buffer.from(CLASHING)],
    ['a view of a part', () => new Uint8Array([...Buffer.from(`??${CLASHING}`)]).subarray(2)],
  ])('gives the same mesh and report as parse, of %s', async (_, make) => {
    const source = make();
    const content = source instanceof Blob ? await source.arrayBuffer() : source;
    const expected = HalfedgeMesh.parse(content);
    const actual = await parseInWorker(source);
    expect(actual.mesh).toBeInstanceOf(HalfedgeMesh);
    expect(actual.mesh.validate()).toEqual([]);
    expect(shown(actual)).toEqual(shown(expected));
  });

  test('hands on its options', async () => {
    const { mesh, report } = await parseInWorker('3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n', {
      format: 'off',
      storePrev: false,
    });
    expect(report.format).toBe('off');
    expect(mesh.connectivity.prev.length).toBe(0);
  });

  test('hands on the options that it inherits', async () => {
    const reason = new Error('Too late.');
    const inherited = (options: object) => Object.create(options);
    expect(await rejection(parseInWorker(CLASHING, inherited({ repair: false })))).toMatchObject({
      code: 'opposite-orientation',
    });
    const aborted = inherited({ signal: AbortSignal.abort(reason) });
    expect(await rejection(parseInWorker(SQUARE, aborted))).toBe(reason);
    const worker = createMeshWorker();
    const soup = await worker.fromSoup([0, 0, 0], [], inherited({ dropIsolated: true }));
    worker.terminate();
    expect(soup.mesh.vertexCount).toBe(0);
  });

  test.each([
    ['a file that is none', 'OFF\n3 1 0\n0 0 zero\n', {}],
    ['a strict build', CLASHING, { repair: false }],
    ['an option of the wrong type', SQUARE, { repair: 'yes' }],
    ['an option out of range', SQUARE, { format: 'doc' }],
  ])('throws the error of parse for %s, with all that it has', async (_, source, options) => {
    let expected: unknown;
    try {
      HalfedgeMesh.parse(source, options as object);
    } catch (error) {
      expected = error;
    }
    const actual = await rejection(parseInWorker(source, options as object));
    expect(actual.constructor).toBe((expected as Error).constructor);
    expect(actual).toEqual(expected);
    expect({ ...actual }).toEqual({ ...(expected as object) });
  });

  test('refuses what is no file, no signal and no option before anything is sent', async () => {
    const none = (source: unknown, options: object = {}) =>
      rejection(parseInWorker(source as string, options));
    expect((await none(7)).message).toMatch(/^source is 7; expected the content of a file/);
    expect((await none(SQUARE, { signal: 7 })).message).toContain('options.signal is 7');
    expect((await none(SQUARE, { transfer: 7 })).message).toContain('options.transfer is 7');
    expect((await none(SQUARE, { worker: 7 })).message).toContain('options.worker is 7');
  });

  test('leaves buffers alone, unless they are handed over', async () => {
    const bytes = new Uint8Array(Buffer.from(SQUARE)).slice();
    await parseInWorker(bytes);
    expect(bytes.length).toBe(SQUARE.length);
    const { mesh } = await parseInWorker(bytes, { transfer: true });
    expect(mesh.faceCount).toBe(2);
    expect(bytes.buffer.byteLength).toBe(0);
  });

  test('takes nothing, and starts nothing, where it refuses', async () => {
    let started = 0;
    const worker = () => {
      started += 1;
      throw new Error('Not allowed.');
    };
    const reason = new Error('Too late.');
    const bytes = new Uint8Array(Buffer.from(SQUARE)).slice();
    for (const [options, sentence] of [
      [{ signal: AbortSignal.abort(reason) }, 'Too late.'],
      [{ repair: 'yes' }, 'options.repair is "yes"'],
      [{ format: 'doc' }, 'options.format is "doc"'],
      [{ onProgress: 7 }, 'options.onProgress is 7'],
      [{ storePrev: 7 }, 'options.storePrev is 7'],
    ] as const) {
      const all = { ...options, worker, transfer: true } as object;
      expect((await rejection(parseInWorker(bytes, all))).message).toContain(sentence);
      expect(bytes.length).toBe(SQUARE.length);
    }
    expect((await rejection(parseInWorker(7 as never, { worker }))).message).toContain('source is');
    expect((await rejection(parseInWorker('bunny.obj', { worker }))).message).toContain(
      'source is "bunny.obj", the name of a file',
    );
    expect(started).toBe(0);
  });

  test('copies shared memory, also where it is to be handed over', async () => {
    const bytes = new Uint8Array(new SharedArrayBuffer(SQUARE.length));
    bytes.set(Buffer.from(SQUARE));
    const { mesh } = await parseInWorker(bytes, { transfer: true });
    expect(mesh.faceCount).toBe(2);
    expect(bytes.length).toBe(SQUARE.length);
    mesh.dispose();
  });

  test.each(['Blob', 'File', 'Object'])(
    'reads a Blob that can not be sent, such as jsdom has: %s',
    async (tag) => {
      class OtherBlob {
        readonly [Symbol.toStringTag] = tag;
        readonly size = SQUARE.length;
        slice() {}
        async arrayBuffer() {
          return new TextEncoder().encode(SQUARE).buffer;
        }
      }
      Object.setPrototypeOf(OtherBlob.prototype, Blob.prototype);
      const source = new OtherBlob() as unknown as Blob;
      const { mesh } = await parseInWorker(source);
      expect(mesh.faceCount).toBe(2);
      const controller = new AbortController();
      const aborted = rejection(parseInWorker(source, { signal: controller.signal }));
      controller.abort('Enough.');
      expect(await aborted).toBe('Enough.');
      const worker = createMeshWorker();
      const ended = rejection(worker.parse(source));
      worker.terminate();
      expect((await ended).code).toBe('worker-terminated');
    },
  );

  test('throws what a Blob can not be read for, with its name and its cause', async () => {
    const worker = () => {
      const { Worker } = process.getBuiltinModule('node:worker_threads');
      const script = `
        Blob.prototype.arrayBuffer = async () => {
          const cause = new RangeError('Bad sector.');
          throw Object.assign(new Error('Unreadable.', { cause }), { name: 'NotReadableError' });
        };
        import(${JSON.stringify(threadScript)});`;
      return new Worker(script, { eval: true });
    };
    const error = await rejection(parseInWorker(new Blob([SQUARE]), { worker }));
    expect(error).toMatchObject({ name: 'NotReadableError', message: 'Unreadable.' });
    expect(error.cause).toBeInstanceOf(RangeError);
    expect(error.cause).toMatchObject({ message: 'Bad sector.' });
  });

  test('is cancelled by a signal, before and while it works', async () => {
    const reason = new Error('The user went away.');
    expect(await rejection(parseInWorker(SQUARE, { signal: AbortSignal.abort(reason) }))).toBe(
      reason,
    );
    const controller = new AbortController();
    const { signal } = controller;
    const large = HalfedgeMesh.icoSphere(7).write('obj');
    const told: number[] = [];
    const onProgress = (fraction: number) => {
      told.push(fraction);
      controller.abort(reason);
    };
    expect(await rejection(parseInWorker(large, { signal, onProgress }))).toBe(reason);
    expect(told).toHaveLength(1);
    expect(told[0]).toBeLessThan(1);
  });

  test('is cancelled without a word of the worker', async () => {
    const { Worker } = process.getBuiltinModule('node:worker_threads');
    const worker = () => new Worker('setInterval(() => {}, 1000);', { eval: true });
    const reason = new Error('The user went away.');
    const controller = new AbortController();
    const { signal } = controller;
    const job = rejection(parseInWorker(SQUARE, { signal, worker }));
    controller.abort(reason);
    expect(await job).toBe(reason);
  });
});

describe('A mesh worker', () => {
  let worker: MeshWorker;
  beforeEach(() => {
    worker = createMeshWorker();
  });
  afterEach(() => worker.terminate());

  test('does many jobs, in order, and goes on after one that failed', async () => {
    const order: number[] = [];
    const jobs = [SQUARE, 'OFF\n1 one', CLASHING].map((source, i) =>
      worker.parse(source).finally(() => order.push(i)),
    );
    const [first, second, third] = await Promise.allSettled(jobs);
    expect([first.status, second.status, third.status]).toEqual([
      'fulfilled',
      'rejected',
      'fulfilled',
    ]);
    expect(order).toEqual([0, 1, 2]);
  });

  test('makes meshes of soups, in all three forms', async () => {
    const positions = new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0]);
    const faces = [
      [0, 1, 2],
      [3, 4, 5],
    ];
    const sizes = [3, 3];
    const corners = new Uint32Array(faces.flat());
    const expected = shown(HalfedgeMesh.fromSoup(positions, faces, { weld: true }));
    for (const form of [faces, corners, { sizes, corners }]) {
      expect(shown(await worker.fromSoup(positions, form, { weld: true }))).toEqual(expected);
    }
    const error = await rejection(worker.fromSoup([0, 0], faces));
    expect(error).toBeInstanceOf(RangeError);
    await worker.fromSoup(positions, { sizes, corners }, { transfer: true });
    expect([positions.length, corners.length]).toEqual([0, 0]);
  });

  test('takes two views of one buffer over together', async () => {
    const buffer = new ArrayBuffer(4 * (12 + 6));
    const positions = new Float32Array(buffer, 0, 12);
    const corners = new Uint32Array(buffer, 48, 6);
    positions.set([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]);
    corners.set([0, 1, 2, 0, 2, 3]);
    const { mesh } = await worker.fromSoup(positions, corners, { transfer: true });
    expect([mesh.vertexCount, mesh.faceCount]).toEqual([4, 2]);
    expect([...mesh.positions.subarray(3, 6)]).toEqual([1, 0, 0]);
    expect(buffer.byteLength).toBe(0);
    mesh.dispose();
  });

  test('takes nothing where it refuses a soup, or is terminated', async () => {
    const positions = new Float32Array(12);
    const faces = new Uint32Array(6);
    const soup = (given: unknown, options: object = {}) =>
      rejection(worker.fromSoup(positions, given as Uint32Array, { transfer: true, ...options }));
    expect((await soup(7)).message).toContain('faces is 7');
    expect((await soup(new Uint32Array(5))).message).toContain('faces has 5 numbers');
    expect((await soup({ sizes: [], corners: faces })).message).toContain('faces.sizes is empty');
    expect((await soup(faces, { weld: -1 })).message).toContain('options.weld is -1');
    const reason = new Error('Too late.');
    expect(await soup(faces, { signal: AbortSignal.abort(reason) })).toBe(reason);
    worker.terminate();
    expect(await soup(faces)).toMatchObject({ code: 'worker-terminated' });
    const bytes = new Uint8Array(Buffer.from(SQUARE)).slice();
    await rejection(worker.parse(bytes, { transfer: true }));
    expect([positions.length, faces.length, bytes.length]).toEqual([12, 6, SQUARE.length]);
  });

  test('takes what it is given at that moment', async () => {
    const bytes = new Uint8Array(Buffer.from(SQUARE));
    const before = worker.parse(HalfedgeMesh.icoSphere(5).write('obj'));
    const job = worker.parse(bytes);
    bytes.fill(0);
    await before;
    expect((await job).mesh.faceCount).toBe(2);
  });

  test('when one job is cancelled does the others all the same', async () => {
    const controllers = [new AbortController(), new AbortController()];
    const large = HalfedgeMesh.icoSphere(6).write('obj');
    const running = rejection(worker.parse(large, { signal: controllers[0].signal }));
    const waiting = rejection(worker.parse(large, { signal: controllers[1].signal }));
    const other = worker.parse(SQUARE);
    controllers[1].abort();
    controllers[0].abort();
    expect([(await running).name, (await waiting).name]).toEqual(['AbortError', 'AbortError']);
    expect((await other).mesh.faceCount).toBe(2);
  });

  test('starts no thread for what the same signal cancels', async () => {
    const { Worker } = process.getBuiltinModule('node:worker_threads');
    let started = 0;
    using worker = createMeshWorker({
      worker: () => {
        started += 1;
        return new Worker(new URL(threadScript));
      },
    });
    const controller = new AbortController();
    const { signal } = controller;
    const jobs = Array.from({ length: 8 }, () => rejection(worker.parse(SQUARE, { signal })));
    const other = worker.parse(SQUARE);
    const last = rejection(worker.parse(SQUARE, { signal }));
    controller.abort();
    const errors = await Promise.all([...jobs, last]);
    expect(new Set(errors.map(({ name }) => name))).toEqual(new Set(['AbortError']));
    expect((await other).mesh.faceCount).toBe(2);
    expect(started).toBe(2); // the one that was ended, and one for the other job
  });

  test('does the other jobs when what makes the second thread cancels one, or ends all when it terminates', async () => {
    const { Worker } = process.getBuiltinModule('node:worker_threads');
    const large = HalfedgeMesh.icoSphere(6).write('obj');
    for (const meddles of ['cancels', 'terminates']) {
      const threads: InstanceType<typeof Worker>[] = [];
      const [first, second] = [new AbortController(), new AbortController()];
      using worker: MeshWorker = createMeshWorker({
        worker: () => {
          if (threads.length === 1 && meddles === 'cancels') second.abort();
          if (threads.length === 1 && meddles === 'terminates') worker.terminate();
          threads.push(new Worker(new URL(threadScript)));
          return threads.at(-1) as InstanceType<typeof Worker>;
        },
      });
      const running = rejection(worker.parse(large, { signal: first.signal }));
      const cancelled = rejection(worker.parse(SQUARE, { signal: second.signal }));
      const others = [worker.parse(SQUARE), worker.parse(SQUARE)];
      const outcomes = Promise.allSettled(others);
      first.abort();
      expect((await running).name).toBe('AbortError');
      expect(threads).toHaveLength(2);
      if (meddles === 'cancels') {
        expect((await cancelled).name).toBe('AbortError');
        for (const { mesh } of await Promise.all(others)) expect(mesh.faceCount).toBe(2);
        expect(threads).toHaveLength(2);
      } else {
        const ended = new Promise((resolve) => threads[1].on('exit', resolve));
        expect((await cancelled).code).toBe('worker-terminated');
        for (const { status } of await outcomes) expect(status).toBe('rejected');
        await ended;
      }
    }
  });

  test('listens once to a signal of many jobs, and no longer than for them', async () => {
    const controller = new AbortController();
    const { signal } = controller;
    const { getEventListeners } = process.getBuiltinModule('node:events');
    const listeners = () => getEventListeners(signal, 'abort').length;
    for (let round = 0; round < 2; round++) {
      const jobs = Array.from({ length: 12 }, () => worker.parse(SQUARE, { signal }));
      jobs.push(parseInWorker(SQUARE, { signal }));
      const during = listeners();
      for (const { mesh } of await Promise.all(jobs)) expect(mesh.faceCount).toBe(2);
      expect([during, listeners()]).toEqual([1, 0]);
    }
    const jobs = [worker.parse(SQUARE, { signal }), parseInWorker(SQUARE, { signal })];
    const errors = jobs.map(rejection);
    controller.abort();
    for (const error of errors) expect((await error).name).toBe('AbortError');
    expect(listeners()).toBe(0);
  });

  test('is made by new, too', async () => {
    using worker = new MeshWorker();
    expect((await worker.parse(SQUARE)).mesh.faceCount).toBe(2);
    for (const options of [{ wroker: 3 }, { worker: 3 }, null]) {
      expect(() => new MeshWorker(options as never)).toThrow(TypeError);
    }
  });

  test('once terminated rejects its jobs, and takes no more', async () => {
    const job = rejection(worker.parse(SQUARE));
    worker.terminate();
    expect(await job).toMatchObject({ code: 'worker-terminated' });
    expect(await rejection(worker.parse(SQUARE))).toMatchObject({ code: 'worker-terminated' });
  });

  test('declared with using is terminated at the end of its block', async () => {
    let job: Promise<unknown>;
    {
      using disposed = createMeshWorker();
      job = rejection(disposed.parse(SQUARE));
    }
    expect(await job).toMatchObject({ code: 'worker-terminated' });
  });

  test('leaves nothing in memory here but the mesh', async () => {
    const { mesh } = await worker.parse(SQUARE);
    mesh.dispose();
    const before = bytesInUse();
    for (let i = 0; i < 3; i++) {
      await rejection(worker.parse('OFF\n1 one'));
      (await worker.parse(CLASHING)).mesh.dispose();
    }
    expect(bytesInUse()).toBe(before);
  });
});

test('A thread frees the mesh whose bytes it has no room for', async () => {
  const worker = createMeshWorker({
    worker: () => {
      const { Worker } = process.getBuiltinModule('node:worker_threads');
      const script = `
        import(${JSON.stringify(threadScript.replace('worker-thread', 'mesh'))})
          .then(({ HalfedgeMesh: { prototype } }) => {
            const { dispose } = prototype;
            let disposed = 0;
            prototype.dispose = function () {
              disposed += 1;
              dispose.call(this);
            };
            prototype.toBytes = () => {
              throw new Error(disposed + ' were disposed of before.');
            };
          })
          .then(() => import(${JSON.stringify(threadScript)}));`;
      return new Worker(script, { eval: true });
    },
  });
  const messages = [];
  for (let i = 0; i < 2; i++) messages.push((await rejection(worker.parse(SQUARE))).message);
  worker.terminate();
  expect(messages).toEqual(['0 were disposed of before.', '1 were disposed of before.']);
});

test('The address of a script that starts another is given back once that runs', () => {
  const scope = globalThis as { Worker?: unknown };
  const listeners: Record<string, ((event: object) => void)[]> = {};
  scope.Worker = class {
    constructor(address: URL | string) {
      if (!String(address).startsWith('blob:')) throw new Error('Another site.');
    }
    addEventListener(type: string, listener: (event: object) => void) {
      listeners[type] = [...(listeners[type] ?? []), listener];
    }
    postMessage() {}
    terminate() {}
  };
  const revoke = import.meta.jest.spyOn(URL, 'revokeObjectURL');
  try {
    const worker = createMeshWorker();
    expect(revoke).not.toHaveBeenCalled();
    for (const listener of listeners.error ?? []) listener({});
    expect(revoke).toHaveBeenCalledWith(expect.stringMatching(/^blob:/));
    worker.terminate();
  } finally {
    delete scope.Worker;
    revoke.mockRestore();
  }
});

describe('A worker that can not be started', () => {
  const given = (script: string) =>
    createMeshWorker({
      worker: () => {
        const { Worker } = process.getBuiltinModule('node:worker_threads');
        return new Worker(script, { eval: true });
      },
    });

  test.each([
    ['throws', "throw new Error('No way.')", 'The worker failed: No way.'],
    ['ends', '', 'The worker failed: it has ended.'],
  ])('because its script %s is a HalfedgeError', async (_, script, message) => {
    const worker = given(script);
    const error = await rejection(worker.parse(SQUARE));
    worker.terminate();
    expect(error).toBeInstanceOf(HalfedgeError);
    expect(error).toMatchObject({ code: 'worker-failed', message });
  });

  test('because there is none is one, too', () => {
    const make = () =>
      createMeshWorker({
        worker: () => {
          throw new Error('Not allowed.');
        },
      });
    expect(make).toThrow('The worker failed: Error: Not allowed.');
  });

  test.each([
    ['nothing', () => undefined, 'undefined'],
    ['a promise of one', async () => undefined, 'a Promise, which is to be awaited'],
  ])('because %s was made is one, too', (_, worker, what) => {
    const make = () => createMeshWorker({ worker: worker as never });
    expect(make).toThrow(
      `The worker failed: TypeError: options.worker returned ${what}; expected a worker.`,
    );
  });

  test.each([
    ['an object', '{ ready: true }', 'an Object'],
    ['nothing', 'null', 'null'],
  ])('because it runs another script, which sends %s, is one, too', async (_, message, what) => {
    const worker = given(
      `const { parentPort } = require('node:worker_threads');
      parentPort.on('message', () => parentPort.postMessage(${message}));`,
    );
    const error = await rejection(worker.parse(SQUARE));
    worker.terminate();
    expect(error).toMatchObject({
      code: 'worker-failed',
      message: `The worker failed: it sent ${what}; expected a worker that runs halfedge/worker-thread, of the same version, and sends nothing else.`,
    });
  });

  test('because it was used before is one, too', async () => {
    const { Worker } = process.getBuiltinModule('node:worker_threads');
    const one = new Worker(new URL(threadScript));
    const worker = createMeshWorker({ worker: () => one });
    const controller = new AbortController();
    const job = worker.parse(SQUARE, { signal: controller.signal });
    controller.abort(new Error('No more.'));
    await expect(job).rejects.toThrow('No more.');
    const message =
      'The worker failed: TypeError: options.worker returned a worker that it has returned before; expected a new one each time.';
    await expect(worker.parse(SQUARE)).rejects.toMatchObject({ code: 'worker-failed', message });
    expect(() => createMeshWorker({ worker: () => one })).toThrow(message);
    worker.terminate();
  });

  test('because it has ended is one, too', async () => {
    const { Worker } = process.getBuiltinModule('node:worker_threads');
    const one = new Worker('', { eval: true });
    await new Promise((resolve) => one.on('exit', resolve));
    const message =
      'The worker failed: TypeError: options.worker returned a worker that has ended; expected one that runs.';
    expect(() => createMeshWorker({ worker: () => one })).toThrow(message);
    await expect(parseInWorker(SQUARE, { worker: () => one })).rejects.toMatchObject({
      code: 'worker-failed',
      message,
    });
  });

  test('before init is an error that says what to call', async () => {
    import.meta.jest.resetModules();
    const fresh = (await import('halfedge/worker')) as typeof import('halfedge/worker');
    expect(() => fresh.createMeshWorker()).toThrow('call `await init()` once');
  });
});
