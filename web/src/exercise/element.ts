import { LitElement, type PropertyValues, type TemplateResult } from 'lit';
import { FLAG } from '../figure/flag.js';
import { keepUsedKey } from '../figure/keys.js';
import { started } from '../figure/start.js';
import { prefersReducedMotion } from '../scene/reduced-motion.js';
import { CodeEditor } from './editor.js';
import { tell } from './events.js';
import { checkTask } from './judge/check-task.js';
import type { Trial } from './judge/deal.js';
import { messageOf } from './judge/program.js';
import type { ExerciseTask } from './judge/task.js';
import { taskNamed } from './judge/tasks.js';
import type { Failure, Verdict } from './judge/verdict.js';
import { Memory } from './memory.js';
import { exampleOf, type Picture, pictureOf } from './picture.js';
import { runProgram, type Workers } from './runner.js';
import { exerciseStyles } from './styles.js';
import { page } from './template.js';

/** What an exercise is doing, as its attribute `state` tells. */
export type ExerciseState = 'ready' | 'running' | 'passed' | 'failed';

const LIMIT = 3000;

/** Makes a worker that runs the script of exercises; each entry of the package has its own way. */
let workers: Workers | null = null;

/** To be called by the entry, before any exercise runs. The first call counts. */
export function runWith(those: Workers): void {
  workers ??= those;
}

/** Why a run ended that nobody waits for any more: nothing to be told. */
class Cancelled extends Error {}

/**
 * An exercise: readers write a function, which runs in a worker on several meshes, and are told what is wrong.
 *
 * ```html
 * <halfedge-exercise task="vertex-vertices"></halfedge-exercise>
 * ```
 */
export class HalfedgeExercise extends LitElement {
  static override readonly styles = exerciseStyles;
  static override readonly properties = {
    task: { reflect: true },
    definition: { attribute: false },
    seed: { type: Number, reflect: true },
    limit: { type: Number },
    save: { reflect: true },
    solution: FLAG,
    theme: { reflect: true },
    state: { reflect: true },
    result: { state: true },
    shown: { state: true },
    failure: { state: true },
  };

  /** An exercise of the package, by its name. */
  declare task: string | null;
  /** An exercise of your own, instead of `task`. */
  declare definition: ExerciseTask | null;
  /** What numbers the shuffled meshes have. Left out, others each time the page is opened. */
  declare seed: number;
  /** After so many milliseconds without a sign of life a program is ended. */
  declare limit: number;
  /** Keeps the code in this browser, under this name; under that of the task where it is empty. */
  declare save: string | null;
  /** Whether there is a button that shows a solution. */
  declare solution: boolean;
  /** `light`, `dark` or `auto`. */
  declare theme: string | null;
  /** What it is doing; to be read only. */
  declare state: ExerciseState;
  /** What the last run has shown; null before the first. To be read only. */
  declare result: Verdict | null;
  /** The failure that is told, of those of the result. @internal */
  declare shown: Failure | null;
  /** Why there is no exercise. @internal */
  declare failure: string | null;

  #editor: CodeEditor | null = null;
  #code: string | null = null;
  /** Whether the code was set before there was a task to begin with. */
  #isGiven = false;
  #trials: readonly Trial[] = [];
  #picture: Picture | null = null;
  #running: AbortController | null = null;
  /** The task of the last run. */
  #ran: ExerciseTask | null = null;
  /** What the exercise was made of: a definition, or the name of a task. */
  #asked: ExerciseTask | string | null | undefined;
  /** The picture that the figure has been given. */
  #given: Picture | null = null;

  constructor() {
    super();
    this.task = this.save = this.theme = null;
    this.definition = null;
    this.seed = 1 + Math.floor(Math.random() * 9999);
    this.limit = LIMIT;
    this.solution = false;
    this.state = 'ready';
    this.result = this.shown = this.failure = null;
    this.addEventListener('keydown', keepUsedKey);
    this.#takeEarlyCode();
  }

  /** The code in the editor. */
  get code(): string {
    return this.#code ?? '';
  }

