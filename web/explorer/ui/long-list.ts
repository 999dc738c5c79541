import { grouped } from '../app/facts.js';
import { fill, h } from './dom.js';

const MORE = 50;

/** A list that shows its first lines, and more of them when asked to. */
export function longList(name: string, label: string) {
  const element = h('ul', { class: name, 'aria-label': label });
  const show = (lines: readonly (() => HTMLElement)[], most: number): void => {
    const rest = lines.length - most;
    const shown = lines.slice(0, most).map((make) => make());
    if (rest > 0) {
      const more = h(
        'button',
        {
          type: 'button',
          class: 'more',
          onclick: () => {
            show(lines, most + MORE);
            element.querySelector<HTMLElement>(`li:nth-child(n + ${most + 1}) button`)?.focus();
          },
        },
        `and ${grouped(rest)} more`,
      );
      shown.push(h('li', {}, more));
    }
    fill(element, ...shown);
  };
  return { element, show };
}
