import type { Item } from 'halfedge/teaching';
import { type Explorer, LARGE } from '../app/explorer.js';
import { grouped, type MeshFacts, type Numbers, type Problems } from '../app/facts.js';
import { fill, h, icon } from './dom.js';
import { downloads, type TakePicture } from './downloads.js';
import { changeBadge } from './history-bar.js';
import { longList } from './long-list.js';
import { segments } from './segments.js';

const LOOPS_SHOWN = 12;
const PROBLEMS_SHOWN = 5;

const ENTRIES: readonly [keyof Numbers, string, string?][] = [
  ['vertices', 'Vertices'],
  ['edges', 'Edges'],
  ['faces', 'Faces'],
  ['characteristic', 'Euler χ', 'V − E + F'],
  ['genus', 'Genus', 'handles, over all components'],
  ['loops', 'Boundary loops'],
];

/** Selects an item and flies there. */
export type GoTo = (item: Item) => void;

/** The topology numbers of the mesh, whether it is sound and where it is not, its boundary loops. */
export function meshPanel(explorer: Explorer, goTo: GoTo, takePicture: TakePicture): HTMLElement {
  const title = h('h2', { id: 'mesh-title' });
  const counts = h('dl', { class: 'counts' });
  const validity = h('p', { class: 'validity', role: 'status' });
  const problems = longList('problems', 'What validation found');
  const loops = longList('loops', 'Boundary loops');
  const show = () => {
    const opened = explorer.document.value;
    const facts = explorer.facts.value;
    if (!opened) return;
    const { mesh } = opened;
    title.textContent = opened.name;
    const numbers = facts?.numbers ?? {
      vertices: mesh.vertexCount,
      edges: mesh.edgeCount,
      faces: mesh.faceCount,
    };
    fill(counts, ...ENTRIES.map((entry) => count(entry, numbers, facts?.changes ?? {})));
    showValidity(validity, facts);
    const lines = (facts?.boundaryLoops ?? []).map(
      (index) => () => loopLine(index, [...mesh.halfedgeLoop(index)].length, goTo),
    );
    loops.show(lines, LOOPS_SHOWN);
  };
  explorer.document.subscribe(show);
  explorer.facts.subscribe(show);
  const unchecked = h(
    'p',
    { class: 'unchecked' },
    `Where the vertices lie is checked up to ${grouped(LARGE)} faces.`,
  );
  explorer.problems.subscribe((found) => {
    problems.show(found ? problemLines(found, goTo) : [], PROBLEMS_SHOWN);
    unchecked.hidden = !found || (explorer.document.value?.mesh.faceCount ?? 0) <= LARGE;
  });
  return h(
    'section',
    { class: 'mesh-facts', 'aria-labelledby': 'mesh-title' },
    title,
    counts,
    validity,
    problems.element,
    unchecked,
    loops.element,
    upChoice(explorer),
    downloads(explorer, takePicture),
  );
}

/** Which axis points up: files don't tell, and those of CAD and of scanners mostly mean z. */
function upChoice(explorer: Explorer): HTMLElement {
  const axes = segments(
    'up',
    { 'aria-labelledby': 'up-title' },
    (['y', 'z'] as const).map((value) => ({
      value,
      content: [value],
      title: `${value} points up (Y)`,
    })),
    (axis) => explorer.setUp(axis),
  );
  explorer.up.subscribe((axis) => axes.mark(axis));
  const title = h('span', { id: 'up-title' }, 'Points up');
  return h('div', { class: 'up-choice' }, title, axes.element);
}

function count(
  [name, term, hint]: (typeof ENTRIES)[number],
  numbers: Partial<Numbers>,
  changes: Partial<Numbers>,
): HTMLElement {
  const [value, change] = [numbers[name], changes[name]];
  return h(
    'div',
    { title: hint },
    h('dt', {}, term),
    h(
      'dd',
      {},
      value === undefined ? '…' : grouped(value),
      change !== undefined && changeBadge(change),
    ),
  );
}

function showValidity(line: HTMLElement, facts: MeshFacts | null): void {
  line.classList.remove('broken');
  if (!facts) {
    fill(line, 'Checking the mesh …');
    return;
  }
  const { numbers, isolatedVertices, problems } = facts;
  const errors = problems.filter(({ severity }) => severity === 'error').length;
  line.classList.toggle('broken', errors > 0);
  if (errors > 0) {
    const times =
      errors === 1 ? 'one invariant is broken' : `invariants are broken ${grouped(errors)} times`;
    fill(line, icon('warning'), h('span', {}, `Not valid: ${times}.`));
    return;
  }
  const parts: string[] = [];
  if (numbers.faces === 0) {
    parts.push('no faces');
  } else {
    const { components } = numbers;
    parts.push(components === 1 ? 'one component' : `${grouped(components)} components`);
    parts.push(numbers.loops === 0 ? 'closed' : 'with a boundary');
  }
  if (isolatedVertices > 0) {
    const vertices = isolatedVertices === 1 ? 'vertex' : 'vertices';
    parts.push(`${grouped(isolatedVertices)} isolated ${vertices}`);
  }
  fill(line, icon('check'), h('span', {}, `Valid: all invariants hold; ${parts.join(', ')}.`));
}

/** What validation found, the worst first; a click goes to the item that it is about. */
function problemLines(problems: Problems, goTo: GoTo): (() => HTMLElement)[] {
  const order = ['error', 'warning', 'info'];
  const sorted = [...problems].sort(
    (a, b) => order.indexOf(a.severity) - order.indexOf(b.severity),
  );
  return sorted.map(({ message, kind, index, severity, code }) => () => {
    const text = [
      h('span', { class: `severity ${severity}` }, severity === 'info' ? 'note' : severity),
      h('span', {}, message),
    ];
    if (kind === 'mesh' || index < 0) return h('li', {}, ...text);
    const act = () => goTo({ kind, index });
    const attributes = { type: 'button', 'data-problem': code, title: 'Go there', onclick: act };
    return h('li', {}, h('button', attributes, ...text));
  });
}

/** A boundary loop by a halfedge of it; a click goes there. */
function loopLine(index: number, length: number, goTo: GoTo): HTMLElement {
  const act = () => goTo({ kind: 'halfedge', index });
  const edges = length === 1 ? '1 edge' : `${grouped(length)} edges`;
  return h(
    'li',
    {},
    h(
      'button',
      { type: 'button', title: 'Go to this boundary loop', onclick: act },
      `loop h${index} `,
      h('small', {}, edges),
    ),
  );
}
