import { css, unsafeCSS } from 'lit';
import { DARK, declarations, LIGHT, MORE_CONTRAST } from '../scene/colors.js';

const light = unsafeCSS(declarations(LIGHT, 'halfedge'));
const dark = unsafeCSS(declarations(DARK, 'halfedge'));

/** What the elements have in common: colours, which a page can set as `--halfedge-…`, and plain controls. */
export const basicStyles = css`
  :host {
    ${light}
    color-scheme: light;
    --sans: var(--halfedge-sans, system-ui, sans-serif);
    --mono: var(--halfedge-mono, ui-monospace, "SF Mono", "Cascadia Mono", Menlo, monospace);
    --quick: 0.12s;
    display: block;
    min-width: 0; /* as an item of a flexible box or a grid */
    color: var(--text);
    font: 400 14px / 1.45 var(--sans);
    text-align: start;
  }

  @media (prefers-color-scheme: dark) {
    :host(:not([theme="light"])) {
      ${dark}
      color-scheme: dark;
    }
  }

  :host([theme="dark"]) {
    ${dark}
    color-scheme: dark;
  }

  @media (prefers-contrast: more) {
    :host {
      ${unsafeCSS(MORE_CONTRAST)}
    }
  }

  :host([hidden]) {
    display: none;
  }

  @media (prefers-reduced-motion: reduce) {
    :host {
      --quick: 0s;
    }
  }

  *,
  ::before,
  ::after {
    box-sizing: border-box;
  }

  .icon {
    flex: none;
    width: 18px;
    height: 18px;
    fill: none;
    stroke: currentcolor;
    stroke-width: 2;
    stroke-linecap: round;
    stroke-linejoin: round;
  }

  .icon.filled {
    fill: currentcolor;
  }

  button,
  select {
    color: inherit;
    font: inherit;
  }

  button {
    display: grid;
    place-items: center;
    width: 34px;
    height: 34px;
    padding: 0;
    border: 1px solid var(--line);
    border-radius: 9px;
    background: var(--raised);
    cursor: pointer;
    transition: border-color var(--quick), background var(--quick);
  }

  button:hover:not(:disabled) {
    border-color: var(--line-strong);
  }

  button:disabled {
    color: color-mix(in srgb, var(--muted) 55%, transparent);
    cursor: default;
  }

  :focus-visible {
    outline: 2px solid var(--focus);
    outline-offset: 1px;
  }

  .hidden {
    position: absolute;
    width: 1px;
    height: 1px;
    margin: -1px;
    padding: 0;
    overflow: hidden;
    border: 0;
    clip-path: inset(50%);
    white-space: nowrap;
  }
`;
