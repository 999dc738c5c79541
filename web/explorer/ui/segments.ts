import { h } from './dom.js';

/** One of several choices. */
export interface Segment<Value extends string> {
  readonly value: Value;
  /** What stands on it. */
  readonly content: readonly (string | Node)[];
  readonly title?: string;
  /** How it is read out, where that is not what stands on it. */
  readonly label?: string;
}

/** How a row of choices looks, and what it is called: by a text, or by the element with an id. */
interface Row {
  readonly class?: string;
  readonly 'aria-label'?: string;
  readonly 'aria-labelledby'?: string;
}

/** Choices side by side, of which one is marked: radio buttons that have a `name` in common. */
export function segments<Value extends string>(
  name: string,
  row: Row,
  choices: readonly Segment<Value>[],
  choose: (value: Value) => void,
) {
  const inputs = choices.map(({ value, label }) =>
    h('input', { type: 'radio', name, value, 'aria-label': label, onchange: () => choose(value) }),
  );
  const labels = choices.map(({ content, title }, i) =>
    h('label', { title }, inputs[i], ...content),
  );
  const element = h('div', { class: 'segments', role: 'radiogroup', ...row }, ...labels);
  return {
    element,
    /** Marks the one with that value, whoever has chosen it. */
    mark(value: Value): void {
      for (const input of inputs) input.checked = input.value === value;
    },
    /** Whether nothing can be chosen now. */
    disable(disabled: boolean): void {
      for (const input of inputs) input.disabled = disabled;
    },
  };
}
