import type { Problem } from 'halfedge';
import type { Diagnosis, Finding } from '../app/diagnosis.js';
import type { Explorer } from '../app/explorer.js';
import { grouped } from '../app/facts.js';
import { fill, h, icon } from './dom.js';
import { downloads, type TakePicture } from './downloads.js';
import { longList } from './long-list.js';

const SHOWN = 4;

/** What was wrong in the file and what was done about it; a click on a problem goes there. */
export function problemsPanel(
  explorer: Explorer,
  focus: () => void,
  takePicture: TakePicture,
): HTMLElement {
  const title = h('h2', { id: 'problems-title' });
  const lesson = h('p', { class: 'lesson' });
  const summary = h('p', { class: 'diagnosis', role: 'status' });
  const findings = h('div', { class: 'findings' });
  explorer.document.subscribe((opened) => {
    if (!opened) return;
    const { diagnosis } = opened;
    title.textContent = opened.name;
    lesson.textContent = opened.lesson;
    lesson.hidden = opened.lesson === null;
    // What a reader without a diagnosis did is in the lesson.
    summary.hidden = diagnosis === null && opened.sample === null;
    summary.classList.toggle('repaired', diagnosis?.isRepaired ?? false);
    const state = diagnosis?.isRepaired ? 'warning' : 'check';
    fill(summary, icon(state), h('span', {}, verdict(diagnosis)));
    fill(
      findings,
      ...(diagnosis?.findings ?? []).map((found) =>
        group(explorer, found, diagnosis?.placed, focus),
      ),
    );
  });
  explorer.problem.subscribe((lit) => {
    for (const button of findings.querySelectorAll<LitButton>('[data-finding] [data-code]')) {
      button.setAttribute('aria-pressed', String(lit !== null && button.problem === lit));
    }
  });
  return h(
    'section',
    { class: 'file-problems', 'aria-labelledby': 'problems-title' },
    title,
    lesson,
    summary,
    findings,
    downloads(explorer, takePicture),
  );
}

/** A button that remembers what it lights. */
type LitButton = HTMLButtonElement & { problem?: Problem };

function verdict(diagnosis: Diagnosis | null): string {
  if (!diagnosis) return 'Nothing in the file had to be repaired.';
  if (!diagnosis.isRepaired) return 'Nothing had to be repaired; there are remarks.';
  const count = diagnosis.findings
    .filter(({ fate }) => fate !== 'noted')
    .reduce((sum, finding) => sum + finding.count, 0);
  const problems = count === 1 ? 'One problem was' : `${grouped(count)} problems were`;
  return `${problems} repaired. The file itself is unchanged.`;
}

function group(
  explorer: Explorer,
  finding: Finding,
  placed: Diagnosis['placed'] | undefined,
  focus: () => void,
): HTMLElement {
  const { code, title, deed, fate, problems, unlisted } = finding;
  const list = longList('entries', title);
  list.show(
    problems.map((problem) => () => {
      if (placed?.has(problem)) return entry(explorer, problem, focus);
      return h('li', {}, h('span', { 'data-code': problem.code }, problem.message));
    }),
    SHOWN,
  );
  return h(
    'section',
    { class: 'finding', 'data-finding': code, 'aria-label': title },
    h('h3', {}, h('i', { class: `swatch ${fate}`, 'aria-hidden': 'true' }), title),
    h('p', { class: 'deed' }, deed),
    list.element,
    unlisted > 0 &&
      h('p', { class: 'deed' }, `… and ${grouped(unlisted)} more that are not listed one by one.`),
  );
}

function entry(explorer: Explorer, problem: Problem, focus: () => void): HTMLElement {
  const { message, code } = problem;
  const button: LitButton = h(
    'button',
    {
      type: 'button',
      'data-code': code,
      'aria-pressed': String(explorer.problem.value === problem),
      title: 'Go there',
      onclick: () => {
        // A second time: back to the place, if the camera has left it.
        if (explorer.problem.value === problem) focus();
        else explorer.showProblem(problem);
      },
    },
    message,
  );
  button.problem = problem;
  return h('li', {}, button);
}
