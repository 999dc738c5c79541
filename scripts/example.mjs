// `npm run example three`: builds the package and serves one of the examples that are pages, with it and
// the packages of the repository. Copied elsewhere, an example has a package.json of its own.

import { existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { argv } from 'node:process';
import { build } from './build.mjs';
import { asProgram, Failure, root } from './lib/run.mjs';
import { setup } from './setup.mjs';

const folder = join(root, 'examples');
const projects = readdirSync(folder).filter((name) =>
  existsSync(join(folder, name, 'package.json')),
);
const pages = readdirSync(folder).filter((name) => name.endsWith('.html'));
const names = [...projects, ...pages.map((name) => name.replace(/\.html$/, ''))];

/** A page without a bundler: the files of the repository as they are. */
async function servePage(name) {
  const { preview } = await import('vite');
  const server = await preview({
    root,
    configFile: false,
    appType: 'mpa',
    logLevel: 'error', // it warns of building into the repository, which nobody does here
    build: { outDir: '.' },
  });
  return `${server.resolvedUrls.local[0]}examples/${name}.html`;
}

/** A project, whose `halfedge` is what has been built here. */
async function serveProject(name) {
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
  await server.listen();
  return server.resolvedUrls.local[0];
}

await asProgram(async () => {
  const name = argv[2];
  if (!names.includes(name)) {
    throw new Failure(`Usage: npm run example <name>, which is ${names.join(', ')}.`);
  }
  await setup(['build']);
  await build();
  const address = await (projects.includes(name) ? serveProject(name) : servePage(name));
  console.log(`\nThe example is at ${address}  (Ctrl-C stops it)\n`);
});
