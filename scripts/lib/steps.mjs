// A run of named steps: each one timed, none hiding another's failure, and one sum at the end.

import { performance } from 'node:perf_hooks';
import { Failure } from './run.mjs';

/** How many tests passed, failed and were skipped. */
export const counts = (passed, failed = 0, skipped = 0) => ({ passed, failed, skipped });

export class Steps {
  #rows = [];

  /**
   * Runs `action` under a heading. It returns the counts of its runner; a step without a runner
   * counts as one test, passed unless it throws. A thrown Failure is told, and the run goes on.
   * Returns whether nothing failed.
   */
  async run(title, action) {
    console.log(`\n── ${title}`);
    const start = performance.now();
    let result;
    try {
      result = (await action()) ?? counts(1);
    } catch (error) {
      if (!(error instanceof Failure)) throw error;
      console.log(error.message);
      result = error.counts ?? counts(0, 1);
    }
    const seconds = (performance.now() - start) / 1000;
    this.#rows.push({ title, seconds, ...result });
    console.log(`── ${title}: ${inWords(result)} (${seconds.toFixed(1)} s)`);
    return result.failed === 0;
  }

  /** Prints a table of the steps and the closing line. Returns whether nothing failed. */
  close() {
    const width = Math.max(...this.#rows.map((row) => row.title.length));
    console.log('');
    for (const row of this.#rows) {
      const mark = row.failed > 0 ? '✗' : '✓';
      const time = `${row.seconds.toFixed(1)} s`.padStart(8);
      console.log(`${mark} ${row.title.padEnd(width)} ${time}  ${inWords(row)}`);
    }
    const sum = (key) => this.#rows.reduce((total, row) => total + row[key], 0);
    const total = counts(sum('passed'), sum('failed'), sum('skipped'));
    const seconds = sum('seconds');
    console.log(`\nAll of it took ${Math.floor(seconds / 60)} min ${Math.round(seconds % 60)} s.`);
    console.log(inWords(total));
    return total.failed === 0;
  }
}

function inWords({ passed, failed, skipped }) {
  return `${passed} passed, ${failed} failed, ${skipped} skipped`;
}
