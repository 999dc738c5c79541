import type { ItemKind } from 'halfedge';
import { type Item, isLive, itemName, itemSlots, sameItem } from 'halfedge/teaching';
import type { Explorer } from '../app/explorer.js';
import { type Cell, type Column, columnsOf, roomOfIndex } from '../app/record-columns.js';
import { cellKey, type Reading, readingOf, rowsOf } from '../app/records.js';
import type { Signal } from '../app/signal.js';
import { fill, h, setAttribute } from './dom.js';
import { VirtualRows } from './virtual-rows.js';

const ROW_PX = 26;

const KINDS: readonly [ItemKind, string][] = [
  ['vertex', 'Vertices'],
  ['halfedge', 'Halfedges'],
  ['edge', 'Edges'],
  ['face', 'Faces'],
];

/**
 * The arrays of the mesh as they are: a grid of links that lead from record to record, and of attributes. It
 * follows the selection and the player, and lights what is pointed at in the picture.
 */
export function recordsPanel(explorer: Explorer): HTMLElement {
  let kind: ItemKind = 'vertex';
  let columns: readonly Column[] = [];
  /** The cell of the keyboard; column 0 is the record itself. */
  let active = { row: 0, column: 0 };
  let reading: Reading = { cells: new Set(), at: null };
  /** Where the mouse was seen last, and whether keys were pressed since. */
  let mouse = { x: Number.NaN, y: Number.NaN, isLeft: false };

  const kinds = kindSegments((chosen) => {
    show(chosen);
    active = { row: 0, column: 0 };
    reveal();
  });
  const head = h('div', { class: 'record head', role: 'row', 'aria-rowindex': 1 });
  const grid = h('div', {
    class: 'records-grid rows',
    role: 'grid',
    tabindex: 0,
    'aria-label': 'Records',
  });
  const makeRow = () => h('div', { class: 'record', role: 'row' });
  const rows = new VirtualRows(
    grid,
    h('div', { role: 'rowgroup' }, head),
    ROW_PX,
    makeRow,
    showRow,
  );
  const section = h(
    'section',
    { class: 'records', 'aria-labelledby': 'records-title' },
    h('h2', { id: 'records-title', class: 'visually-hidden' }, 'Records'),
    kinds.element,
    grid,
  );

  const meshNow = () => explorer.document.value?.mesh;
  const isShown = () => explorer.tab.value === 'records';

  /** What a cell stands for: its record, or where its link leads. */
  function itemAt(row: number, column: number): Item | null {
    const mesh = meshNow();
    if (!mesh || !isLive(mesh, { kind, index: row })) return null;
    if (column === 0) return { kind, index: row };
    return columns[column - 1]?.cell(mesh, row).target ?? null;
  }

  function show(next: ItemKind): void {
    const { value: opened } = explorer.document;
    if (!opened) return;
    const { mesh, names } = opened;
    const isOther = next !== kind;
    kind = next;
    columns = columnsOf(mesh, kind, names);
    kinds.choose(kind);
    grid.dataset.records = kind;
    setTracks(grid, [roomOfIndex(mesh, kind), ...columns.map(({ room }) => room)]);
    if (isOther) grid.scrollLeft = 0;
    setAttribute(grid, 'aria-rowcount', itemSlots(mesh, kind) + 1);
    setAttribute(grid, 'aria-colcount', columns.length + 1);
    const heads = columns.map(({ name, meaning, isAttribute }) =>
      h('span', { role: 'columnheader', title: meaning, 'data-attribute': isAttribute }, name),
    );
    fill(head, h('span', { role: 'columnheader', title: 'its index' }, kind), ...heads);
    rows.setCount(itemSlots(mesh, kind));
  }

  function showRow(row: number, element: HTMLElement): void {
    const mesh = meshNow();
    if (!mesh) return;
    const { selected, hovered } = explorer;
    const live = isLive(mesh, { kind, index: row });
    const cells: Cell[] = live ? columns.map((column) => column.cell(mesh, row)) : [];
    const shown = [
      { text: itemName({ kind, index: row }), target: { kind, index: row } },
      ...cells,
    ];
    while (element.childElementCount > shown.length) element.lastElementChild?.remove();
    while (element.childElementCount < shown.length) element.append(h('span'));
    setAttribute(element, 'aria-rowindex', row + 2);
    element.dataset.row = String(row);
    element.classList.toggle('deleted', !live);
    const isSelected = rowsOf(selected.value, kind).includes(row);
    const isAt = kind === 'halfedge' && reading.at === row;
    element.classList.toggle('selected', isSelected);
    element.classList.toggle('hovered', rowsOf(hovered.value, kind).includes(row));
    element.classList.toggle('at', isAt);
    // What the colours say, for those who hear the table.
    setAttribute(element, 'aria-selected', isSelected && 'true');
    setAttribute(element, 'aria-current', isAt && 'step');
    shown.forEach(({ text, target }, column) => {
      const cell = element.children[column] as HTMLElement;
      const isActive = row === active.row && column === active.column;
      const { name = '', isAttribute = false } = columns[column - 1] ?? {};
      cell.id = `record-${row}-${column}`;
      setAttribute(cell, 'role', column === 0 ? 'rowheader' : 'gridcell');
      cell.dataset.column = String(column);
      cell.dataset.name = name;
      setAttribute(cell, 'data-attribute', isAttribute);
      setAttribute(cell, 'title', target === null && text);
      if (cell.textContent !== text) cell.textContent = text;
      const points = column > 0 && target !== null;
      cell.classList.toggle('link', live && target !== null);
      cell.classList.toggle('active', isActive);
      const isRead = !isAttribute && reading.cells.has(cellKey(kind, row, name));
      cell.classList.toggle('read', isRead);
      cell.classList.toggle('to-selected', points && sameItem(target, selected.value));
      cell.classList.toggle('to-hovered', points && sameItem(target, hovered.value));
      if (isActive) grid.setAttribute('aria-activedescendant', cell.id);
    });
    if (!live) element.append(h('span', { role: 'gridcell', class: 'gone' }, 'deleted'));
  }

  function reveal(): void {
    rows.reveal(active.row);
    rows.render();
  }

  /** Brings the cell of the keyboard into sight, from beyond the edge or from under the record's name. */
  function nudgeSideways(): void {
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

  /** Goes where the selection is: to its record, or the first of its two. */
  function follow(): void {
    const mesh = meshNow();
    if (!mesh || !isShown()) return;
    const { value: selected } = explorer.selected;
    reading = readingOf(mesh, explorer.play.value);
    const at = reading.at;
    if (at !== null && explorer.play.value?.position) {
      show('halfedge');
      active = { row: at, column: 0 };
    } else if (selected) {
      // An edge is two halfedges side by side, unless it is edges that are looked at.
      const next = selected.kind === 'edge' && kind !== 'edge' ? 'halfedge' : selected.kind;
      show(next);
      active = { row: rowsOf(selected, next)[0] ?? 0, column: 0 };
    } else {
      show(kind);
    }
    reveal();
  }

  function point(row: number, column: number): void {
    const item = itemAt(row, column);
    if (!sameItem(item, explorer.hovered.value)) explorer.hovered.value = item;
  }

  function cellOfEvent(event: Event): [row: number, column: number] | null {
    const cell = (event.target as HTMLElement).closest<HTMLElement>('[data-column]');
    const row = cell?.parentElement?.dataset.row;
    return cell && row !== undefined ? [Number(row), Number(cell.dataset.column)] : null;
  }

  function enter(row: number, column: number): void {
    active = { row, column };
    const item = itemAt(row, column);
    if (item) explorer.pick(item);
    rows.render();
  }

  grid.addEventListener('mouseover', (event) => {
    const { clientX: x, clientY: y } = event;
    // Rows that come under a mouse at rest are not pointed at by it.
    if (mouse.isLeft && mouse.x === x && mouse.y === y) return;
    mouse = { x, y, isLeft: false };
    const at = cellOfEvent(event);
    if (at) point(...at);
  });
  grid.addEventListener('mouseleave', () => {
    explorer.hovered.value = null;
  });
  grid.addEventListener('click', (event) => {
    const at = cellOfEvent(event);
    grid.focus({ preventScroll: true });
    if (at) enter(...at);
  });
  grid.addEventListener('blur', () => {
    explorer.hovered.value = null;
  });
  grid.addEventListener('keydown', (event) => {
    const mesh = meshNow();
    if (!mesh) return;
    const last = { row: itemSlots(mesh, kind) - 1, column: columns.length };
    const { row, column } = active;
    const far = event.ctrlKey || event.metaKey;
    const moves: Record<string, () => typeof active> = {
      ArrowUp: () => ({ row: row - 1, column }),
      ArrowDown: () => ({ row: row + 1, column }),
      ArrowLeft: () => ({ row, column: column - 1 }),
      ArrowRight: () => ({ row, column: column + 1 }),
      PageUp: () => ({ row: row - rows.page, column }),
      PageDown: () => ({ row: row + rows.page, column }),
      Home: () => ({ row: far ? 0 : row, column: 0 }),
      End: () => ({ row: far ? last.row : row, column: last.column }),
    };
    const move = moves[event.key];
    if (event.key === 'Enter') enter(row, column);
    else if (!move) return;
    event.preventDefault();
    event.stopPropagation();
    if (!move) return;
    mouse = { ...mouse, isLeft: true };
    const to = move();
    active = {
      row: Math.max(0, Math.min(last.row, to.row)),
      column: Math.max(0, Math.min(last.column, to.column)),
    };
    rows.nudge(active.row);
    rows.render();
    nudgeSideways();
    point(active.row, active.column);
  });

  for (const signal of [explorer.tab, explorer.document, explorer.selected, explorer.play]) {
    (signal as Signal<unknown>).subscribe(follow);
  }
  explorer.editor.edit.subscribe(() => queueMicrotask(follow));
  explorer.hovered.subscribe(() => {
    if (isShown()) rows.render();
  });
  return section;
}

/** The widths of the columns: each has what it needs, and its share of what is left. */
function setTracks(grid: HTMLElement, rooms: readonly number[]): void {
  const least = (room: number) => `calc(${room}ch + var(--cell-padding))`;
  grid.style.setProperty('--tracks', rooms.map((it) => `minmax(${least(it)}, ${it}fr)`).join(' '));
  grid.style.setProperty('--least-width', `calc(${rooms.map(least).join(' + ')})`);
}

function kindSegments(choose: (kind: ItemKind) => void) {
  const inputs = new Map<ItemKind, HTMLInputElement>();
  const element = h('div', {
    class: 'segments',
    role: 'radiogroup',
    'aria-label': 'Records of',
  });
  for (const [kind, text] of KINDS) {
    const input = h('input', {
      type: 'radio',
      name: 'records',
      value: kind,
      onchange: () => choose(kind),
    });
    inputs.set(kind, input);
    element.append(h('label', {}, input, text));
  }
  const mark = (kind: ItemKind) => {
    for (const [each, input] of inputs) input.checked = each === kind;
  };
  return { element, choose: mark };
}
