import { css, unsafeCSS } from 'lit';
import { LABEL_STYLES } from '../scene/label-styles.js';
import { PALETTE_PROPERTIES } from '../scene/palette.js';
import { SLIDER_STYLES } from '../scene/slider-styles.js';
import { basicStyles } from './basic-styles.js';

const parts = css`
  /* A page may give the figure a height, or a largest one: the stage takes what the other parts leave. */
  :host {
    display: flex;
    flex-direction: column;
  }

  figure {
    display: flex;
    flex: 1 1 auto;
    flex-direction: column;
    min-height: 0;
    container-type: inline-size;
    /* Where the page asks how wide it would be, as in a dialog: as wide as other pictures without a width. */
    contain-intrinsic-inline-size: 300px;
    margin: 0;
    overflow: hidden;
    border: 1px solid var(--line);
    border-radius: var(--halfedge-radius, 12px);
    background: var(--page);
  }

  /* Names, code and buttons run from left to right, on every page; the caption is the page's. */
  .stage,
  .bar,
  .code {
    direction: ltr;
  }

  figure > * {
    flex: none;
  }

  figure > .stage {
    position: relative;
    flex: 1 1 auto;
    min-height: 0;
    aspect-ratio: var(--halfedge-aspect, 16 / 10);
    overflow: hidden;
    background: radial-gradient(ellipse at 50% 45%, var(--page) 35%, var(--page-far));
  }

  canvas {
    position: absolute;
    inset: 0;
    width: 100%;
    height: 100%;
    cursor: grab;
    outline: none;
    touch-action: pan-y pinch-zoom;
    -webkit-tap-highlight-color: transparent;
    /* Its beginning tells that the page has set other colours, which are drawn then. */
    transition: 1ms step-end allow-discrete;
    transition-property: ${unsafeCSS(Object.values(PALETTE_PROPERTIES).join(', '))};
  }

  canvas:active {
    cursor: grabbing;
  }

  canvas:focus-visible {
    box-shadow: inset 0 0 0 2px var(--focus);
  }

  .poster {
    position: absolute;
    inset: 0;
    display: grid;
    place-items: center;
    overflow: hidden;
    color: var(--muted);
    pointer-events: none;
  }

  .poster ::slotted(*) {
    pointer-events: auto;
  }

  .poster ::slotted(*),
  .poster svg {
    width: 100%;
    height: 100%;
    object-fit: contain;
  }

  .poster.waiting {
    animation: appear 0.2s 0.4s both;
  }

  @keyframes appear {
    from {
      opacity: 0;
    }
  }

  .error {
    position: absolute;
    right: 10px;
    bottom: 10px;
    left: 10px;
    display: grid;
    grid-template-columns: auto 1fr auto;
    gap: 8px;
    align-items: start;
    margin: 0;
    padding: 9px 12px;
    border: 1px solid color-mix(in srgb, var(--danger) 35%, var(--line));
    border-radius: 9px;
    background: var(--raised);
    font-size: 13px;
    overflow-wrap: anywhere;
  }

  .error button {
    width: auto;
    height: auto;
    padding: 3px 10px;
  }

  .error .icon,
  .sentence .icon {
    width: 17px;
    height: 17px;
    margin-top: 1px;
    color: var(--danger);
  }

  .bar {
    display: flex;
    align-items: center;
    gap: 10px;
    padding: 8px 10px;
    border-top: 1px solid var(--line);
  }

  .buttons {
    display: flex;
    gap: 4px;
  }

  button.play {
    width: 44px;
    border-color: var(--accent);
    background: var(--accent);
    color: var(--page);
  }

  button.play:disabled {
    border-color: var(--line);
    background: var(--well);
    color: var(--muted);
  }

  button.wide {
    display: flex;
    align-items: center;
    width: auto;
    gap: 5px;
    padding: 0 10px 0 8px;
    font-size: 13px;
    font-weight: 550;
  }

  .home {
    position: absolute;
    top: 8px;
    right: 8px;
    width: 30px;
    height: 30px;
    background: color-mix(in srgb, var(--raised) 85%, transparent);
    color: var(--muted);
    opacity: 0;
    transition: opacity var(--quick);
  }

  .stage:hover .home,
  .home:focus-visible {
    opacity: 1;
  }

  @media (hover: none) {
    .home {
      opacity: 1;
    }
  }

  ${unsafeCSS(SLIDER_STYLES)}

  input[type="range"] {
    flex: 1;
    min-width: 40px;
    height: 24px;
  }

  output {
    color: var(--muted);
    font-size: 12.5px;
    font-variant-numeric: tabular-nums;
    white-space: nowrap;
  }

  .sentence {
    display: flex;
    gap: 8px;
    min-height: 2.9em;
    margin: 0;
    padding: 8px 12px 9px;
    border-top: 1px solid var(--line);
    font-size: 13px;
    overflow-wrap: anywhere;
  }

  figure > .code {
    display: flex;
    flex: 0 1 auto;
    flex-direction: column;
    min-height: 95px; /* the header and three lines */
    border-top: 1px solid var(--line);
    background: var(--well);
  }

  .code header {
    display: flex;
    align-items: center;
    gap: 8px;
    padding: 5px 6px 5px 12px;
    border-bottom: 1px solid var(--line);
    font: 450 12px / 1.5 var(--mono);
  }

  .code header code {
    flex: 1;
    min-width: 0;
    overflow: hidden;
    font: inherit;
    text-overflow: ellipsis;
    white-space: nowrap;
  }

  .code select {
    height: 26px;
    padding: 0 4px;
    border: 1px solid var(--line);
    border-radius: 7px;
    background: var(--raised);
    font: 450 12px / 1 var(--sans);
  }

  .code .lines {
    min-height: 0;
    overflow: auto;
  }

  .code ol {
    width: max-content;
    min-width: 100%;
    margin: 0;
    padding: 5px 0;
    font: 450 12px / 18px var(--mono);
    font-variant-ligatures: none;
    list-style: none;
  }

  .code li {
    padding: 0 12px 0 9px;
    border-left: 3px solid transparent;
    white-space: pre;
  }

  .code .ran {
    border-left-color: color-mix(in srgb, var(--next-text) 45%, transparent);
  }

  .code [aria-current] {
    border-left-color: var(--next-text);
    background: color-mix(in srgb, var(--next) 11%, transparent);
  }

  figcaption {
    padding: 8px 12px 10px;
    border-top: 1px solid var(--line);
    color: var(--muted);
    font-size: 13px;
  }

  figcaption.empty {
    display: none;
  }

  @container (max-width: 360px) {
    .restart,
    .direction span {
      display: none;
    }
  }

  ${unsafeCSS(LABEL_STYLES)}
`;

