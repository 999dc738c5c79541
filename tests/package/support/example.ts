import { withPage } from './browser.js';

type Watched = Parameters<Parameters<typeof withPage>[1]>[0];

/** One of the examples with a 3D picture, in a tab of its own. */
export class Example {
  readonly page: Watched['page'];
  readonly complaints: string[];

  private constructor({ page, complaints }: Watched) {
    this.page = page;
    this.complaints = complaints;
  }

  /** Opens a page for as long as `use` runs. */
  static open(address: string, use: (example: Example) => Promise<void>): Promise<void> {
    return withPage(address, (watched) => use(new Example(watched)));
  }

  /** Waits until an element has a text that matches, and returns it. */
  async text(selector: string, pattern: RegExp): Promise<string> {
    const element = this.page.locator(selector).filter({ hasText: pattern });
    return (await element.textContent()) ?? '';
  }

  /** Clicks so far from the middle of the picture, in pixels, once the picture fills its place. */
  async click(right = 0, down = 0): Promise<void> {
    await this.page.waitForFunction(() => {
      const { width = 0, clientWidth = 0 } = document.querySelector('canvas') ?? {};
      return width === clientWidth && width !== 300; // which is what it has at first
    });
    const { x, y, width, height } = await this.page.locator('canvas').evaluate((canvas) => {
      return canvas.getBoundingClientRect().toJSON();
    });
    await this.page.mouse.click(x + width / 2 + right, y + height / 2 + down);
  }
}
