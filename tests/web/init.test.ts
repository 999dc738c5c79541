import { readFileSync } from 'node:fs';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { createContext, runInContext } from 'node:vm';
import { build as bundle } from 'esbuild';
import { HalfedgeError, HalfedgeMesh, init } from 'halfedge';

const address = new URL('../../dist/core.wasm', import.meta.url);
const bytes = readFileSync(address);

type Halfedges = typeof import('halfedge');

/** The package as if imported for the first time: nothing is loaded yet. */
async function fresh(entry = 'halfedge'): Promise<Halfedges> {
  import.meta.jest.resetModules();
  return (await import(entry)) as Halfedges;
}

function expectWorking({ HalfedgeMesh }: Halfedges): void {
  using mesh = HalfedgeMesh.fromTriangles([0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 2]);
  expect(mesh.validate()).toEqual([]);
}

async function rejection(promise: Promise<unknown>): Promise<HalfedgeError> {
  return promise.then(
    () => {
      throw new Error('It resolved.');
    },
    (error) => error,
  );
}

describe('Before init', () => {
  const uses: [string, (api: Halfedges) => unknown][] = [
    ['a build', ({ HalfedgeMesh }) => HalfedgeMesh.fromTriangles([], [])],
    [
      'a build of integers and floats',
      (api) => api.HalfedgeMesh.fromTriangles(Uint8Array.of(0, 0, 0), Float32Array.of(0, 0, 0)),
    ],
    ['a build from polygons', ({ HalfedgeMesh }) => HalfedgeMesh.fromPolygons([], [])],
    ['an empty mesh', ({ HalfedgeMesh }) => new HalfedgeMesh()],
    ['a file', ({ HalfedgeMesh }) => HalfedgeMesh.parse('OFF 0 0 0')],
  ];
  test.each(uses)('%s is an error that says what to call', async (_, use) => {
    const api = await fresh();
    expect(() => use(api)).toThrow(api.HalfedgeError);
    expect(() => use(api)).toThrow('call `await init()` once, before any mesh is made');
    try {
      use(api);
    } catch (error) {
      expect(error).toMatchObject({ code: 'not-initialised' });
    }
  });
});

