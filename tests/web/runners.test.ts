// What `npm test` counts where one process runs many tests of C++.

import { withShare } from '../../scripts/lib/runners.mjs';

/** A report of GoogleTest: of so many tests some failed, others were skipped. */
function reportOf(tests: number, failures: number, skipped: number): string {
  const results = [
    ...Array(skipped).fill('skipped'),
    ...Array(tests - skipped).fill('completed'),
  ].map((result) => `<testcase name="It" status="run" result="${result}" />`);
  return `<?xml version="1.0" encoding="UTF-8"?>
<testsuites tests="${tests}" failures="${failures}" disabled="0" errors="0" time="8.25" name="AllTests">
  <testsuite name="Mesh" tests="${tests}" failures="${failures}" disabled="0" skipped="${skipped}" errors="0">
    ${results.join('')}
  </testsuite>
</testsuites>`;
}

// Three processes, of which one ran a share; whether it passed is what CTest says.
const passed = { passed: 3, failed: 0, skipped: 0 };
const failed = { passed: 2, failed: 1, skipped: 0 };

test('the tests of a share are counted, instead of its process', () => {
  expect(withShare(passed, reportOf(64, 0, 0))).toEqual({ passed: 66, failed: 0, skipped: 0 });
  expect(withShare(passed, reportOf(64, 0, 5))).toEqual({ passed: 61, failed: 0, skipped: 5 });
});

test('its failed tests are, too', () => {
  expect(withShare(failed, reportOf(64, 3, 2))).toEqual({ passed: 61, failed: 3, skipped: 2 });
});

test('a process that fails though its tests pass, as by a leak, counts as one that failed', () => {
  expect(withShare(failed, reportOf(64, 0, 0))).toEqual({ passed: 65, failed: 1, skipped: 0 });
});
