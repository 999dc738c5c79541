import type { ItemKind } from 'halfedge';

/** Where items have their names beside them: nowhere, around the selection, the pointer, everywhere. */
export const LABEL_SCOPES = ['off', 'selection', 'pointer', 'all'] as const;
export type LabelScope = (typeof LABEL_SCOPES)[number];

export const LABEL_KINDS: readonly ItemKind[] = ['vertex', 'edge', 'halfedge', 'face'];

/** Which items have their names beside them, besides what is selected or visited. */
export interface LabelChoice {
  readonly scope: LabelScope;
  readonly kinds: readonly ItemKind[];
}

export const NO_LABELS: LabelChoice = { scope: 'off', kinds: ['vertex', 'halfedge', 'face'] };

/** The scope after this one, which comes around. */
export function nextScope({ scope, kinds }: LabelChoice): LabelChoice {
  const at = LABEL_SCOPES.indexOf(scope);
  return { scope: LABEL_SCOPES[(at + 1) % LABEL_SCOPES.length], kinds };
}

/** With a kind, or without it; in the order of the kinds. */
export function withKind({ scope, kinds }: LabelChoice, kind: ItemKind, on: boolean): LabelChoice {
  const chosen = LABEL_KINDS.filter((each) => (each === kind ? on : kinds.includes(each)));
  return { scope, kinds: chosen };
}

/** `all:vh`; null where that is no choice of labels. */
export function parseLabels(text: string): LabelChoice | null {
  const [, word, letters] = /^(\w+):([vehf]*)$/.exec(text) ?? [];
  const scope = LABEL_SCOPES.find((known) => known === word);
  if (!scope) return null;
  return { scope, kinds: LABEL_KINDS.filter(([letter]) => letters.includes(letter)) };
}

/** What `parseLabels` reads. */
export function labelsText({ scope, kinds }: LabelChoice): string {
  return `${scope}:${kinds.map(([letter]) => letter).join('')}`;
}
