/** A line that is filled up to the thumb: `--filled` says how far. */
const TRACK =
  'linear-gradient(var(--accent), var(--accent)) 0 / var(--filled, 0%) 100% no-repeat var(--line)';

/**
 * The style sheet of sliders; the colours are custom properties, see `declarations`. Fingers have 24 pixels, of which
 * the parts around leave 20.
 */
export const SLIDER_STYLES = `
input[type="range"] {
  width: 100%;
  min-width: 0;
  height: 24px;
  margin: -2px 0;
  background: none;
  appearance: none;
  cursor: pointer;
}

input[type="range"]::-webkit-slider-runnable-track {
  height: 4px;
  border-radius: 2px;
  background: ${TRACK};
}

input[type="range"]::-moz-range-track {
  height: 4px;
  border-radius: 2px;
  background: ${TRACK};
}

input[type="range"]::-webkit-slider-thumb {
  width: 14px;
  height: 14px;
  margin-top: -5px;
  border: 2px solid var(--accent);
  border-radius: 50%;
  background: var(--raised);
  appearance: none;
}

input[type="range"]::-moz-range-thumb {
  width: 10px;
  height: 10px;
  border: 2px solid var(--accent);
  border-radius: 50%;
  background: var(--raised);
}
`;
