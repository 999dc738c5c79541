// The test runners, and what their own reports say they counted.

import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { Failure, root, run } from './run.mjs';
import { counts } from './steps.mjs';

/**
 * Runs the tests of a CMake preset, two at a time. Returns the counts of CTest's report, in which a process that
 * runs a share of a program's tests stands for what its own report counts.
 */
export async function runCtest(preset) {
  const report = freshReport(`ctest-${preset}.xml`);
  const shares = join(root, 'build', preset, 'shares');
  rmSync(shares, { recursive: true, force: true });
  const options = ['--output-junit', report, '--no-tests=error', '-j2', '--progress'];
  const count = (xml) => readShares(shares).reduce(withShare, countJunit(xml));
  return runAndCount(`ctest (${preset})`, report, count, () =>
    run('ctest', ['--preset', preset, ...options]),
  );
}

/** Runs one suite of jest.config.mjs. Returns the counts of Jest's report. */
export async function runJest(suite) {
  const report = freshReport(`jest-${suite}.json`);
  const jest = ['node_modules/jest/bin/jest.js', '--selectProjects', suite];
  const node = ['--experimental-vm-modules', '--no-warnings', '--expose-gc'];
  return runAndCount(`jest (${suite})`, report, countJest, () =>
    run(process.execPath, [...node, ...jest, '--json', `--outputFile=${report}`]),
  );
}

/** The path of a report below build/, which is not there yet. */
function freshReport(name) {
  const folder = join(root, 'build/reports');
  mkdirSync(folder, { recursive: true });
  const path = join(folder, name);
  rmSync(path, { force: true });
  return path;
}

/** Runs a runner and reads its report, whether it succeeded or not. No tests at all is a failure. */
async function runAndCount(name, report, count, start) {
  let failure;
  try {
    await start();
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
    failure = error;
  }
  const result = existsSync(report) ? count(readFileSync(report, 'utf8')) : counts(0);
  if (!failure && result.passed + result.failed + result.skipped > 0) return result;
  failure ??= new Failure(`${name} found no tests.`);
  // A runner that fails without a failed test (it crashed, a file did not load) is a failure too.
  failure.counts = { ...result, failed: Math.max(result.failed, 1) };
  throw failure;
}

function countJunit(xml) {
  const attribute = numbersOf(xml, 'testsuite');
  const failed = attribute('failures') + attribute('errors');
  const skipped = attribute('skipped') + attribute('disabled');
  return counts(attribute('tests') - failed - skipped, failed, skipped);
}

/** The attributes of the first element of this name, those that are numbers. */
function numbersOf(xml, name) {
  const [element] = new RegExp(`<${name}\\b[^>]*>`).exec(xml) ?? [''];
  return (key) => Number(new RegExp(`\\b${key}="(\\d+)"`).exec(element)?.[1] ?? 0);
}

/** What the programs of GoogleTest in a folder report; one that crashed has left nothing. */
function readShares(folder) {
  if (!existsSync(folder)) return [];
  return readdirSync(folder).map((name) => readFileSync(join(folder, name), 'utf8'));
}

/** Counts the tests of a share instead of its process, which fails by them, or by what was left at its end. */
export function withShare({ passed, failed, skipped }, xml) {
  const attribute = numbersOf(xml, 'testsuites');
  const failures = attribute('failures') + attribute('errors');
  const left = xml.match(/ result="(?:skipped|suppressed)"/g)?.length ?? 0;
  const others = attribute('tests') - failures - left;
  if (failures > 0) return counts(passed + others, failed + failures - 1, skipped + left);
  return counts(passed + others - 1, failed, skipped + left);
}

function countJest(json) {
  const report = JSON.parse(json);
  const skipped = report.numPendingTests + report.numTodoTests;
  // A test file that does not even load has no tests to count: it counts as one that failed.
  const failed = report.numFailedTests + report.numRuntimeErrorTestSuites;
  return counts(report.numPassedTests, failed, skipped);
}
