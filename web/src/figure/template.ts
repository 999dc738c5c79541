import { html, nothing, svg, type TemplateResult } from 'lit';
import { FILLED_ICONS, ICONS, type IconName } from '../scene/icons.js';
import { hasDirection, queryCode } from '../teaching/circulators.js';
import { type DialectId, dialects } from '../teaching/dialects.js';
import type { CirculatorPlayer } from '../teaching/player.js';
import { isPlayable, type Story, WalkStory } from './story.js';

/** What the controls of a figure do. */
export interface Controls {
  toggle(): void;
  seek(position: number): void;
  turn(): void;
  setDialect(id: DialectId): void;
}

export function icon(name: IconName): TemplateResult {
  const look = FILLED_ICONS.has(name) ? 'icon filled' : 'icon';
  return html`<svg class=${look} viewBox="0 0 24 24" aria-hidden="true">${svg`<path d=${ICONS[name]}></path>`}</svg>`;
}

/** Buttons and slider of the player; `idle` where it has nothing to play right now. */
export function playerBar(
  story: Story,
  playing: boolean,
  controls: Controls,
  idle: boolean,
): TemplateResult {
  const { count } = story;
  const position = idle ? 0 : story.position;
  const ended = idle || position >= count || story.refusal !== null;
  const empty = idle || count === 0;
  const turns = story instanceof WalkStory && hasDirection(story.player.query.circulator);
  return html`
    <div class="bar" part="controls" lang="en" role="group" aria-label="Player">
      <div class="buttons">
        ${button('restart', 'Back to the start', position === 0, () => controls.seek(0))}
        ${button('back', 'Step back', position === 0, () => controls.seek(position - 1))}
        <button
          type="button"
          class="play"
          part="button play"
          title=${`${playing ? 'Pause' : 'Play'} (space)`}
          aria-label=${playing ? 'Pause' : 'Play'}
          ?disabled=${idle || !isPlayable(story)}
          @click=${controls.toggle}
        >
          ${icon(playing ? 'pause' : 'play')}
        </button>
        ${button('forward', 'Step forward', ended, () => controls.seek(position + 1))}
      </div>
      <input
        type="range"
        part="slider"
        min="0"
        step="1"
        max=${count}
        .value=${String(position)}
        aria-label="Step"
        aria-valuetext=${`${position} of ${count}`}
        style=${`--filled: ${(100 * position) / Math.max(1, count)}%`}
        ?disabled=${empty}
        @input=${(event: InputEvent) => controls.seek(Number((event.target as HTMLInputElement).value))}
      />
      <output>${position} of ${count}</output>
      ${turns ? directionButton(story, controls, idle) : nothing}
    </div>
  `;
}

function button(name: IconName, label: string, disabled: boolean, act: () => void): TemplateResult {
  return html`<button
    type="button"
    class=${name}
    part=${`button ${name}`}
    title=${label}
    aria-label=${label}
    ?disabled=${disabled}
    @click=${act}
  >
    ${icon(name)}
  </button>`;
}

function directionButton({ player }: WalkStory, controls: Controls, idle: boolean): TemplateResult {
  const { direction } = player.query;
  const word = direction === 'ccw' ? 'counter-clockwise' : 'clockwise';
  return html`<button
    type="button"
    class="wide direction"
    part="button direction"
    title=${`Goes ${word}: turn round`}
    aria-label=${`${direction}, ${word}: turn round`}
    ?disabled=${idle}
    @click=${controls.turn}
  >
    ${icon(direction)}<span>${direction}</span>
  </button>`;
}

/** The code that runs, its current line lit unless it is idle, in the names of a library. */
export function codeListing(
  player: CirculatorPlayer,
  controls: Controls,
  idle: boolean,
): TemplateResult {
  const ran = (idle ? null : player.current?.ran) ?? [];
  const call = queryCode(player.query);
  return html`
    <div class="code" part="code" lang="en">
      <header>
        <code title=${call}>${call}</code>
        <select
          aria-label="Names of"
          ?disabled=${idle}
          @change=${(event: Event) =>
            controls.setDialect((event.target as HTMLSelectElement).value as DialectId)}
        >
          ${dialects.map(
            ({ id, label }) =>
              html`<option value=${id} ?selected=${id === player.dialect.id}>${label}</option>`,
          )}
        </select>
      </header>
      <div class="lines" tabindex="0" role="group" aria-label="Code">
        <ol>
          ${player.program.lines.map(
            (line, i) =>
              html`<li
                class=${ran.includes(i) ? 'ran' : ''}
                aria-current=${i === ran.at(-1) ? 'step' : nothing}
              ><code>${line}</code></li>`,
          )}
        </ol>
      </div>
    </div>
  `;
}
