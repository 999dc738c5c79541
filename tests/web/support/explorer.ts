/** What the types of Jest leave out. */
interface ModuleMocks {
  unstable_mockModule(path: string, make: () => object): void;
}

/** Imports a module of the explorer without its samples, one of which is a file that only Vite can import. */
export function importWithoutSamples<Module>(load: () => Promise<Module>): Promise<Module> {
  (import.meta.jest as unknown as ModuleMocks).unstable_mockModule(
    '../../../web/explorer/samples/index.js',
    () => ({ samples: [] }),
  );
  return load();
}
