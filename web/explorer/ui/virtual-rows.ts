import { h } from './dom.js';

/** Browsers lay out no element higher than some millions of pixels. */
const MOST_PIXELS = 2_000_000;

/**
 * Scrolls through any number of rows of one height, of which only those in sight are elements. Where
 * they are too many for the height of an element, the wheel still moves by what it says, and the
 * scrollbar goes through all of them.
 */
export class VirtualRows {
  readonly element: HTMLElement;
  readonly #head: HTMLElement;
  readonly #window: HTMLElement;
  readonly #spacer: HTMLElement;
  readonly #rowHeight: number;
  readonly #show: (row: number, element: HTMLElement) => void;
  readonly #make: () => HTMLElement;
  #count = 0;
  /** What is at the upper edge, in pixels of all rows. */
  #top = 0;
  /** The scrollTop that goes with it. */
  #told = 0;
  /** What was to be revealed while there was no room. */
  #wanted: number | null = null;

  /** `grid` is what scrolls, `head` stays at its upper edge. */
  constructor(
    grid: HTMLElement,
    head: HTMLElement,
    rowHeight: number,
    make: () => HTMLElement,
    show: (row: number, element: HTMLElement) => void,
  ) {
    this.element = grid;
    this.#head = head;
    this.#rowHeight = rowHeight;
    this.#make = make;
    this.#show = show;
    this.#window = h('div', { class: 'rows-window', role: 'presentation' });
    this.#spacer = h('div', { class: 'rows-spacer', role: 'rowgroup' }, this.#window);
    grid.append(head, this.#spacer);
    this.element.addEventListener('scroll', () => {
      const { scrollTop } = this.element;
      if (Math.abs(scrollTop - this.#told) < 1) return;
      this.#told = scrollTop;
      this.#top = scrollTop * this.#scale;
      this.render();
    });
    this.element.addEventListener(
      'wheel',
      (event) => {
        if (this.#scale === 1 || event.ctrlKey) return;
        event.preventDefault();
        this.element.scrollLeft += event.deltaX;
        this.#moveTo(this.#top + event.deltaY * (event.deltaMode === 1 ? this.#rowHeight : 1));
      },
      { passive: false },
    );
    new ResizeObserver(() => {
      if (this.#wanted !== null) this.reveal(this.#wanted);
      // Rows that are in sight already were not drawn while there was no room.
      this.#moveTo(this.#top);
    }).observe(this.element);
  }

  /** How many rows are wholly in sight. */
  get page(): number {
    return Math.max(1, Math.floor(this.#height / this.#rowHeight));
  }

  setCount(count: number): void {
    this.#count = count;
    this.#spacer.style.height = `${Math.min(MOST_PIXELS, count * this.#rowHeight)}px`;
    this.#moveTo(this.#top);
  }

  /** Brings a row into sight: in the middle, if it was not. */
  reveal(row: number): void {
    const at = row * this.#rowHeight;
    const height = this.#height;
    this.#wanted = height <= 0 ? row : null;
    if (height <= 0) return;
    if (at < this.#top || at + this.#rowHeight > this.#top + height) {
      this.#moveTo(at - (height - this.#rowHeight) / 2);
    }
  }

  /** As `reveal`, by no more than it takes. */
  nudge(row: number): void {
    const at = row * this.#rowHeight;
    const height = this.#height;
    if (at < this.#top) this.#moveTo(at);
    else if (at + this.#rowHeight > this.#top + height) this.#moveTo(at + this.#rowHeight - height);
  }

  /** Shows the rows in sight anew. */
  render(): void {
    const height = this.#height;
    if (height <= 0) return;
    const first = Math.floor(this.#top / this.#rowHeight);
    const shown = Math.min(this.#count - first, Math.ceil(height / this.#rowHeight) + 1);
    while (this.#window.childElementCount < shown) this.#window.append(this.#make());
    [...this.#window.children].forEach((element, i) => {
      (element as HTMLElement).hidden = i >= shown;
      if (i < shown) this.#show(first + i, element as HTMLElement);
    });
    this.#window.style.transform = `translateY(${first * this.#rowHeight - this.#top}px)`;
  }

  /** The room for rows. */
  get #height(): number {
    return this.element.clientHeight - this.#head.offsetHeight;
  }

  /** Pixels of the rows to a pixel of the scrollbar. */
  get #scale(): number {
    const height = this.#height;
    const rows = this.#count * this.#rowHeight - height;
    const bar = Math.min(MOST_PIXELS, this.#count * this.#rowHeight) - height;
    return bar > 0 ? rows / bar : 1;
  }

  #moveTo(top: number): void {
    if (this.#height <= 0) return;
    const most = this.#count * this.#rowHeight - this.#height;
    this.#top = Math.max(0, Math.min(top, most));
    this.element.scrollTop = this.#top / this.#scale;
    this.#told = this.element.scrollTop;
    this.render();
  }
}
