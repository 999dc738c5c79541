import { itemName } from 'halfedge/teaching';
import { digestOf } from '../app/digest.js';
import type { Explorer } from '../app/explorer.js';
import type { View } from '../scene/view.js';
import { setAttribute } from './dom.js';

/**
 * Keeps the state of the page readable from outside, as attributes of `html` and `main.stage`.
 * README.md beside this folder documents them; tests and embedding pages rely on them.
 */
export function publishState(explorer: Explorer, view: View, stage: HTMLElement): void {
  const publish = (name: string, value: string | number | null) =>
    setAttribute(stage, `data-${name}`, value);
  const page = document.documentElement;
  explorer.busy.subscribe((busy) => {
    if (busy !== null) page.dataset.state = 'loading';
    else view.stage.invalidate();
  });
  explorer.failure.subscribe((failure) => {
    if (failure && !explorer.document.value) page.dataset.state = 'error';
  });
  explorer.document.subscribe((opened) => publish('mesh', opened?.name ?? null));
  explorer.selected.subscribe((item) => publish('selected', item && itemName(item)));
  explorer.hovered.subscribe((item) => publish('hovered', item && itemName(item)));
  explorer.walker.play.subscribe((play) => {
    const done = play?.player.done && play.position > 0;
    publish('player', play ? (play.playing ? 'playing' : done ? 'done' : 'paused') : null);
    publish('position', play?.position ?? null);
    publish('count', play?.player.count ?? null);
  });
  const { editor } = explorer;
  editor.past.subscribe(({ undoCount, redoCount }) => {
    publish('undo', undoCount);
    publish('redo', redoCount);
  });
  editor.refused.subscribe((refused) => {
    publish('refusal', refused?.refusal.code ?? null);
    publish('witness', refused?.witness.map(itemName).join(' ') ?? null);
  });
  editor.pending.subscribe((pending) => publish('pending', pending?.operation.stem ?? null));
  // What is known of the mesh before an edit stays in the panels until it is measured again.
  editor.edit.subscribe(() => publish('digest', null));
  explorer.facts.subscribe((facts) => {
    const mesh = explorer.document.value?.mesh;
    publish('digest', facts && mesh ? digestOf(mesh) : null);
  });
  explorer.showsFile.subscribe((shows) => publish('picture', shows ? 'original' : 'repaired'));
  explorer.problem.subscribe((problem) => publish('problem', problem?.code ?? null));
  let frames = 0;
  view.stage.onFrame(() => {
    frames += 1;
    publish('frames', frames);
  });
  view.stage.onChange(
    () => {
      if (page.dataset.state === 'ready') page.dataset.state = 'drawing';
    },
    () => {
      publish('camera', view.cameraState());
      if (explorer.busy.value === null && explorer.document.value) page.dataset.state = 'ready';
    },
  );
}
