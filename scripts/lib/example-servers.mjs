// The examples that are pages, and the servers that show them with what has been built here.

import { existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './run.mjs';

const folder = join(root, 'examples');
const names = readdirSync(folder);

/** Those with a package.json of their own. */
export const projects = names.filter((name) => existsSync(join(folder, name, 'package.json')));
/** Those of one file. */
export const pages = names.filter((name) => /\.html$/.test(name)).map((name) => name.slice(0, -5));

/** The files of the repository as they are: pages without a bundler need no more. */
export async function serveRepository() {
  const { preview } = await import('vite');
  return preview({
    root,
    configFile: false,
    appType: 'mpa',
    logLevel: 'error', // it warns of building into the repository, which nobody does here
    build: { outDir: '.' },
  });
}

/** A project, whose `halfedge` is what has been built here. */
export async function serveProject(name) {
  const { createServer } = await import('vite');
  const dist = join(root, 'dist');
  const server = await createServer({
    root: join(folder, name),
    configFile: false,
    resolve: {
      alias: [
        { find: /^halfedge$/, replacement: join(dist, 'index.js') },
        { find: /^halfedge\/three$/, replacement: join(dist, 'three/index.js') },
      ],
    },
    server: { fs: { allow: [root] } },
  });
  return server.listen();
}
