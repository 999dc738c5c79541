// Completes package-lock.json for the platforms that the registry at hand does not carry.
//
// Packages with native parts (esbuild, Biome, swc, rolldown) list one optional package for each
// platform. Where a registry mirror lacks some of them, `npm install` silently leaves them out of
// the lock file, and `npm ci` then refuses it everywhere. This script adds each missing entry with
// its exact version and the platform that its name tells, so that npm skips it elsewhere without
// asking the registry. Run it after `npm install` has changed the lock file.

import { readFileSync, writeFileSync } from 'node:fs';

const lockPath = new URL('../package-lock.json', import.meta.url);
const lock = JSON.parse(readFileSync(lockPath, 'utf8'));
const systems = ['aix', 'android', 'darwin', 'freebsd', 'linux', 'netbsd', 'openbsd'];
const otherSystems = ['openharmony', 'sunos', 'win32'];
const processors = ['arm', 'arm64', 'ia32', 'loong64', 'mips64el', 'ppc64', 'riscv64', 's390x'];
const otherProcessors = ['wasm32', 'x64'];

/** The `os`, `cpu` and `libc` of a platform package, read from the words of its name. */
function platformOf(name) {
  const words = name.split(/[/-]/).map((word) => word.replace(/^(gnu|musl)eabi(hf)?$/, '$1'));
  const os = [...systems, ...otherSystems].filter((system) => words.includes(system));
  const cpu = [...processors, ...otherProcessors].filter((processor) => words.includes(processor));
  const libc = words.includes('musl') ? ['musl'] : words.includes('gnu') ? ['glibc'] : [];
  if (os.length + cpu.length === 0) return undefined;
  return {
    ...(cpu.length > 0 && { cpu }),
    ...(os.length > 0 && { os }),
    ...(libc.length > 0 && os.includes('linux') && { libc }),
  };
}

/** Where npm looks for `name` from the package at `location`: each enclosing node_modules. */
function candidates(location, name) {
  const found = [`${location}/node_modules/${name}`];
  for (let at = location.lastIndexOf('node_modules/'); at >= 0; ) {
    found.push(`${location.slice(0, at)}node_modules/${name}`);
    at = at === 0 ? -1 : location.lastIndexOf('node_modules/', at - 1);
  }
  return found;
}

const added = [];
for (const [location, entry] of Object.entries(lock.packages)) {
  for (const [name, version] of Object.entries(entry.optionalDependencies ?? {})) {
    const platform = platformOf(name);
    const places = candidates(location, name);
    const exact = /^\d+\.\d+\.\d+[\w.-]*$/.test(version);
    if (platform === undefined || !exact) continue;
    if (places.some((place) => lock.packages[place]?.version === version)) continue;
    const shared = `node_modules/${name}`;
    const place = lock.packages[shared] === undefined ? shared : places[0];
    lock.packages[place] = { version, ...platform, dev: true, optional: true };
    added.push(`${name}@${version}`);
  }
}

const root = ['', lock.packages['']];
const rest = Object.entries(lock.packages).filter(([location]) => location !== '');
rest.sort(([a], [b]) => (a < b ? -1 : 1));
lock.packages = Object.fromEntries([root, ...rest]);
writeFileSync(lockPath, `${JSON.stringify(lock, null, 2)}\n`);
console.log(`Added ${added.length} platform packages to package-lock.json.`);
for (const line of added) console.log(`  ${line}`);
