// The suites of one runner: `web` tests the package that dist/ holds, `three-oldest` those parts of it that
// use three.js with the oldest release of it that package.json allows, `browser` drives the explorer in
// Chromium, Firefox and WebKit, `package` tries the packed tarball; `fuzz` is for `npm run fuzz`. Modules are
// loaded as what they are, ES modules (node --experimental-vm-modules), so that the shipped files are
// tested unchanged.

import { availableParallelism } from 'node:os';

const suite = (name) => ({
  displayName: name,
  testMatch: [`<rootDir>/tests/${name}/**/*.test.ts`],
  extensionsToTreatAsEsm: ['.ts'],
  transform: {
    '^.+\\.ts$': [
      '@swc/jest',
      {
        jsc: {
          target: 'es2022',
          parser: { syntax: 'typescript', explicitResourceManagement: true },
        },
        module: { type: 'es6' },
      },
    ],
  },
  moduleNameMapper: {
    '^halfedge$': '<rootDir>/dist/index.js',
    '^halfedge/inline$': '<rootDir>/dist/inline.js',
    '^halfedge/dialects$': '<rootDir>/dist/dialects/index.js',
    '^halfedge/(exercise|figure|gltf|scene|teaching)$': '<rootDir>/dist/$1/index.js',
    '^halfedge/exercise/judge$': '<rootDir>/dist/exercise/judge/index.js',
    '^halfedge/three$': '<rootDir>/dist/three/index.js',
    '^halfedge/three/(picking|webgpu)$': '<rootDir>/dist/three/$1.js',
    '^halfedge/worker$': '<rootDir>/dist/worker.js',
    '^(\\.{1,2}/.*)\\.js$': '$1',
  },
});

const web = suite('web');

export default {
  projects: [
    { ...web, globals: { THREE: 'three' } },
    {
      ...web,
      displayName: 'three-oldest',
      testMatch: ['three-*', 'gltf', 'gltf-write', 'gltf-broken', 'gltf-meshopt', 'gltf-valid'].map(
        (name) => `<rootDir>/tests/web/${name}.test.ts`,
      ),
      moduleNameMapper: {
        ...web.moduleNameMapper,
        '^three$': 'three-oldest',
        '^three/addons/(.*)$': 'three-oldest/examples/jsm/$1',
      },
      globals: { THREE: 'three-oldest' },
    },
    {
      ...suite('browser'),
      globalSetup: '<rootDir>/tests/browser/support/setup.mjs',
      globalTeardown: '<rootDir>/tests/browser/support/teardown.mjs',
    },
    { ...suite('fuzz'), testMatch: ['<rootDir>/tests/fuzz/*.fuzz.ts'] },
    {
      ...suite('package'),
      globalSetup: '<rootDir>/tests/package/support/setup.mjs',
      globalTeardown: '<rootDir>/tests/package/support/teardown.mjs',
    },
  ],
  // By itself Jest leaves a processor idle, which is half of two.
  maxWorkers: Math.min(availableParallelism(), 4),
  testTimeout: 180_000,
};
