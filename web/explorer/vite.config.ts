import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

const fromRoot = (path: string) => fileURLToPath(new URL(`../../${path}`, import.meta.url));

export default defineConfig({
  // So that the built page can be put into any folder of a server.
  base: './',
  // The explorer uses the package as it is shipped.
  resolve: {
    alias: [{ find: /^halfedge$/, replacement: fromRoot('dist/index.js') }],
  },
  build: { outDir: fromRoot('build/explorer'), emptyOutDir: true, target: 'es2022' },
});
