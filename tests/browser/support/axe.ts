import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';

/** What is run in the page. */
interface Axe {
  run(): Promise<{
    violations: {
      impact: string;
      id: string;
      nodes: { target: string[]; failureSummary: string }[];
    }[];
  }>;
}

/** The rules for headings and landmarks, whose findings are moderate. */
const OUTLINE = new Set(['heading-order', 'landmark-unique']);
const AXE = readFileSync(join(process.cwd(), 'node_modules/axe-core/axe.min.js'), 'utf8');

/** What axe-core finds serious or critical in a page as it is, and all that it finds about its outline. */
export async function seriousFindings(page: Page): Promise<string[]> {
  if (!(await page.evaluate(() => 'axe' in window))) await page.evaluate(AXE);
  const violations = await page.evaluate(async () => {
    const { axe } = window as unknown as { axe: Axe };
    return (await axe.run()).violations;
  });
  return violations
    .filter(({ impact, id }) => impact === 'serious' || impact === 'critical' || OUTLINE.has(id))
    .flatMap(({ id, nodes }) =>
      nodes.map(({ target, failureSummary }) => `${id}: ${target}: ${failureSummary}`),
    );
}
