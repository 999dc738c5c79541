import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { disconnect, ExplorerPage } from './support/explorer.js';

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

const AXE = readFileSync(join(process.cwd(), 'node_modules/axe-core/axe.min.js'), 'utf8');

afterAll(disconnect);

/** What axe-core finds serious or critical in the page as it is. */
async function findings({ page }: ExplorerPage): Promise<string[]> {
  const violations = await page.evaluate(async () => {
    const { axe } = window as unknown as { axe: Axe };
    return (await axe.run()).violations;
  });
  return violations
    .filter(({ impact }) => impact === 'serious' || impact === 'critical')
    .flatMap(({ id, nodes }) =>
      nodes.map(({ target, failureSummary }) => `${id}: ${target}: ${failureSummary}`),
    );
}

test.each([
  ['a desktop, light', {}],
  ['a desktop, dark', { dark: true }],
  ['a telephone, light', { width: 390, height: 844, phone: true }],
  ['a telephone, dark', { width: 390, height: 844, phone: true, dark: true }],
])(
  'axe-core finds nothing serious on any panel: %s',
  async (_name, settings) => {
    const explorer = await ExplorerPage.open(settings);
    const { page } = explorer;
    await page.evaluate(AXE);
    const found: Record<string, string[]> = {};
    const look = async (place: string) => {
      await explorer.rest();
      const serious = await findings(explorer);
      if (serious.length > 0) found[place] = serious;
    };
    for (const tab of ['circulate', 'edit', 'mesh', 'records']) {
      await page.click(`[data-tab-button=${tab}]`);
      await explorer.press('.', '.');
      await look(tab);
    }
    await page.click('.mesh-button');
    await look('menu');
    await page.click('[data-broken]');
    await page.waitForSelector('[data-finding]');
    await look('problems');
    await page.evaluate(() => {
      location.hash = 'sample=none';
    });
    await page.waitForSelector('.notice:not([hidden])');
    await look('failure');
    expect(found).toEqual({});
    expect(explorer.complaints).toEqual([]);
    await explorer.close();
  },
  180_000,
);
