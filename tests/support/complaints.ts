import type { Page } from 'playwright-core';

/**
 * What the driver says of each frame, since the browser itself reads the pixels of a canvas to put the
 * page together without a graphics card.
 */
const FRAME_WAS_READ = /GL Driver Message .* GPU stall due to ReadPixels/;

/** Collects what a page complains of: errors and warnings in the console, uncaught errors, and failed requests. */
export function collectComplaints(page: Page): string[] {
  const complaints: string[] = [];
  page.on('console', (message) => {
    const text = message.text();
    if (!['error', 'warning'].includes(message.type()) || FRAME_WAS_READ.test(text)) return;
    complaints.push(text);
  });
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('requestfailed', (it) => complaints.push(`${it.url()}: ${it.failure()?.errorText}`));
  return complaints;
}

/** Has pages warn where they make the graphics card wait by reading pixels. To be called before the first one. */
export async function warnOfReadPixels(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const { prototype } = WebGL2RenderingContext;
    const { readPixels } = prototype;
    prototype.readPixels = function (this: WebGL2RenderingContext, ...parameters: unknown[]) {
      console.warn('The page waits for the graphics card: it reads pixels.');
      (readPixels as (...all: unknown[]) => void).apply(this, parameters);
    };
  });
}
