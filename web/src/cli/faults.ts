import type { HalfedgeMesh, Problem, RepairReport, ValidationLevel } from '../index.js';

/**
 * What is wrong with a file: what had to be repaired are errors, because a strict build would refuse
 * it; what is left are warnings, such as open fans that touch in a vertex, or edges without length; then
 * what is worth telling.
 */
export function faultsOf(
  mesh: HalfedgeMesh,
  report: RepairReport,
  level: ValidationLevel = 4,
): Problem[] {
  const repaired = report.problems.map((problem): Problem => {
    return problem.severity === 'info' ? problem : { ...problem, severity: 'error' };
  });
  // Isolated vertices: the report has told of them, by their index in the file.
  const left = mesh.validate(level).filter(({ code }) => code !== 'isolated-vertex');
  const rank = ({ severity }: Problem) => ['error', 'warning', 'info'].indexOf(severity);
  return [...repaired, ...left].sort((a, b) => rank(a) - rank(b));
}

/** How many things had to be repaired: not what is worth telling alone. */
export function repairCount({ problems, counts }: RepairReport): number {
  const codes = problems.filter(({ severity }) => severity !== 'info').map(({ code }) => code);
  const all = counts as Readonly<Record<string, number>>;
  return [...new Set(codes)].reduce((sum, code) => sum + (all[code] ?? 0), 0);
}
