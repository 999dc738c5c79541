import type { MeshFacts } from '../app/documents.js';
import type { Explorer } from '../app/explorer.js';
import { fill, h, icon } from './dom.js';

const LOOPS_SHOWN = 12;
const PROBLEMS_SHOWN = 5;

const number = (value: number) => value.toLocaleString('en-US').replace('-', '−');

/** The topology numbers of the mesh, its boundary loops, and whether it is sound. */
export function meshPanel(explorer: Explorer): HTMLElement {
  const title = h('h2', { id: 'mesh-title' });
  const counts = h('dl', { class: 'counts' });
  const validity = h('p', { class: 'validity', role: 'status' });
  const problems = h('ul', { class: 'problems', 'aria-label': 'Problems' });
  const loops = h('ul', { class: 'loops', 'aria-label': 'Boundary loops' });
  const show = () => {
    const opened = explorer.document.value;
    if (!opened) return;
    const { mesh } = opened;
    const facts = explorer.facts.value;
    title.textContent = opened.name;
    const entries: [string, string, string?][] = [
      ['Vertices', number(mesh.vertexCount)],
      ['Edges', number(mesh.edgeCount)],
      ['Faces', number(mesh.faceCount)],
      ['Euler χ', facts ? number(facts.characteristic) : '…', 'V − E + F'],
      ['Genus', facts ? number(facts.genus) : '…', 'handles, over all components'],
      ['Boundary loops', facts ? number(facts.boundaryLoops.length) : '…'],
    ];
    fill(
      counts,
      ...entries.map(([term, value, hint]) =>
        h('div', { title: hint }, h('dt', {}, term), h('dd', {}, value)),
      ),
    );
    showValidity(validity, facts);
    fill(problems, ...problemButtons(explorer, facts));
    fill(loops, ...loopButtons(explorer, facts));
  };
  explorer.document.subscribe(show);
  explorer.facts.subscribe(show);
  return h(
    'section',
    { class: 'mesh-facts', 'aria-labelledby': 'mesh-title' },
    title,
    counts,
    validity,
    problems,
    loops,
  );
}

function showValidity(line: HTMLElement, facts: MeshFacts | null): void {
  if (!facts) {
    fill(line, 'Checking the mesh …');
    return;
  }
  const errors = facts.problems.filter(({ severity }) => severity === 'error').length;
  line.classList.toggle('broken', errors > 0);
  if (errors > 0) {
    const count =
      errors === 1 ? 'one invariant is broken' : `invariants are broken ${number(errors)} times`;
    fill(line, icon('warning'), h('span', {}, `Not valid: ${count}.`));
    return;
  }
  const parts = [facts.components === 1 ? 'one component' : `${facts.components} components`];
  parts.push(facts.boundaryLoops.length === 0 ? 'closed' : 'with a boundary');
  if (facts.isolatedVertices > 0) parts.push(`${number(facts.isolatedVertices)} isolated vertices`);
  fill(line, icon('check'), h('span', {}, `Valid: all invariants hold; ${parts.join(', ')}.`));
}

/** What validation found, the worst first; a click goes to the item that it is about. */
function problemButtons(explorer: Explorer, facts: MeshFacts | null): HTMLElement[] {
  const order = ['error', 'warning', 'info'];
  const problems = [...(facts?.problems ?? [])].sort(
    (a, b) => order.indexOf(a.severity) - order.indexOf(b.severity),
  );
  const lines = problems.slice(0, PROBLEMS_SHOWN).map(({ message, kind, index, severity }) => {
    const text = h('span', { class: severity }, message);
    if (kind === 'mesh' || index < 0) return h('li', {}, text);
    const act = () => explorer.select({ kind, index });
    return h('li', {}, h('button', { type: 'button', title: 'Select it', onclick: act }, text));
  });
  const rest = problems.length - lines.length;
  if (rest > 0) lines.push(h('li', { class: 'empty' }, `and ${number(rest)} more`));
  return lines;
}

/** One button for each boundary loop, which selects a halfedge of it. */
function loopButtons(explorer: Explorer, facts: MeshFacts | null): HTMLElement[] {
  const halfedges = facts?.boundaryLoops ?? [];
  const buttons = halfedges.slice(0, LOOPS_SHOWN).map((index) =>
    h(
      'li',
      {},
      h(
        'button',
        {
          type: 'button',
          title: 'Select a halfedge of this boundary loop',
          onclick: () => explorer.select({ kind: 'halfedge', index }),
        },
        `loop h${index}`,
      ),
    ),
  );
  const rest = halfedges.length - buttons.length;
  if (rest > 0) buttons.push(h('li', { class: 'empty' }, `and ${number(rest)} more`));
  return buttons;
}
