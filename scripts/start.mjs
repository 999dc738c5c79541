// `npm start`: installs what is missing, builds the package and serves the explorer on localhost,
// at PORT or the first free port from 5173 on.

import { join } from 'node:path';
import { build } from './build.mjs';
import { asProgram, Failure, root } from './lib/run.mjs';
import { setup } from './setup.mjs';

async function serve() {
  const { createServer } = await import('vite');
  const server = await createServer({
    root: join(root, 'web/explorer'),
    server: { port: requestedPort() ?? 5173, strictPort: requestedPort() !== undefined },
  });
  await server.listen().catch(refusePort);
  const [address] = server.resolvedUrls.local;
  console.log(`\nThe explorer is at ${address}  (Ctrl-C stops it)\n`);
}

/** A port that is taken, or that not everybody may take. */
function refusePort(error) {
  if (!/already in use|EADDRINUSE|EACCES/.test(error.message)) throw error;
  throw new Failure(`${error.message}: choose another PORT, or none.`);
}

function requestedPort() {
  const text = process.env.PORT;
  if (text === undefined || text === '') return undefined;
  const port = Number(text);
  if (Number.isInteger(port) && port > 0 && port < 65536) return port;
  throw new Failure(`PORT is "${text}", expected a number from 1 to 65535.`);
}

await asProgram(async () => {
  requestedPort();
  console.log('1/3 Installing what is missing');
  await setup(['build']);
  console.log('2/3 Building the package');
  await build();
  console.log('3/3 Starting the server');
  await serve();
});
