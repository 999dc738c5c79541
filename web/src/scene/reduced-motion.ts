/** Whether the user asks for less motion. jsdom, where components are tested, can't say. */
export function prefersReducedMotion(): boolean {
  return globalThis.matchMedia?.('(prefers-reduced-motion: reduce)').matches ?? false;
}
