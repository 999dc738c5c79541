// The benchmark itself, the same in Node and in a browser.

import { rowsFor } from './contenders.mjs';
import { grid, icosphere, shuffled } from './meshes.mjs';

/** Milliseconds from which a contender is hopeless: its first run is its only one. */
const HOPELESS = 1000;
/** The peers take long: they have fewer rounds. */
const PEERS = { names: ['tmh', 'csg', 'manifold', 'three'], rounds: 3 };

/** The meshes by name: [side of the grid, splits of the icosahedron] decide how large they are. */
function inputs([side, splits]) {
  const open = grid(side);
  const sphere = icosphere(splits);
  return {
    'open grid': open,
    'open grid, shuffled': shuffled(open),
    sphere,
    'sphere, shuffled': shuffled(sphere),
  };
}

/**
 * Runs all rows on all meshes: `[{ mesh, vertices, faces, rows: [{ title, times }], bytes }]`, where
 * `times` holds the median of each contender in milliseconds. Each runs for `warm` milliseconds before
 * that. Throws if two contenders disagree.
 */
export async function runSuite(
  libraries,
  { sizes = [512, 7], rounds = 9, warm = 150, say = () => {} } = {},
) {
  const results = [];
  for (const [name, input] of Object.entries(inputs(sizes))) {
    say(name);
    const { builds, passes, made } = rowsFor(libraries, input);
    const rows = [];
    for (const row of [builds, ...passes]) rows.push(await measure(row, rounds, warm));
    results.push({
      mesh: name,
      vertices: input.positions.length / 3,
      faces: input.triangles.length / 3,
      rows,
      bytes: bytesPerVertex(made, input),
    });
    for (const [who, built] of Object.entries(made)) builds.forget(who, built);
    globalThis.gc?.();
  }
  say(AFTER_OTHERS);
  results.push(await afterOtherKinds(libraries, sizes, rounds, warm));
  return results;
}

const AFTER_OTHERS = 'sphere, after other kinds of circulators';

/**
 * The loops once more, in a program that has gone around other things, other ways and past boundaries before:
 * what V8 compiles a loop to depends on that. Compiled anew, so from a module of its own.
 */
async function afterOtherKinds(libraries, [side, splits], rounds, warm) {
  const { rowsFor, goAroundOthers } = await import('./contenders.mjs?after-other-kinds');
  const { HalfedgeMesh } = libraries;
  const open = grid(side >> 3);
  const other = HalfedgeMesh.fromTriangles(open.positions, open.triangles);
  goAroundOthers(other);
  other.dispose();

  const input = icosphere(splits);
  const { passes, made } = rowsFor(libraries, input);
  made.halfedge = HalfedgeMesh.fromTriangles(input.positions, input.triangles);
  const rows = [];
  for (const { run, ...row } of passes) {
    const { halfedge, hand } = run;
    rows.push(await measure({ ...row, run: { halfedge, hand } }, rounds, warm));
  }
  const bytes = bytesPerVertex({ halfedge: made.halfedge, flat: {} }, input);
  made.halfedge.dispose();
  return {
    mesh: AFTER_OTHERS,
    vertices: input.positions.length / 3,
    faces: input.triangles.length / 3,
    rows,
    bytes: { halfedge: bytes.halfedge },
  };
}

/** Medians of rounds in which one contender comes after the other. */
async function measure({ title, run, sum = (_, result) => result, keep, forget }, rounds, warm) {
  const times = {};
  const sums = {};
  const timed = (who) => {
    const begin = performance.now();
    const result = run[who]();
    const time = performance.now() - begin;
    if (who in sums) {
      forget?.(who, result);
    } else {
      keep?.(who, result);
      sums[who] = sum(who, result);
    }
    return time;
  };

  for (const who of Object.keys(run)) {
    const first = timed(who);
    times[who] = first > HOPELESS ? [first] : [];
    for (let spent = first; spent < warm; ) spent += timed(who);
    await breathe();
  }
  for (let round = 0; round < rounds; round++) {
    for (const who of Object.keys(run)) {
      if (times[who][0] > HOPELESS) continue;
      if (PEERS.names.includes(who) && round >= PEERS.rounds) continue;
      times[who].push(timed(who));
    }
    await breathe();
  }
  if (new Set(Object.values(sums)).size > 1) {
    throw new Error(`${title}: the contenders disagree: ${JSON.stringify(sums)}.`);
  }
  return { title, times: Object.fromEntries(Object.entries(times).map(withMedian)) };
}

const withMedian = ([who, list]) => [who, list.sort((a, b) => a - b)[list.length >> 1]];

/** Lets the garbage collector and the compiler have their turn. */
const breathe = () => new Promise((resolve) => setTimeout(resolve, 1));

/** Bytes of connectivity to a vertex, without positions. */
function bytesPerVertex({ halfedge, flat }, { positions }) {
  const bytes = (arrays) => arrays.reduce((sum, { byteLength }) => sum + byteLength, 0);
  const vertices = positions.length / 3;
  return {
    halfedge: bytes(Object.values(halfedge.connectivity)) / vertices,
    flat: bytes(Object.values(flat)) / vertices,
  };
}
