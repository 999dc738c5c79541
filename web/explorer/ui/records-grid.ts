import type { HalfedgeMesh, ItemKind } from 'halfedge';
import { type Item, isLive, itemName, itemSlots, sameItem } from 'halfedge/teaching';
import type { Explorer } from '../app/explorer.js';
import { type Cell, type Column, columnsOf, roomOfIndex } from '../app/record-columns.js';
import { cellKey, type Reading, rowsOf } from '../app/records.js';
import { fill, h, setAttribute } from './dom.js';
import { VirtualRows } from './virtual-rows.js';

const ROW_PX = 26;

/** A cell; column 0 is the record itself. */
interface Place {
  readonly row: number;
  readonly column: number;
}

/**
 * The records of one kind, as a grid that is left by its links: a click or Enter picks what a cell leads to. Only the
 * rows in sight are elements, and each shows one record after another.
 */
export class RecordsGrid {
  readonly element: HTMLElement;
  /** What the last step of the player has read. */
  reading: Reading = { cells: new Set(), at: null };
  readonly #explorer: Explorer;
  readonly #head: HTMLElement;
  readonly #rows: VirtualRows;
  #kind: ItemKind = 'vertex';
  #columns: readonly Column[] = [];
  /** The cell of the keyboard. */
  #active: Place = { row: 0, column: 0 };
  /** Where the mouse was seen last, and whether keys were pressed since. */
  #mouse = { x: Number.NaN, y: Number.NaN, isLeft: false };

