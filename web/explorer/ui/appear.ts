/**
 * Returns how to show or hide a notice, or to show it for a while. The focus that is in it goes back to where it was
 * before, or else to the picture.
 */
export function appearance(notice: HTMLElement): (shows: boolean, forMs?: number) => void {
  let before: Element | null = null;
  let hiding: ReturnType<typeof setTimeout> | undefined;
  return function appear(shows: boolean, forMs?: number): void {
    clearTimeout(hiding);
    if (forMs !== undefined) hiding = setTimeout(() => appear(false), forMs);
    const { activeElement } = document;
    if (shows && notice.hidden) before = activeElement;
    if (!shows && notice.contains(activeElement)) giveFocusTo(before);
    notice.hidden = !shows;
  };
}

/** Has Escape, where the focus is in a notice, do no more than to hide that. */
export function hideByEscape(notice: HTMLElement, hide: () => void): void {
  notice.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape') return;
    event.stopPropagation();
    hide();
  });
}

/** Lets the keys walk and orbit: no button takes Enter and Space for itself. */
export function focusPicture(): void {
  document.querySelector<HTMLElement>('main.stage canvas')?.focus();
}

function giveFocusTo(element: Element | null): void {
  const takes = element instanceof HTMLElement && element.checkVisibility();
  if (takes && element !== document.body) element.focus();
  else focusPicture();
}