  set code(code: string) {
    this.#code = code;
    this.#isGiven = this.#asked === undefined;
    if (this.#editor) this.#editor.code = code;
    this.#changed(code);
  }

  /** The exercise, or null where `task` names none. */
  get exercise(): ExerciseTask | null {
    try {
      return this.#needed();
    } catch {
      return null;
    }
  }

  /** Runs the code on all meshes, and resolves to what is to be said of it. */
  async run(): Promise<Verdict> {
    const task = this.#needed();
    this.#running?.abort(new Error('Another run was begun.'));
    const abort = new AbortController();
    this.#running = abort;
    this.#ran = task;
    this.state = 'running';
    this.failure = null;
    try {
      await started();
      const { code, seed, limit } = this;
      const { signal } = abort;
      if (!workers) throw new Error('No entry of the package was imported.');
      signal.throwIfAborted();
      const ran = await runProgram({ task, code, seed, limit, ...workers, signal });
      this.#take(ran.trials);
      this.result = ran.verdict;
      this.state = ran.verdict.passed ? 'passed' : 'failed';
      this.show(ran.verdict.failure);
      await this.updateComplete;
      tell(this, 'halfedge-result', ran.verdict);
      return ran.verdict;
    } catch (error) {
      if (this.#running === abort) this.state = 'ready';
      throw error;
    } finally {
      if (this.#running === abort) this.#running = null;
    }
  }

  /** Puts the code back that was there at first. */
  reset(): void {
    this.#running?.abort(new Cancelled('The exercise was reset.'));
    this.#forget();
    this.code = this.#starter();
    this.#memory.forget();
    void this.#begin();
  }

  /** Shows what was wrong in one of the meshes; null for an example of the task. */
  show(failure: Failure | null): void {
    this.shown = failure;
    const task = this.exercise;
    if (!task) return;
    const trial = failure ? this.#trials[failure.trial] : undefined;
    this.#picture = failure && trial ? pictureOf(task, trial, failure) : exampleOf(task);
    this.#editor?.mark(failure?.line ?? null);
    this.requestUpdate();
  }

  /** Takes other numbers for the shuffled meshes, and runs the code on them. */
  renumber(): void {
    this.seed = 1 + Math.floor(Math.random() * 9999);
    void this.runByHand();
  }

  /** Puts a right answer into the editor. */
  reveal(): void {
    this.code = this.#needed().solution;
    this.#editor?.goTo(1);
  }

  /** Puts the cursor where something is wrong. */
  goTo(line: number, column?: number): void {
    this.#editor?.goTo(line, column);
  }

  /** Runs, where nobody waits for the result, and brings what is said of it into sight. */
  async runByHand(): Promise<void> {
    try {
      await this.run();
      const behavior = prefersReducedMotion() ? 'auto' : 'smooth';
      this.renderRoot.querySelector('.verdict')?.scrollIntoView({ block: 'nearest', behavior });
    } catch (error) {
      if (this.state !== 'running' && !(error instanceof Cancelled))
        this.failure = messageOf(error);
    }
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.requestUpdate(); // the editor is made anew
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#running?.abort(new Cancelled('The exercise was taken out of its page.'));
    this.#closeEditor();
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('seed') && !Number.isFinite(this.seed)) this.seed = 1;
    if (changed.has('limit') && !(this.limit > 0)) this.limit = LIMIT;
    const asked = this.definition ?? this.task;
    if (asked === this.#asked) return;
    this.#asked = asked;
    if (this.#ran !== this.exercise) {
      this.#running?.abort(new Cancelled('The exercise was given another task.'));
    }
    this.failure = null;
    this.#closeEditor();
    this.#forget();
    try {
      this.#needed();
      if (!this.#isGiven) this.#code = this.#memory.code ?? this.#starter();
      this.#isGiven = false;
      void this.#begin();
    } catch (error) {
      this.failure = messageOf(error);
    }
  }

  protected override updated(): void {
    if (!this.isConnected) return;
    this.#showCode();
    this.#showPicture();
  }

  protected override render(): TemplateResult {
    return page(this.exercise, this, this.#picture);
  }

  #showCode(): void {
    const task = this.exercise;
    const parent = this.renderRoot.querySelector<HTMLElement>('.editor');
    if (!task || !parent) return;
    if (this.#editor) {
      this.#editor.code = this.code;
      return;
    }
    this.#editor = new CodeEditor(parent, this.renderRoot as ShadowRoot, {
      label: `Your code: the function ${task.call}`,
      describedBy: 'editor-help',
      code: this.code,
      changed: (code) => {
        this.#code = code;
        this.#changed(code);
      },
      run: () => void this.runByHand(),
    });
  }

  /** Once for each picture: afterwards the reader may step and select in it. */
  #showPicture(): void {
    const picture = this.#picture;
    const figure = this.renderRoot.querySelector('halfedge-figure');
    if (!figure || !picture || picture === this.#given) return;
    this.#given = picture;
    const { bytes, camera, trail, select, step } = picture;
    Object.assign(figure, { bytes, camera, trail, select, step });
  }

  #closeEditor(): void {
    this.#editor?.dispose();
    this.#editor = null;
  }

  /** Shows the mesh of an example, once the core is loaded. */
  async #begin(): Promise<void> {
    try {
      await started();
      if (this.isConnected && !this.result) this.show(null);
    } catch (error) {
      this.failure = messageOf(error);
    }
  }

  /** A page may have set the code before the class was known: it would hide the accessor for good. */
  #takeEarlyCode(): void {
    if (!Object.hasOwn(this, 'code')) return;
    const { code } = this;
    Reflect.deleteProperty(this, 'code');
    this.code = code;
  }

  #needed(): ExerciseTask {
    const { definition, task } = this;
    return definition ? checkTask('definition', definition) : taskNamed(task ?? '');
  }

  get #memory(): Memory {
    return new Memory(this.save === '' ? (this.exercise?.name ?? null) : this.save);
  }

  /** The code that is there at first: that in the element, or that of the task. */
  #starter(): string {
    const own = this.querySelector(':scope > script[type="text/plain"], :scope > template');
    const text = own instanceof HTMLTemplateElement ? own.content.textContent : own?.textContent;
    return text?.trim() ? `${text.trim()}\n` : this.#needed().starter;
  }

  #changed(code: string): void {
    this.#memory.code = code;
    this.#running?.abort(new Cancelled('The code was changed while it ran.'));
    if (this.state === 'passed') this.state = 'ready';
    tell(this, 'halfedge-code', { code });
    this.requestUpdate();
  }

  #forget(): void {
    this.state = 'ready';
    this.result = null;
    this.#take([]);
    this.shown = null;
    this.#picture = this.#given = null;
  }

  #take(trials: readonly Trial[]): void {
    for (const { mesh } of this.#trials) mesh.dispose();
    this.#trials = trials;
  }
}
