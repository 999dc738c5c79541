// `npm run example three`: builds the package and serves one of the examples that are pages, with it and
// the packages of the repository. Copied elsewhere, an example has a package.json of its own.

import { argv } from 'node:process';
import { build } from './build.mjs';
import { pages, projects, serveProject, serveRepository } from './lib/example-servers.mjs';
import { asProgram, Failure } from './lib/run.mjs';
import { setup } from './setup.mjs';

const addressOf = ({ resolvedUrls }) => resolvedUrls.local[0];

async function serve(name) {
  if (projects.includes(name)) return addressOf(await serveProject(name));
  return `${addressOf(await serveRepository())}examples/${name}.html`;
}

await asProgram(async () => {
  const name = argv[2];
  const names = [...projects, ...pages];
  if (!names.includes(name)) {
    throw new Failure(`Usage: npm run example <name>, which is ${names.join(', ')}.`);
  }
  await setup(['build']);
  await build();
  console.log(`\nThe example is at ${await serve(name)}  (Ctrl-C stops it)\n`);
});
