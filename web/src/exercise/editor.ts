import { defaultKeymap, history, historyKeymap, indentWithTab } from '@codemirror/commands';
import { javascript } from '@codemirror/lang-javascript';
import {
  bracketMatching,
  HighlightStyle,
  indentOnInput,
  syntaxHighlighting,
} from '@codemirror/language';
import { EditorState, StateEffect, StateField } from '@codemirror/state';
import {
  Decoration,
  type DecorationSet,
  EditorView,
  highlightActiveLine,
  keymap,
  lineNumbers,
} from '@codemirror/view';
import { tags } from '@lezer/highlight';

/** What an editor tells, and what it is called for who can't see it. */
export interface EditorOptions {
  readonly label: string;
  /** The id of what describes it. */
  readonly describedBy: string;
  readonly code: string;
  changed(code: string): void;
  run(): void;
}

/** A field for code, made by CodeMirror. Escape, then Tab leaves it: Tab alone indents. */
export class CodeEditor {
  readonly #view: EditorView;
  #told = true;

  constructor(parent: HTMLElement, root: ShadowRoot, options: EditorOptions) {
    const run = () => {
      options.run();
      return true;
    };
    const state = EditorState.create({
      doc: options.code,
      extensions: [
        lineNumbers(),
        history(),
        indentOnInput(),
        bracketMatching(),
        highlightActiveLine(),
        EditorView.lineWrapping,
        faultyLine,
        javascript(),
        syntaxHighlighting(colors),
        theme,
        EditorState.tabSize.of(2),
        EditorView.contentAttributes.of({
          'aria-label': options.label,
          'aria-describedby': options.describedBy,
          autocapitalize: 'off',
          autocorrect: 'off',
          spellcheck: 'false',
          tabindex: '0',
        }),
        keymap.of([
          { key: 'Mod-Enter', run },
          { key: 'Ctrl-Enter', run }, // which a Mac doesn't call Mod, and the page does
          { key: 'Shift-Enter', run },
          ...historyKeymap,
          indentWithTab,
          ...defaultKeymap,
        ]),
        EditorView.updateListener.of(({ docChanged }) => {
          if (!docChanged) return;
          if (this.#told) options.changed(this.code);
        }),
      ],
    });
    this.#view = new EditorView({ state, parent, root });
  }

  get code(): string {
    return this.#view.state.doc.toString();
  }

  /** Sets the code, without telling. Where it is there already, the cursor and what can be undone stay. */
  set code(code: string) {
    // The editor keeps lines, not what ends them.
    if (code.replace(/\r\n?/g, '\n') === this.code) return;
    this.#told = false;
    this.#view.dispatch({ changes: { from: 0, to: this.#view.state.doc.length, insert: code } });
    this.#told = true;
  }

  /** Marks a line as the one where something is wrong; null for none. */
  mark(line: number | null): void {
    const { doc } = this.#view.state;
    const at = line !== null && line >= 1 && line <= doc.lines ? doc.line(line).from : null;
    this.#view.dispatch({ effects: markAt.of(at) });
  }

  /** Puts the cursor into a line, and the focus into the editor. */
  goTo(line: number, column = 1): void {
    const { doc } = this.#view.state;
    const { from, to } = doc.line(Math.max(1, Math.min(doc.lines, line)));
    const anchor = Math.min(to, from + column - 1);
    this.#view.dispatch({ selection: { anchor }, scrollIntoView: true });
    this.#view.focus();
  }

  dispose(): void {
    this.#view.destroy();
  }
}

const markAt = StateEffect.define<number | null>();

/** The line that is marked; the first change of the text unmarks it. */
const faultyLine = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(marks, transaction) {
    for (const effect of transaction.effects) {
      if (!effect.is(markAt)) continue;
      return effect.value === null
        ? Decoration.none
        : Decoration.set(Decoration.line({ class: 'faulty' }).range(effect.value));
    }
    return transaction.docChanged ? Decoration.none : marks;
  },
  provide: (field) => EditorView.decorations.from(field),
});

const colors = HighlightStyle.define([
  { tag: tags.keyword, color: 'var(--code-keyword)' },
  { tag: [tags.comment, tags.meta], color: 'var(--muted)', fontStyle: 'italic' },
  { tag: [tags.string, tags.regexp], color: 'var(--code-string)' },
  { tag: [tags.number, tags.bool, tags.null], color: 'var(--code-number)' },
  {
    tag: [tags.function(tags.variableName), tags.function(tags.propertyName)],
    color: 'var(--code-function)',
  },
  { tag: tags.invalid, color: 'var(--danger)' },
]);

/** Colours are custom properties, so that the editor follows the theme of the element. */
const theme = EditorView.theme({
  '&': { backgroundColor: 'var(--well)', color: 'var(--text)', height: '100%' },
  '&.cm-focused': { outline: '2px solid var(--focus)', outlineOffset: '-2px' },
  '.cm-scroller': { font: '450 13px/1.55 var(--mono)', fontVariantLigatures: 'none' },
  '.cm-content': { padding: '10px 0', caretColor: 'var(--text)' },
  // What goes on in the next row is indented there.
  '.cm-line': { padding: '0 12px 0 calc(6px + 4ch)', textIndent: '-4ch' },
  '.cm-gutters': { border: 'none', backgroundColor: 'transparent', color: 'var(--muted)' },
  '.cm-lineNumbers .cm-gutterElement': { minWidth: '30px', padding: '0 6px 0 8px' },
  '.cm-activeLine': { backgroundColor: 'transparent' },
  '&.cm-focused .cm-activeLine': {
    backgroundColor: 'color-mix(in srgb, var(--accent) 7%, transparent)',
  },
  '.faulty, &.cm-focused .faulty': {
    backgroundColor: 'var(--danger-soft)',
    boxShadow: 'inset 3px 0 var(--danger)',
  },
  '@media (forced-colors: active)': {
    '.faulty': { outline: '2px solid Highlight', outlineOffset: '-2px' },
  },
  '&.cm-focused .cm-matchingBracket': {
    backgroundColor: 'color-mix(in srgb, var(--accent) 22%, transparent)',
  },
});
