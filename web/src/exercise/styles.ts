import { css } from 'lit';
import { basicStyles } from '../figure/basic-styles.js';

const parts = css`
  :host {
    --code-keyword: #7a3e9d;
    --code-string: #8a4b08;
    --code-number: #0b5fc0;
    --code-function: #046a53;
    --good: var(--next-text);
  }

  @media (prefers-color-scheme: dark) {
    :host(:not([theme="light"])) {
      --code-keyword: #d3a6f0;
      --code-string: #f0b878;
      --code-number: #a3bbfc;
      --code-function: #58fecb;
    }
  }

  :host([theme="dark"]) {
    --code-keyword: #d3a6f0;
    --code-string: #f0b878;
    --code-number: #a3bbfc;
    --code-function: #58fecb;
  }

  /* Code and buttons run from left to right, on every page; texts as their words do. */
  section {
    direction: ltr;
    container-type: inline-size;
    contain-intrinsic-inline-size: 300px;
    overflow: hidden;
    border: 1px solid var(--line);
    border-radius: var(--halfedge-radius, 12px);
    background: var(--page);
  }

  p {
    margin: 0;
  }

  header {
    display: flex;
    align-items: baseline;
    gap: 10px;
    padding: 14px 16px 0;
  }

  .title {
    flex: 1;
    font-size: 16.5px;
    font-weight: 650;
    letter-spacing: -0.01em;
  }

  .badge {
    display: inline-flex;
    align-items: center;
    gap: 4px;
    padding: 1px 9px;
    border: 1px solid var(--line);
    border-radius: 99px;
    color: var(--muted);
    font-size: 12.5px;
    font-weight: 550;
    white-space: nowrap;
  }

  .badge .icon {
    width: 14px;
    height: 14px;
  }

  .badge.passed {
    border-color: color-mix(in srgb, var(--good) 40%, var(--line));
    color: var(--good);
  }

  .badge.failed {
    border-color: color-mix(in srgb, var(--danger) 35%, var(--line));
    color: var(--danger);
  }

  .statement {
    max-width: 72ch;
    padding: 4px 16px 13px;
    color: var(--muted);
    font-size: 14.5px;
  }

  code,
  .statement ::slotted(code) {
    padding: 0.1em 0.3em;
    border-radius: 4px;
    background: color-mix(in srgb, var(--text) 8%, transparent);
    color: var(--text);
    font: 450 0.9em var(--mono);
    overflow-wrap: anywhere;
  }

  .work {
    display: grid;
    border-top: 1px solid var(--line);
  }

  .writing {
    display: flex;
    flex-direction: column;
    min-width: 0;
    background: var(--well);
  }

  .editor {
    flex: 1;
    min-height: var(--halfedge-editor-height, 250px);
  }

  .bar {
    display: flex;
    flex-wrap: wrap;
    align-items: center;
    gap: 6px;
    padding: 8px 10px;
    border-top: 1px solid var(--line);
    background: var(--page);
  }

  .bar button,
  .verdict button,
  .meshes button {
    display: inline-flex;
    align-items: center;
    width: auto;
    gap: 5px;
    padding: 0 11px;
    font-size: 13.5px;
    font-weight: 550;
  }

  .bar .icon {
    width: 16px;
    height: 16px;
    margin-left: -3px;
  }

  .bar .run {
    padding: 0 15px;
    border-color: var(--accent);
    background: var(--accent);
    color: var(--page);
  }

  .bar .run:disabled {
    opacity: 0.6;
    color: var(--page);
  }

  .help {
    flex: 1 1 150px;
    color: var(--muted);
    font-size: 12px;
    line-height: 1.3;
    text-align: end;
  }

  .uses {
    padding: 0 12px 9px;
    background: var(--page);
    color: var(--muted);
    font-size: 12px;
    line-height: 1.75;
  }

  .uses code {
    white-space: nowrap;
  }

  halfedge-figure {
    --halfedge-radius: 0;
    --halfedge-aspect: 16 / 11;
    min-width: 0;
    border-top: 1px solid var(--line);
  }

  halfedge-figure::part(figure) {
    border: 0;
  }

  .no-figure {
    min-height: 330px;
    border-top: 1px solid var(--line);
  }

  .error {
    padding: 10px 16px;
    border-top: 1px solid var(--line);
    color: var(--danger);
  }

  .verdict {
    display: grid;
    grid-template-columns: auto 1fr;
    gap: 10px;
    padding: 13px 16px;
    border-top: 1px solid var(--line);
    font-size: 14px;
  }

  .verdict > .icon {
    width: 20px;
    height: 20px;
    margin-top: 1px;
  }

  .verdict.failed {
    background: var(--danger-soft);
  }

  .verdict.failed > .icon,
  .chip.failed .icon {
    color: var(--danger);
  }

  .verdict.passed > .icon,
  .chip.passed .icon {
    color: var(--good);
  }

  .verdict > * {
    transition: opacity var(--quick);
  }

  .stale > * {
    opacity: 0.5;
  }

  .headline {
    font-size: 15px;
    font-weight: 600;
    overflow-wrap: anywhere;
  }

  dl {
    display: grid;
    grid-template-columns: auto 1fr;
    gap: 3px 12px;
    margin: 7px 0 2px;
  }

  dt {
    color: var(--muted);
  }

  dd {
    margin: 0;
    min-width: 0;
  }

  .verdict code {
    background: color-mix(in srgb, var(--page) 70%, transparent);
  }

  .hint {
    max-width: 72ch;
    margin-top: 5px;
  }

  .verdict button {
    height: 28px;
    margin-top: 8px;
    font-size: 13px;
  }

  .meshes {
    display: flex;
    flex-wrap: wrap;
    align-items: center;
    justify-content: space-between;
    gap: 8px 16px;
    padding: 9px 12px;
    border-top: 1px solid var(--line);
  }

  .meshes ul {
    display: flex;
    flex-wrap: wrap;
    gap: 6px;
    margin: 0;
    padding: 0;
    list-style: none;
  }

  .meshes .chip {
    display: inline-flex;
    align-items: center;
    height: 26px;
    gap: 4px;
    padding: 0 9px 0 6px;
    border: 1px solid var(--line);
    border-radius: 99px;
    font-size: 12.5px;
    font-weight: 500;
  }

  .chip .icon {
    width: 14px;
    height: 14px;
    stroke-width: 2.4;
  }

  .chip.failed {
    border-color: color-mix(in srgb, var(--danger) 35%, var(--line));
  }

  .chip[aria-pressed="true"] {
    border-color: var(--danger);
    background: var(--danger-soft);
  }

  .seed {
    display: flex;
    align-items: center;
    gap: 8px;
    color: var(--muted);
    font-size: 12.5px;
  }

  .meshes .seed button {
    height: 26px;
    padding: 0 9px;
    color: var(--text);
    font-size: 12.5px;
  }

  @container (min-width: 720px) {
    .work {
      grid-template-columns: minmax(0, 1.15fr) minmax(0, 1fr);
    }

    halfedge-figure,
    .no-figure {
      grid-area: 1 / 2;
      border-top: 0;
      border-left: 1px solid var(--line);
    }

    .outcome {
      grid-column: 1 / -1;
      grid-row: 2;
    }
  }

  @container (max-width: 480px) {
    .help {
      flex-basis: 100%;
      text-align: start;
    }
  }

  @media (forced-colors: active) {
    .chip[aria-pressed="true"] {
      border-color: Highlight;
      background: Highlight;
      color: HighlightText;
      forced-color-adjust: none;
    }

    .chip[aria-pressed="true"] .icon {
      color: inherit;
    }
  }

  /* Keys are of no use to fingers. */
  @media (hover: none) {
    .help {
      display: none;
    }
  }
`;

/** The looks of an exercise. A page can set each colour as `--halfedge-…`, and style the parts. */
export const exerciseStyles = [basicStyles, parts];