describe('init', () => {
  test('finds the module beside its own file', async () => {
    const api = await fresh();
    await api.init();
    expectWorking(api);
  });

  test('is idempotent, also while it is loading, and whatever it is given then', async () => {
    const api = await fresh();
    const twice = [api.init(), api.init({ wasm: bytes }), api.init()];
    await Promise.all(twice);
    using mesh = new api.HalfedgeMesh();
    await api.init({ wasm: 'http://localhost:1/nothing' });
    expect(mesh.vertexCount).toBe(0);
    expectWorking(api);
  });

  test('tries in its own way where another one fails that was there before', async () => {
    const api = await fresh();
    const [wrong, missing, right] = await Promise.allSettled([
      api.init({ wasm: 5 as never }),
      api.init({ wasm: 'http://localhost:1/nothing' }),
      api.init({ wasm: bytes }),
    ]);
    expect(wrong).toMatchObject({ status: 'rejected', reason: expect.any(TypeError) });
    expect(missing).toMatchObject({ status: 'rejected', reason: { code: 'init-failed' } });
    expect(right.status).toBe('fulfilled');
    expectWorking(api);
    await expect(api.init({ wasm: null as never })).rejects.toThrow('wasm is null; expected a URL');
  });

  const sources: [string, () => unknown][] = [
    ['a URL', () => address],
    ['the string of a URL', () => address.href],
    ['an absolute path', () => fileURLToPath(address)],
    ['a relative path', () => relative('.', fileURLToPath(address))],
    ['an ArrayBuffer', () => Uint8Array.from(bytes).buffer],
    ['a Uint8Array', () => Uint8Array.from(bytes)],
    ['a Buffer', () => bytes],
    ['a view inside a buffer', () => Uint8Array.from([9, 9, ...bytes, 9]).subarray(2, -1)],
    ['a DataView', () => new DataView(Uint8Array.from(bytes).buffer)],
    [
      'shared memory',
      () => {
        const shared = new Uint8Array(new SharedArrayBuffer(bytes.length));
        shared.set(bytes);
        return shared;
      },
    ],
    ['a compiled module', () => new WebAssembly.Module(bytes)],
  ];
  test.each(sources)('takes %s', async (_, source) => {
    const api = await fresh();
    await api.init({ wasm: source() as Uint8Array });
    expectWorking(api);
  });

  test('has an entry with the module embedded', async () => {
    const api = await fresh('halfedge/inline');
    await api.init();
    expectWorking(api);
  });

  test.each([
    [5, 'wasm is 5; expected a URL, a string, an ArrayBuffer'],
    [{}, 'wasm is an Object; expected a URL'],
    [true, 'wasm is true; expected a URL'],
    [Symbol('x'), 'wasm is a symbol; expected a URL'],
    [[1, 2], 'wasm is an array of 2 elements; expected a URL'],
  ])('refuses %p as the module', async (wasm, message) => {
    const api = await fresh();
    const error = await rejection(api.init({ wasm: wasm as string }));
    expect(error).toBeInstanceOf(TypeError);
    expect(error.message).toContain(message);
    await api.init();
    expectWorking(api);
  });

  test('refuses options that are no object', async () => {
    const api = await fresh();
    const module = await WebAssembly.compile(bytes);
    const nowhere = Promise.reject(new Error('404'));
    nowhere.catch(() => {});
    for (const options of [null, 5, 'core.wasm', bytes, bytes.buffer, module, nowhere]) {
      const error = await rejection(api.init(options as never));
      expect(error).toBeInstanceOf(TypeError);
      expect(error.message).toContain('expected an object such as { wasm }');
    }
  });

  test('refuses options that there are not', async () => {
    const api = await fresh();
    const error = await rejection(api.init({ locateFile: () => '' } as never));
    expect(error).toBeInstanceOf(TypeError);
    expect(error.message).toBe('options has the name "locateFile"; expected wasm.');
  });

  test('refuses a buffer that was transferred away', async () => {
    const api = await fresh();
    const { buffer } = Uint8Array.from(bytes);
    structuredClone(buffer, { transfer: [buffer] });
    const error = await rejection(api.init({ wasm: buffer }));
    expect(error.message).toContain('wasm is a detached buffer');
  });

  const strangers: [string, Uint8Array, string][] = [
    [
      'a page',
      new TextEncoder().encode('<!DOCTYPE html><title>x'),
      'it begins with "<!DOCTYPE html>',
    ],
    [
      'an image',
      Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0, 1, 2, 3, 4),
      'it begins with the bytes 89 50 4e 47 00 01 02 03;',
    ],
    ['nothing', new Uint8Array(), 'it is empty'],
  ];
  test.each(strangers)('says that %s is not WebAssembly', async (_, content, says) => {
    const api = await fresh();
    const error = await rejection(api.init({ wasm: content }));
    expect(error).toBeInstanceOf(api.HalfedgeError);
    expect(error.code).toBe('not-webassembly');
    expect(error.message).toContain(says);
    await api.init();
    expectWorking(api);
  });

  test('says that a damaged module does not compile', async () => {
    const api = await fresh();
    const error = await rejection(api.init({ wasm: bytes.subarray(0, 5000) }));
    expect(error.code).toBe('init-failed');
    expect(error.message).toMatch(/can't be compiled: .+/);
  });

  test("says that somebody else's module can't be started", async () => {
    const api = await fresh();
    const empty = Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0);
    const error = await rejection(api.init({ wasm: empty }));
    expect(error.code).toBe('init-failed');
    expect(error.message).toContain('Does core.wasm belong to this version of the package?');
    await api.init();
    expectWorking(api);
  });

  test('names a file that is not there', async () => {
    const api = await fresh();
    const error = await rejection(api.init({ wasm: new URL('./no-such.wasm', import.meta.url) }));
    expect(error.code).toBe('init-failed');
    expect(error.message).toMatch(/no-such\.wasm: ENOENT/);
    expect(error.cause).toBeDefined();
  });

  test('names an address that is none', async () => {
    const api = await fresh();
    const error = await rejection(api.init({ wasm: 'http://' }));
    expect(error.code).toBe('init-failed');
    expect(error.message).toContain('wasm is "http://"; expected an address');
  });
});

test('init says what to do in a bundle for a server, whose addresses are those of pages', async () => {
  const api = await fresh();
  // As webpack and Turbopack make it of `new URL('./core.wasm', import.meta.url)`.
  const href = { value: '/_next/static/media/core.wasm' };
  const wasm: URL = Object.create(URL.prototype, { href, protocol: { value: '' } });
  const error = await rejection(api.init({ wasm }));
  expect(error.code).toBe('init-failed');
  expect(error.message).toMatch(
    /from \/_next\/static\/media\/core\.wasm: .*Import from 'halfedge\/inline'/,
  );
});

/** The package in a bundle that takes itself for the script at an address; without one, it has none. */
async function bundled(address?: string): Promise<Halfedges> {
  const { outputFiles } = await bundle({
    entryPoints: [fileURLToPath(new URL('../../dist/index.js', import.meta.url))],
    bundle: true,
    format: 'esm',
    write: false,
    ...(address ? { define: { 'import.meta.url': JSON.stringify(address) } } : {}),
  });
  const script = Buffer.from(outputFiles[0].contents).toString('base64');
  return import(`data:text/javascript;base64,${script}`);
}

test('init says what to do in a script that has no address', async () => {
  const api = await bundled();
  const error = await rejection(api.init());
  expect(error.code).toBe('init-failed');
  expect(error.message).toContain(
    "call init({ wasm }) with an address or a compiled module, or import from 'halfedge/inline'",
  );
  await api.init({ wasm: bytes });
  expectWorking(api);
});

