import { html, nothing, type TemplateResult } from 'lit';
import { icon } from '../figure/template.js';
import type { ExerciseState } from './element.js';
import type { ExerciseTask } from './judge/task.js';
import { tasks } from './judge/tasks.js';
import type { Failure, MeshResult, Verdict } from './judge/verdict.js';
import type { Picture } from './picture.js';

/** What the parts of an exercise show, and what they do. */
export interface Actions {
  readonly state: ExerciseState;
  readonly result: Verdict | null;
  readonly shown: Failure | null;
  readonly failure: string | null;
  readonly seed: number;
  readonly solution: boolean;
  readonly theme: string | null;
  runByHand(): void;
  reset(): void;
  reveal(): void;
  renumber(): void;
  show(failure: Failure | null): void;
  goTo(line: number, column?: number): void;
}

/** The whole exercise; only a sentence where there is none. */
export function page(
  task: ExerciseTask | null,
  actions: Actions,
  picture: Picture | null,
): TemplateResult {
  const { failure } = actions;
  const sentence = failure
    ? html`<p class="error" part="error" role="alert">${failure}</p>`
    : nothing;
  if (!task) return html`<section part="exercise" lang="en">${sentence}</section>`;
  return html`
    <section part="exercise" aria-labelledby="title" lang=${tasks.includes(task) ? 'en' : nothing}>
      <header part="header">
        <div class="title" id="title" part="title" role="heading" aria-level="3" dir="auto">${task.title}</div>
        ${badge(actions.state)}
      </header>
      <div class="statement" part="statement"><slot name="statement" dir="auto"><p dir="auto">${withCode(task.statement)}</p></slot></div>
      <div class="work">
        <div class="writing">
          <div class="editor" part="editor"></div>
          ${bar(task, actions)}
        </div>
        <div class="outcome">
          ${sentence}
          <div class="verdict-place" role="status">${verdict(actions)}</div>
          ${actions.result ? meshes(actions.result, actions) : nothing}
        </div>
        ${figure(picture, actions.theme)}
      </div>
    </section>
  `;
}

/** A text in which words between backticks are code. */
function withCode(text: string): (string | TemplateResult)[] {
  return text.split('`').map((part, i) => (i % 2 === 1 ? html`<code>${part}</code>` : part));
}

const BADGES: Readonly<Record<ExerciseState, string>> = {
  ready: '',
  running: 'Running …',
  passed: 'Solved',
  failed: 'Not yet',
};

function badge(state: ExerciseState): TemplateResult | typeof nothing {
  if (state === 'ready') return nothing;
  return html`<span class=${`badge ${state}`} part="badge">${state === 'passed' ? icon('check') : nothing}${BADGES[state]}</span>`;
}

function bar(task: ExerciseTask, actions: Actions): TemplateResult {
  const running = actions.state === 'running';
  const uses = task.gets === 'mesh' ? task.uses.map((name) => `mesh.${name}`) : [];
  return html`
    <div class="bar" part="bar">
      <button type="button" class="run" part="button run" title="Run (Ctrl Enter)" ?disabled=${running} @click=${actions.runByHand}>
        ${icon('play')}Run
      </button>
      <button type="button" part="button reset" title="Put the first code back" @click=${actions.reset}>
        ${icon('restart')}Reset
      </button>
      ${
        actions.solution
          ? html`<button type="button" part="button solution" @click=${actions.reveal}>Show a solution</button>`
          : nothing
      }
      <span class="help" id="editor-help">Ctrl Enter runs. Escape, then Tab leaves the editor.</span>
    </div>
    ${
      uses.length > 0
        ? html`<p class="uses" part="uses">To be used: ${uses.map((name) => html`<code>${name}</code> `)}</p>`
        : nothing
    }
  `;
}

/** Its mesh and its trail are handed to it when they change: see the element. */
function figure(picture: Picture | null, theme: string | null): TemplateResult {
  if (!picture) return html`<div class="no-figure"></div>`;
  return html`
    <halfedge-figure
      part="figure"
      exportparts="stage, canvas, sentence, caption: figure-caption"
      overlays=${picture.overlays}
      controls=${picture.trail.steps.length > 0 ? '' : nothing}
      theme=${theme ?? nothing}
    >
      <span slot="caption">${picture.caption}</span>
    </halfedge-figure>
  `;
}

/** What is to be said of the last run, in one place. */
function verdict(actions: Actions): TemplateResult | typeof nothing {
  const { result, shown, state } = actions;
  if (!result) return nothing;
  const stale = state === 'running' || (state === 'ready' && result.passed) ? ' stale' : '';
  if (result.passed) {
    const count = new Set(result.meshes.map(({ mesh }) => mesh)).size;
    return html`
      <div class=${`verdict passed${stale}`} part="verdict passed">
        ${icon('check')}
        <div>
          <p class="headline" part="headline">Right.</p>
          <p>It holds on ${count === 1 ? 'the mesh' : `all ${count} meshes`}, also with shuffled numbers and other anchors.</p>
        </div>
      </div>
    `;
  }
  return shown ? told(shown, stale, actions) : nothing;
}

function told(failure: Failure, stale: string, actions: Actions): TemplateResult {
  const { title, hint, call, got, expected, line, column } = failure;
  const known = [
    ...(call ? [['Asked', call]] : []),
    ...(got ? [['Got', got]] : []),
    ...(expected ? [['Expected', expected]] : []),
  ];
  return html`
    <div class=${`verdict failed${stale}`} part="verdict failed">
      ${icon('warning')}
      <div>
        <p class="headline" part="headline" dir="auto">${title}</p>
        ${
          known.length > 0
            ? html`<dl part="facts">${known.map(([name, value]) => html`<dt>${name}</dt><dd><code>${value}</code></dd>`)}</dl>`
            : nothing
        }
        ${hint ? html`<p class="hint" part="hint" dir="auto">${withCode(hint)}</p>` : nothing}
        ${
          line === null
            ? nothing
            : html`<button type="button" part="button line" @click=${() => actions.goTo(line, column)}>Go to line ${line}</button>`
        }
      </div>
    </div>
  `;
}

/** One button for each mesh, and where the numbers come from. */
function meshes({ meshes, seed }: Verdict, actions: Actions): TemplateResult | typeof nothing {
  if (meshes.length === 0) return nothing;
  const byMesh = new Map<string, MeshResult[]>();
  for (const result of meshes) {
    byMesh.set(result.mesh, [...(byMesh.get(result.mesh) ?? []), result]);
  }
  return html`
    <div class="meshes" part="meshes">
      <ul aria-label="The meshes">
        ${[...byMesh.values()].map((results) => html`<li>${chip(results, actions)}</li>`)}
      </ul>
      <p class="seed" part="seed">
        Shuffled with seed ${seed}
        <button type="button" part="button renumber" @click=${actions.renumber}>Other numbers</button>
      </p>
    </div>
  `;
}

function chip(results: readonly MeshResult[], actions: Actions): TemplateResult {
  const failed = results.find(({ passed }) => !passed);
  const words = results[0].words.replace(/^the /, '');
  const name = failed?.numbering === 'shuffled' ? `${words}, shuffled` : words;
  if (!failed?.failure) {
    return html`<span class="chip passed" part="mesh passed">${icon('check')}${name}<span class="hidden">: right</span></span>`;
  }
  const { failure } = failed;
  return html`<button
    type="button"
    class="chip failed"
    part="mesh failed"
    aria-pressed=${actions.shown?.trial === failure.trial}
    aria-label=${`${name}: wrong; show what`}
    @click=${() => actions.show(failure)}
  >${icon('close')}${name}</button>`;
}