/** On paper the stage may be wider or narrower than it was drawn: labels are scaled with the picture. */
const printed = css`
  @media print {
    figure {
      break-inside: avoid;
    }

    .labels {
      inset: 0 auto auto 0;
      width: var(--drawn-width, 100%);
      height: var(--drawn-height, 100%);
      transform-origin: 0 0;
      /* The quotient of two lengths. */
      scale: tan(atan2(100cqw, var(--drawn-width)));
    }
  }
`;

/** Where the system chooses the colours (high contrast): it drops backgrounds and shadows, which tell states here. */
const forced = css`
  @media (forced-colors: active) {
    /* They go by the colours of the picture, which stay. */
    .labels {
      forced-color-adjust: none;
    }

    input[type="range"] {
      --accent: Highlight;
      --line: GrayText;
      --raised: Canvas;

      forced-color-adjust: none;
    }

    .code li {
      border-left-color: Canvas;
    }

    .code .ran {
      border-left-color: Highlight;
    }

    .code [aria-current] {
      background: Highlight;
      color: HighlightText;
      forced-color-adjust: none;
    }

    canvas:focus-visible {
      outline: 2px solid CanvasText;
      outline-offset: -2px;
    }

    button:disabled {
      border-color: GrayText;
      color: GrayText;
    }
  }
`;

/** The looks of a figure. A page can set each colour as `--halfedge-…`, and style the parts. */
export const figureStyles = [basicStyles, parts, printed, forced];
