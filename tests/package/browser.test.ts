import { disconnect, visit } from './support/browser.js';
import { EXPECTED, page, program, startWorker, TITLE } from './support/programs.js';
import { project } from './support/project.js';
import { type Answer, STRICT_POLICY, serve } from './support/server.js';

const MODULE = './node_modules/halfedge/dist/index.js';
const INLINE = './node_modules/halfedge/dist/inline.js';
const WASM = 'node_modules/halfedge/dist/core.wasm';

const importMap = `<script type="importmap">{ "imports": { "halfedge": "${MODULE}" } }</script>`;

/** Evaluates a string as code before anything else: what a strict policy must forbid. */
const evalOr = (main: string) => `
try { (0, eval)('1'); document.title = 'eval was allowed'; } catch { import('${main}'); }
`;

const fromGiven = (kind: string) => `
const address = new URL('${WASM}', document.baseURI);
const bytes = async () => (await fetch(address)).arrayBuffer();
const wasm = await {
  'a URL': () => address,
  'a relative string': () => '${WASM}',
  'an absolute string': () => address.href,
  'an ArrayBuffer': () => bytes(),
  'a Uint8Array': async () => new Uint8Array(await bytes()),
  'a WebAssembly.Module': async () => WebAssembly.compile(await bytes()),
}['${kind}']();
`;

const kinds = [
  'a URL',
  'a relative string',
  'an absolute string',
  'an ArrayBuffer',
  'a Uint8Array',
  'a WebAssembly.Module',
];

/** A site of pages without a bundler, each with one script. */
function site(): string {
  const scripts: Record<string, string> = {
    relative: program(TITLE, { from: MODULE }),
    inline: program(TITLE, { from: INLINE }),
    'start-worker': startWorker(),
    worker: program('postMessage', { from: MODULE }),
    'no-eval': evalOr('./relative.js'),
    'no-eval-inline': evalOr('./inline.js'),
    retry: `
import { init as firstTry } from '${MODULE}';
let failed = false;
try { await firstTry({ wasm: 'nowhere.html' }); } catch { failed = true; }
if (!failed) throw new Error('A page was taken for WebAssembly.');
${program(TITLE, { from: MODULE, options: `{ wasm: '${WASM}' }` })}`,
  };
  for (const [index, kind] of kinds.entries()) {
    const main = program(TITLE, { from: MODULE, options: '{ wasm }' });
    scripts[`given-${index}`] = `${fromGiven(kind)}\n${main}`;
  }
  const files: Record<string, string> = {
    'nowhere.html': page('nothing.js'),
    'import-map.html': page('./import-map.js', importMap),
    'import-map.js': program(TITLE),
  };
  for (const [name, script] of Object.entries(scripts)) {
    files[`${name}.html`] = page(`./${name}.js`);
    files[`${name}.js`] = script;
  }
  return project('site', files);
}

/** Serves the site for one visit. */
async function visitSite(
  path: string,
  options: { policy?: string; answers?: Record<string, Answer> } = {},
) {
  const server = await serve(folder, options);
  try {
    return { ...(await visit(server.address + path)), address: server.address };
  } finally {
    await server.close();
  }
}

let folder: string;
beforeAll(() => {
  folder = site();
});
afterAll(disconnect);

describe('Installed, in a page without a bundler,', () => {
  test.each([
    ['by a relative path', 'relative.html'],
    ['through an import map', 'import-map.html'],
    ['in a module worker', 'start-worker.html'],
  ])('it runs %s', async (_, path) => {
    const { title, complaints, requests } = await visitSite(path);
    expect(complaints).toEqual([]);
    expect(title).toBe(EXPECTED);
    expect(requests.filter((address) => address.endsWith('/core.wasm'))).toHaveLength(1);
  });

  test('`halfedge/inline` runs without a request for the .wasm', async () => {
    const answers = { '.wasm': { status: 404, body: '' } };
    const { title, complaints, requests } = await visitSite('inline.html', { answers });
    expect(complaints).toEqual([]);
    expect(title).toBe(EXPECTED);
    expect(requests.filter((address) => !/\.(m?js|html)$/.test(address))).toEqual([]);
  });

  test.each(kinds.map((kind, index) => [kind, index]))(
    'it takes its WebAssembly as %s',
    async (_, index) => {
      const { title, complaints } = await visitSite(`given-${index}.html`);
      expect(complaints).toEqual([]);
      expect(title).toBe(EXPECTED);
    },
  );
});

describe(`Installed, under the policy "${STRICT_POLICY}",`, () => {
  test.each([
    ['in a page', 'no-eval.html'],
    ['in a worker', 'start-worker.html'],
    ['from `halfedge/inline`', 'no-eval-inline.html'],
  ])('it runs %s', async (_, path) => {
    const { title, complaints } = await visitSite(path, { policy: STRICT_POLICY });
    expect(complaints.filter((text) => !text.includes("'unsafe-eval'"))).toEqual([]);
    expect(title).toBe(EXPECTED);
  });

  test('without wasm-unsafe-eval it says that the page forbids WebAssembly', async () => {
    const { title } = await visitSite('relative.html', { policy: "script-src 'self'" });
    expect(title).toContain('HalfedgeError init-failed: ');
    expect(title).toMatch(
      /Content Security Policy.* In that policy, script-src needs 'wasm-unsafe-eval'\.$/,
    );
  });
});

describe('A server', () => {
  const html = '<!doctype html><title>Welcome</title>';

  test.each([
    ['as HTML', { body: html, type: 'text/html' }],
    ['in the guise of WebAssembly', { body: html, type: 'application/wasm' }],
  ])(
    'that answers a page instead of the module, %s, is told with the address',
    async (_, answer) => {
      const { title, address } = await visitSite('relative.html', { answers: { '.wasm': answer } });
      expect(title).toContain('HalfedgeError not-webassembly: ');
      expect(title).toContain(`${address}${WASM}`);
      expect(title).toContain('<!doctype html>');
    },
  );

  test('that has no module there is told with the address', async () => {
    const answers = { '.wasm': { status: 404, body: 'Not found' } };
    const { title, address } = await visitSite('relative.html', { answers });
    expect(title).toContain('HalfedgeError init-failed: ');
    expect(title).toContain(`${address}${WASM}: the server answered 404`);
  });

  test.each(['application/octet-stream', 'text/plain', 'text/html'])(
    'that takes WebAssembly for %s does no harm',
    async (type) => {
      const { title, complaints } = await visitSite('relative.html', {
        answers: { '.wasm': { type } },
      });
      expect(complaints).toEqual([]);
      expect(title).toBe(EXPECTED);
    },
  );

  test('that failed once can be tried again', async () => {
    const { title, complaints } = await visitSite('retry.html');
    expect(complaints).toEqual([]);
    expect(title).toBe(EXPECTED);
  });
});
