import {
  DARK,
  declarations,
  LABEL_STYLES,
  LIGHT,
  MORE_CONTRAST,
  SLIDER_STYLES,
} from 'halfedge/scene';
import { Signal } from '../app/signal.js';

const KEY = 'halfedge-explorer-theme';

/** The colours of page and picture, and the looks of labels, as the package has them. */
export function addPictureStyles(): void {
  const styles = document.createElement('style');
  styles.textContent = `
    :root { color-scheme: light; ${declarations(LIGHT)} }
    :root[data-theme="dark"] { color-scheme: dark; ${declarations(DARK)} }
    @media (prefers-contrast: more) { :root { ${MORE_CONTRAST} } }
    ${LABEL_STYLES}${SLIDER_STYLES}`;
  document.head.prepend(styles);
}

/** Light or dark: what the system prefers, until somebody chooses otherwise here. */
export class Theme {
  readonly current: Signal<'light' | 'dark'>;
  readonly #system = window.matchMedia('(prefers-color-scheme: dark)');

  constructor() {
    this.current = new Signal(this.#chosen() ?? this.#preferred());
    this.current.subscribe((theme) => {
      document.documentElement.dataset.theme = theme;
    });
    this.#system.addEventListener('change', () => {
      if (!this.#chosen()) this.current.value = this.#preferred();
    });
  }

  toggle(): void {
    const theme = this.current.value === 'dark' ? 'light' : 'dark';
    try {
      localStorage.setItem(KEY, theme);
    } catch {
      // Without storage the choice lasts as long as the page.
    }
    this.current.value = theme;
  }

  #preferred(): 'light' | 'dark' {
    return this.#system.matches ? 'dark' : 'light';
  }

  #chosen(): 'light' | 'dark' | null {
    try {
      const stored = localStorage.getItem(KEY);
      return stored === 'light' || stored === 'dark' ? stored : null;
    } catch {
      return null;
    }
  }
}
