import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

const fromHere = (path: string) => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig({
  root: fromHere('.'),
  // Relative, so that the built page works from any folder of a server.
  base: './',
  publicDir: false,
  resolve: {
    // The package as it is shipped: `npm run build` makes it.
    alias: [
      { find: /^halfedge$/, replacement: fromHere('../../dist/index.js') },
      {
        find: /^halfedge\/(dialects|gltf|scene|teaching|three)$/,
        replacement: fromHere('../../dist/$1/index.js'),
      },
      { find: /^halfedge\/(worker|three\/picking)$/, replacement: fromHere('../../dist/$1.js') },
    ],
  },
  server: { fs: { allow: [fromHere('../..')] } },
  worker: { format: 'es' },
  build: {
    outDir: fromHere('../../build/explorer'),
    emptyOutDir: true,
    target: 'es2022',
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 1000,
  },
});
