// `npm run build`: makes dist/, the package. `build.mjs wasm` and `build.mjs web` make one part.

import {
  chmodSync,
  cpSync,
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  realpathSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { argv } from 'node:process';
import { emscriptenToolchain } from './lib/emscripten.mjs';
import { asProgram, capture, Failure, isProgram, root, run } from './lib/run.mjs';

const dist = join(root, 'dist');
const sources = join(root, 'web/src');
const compiled = join(root, 'build/web');
const toolchainOption = '-DCMAKE_TOOLCHAIN_FILE=';

/** Configures a CMake preset. What CMake says is shown only if it fails. */
export async function configurePreset(preset, options = []) {
  forgetStale(preset, options);
  const { ok, output } = await capture('cmake', ['--preset', preset, ...options]);
  if (!ok) throw new Failure(`${output}\nThe preset ${preset} cannot be configured.`);
}

/** Configures a CMake preset and builds it. */
export async function buildPreset(preset, options = []) {
  await configurePreset(preset, options);
  await run('cmake', ['--build', '--preset', preset]);
}

/** Compiles the core to WebAssembly and puts core.js (the glue, minified) and core.wasm into dist/. */
export async function buildWasm() {
  const toolchain = emscriptenToolchain();
  if (!toolchain) throw new Failure('There is no Emscripten here: `npm run setup` installs it.');
  needPackages();
  await buildPreset('wasm', [`${toolchainOption}${toolchain}`]);

  const { transform } = await import('esbuild');
  const built = join(root, 'build/wasm/wasm');
  const glue = readFileSync(join(built, 'core.mjs'), 'utf8');
  const { code } = await transform(glue, { minify: true, format: 'esm', target: 'es2022' });
  mkdirSync(dist, { recursive: true });
  // Not as .mjs, which many servers (nginx) send with a type that browsers refuse.
  writeFileSync(join(dist, 'core.js'), code);
  writeFileSync(join(dist, 'core.wasm'), readFileSync(join(built, 'core.wasm')));
}

/**
 * A build folder keeps the toolchain and the place that it was made with: start afresh where another toolchain is
 * asked for, or the project has been moved.
 */
function forgetStale(preset, options) {
  const folder = join(root, 'build', preset);
  const cache = join(folder, 'CMakeCache.txt');
  if (!existsSync(cache)) return;
  const text = readFileSync(cache, 'utf8');
  const used = (name) => new RegExp(`^${name}:\\w+=(.*)$`, 'm').exec(text)?.[1];
  const place = used('CMAKE_HOME_DIRECTORY') ?? '';
  const isHere = existsSync(place) && realpathSync(place) === root;
  const toolchain = options.find((option) => option.startsWith(toolchainOption));
  const isSame =
    toolchain === undefined || toolchain === `${toolchainOption}${used('CMAKE_TOOLCHAIN_FILE')}`;
  if (!(isHere && isSame)) rmSync(folder, { recursive: true });
}

/** The tools that are npm packages. */
function needPackages() {
  if (existsSync(join(root, 'node_modules/typescript'))) return;
  throw new Failure('The npm packages are missing: `npm run setup` installs them.');
}

/** What `buildWasm` puts into dist/. */
const FROM_CORE = ['core.js', 'core.wasm'];

/** Compiles the TypeScript package into dist/, beside the WebAssembly module. */
export async function buildWeb() {
  const wasm = join(dist, 'core.wasm');
  for (const name of FROM_CORE) {
    if (existsSync(join(dist, name))) continue;
    throw new Failure(`dist/${name} is missing: run \`npm run build:wasm\`.`);
  }
  needPackages();
  rmSync(compiled, { recursive: true, force: true });
  // The command-line tool apart: the rest must not know that there are such things as Node's modules.
  for (const program of ['tsconfig.build.json', 'tsconfig.cli.json']) {
    await run(process.execPath, ['node_modules/typescript/bin/tsc', '-p', program]);
  }

  // Now that it compiles: nothing of an earlier build may stay in dist/ and be shipped.
  for (const name of readdirSync(dist)) {
    if (!FROM_CORE.includes(name)) rmSync(join(dist, name), { recursive: true });
  }
  cpSync(compiled, dist, { recursive: true });
  chmodSync(join(dist, 'cli/main.js'), 0o755); // npm sees to that where it installs, but not again
  // The hand-written types of the glue and of the module: tsc reads them, but does not copy them.
  for (const name of ['core.d.ts', 'core.d.wasm.ts']) {
    cpSync(join(sources, name), join(dist, name));
  }
  // From here `halfedge/inline` takes the module without a request.
  const text = readFileSync(wasm).toString('base64');
  writeFileSync(join(dist, 'core-base64.js'), `export const coreBase64 =\n  '${text}';\n`);
  await buildStandalone();
}

/**
 * Makes the standalone entries one file each that needs no other, and puts the page for frames beside
 * that of figures. That of exercises has the script of its worker in it, as a text.
 */
async function buildStandalone() {
  const thread = readFileSync(await bundled('exercise/thread.js'), 'utf8');
  const source = join(dist, 'exercise/thread-source.js');
  writeFileSync(source, `export const threadSource = ${JSON.stringify(thread)};\n`);
  for (const entry of ['figure/standalone.js', 'exercise/standalone.js']) {
    cpSync(await bundled(entry), join(dist, entry));
  }
  rmSync(source);
  cpSync(join(sources, 'figure/frame.html'), join(dist, 'figure/frame.html'));
}

/** Bundles a module of dist/, and all that it needs, into one file; returns where that is. */
async function bundled(entry) {
  const { build: bundle } = await import('vite');
  const outDir = join(root, 'build/standalone', dirname(entry));
  const name = basename(entry, '.js');
  await bundle({
    configFile: false,
    root,
    logLevel: 'warn',
    publicDir: false,
    build: {
      outDir,
      emptyOutDir: false,
      target: 'es2022',
      chunkSizeWarningLimit: 4000,
      lib: { entry: join(dist, entry), formats: ['es'], fileName: name },
      rolldownOptions: { output: { codeSplitting: false, minify: true } },
    },
  });
  return join(outDir, `${name}.js`);
}

/** The whole package. */
export async function build() {
  await buildWasm();
  await buildWeb();
}

if (isProgram(import.meta.url)) {
  const parts = { wasm: buildWasm, web: buildWeb };
  const [, , name] = argv;
  await asProgram(() => {
    if (name === undefined) return build();
    if (!(name in parts)) {
      throw new Failure(
        `There is no part ${name}: the parts are ${Object.keys(parts).join(', ')}.`,
      );
    }
    return parts[name]();
  });
}
