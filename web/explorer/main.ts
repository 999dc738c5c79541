import '@fontsource-variable/inter/wght.css';
import '@fontsource-variable/jetbrains-mono/wght.css';
import './styles/tokens.css';
import './styles/controls.css';
import './styles/layout.css';
import './styles/top-bar.css';
import './styles/inspector.css';
import './styles/circulator.css';
import './styles/edit.css';
import './styles/mesh.css';
import './styles/problems.css';
import './styles/records.css';
import './styles/sheet.css';
import './styles/overlays.css';
import './styles/narrow.css';
import './styles/low.css';
import './styles/forced-colors.css';
import './styles/print.css';
import { listenToPointer } from 'halfedge/scene';
import { sameItem } from 'halfedge/teaching';
import { Explorer } from './app/explorer.js';
import { loadPackage } from './app/fetching.js';
import { samples } from './samples/index.js';
import { View } from './scene/view.js';
import { AddressFollower, hasLink } from './ui/address.js';
import { h } from './ui/dom.js';
import { pendingNotice, refusalNotice } from './ui/edit-notices.js';
import { emptyState } from './ui/empty-state.js';
import { chooseGlass } from './ui/glass.js';
import { helpDialog } from './ui/help-dialog.js';
import { listenToKeys } from './ui/keyboard.js';
import { leftNotice } from './ui/left-notice.js';
import {
  busyNotice,
  failureNotice,
  namesHint,
  passedOverNotice,
  startFailure,
} from './ui/notices.js';
import { panel } from './ui/panel.js';
import { pickBar } from './ui/pick-bar.js';
import { pictureSwitch } from './ui/picture-switch.js';
import { keepShapeOnPaper } from './ui/printing.js';
import { shareButton } from './ui/share-button.js';
import { publishState } from './ui/state-attributes.js';
import { addPictureStyles, Theme } from './ui/theme.js';
import { topBar } from './ui/top-bar.js';
import { dropTarget, listenToPaste } from './ui/ways-in.js';

// Both come while the page is built; if the package doesn't, it is told where a mesh is opened.
loadPackage().catch(() => {});
if (!hasLink()) samples[0].fetchAhead?.();

addPictureStyles();
const theme = new Theme();
const explorer = new Explorer();
const canvas = h('canvas', {
  tabindex: 0,
  'aria-label': 'The mesh in 3D. Arrow keys orbit, plus and minus zoom.',
});
const labels = h('div', { class: 'labels', translate: 'no', 'aria-hidden': 'true' });
const stage = h('main', { class: 'stage' }, canvas, labels);
const help = helpDialog();
const openHelp = () => help.showModal();

async function start(): Promise<void> {
  const app = h('div', { id: 'app' }, stage);
  document.body.append(app);
  const view = new View(explorer, canvas, labels);
  chooseGlass(canvas);
  theme.current.subscribe(() => view.applyTheme());
  const side = panel(explorer, {
    goTo: (item) => {
      explorer.select(item);
      view.focus();
    },
    bringIntoSight: (item) => view.travel.bringIntoSight([item]),
    toProblem: () => view.focus(),
    takePicture: (format) => view.picture(format),
  });
  const share = shareButton(explorer, view);
  const cards = [refusalNotice(explorer), pendingNotice(explorer)];
  app.append(
    topBar(explorer, theme, share.button, openHelp),
    pickBar(explorer, () => view.focus()),
    namesHint(view.lacksRoomForNames),
    pictureSwitch(explorer),
    side,
    emptyState(explorer),
    h('div', { class: 'toasts' }, leftNotice(explorer), passedOverNotice(explorer), share.outcome),
    failureNotice(explorer), // over the toasts
    ...cards,
    busyNotice(explorer),
    dropTarget(explorer),
    help,
  );
  view.keepClearOf(side, cards);
  listenToKeys(explorer, view, openHelp);
  listenToPointer(canvas, {
    itemAt: (x, y, reach) => view.pick(x, y, reach),
    hovers: (item) => {
      if (!sameItem(item, explorer.hovered.value)) explorer.hovered.value = item;
    },
    picks: (item) => explorer.pick(item),
    doubleClicked: () => view.focus(),
  });
  listenToPaste(explorer);
  keepShapeOnPaper();
  publishState(explorer, view, stage);
  await new AddressFollower(explorer, view).start();
  window.addEventListener('beforeunload', (event) => {
    if (explorer.editor.anyUnsaved) event.preventDefault();
  });
}

start().catch((error: unknown) => {
  document.documentElement.dataset.state = 'error';
  const hasWebGl = document.createElement('canvas').getContext('webgl2') !== null;
  const message = error instanceof Error ? error.message : String(error);
  const notice = hasWebGl
    ? startFailure('The explorer could not start', message, 'Reload the page.')
    : startFailure(
        'The explorer could not start',
        'This browser gives the page no WebGL 2, which draws the mesh.',
        'Turn on graphics acceleration in its settings and reload the page, or open it in another browser.',
      );
  // There is no panel that it would have to leave room for.
  document.body.replaceChildren(h('main', { class: 'stage', style: '--panel-room: 0px' }, notice));
});
