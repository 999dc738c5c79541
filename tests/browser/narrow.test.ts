import { disconnect, ExplorerPage } from './support/explorer.js';

afterAll(disconnect);

test('The grip pulls the sheet of a telephone by clicks and by keys', async () => {
  const explorer = await ExplorerPage.open({ width: 390, height: 844, phone: true });
  const { page } = explorer;
  const grip = page.locator('.grip');
  const sheet = () => page.getAttribute('.panel', 'data-sheet');
  expect((await grip.boundingBox())?.height).toBeGreaterThanOrEqual(24);
  await grip.click();
  expect(await sheet()).toBe('tall');
  expect(await grip.getAttribute('aria-expanded')).toBe('true');
  await explorer.press('Enter');
  expect(await sheet()).toBe('half');
  await explorer.press('ArrowDown', 'Space');
  expect(await sheet()).toBe('half');
  const { x, y } = (await grip.boundingBox()) ?? { x: 0, y: 0 };
  await page.mouse.move(x + 100, y + 10);
  await page.mouse.down();
  await page.mouse.move(x + 100, y - 90);
  await page.mouse.up();
  expect(await sheet()).toBe('tall');
  expect(explorer.complaints).toEqual([]);
  await explorer.close();
});
