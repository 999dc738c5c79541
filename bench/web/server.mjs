// What the benchmarks in browsers load: the project's files.

import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';
import { root } from '../../scripts/lib/run.mjs';

const TYPES = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript',
  '.mjs': 'text/javascript',
  '.wasm': 'application/wasm',
};

/** Calls `use(address)`; the project's files are served below the address. */
export async function withServer(use) {
  const server = createServer(serve);
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  try {
    return await use(`http://127.0.0.1:${server.address().port}`);
  } finally {
    server.close();
    server.closeAllConnections();
  }
}

async function serve(request, response) {
  const { pathname } = new URL(request.url, 'http://localhost');
  // Isolated pages have a finer clock.
  response.setHeader('Cross-Origin-Opener-Policy', 'same-origin');
  response.setHeader('Cross-Origin-Embedder-Policy', 'require-corp');
  try {
    const body = await readFile(join(root, normalize(decodeURIComponent(pathname))));
    response.setHeader('Content-Type', TYPES[extname(pathname)] ?? 'text/plain');
    response.end(body);
  } catch {
    response.writeHead(404).end('Not found');
  }
}
