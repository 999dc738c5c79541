// Where files of the package lie beside the copies that Vite makes of its scripts in development.

import { originalOf } from '../../dist/original.js';

const HOST = 'http://localhost:5173';

test.each([
  ['Vite', '/node_modules/.vite/deps/halfedge.js?v=1a2b', '/node_modules/'],
  ['Vite below a base', '/app/node_modules/.vite/deps/halfedge.js', '/app/node_modules/'],
  ['Nuxt', '/_nuxt/node_modules/.cache/vite/client/deps/chunk-1.js', '/_nuxt/node_modules/'],
  ['Storybook', '/node_modules/.cache/storybook/1/sb-vite/deps/halfedge.js', '/node_modules/'],
  ['Angular', '/.angular/cache/20.0.0/app/vite/deps/halfedge.js', '/node_modules/'],
])('%s', (_, script, packages) => {
  const { href } = originalOf('core.wasm', HOST + script) ?? {};
  expect(href).toBe(`${HOST}${packages}halfedge/dist/core.wasm`);
});

test.each([
  ['the package itself', '/node_modules/halfedge/dist/init.js'],
  [
    'pnpm, whose folder has a dot',
    '/node_modules/.pnpm/halfedge@1.0.0/node_modules/halfedge/dist/init.js',
  ],
  ['a bundle', '/assets/index-1a2b.js'],
  ['folders named deps', '/deps/init.js'],
  ['a query that names such a folder', '/init.js?from=/.vite/deps/halfedge.js'],
])('%s is no copy', (_, script) => {
  expect(originalOf('core.wasm', HOST + script)).toBeUndefined();
});
