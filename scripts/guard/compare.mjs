// What the counts of a run say, beside those of the table.

/** What callgrind counts, as it is called in sentences: instructions, and lines fetched into a cache. */
export const measures = { instructions: 'instructions', misses: 'cache misses' };

/**
 * Each loop as `{ name, perFace, ofFlat }`, both by measure: so many instructions a face, so many times
 * as many as its yardstick among the loops of the flat baseline takes.
 */
export function relativeToFlat({ loops, counts }) {
  const perFace = new Map();
  for (const { whose, name, faces } of loops) {
    const counted = counts.get(`${whose}: ${name}`);
    if (!counted) throw new Error(`callgrind has counted nothing for ${whose}: ${name}.`);
    const each = Object.keys(measures).map((measure) => [measure, counted[measure] / faces]);
    perFace.set(`${whose}: ${name}`, Object.fromEntries(each));
  }
  return loops
    .filter(({ whose }) => whose === 'halfedge')
    .map(({ name, yardstick }) => {
      const own = perFace.get(`halfedge: ${name}`);
      const flat = perFace.get(`flat: ${yardstick}`);
      const ratio = Object.keys(measures).map((measure) => [measure, own[measure] / flat[measure]]);
      return { name, yardstick, perFace: own, ofFlat: Object.fromEntries(ratio) };
    });
}

/** The table that is stored, of such loops. */
export function tableOf(compiler, loops) {
  const round = (number) => Number(number.toPrecision(3));
  const rows = loops.map(({ name, ofFlat }) => [
    name,
    { instructions: round(ofFlat.instructions), misses: round(ofFlat.misses) },
  ]);
  return { compiler, loops: Object.fromEntries(rows) };
}

/**
 * What has become dearer than the tolerance allows, and what so much cheaper that the table should say
 * so: a sentence each.
 */
export function compare({ compiler, loops }, table, tolerances) {
  const failures = [];
  const gains = [];
  const tolerance = tolerances[compiler === table.compiler ? 'sameCompiler' : 'otherCompiler'];
  for (const { name, yardstick, perFace, ofFlat } of loops) {
    const stored = table.loops[name];
    if (!stored) {
      failures.push(`"${name}" is not in the table.`);
      continue;
    }
    for (const [measure, words] of Object.entries(measures)) {
      const [now, before] = [ofFlat[measure], stored[measure]];
      const most = before * (1 + tolerance[measure]);
      const measured =
        `"${name}" takes ${perFace[measure].toPrecision(3)} ${words} a face, ` +
        `${now.toPrecision(3)} times what "${yardstick}" of the flat baseline takes`;
      if (now > most) {
        failures.push(
          `${measured}; allowed is ${most.toPrecision(3)} (${before} and ${100 * tolerance[measure]} %).`,
        );
      } else if (now < before / (1 + tolerance[measure])) {
        gains.push(`${measured}, where the table has ${before}.`);
      }
    }
  }
  for (const name of Object.keys(table.loops)) {
    if (!loops.some((loop) => loop.name === name)) failures.push(`"${name}" is no longer counted.`);
  }
  return { failures, gains };
}
