// Several programs that measure the same. A loop can take half as long again in one program as in another, for as long
// as it runs: how fast it is, is decided when V8 compiles it.

/** Runs `start(options)` so many times, one after the other, and returns the medians of what all have measured. */
export async function inPrograms(count, start, options) {
  const runs = [];
  for (let run = 0; run < count; run++) {
    options.say(`program ${run + 1} of ${count}`);
    runs.push(await start(options));
  }
  const [{ engine, results, operations }] = runs;
  return {
    engine,
    results: results.map((result, mesh) => ({
      ...result,
      rows: mediansOf(runs.map((run) => run.results[mesh].rows)),
    })),
    operations: { ...operations, rows: mediansOf(runs.map((run) => run.operations.rows)) },
  };
}

/** Of the same rows of several programs. */
function mediansOf(programs) {
  const [first] = programs;
  return first.map(({ title, times }, row) => {
    const medianOf = (who) => [who, median(programs.map((rows) => rows[row].times[who]))];
    return { title, times: Object.fromEntries(Object.keys(times).map(medianOf)) };
  });
}

const median = (times) => times.sort((a, b) => a - b)[times.length >> 1];
