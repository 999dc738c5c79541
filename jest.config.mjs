// Three suites with one runner: `web` tests the package that dist/ holds, `browser` drives the
// explorer in Chromium, `package` tries the packed tarball. Modules are loaded as what they are,
// ES modules (node --experimental-vm-modules), so that the shipped files are tested unchanged.

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
    '^halfedge/gltf$': '<rootDir>/dist/gltf/index.js',
    '^halfedge/three$': '<rootDir>/dist/three/index.js',
    '^halfedge/worker$': '<rootDir>/dist/worker.js',
    '^(\\.{1,2}/.*)\\.js$': '$1',
  },
});

export default {
  projects: [
    suite('web'),
    {
      ...suite('browser'),
      globalSetup: '<rootDir>/tests/browser/support/setup.mjs',
      globalTeardown: '<rootDir>/tests/browser/support/teardown.mjs',
    },
    {
      ...suite('package'),
      globalSetup: '<rootDir>/tests/package/support/setup.mjs',
      globalTeardown: '<rootDir>/tests/package/support/teardown.mjs',
    },
  ],
  testTimeout: 180_000,
};