test('init says what to do where programs may not compile WebAssembly', async () => {
  const api = await fresh('halfedge/inline');
  const options = { codeGeneration: { strings: true, wasm: false } }; // as in Cloudflare Workers
  const { compile } = runInContext('WebAssembly', createContext({}, options));
  const spy = import.meta.jest.spyOn(WebAssembly, 'compile').mockImplementation(compile);
  const error = await rejection(api.init());
  spy.mockRestore();
  expect(error.code).toBe('init-failed');
  expect(error.message).toMatch(
    /^The WebAssembly module from halfedge\/inline can't be compiled: /,
  );
  expect(error.message).toMatch(/disallowed by embedder.*'halfedge\/core\.wasm'.*init\({ wasm }\)/);
  await api.init({ wasm: await WebAssembly.compile(bytes) });
  expectWorking(api);
});

describe('init, from a server,', () => {
  let server: Server;
  let base: string;
  const answers: Record<
    string,
    [status: number, type: string | undefined, body: Uint8Array | string]
  > = {
    '/right.wasm': [200, 'application/wasm', bytes],
    '/octets.wasm': [200, 'application/octet-stream', bytes],
    '/untyped.wasm': [200, undefined, bytes],
    '/page.wasm': [200, 'text/html', '<!DOCTYPE html><html>'],
    '/lying.wasm': [200, 'application/wasm', '<!DOCTYPE html><html>'],
    '/missing.wasm': [404, 'text/html', '<h1>Not found</h1>'],
    '/forbidden/core.wasm': [403, 'text/html', '<h1>Forbidden</h1>'],
    '/down/core.wasm': [503, 'text/html', '<h1>Try again</h1>'],
    '/damaged/core.wasm': [200, 'application/wasm', bytes.subarray(0, 5000)],
    '/missing/core.wasm': [404, 'text/html', '<h1>Not found</h1>'],
    '/page/core.wasm': [200, 'text/html', '<!DOCTYPE html><html>'],
    '/node_modules/halfedge/dist/core.wasm': [404, 'text/html', '<h1>Not found</h1>'],
  };
  beforeAll(async () => {
    server = createServer((request, response) => {
      const answer = answers[request.url ?? ''];
      if (answer === undefined) return request.socket.destroy();
      const [status, type, body] = answer;
      response.writeHead(status, type === undefined ? {} : { 'content-type': type });
      response.end(body);
    });
    await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
    base = `http://127.0.0.1:${(server.address() as AddressInfo).port}`;
  });
  afterAll(() => server.close());

  test.each(['/right.wasm', '/octets.wasm', '/untyped.wasm'])('loads %s', async (path) => {
    const api = await fresh();
    await api.init({ wasm: base + path });
    expectWorking(api);
  });

  test.each([
    ['/page.wasm', 'not-webassembly', 'it begins with "<!DOCTYPE html>'],
    ['/lying.wasm', 'not-webassembly', 'it begins with "<!DOCTYPE html>'],
    ['/missing.wasm', 'init-failed', 'the server answered 404'],
    ['/hangs-up.wasm', 'init-failed', "can't be loaded from"],
  ])('explains %s', async (path, code, says) => {
    const api = await fresh();
    const error = await rejection(api.init({ wasm: new URL(base + path) }));
    expect(error.code).toBe(code);
    expect(error.message).toContain(base + path);
    expect(error.message).toContain(says);
    await api.init();
    expectWorking(api);
  });

  const leftBehind = 'Some bundlers (Angular, Bun, esbuild, Rollup) leave core.wasm behind';
  test.each([
    ['/missing/', leftBehind],
    ['/page/', leftBehind],
    ['/node_modules/.vite/deps/', "In Vite up to 7, set optimizeDeps: { exclude: ['halfedge'] }."],
  ])('says in %s what a bundler may have done', async (folder, advice) => {
    const api = await bundled(`${base}${folder}index.js`);
    expect((await rejection(api.init())).message).toContain(` ${advice}`);
  });

  test.each(['/forbidden/', '/down/', '/damaged/', '/hangs-up/'])(
    'says nothing of bundlers in %s, where none is at fault',
    async (folder) => {
      const api = await bundled(`${base}${folder}index.js`);
      const { message } = await rejection(api.init());
      expect(message).toContain(`${base}${folder}core.wasm`);
      expect(message).not.toMatch(/bundler|Vite/);
    },
  );

  test.each([
    ['a folder that core.wasm is not in', 'file:///nowhere/index.js', true],
    ['an address that no server has', 'extension://nowhere/index.js', true],
    ['a port where nobody listens', 'http://127.0.0.1:9/index.js', false],
  ])('speaks of bundlers only where one may be at fault: %s', async (_, script, isTold) => {
    const { message } = await rejection((await bundled(script)).init());
    expect(message.includes(leftBehind)).toBe(isTold);
  });
});

test('init says why there is no answer, which fetch of Node tells in the cause', async () => {
  const server = createServer();
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  const { port } = server.address() as AddressInfo;
  await new Promise((resolve) => server.close(resolve));
  const wasm = `http://127.0.0.1:${port}/core.wasm`;
  expect((await rejection((await fresh()).init({ wasm }))).message).toBe(
    `The WebAssembly module can't be loaded from ${wasm}: fetch failed: connect ECONNREFUSED 127.0.0.1:${port}.`,
  );
});

test('All this leaves the first module of this file alone', async () => {
  await init();
  expectWorking({ HalfedgeMesh, HalfedgeError, init } as Halfedges);
});