  constructor(explorer: Explorer) {
    this.#explorer = explorer;
    this.#head = h('div', { class: 'record head', role: 'row', 'aria-rowindex': 1 });
    this.element = h('div', {
      class: 'records-grid rows',
      translate: 'no',
      role: 'grid',
      tabindex: 0,
      'aria-label': 'Records',
    });
    this.#rows = new VirtualRows(
      this.element,
      h('div', { role: 'rowgroup' }, this.#head),
      ROW_PX,
      () => h('div', { class: 'record', role: 'row' }),
      (row, element) => this.#showRow(row, element),
    );
    this.#listenToMouse();
    this.element.addEventListener('blur', () => {
      explorer.hovered.value = null;
    });
    this.element.addEventListener('keydown', (event) => this.#pressed(event));
  }

  /** The kind of records on show. */
  get kind(): ItemKind {
    return this.#kind;
  }

  /** Shows the records of a kind, as they are now. */
  show(kind: ItemKind): void {
    const { value: opened } = this.#explorer.document;
    if (!opened) return;
    const { mesh, names } = opened;
    const grid = this.element;
    const isOther = kind !== this.#kind;
    this.#kind = kind;
    this.#columns = columnsOf(mesh, kind, names);
    grid.dataset.records = kind;
    setTracks(grid, [roomOfIndex(mesh, kind), ...this.#columns.map(({ room }) => room)]);
    if (isOther) grid.scrollLeft = 0;
    setAttribute(grid, 'aria-rowcount', itemSlots(mesh, kind) + 1);
    setAttribute(grid, 'aria-colcount', this.#columns.length + 1);
    const heads = this.#columns.map(({ name, meaning, isAttribute }) =>
      h('span', { role: 'columnheader', title: meaning, 'data-attribute': isAttribute }, name),
    );
    fill(this.#head, h('span', { role: 'columnheader', title: 'its index' }, kind), ...heads);
    this.#rows.setCount(itemSlots(mesh, kind));
  }

  /** Makes a record the one of the keyboard, and brings it into sight. */
  goTo(row: number): void {
    this.#active = { row, column: 0 };
    this.reveal();
  }

  /** Brings the cell of the keyboard into sight. */
  reveal(): void {
    this.#rows.reveal(this.#active.row);
    this.render();
  }

  /** Shows the rows in sight anew. */
  render(): void {
    this.#rows.render();
  }

  get #mesh(): HalfedgeMesh | undefined {
    return this.#explorer.document.value?.mesh;
  }

  #showRow(row: number, element: HTMLElement): void {
    const mesh = this.#mesh;
    if (!mesh) return;
    const record: Item = { kind: this.#kind, index: row };
    const live = isLive(mesh, record);
    const cells = live ? this.#columns.map((column) => column.cell(mesh, row)) : [];
    const shown: Cell[] = [{ text: itemName(record), target: record }, ...cells];
    while (element.childElementCount > shown.length) element.lastElementChild?.remove();
    while (element.childElementCount < shown.length) element.append(h('span'));
    setAttribute(element, 'aria-rowindex', row + 2);
    element.dataset.row = String(row);
    this.#markRow(row, element, live);
    shown.forEach((cell, column) => {
      this.#showCell({ row, column }, cell, element.children[column] as HTMLElement, live);
    });
    if (!live) element.append(h('span', { role: 'gridcell', class: 'gone' }, 'deleted'));
  }

  #markRow(row: number, element: HTMLElement, live: boolean): void {
    const { selected, hovered } = this.#explorer;
    const isSelected = rowsOf(selected.value, this.#kind).includes(row);
    const isAt = this.#kind === 'halfedge' && this.reading.at === row;
    element.classList.toggle('deleted', !live);
    element.classList.toggle('selected', isSelected);
    element.classList.toggle('hovered', rowsOf(hovered.value, this.#kind).includes(row));
    element.classList.toggle('at', isAt);
    // What the colours say, for those who hear the table.
    setAttribute(element, 'aria-selected', isSelected && 'true');
    setAttribute(element, 'aria-current', isAt && 'step');
  }

  #showCell({ row, column }: Place, { text, target }: Cell, cell: HTMLElement, live: boolean) {
    const { selected, hovered } = this.#explorer;
    const { name = '', isAttribute = false } = this.#columns[column - 1] ?? {};
    const isActive = row === this.#active.row && column === this.#active.column;
    const isRead = !isAttribute && this.reading.cells.has(cellKey(this.#kind, row, name));
    const points = column > 0 && target !== null;
    cell.id = `record-${row}-${column}`;
    setAttribute(cell, 'role', column === 0 ? 'rowheader' : 'gridcell');
    cell.dataset.column = String(column);
    cell.dataset.name = name;
    setAttribute(cell, 'data-attribute', isAttribute);
    setAttribute(cell, 'title', target === null && text);
    if (cell.textContent !== text) cell.textContent = text;
    cell.classList.toggle('link', live && target !== null);
    cell.classList.toggle('active', isActive);
    cell.classList.toggle('read', isRead);
    cell.classList.toggle('to-selected', points && sameItem(target, selected.value));
    cell.classList.toggle('to-hovered', points && sameItem(target, hovered.value));
    if (isActive) this.element.setAttribute('aria-activedescendant', cell.id);
  }

  /** What a cell stands for: its record, or where its link leads. */
  #itemAt({ row, column }: Place): Item | null {
    const mesh = this.#mesh;
    const record: Item = { kind: this.#kind, index: row };
    if (!mesh || !isLive(mesh, record)) return null;
    if (column === 0) return record;
    return this.#columns[column - 1]?.cell(mesh, row).target ?? null;
  }

  /** Lights what a cell stands for, as if it were pointed at in the picture. */
  #pointAt(place: Place): void {
    const { hovered } = this.#explorer;
    const item = this.#itemAt(place);
    if (!sameItem(item, hovered.value)) hovered.value = item;
  }

  /** Picks what a cell stands for. */
  #enter(place: Place): void {
    this.#active = place;
    const item = this.#itemAt(place);
    if (item) this.#explorer.pick(item);
    this.render();
  }

  #listenToMouse(): void {
    const grid = this.element;
    grid.addEventListener('mouseover', (event) => {
      const { clientX: x, clientY: y } = event;
      // Rows that come under a mouse at rest are not pointed at by it.
      if (this.#mouse.isLeft && this.#mouse.x === x && this.#mouse.y === y) return;
      this.#mouse = { x, y, isLeft: false };
      const place = placeOf(event);
      if (place) this.#pointAt(place);
    });
    grid.addEventListener('mouseleave', () => {
      this.#explorer.hovered.value = null;
    });
    grid.addEventListener('click', (event) => {
      const place = placeOf(event);
      grid.focus({ preventScroll: true });
      if (place) this.#enter(place);
    });
  }

  #pressed(event: KeyboardEvent): void {
    const mesh = this.#mesh;
    if (!mesh) return;
    const to = this.#destination(mesh, event);
    if (event.key === 'Enter') this.#enter(this.#active);
    else if (!to) return;
    event.preventDefault();
    event.stopPropagation();
    if (!to) return;
    this.#mouse.isLeft = true;
    this.#active = to;
    this.#rows.nudge(to.row);
    this.render();
    this.#nudgeSideways();
    this.#pointAt(to);
  }

  /** The cell that a key leads to; null for a key that leads nowhere. */
  #destination(mesh: HalfedgeMesh, event: KeyboardEvent): Place | null {
    const last = { row: itemSlots(mesh, this.#kind) - 1, column: this.#columns.length };
    const { row, column } = this.#active;
    const { page } = this.#rows;
    const far = event.ctrlKey || event.metaKey;
    const places: Record<string, Place> = {
      ArrowUp: { row: row - 1, column },
      ArrowDown: { row: row + 1, column },
      ArrowLeft: { row, column: column - 1 },
      ArrowRight: { row, column: column + 1 },
      PageUp: { row: row - page, column },
      PageDown: { row: row + page, column },
      Home: { row: far ? 0 : row, column: 0 },
      End: { row: far ? last.row : row, column: last.column },
    };
    const to = places[event.key];
    if (!to) return null;
    return {
      row: Math.max(0, Math.min(last.row, to.row)),
      column: Math.max(0, Math.min(last.column, to.column)),
    };
  }

  /** Brings the cell of the keyboard into sight, from beyond the edge or from under the record's name. */
  #nudgeSideways(): void {
    const grid = this.element;
    const cell = grid.querySelector<HTMLElement>('.active');
    const name = cell?.parentElement?.firstElementChild as HTMLElement | null | undefined;
    if (!cell || !name) return;
    if (cell === name) {
      grid.scrollLeft = 0;
      return;
    }
    const most = cell.offsetLeft - name.offsetWidth;
    const least = cell.offsetLeft + cell.offsetWidth - grid.clientWidth;
    grid.scrollLeft = Math.min(most, Math.max(least, grid.scrollLeft));
  }
}

/** The cell under the mouse. */
function placeOf({ target }: MouseEvent): Place | null {
  const cell = (target as HTMLElement).closest<HTMLElement>('[data-column]');
  const row = cell?.parentElement?.dataset.row;
  return cell && row !== undefined
    ? { row: Number(row), column: Number(cell.dataset.column) }
    : null;
}

/** The widths of the columns: each has what it needs, and its share of what is left. */
function setTracks(grid: HTMLElement, rooms: readonly number[]): void {
  const least = (room: number) => `calc(${room}ch + var(--cell-padding))`;
  grid.style.setProperty('--tracks', rooms.map((it) => `minmax(${least(it)}, ${it}fr)`).join(' '));
  grid.style.setProperty('--least-width', `calc(${rooms.map(least).join(' + ')})`);
}
