import type { MeshDocument } from './documents.js';

/** The parts of the panel of which one is shown at a time. */
export const TABS = ['inspect', 'circulate', 'edit', 'mesh', 'records', 'problems'] as const;
export type Tab = (typeof TABS)[number];

/** Whether there is something to tell of a mesh as it was in its file. */
export function hasProblems(opened: MeshDocument | null): boolean {
  return opened !== null && (opened.diagnosis !== null || opened.lesson !== null);
}

/** What comes to the front with a mesh. */
export function firstTab(opened: MeshDocument | null): Tab {
  return hasProblems(opened) ? 'problems' : 'circulate';
}
