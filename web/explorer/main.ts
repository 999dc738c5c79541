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
import { init } from 'halfedge';
import { listenToPointer } from 'halfedge/scene';
import { sameItem } from 'halfedge/teaching';
import { Explorer } from './app/explorer.js';
import { follow } from './app/share.js';
import { Signal } from './app/signal.js';
import { samples } from './samples/index.js';
import { View } from './scene/view.js';
import { h } from './ui/dom.js';
import { pendingNotice, refusalNotice } from './ui/edit-notices.js';
import { emptyState } from './ui/empty-state.js';
import { listenToKeys } from './ui/keyboard.js';
import { leftNotice } from './ui/left-notice.js';
import {
  busyNotice,
  dropTarget,
  failureNotice,
  helpDialog,
  listenToPaste,
  namesHint,
} from './ui/notices.js';
import { panel, type Tab } from './ui/panel.js';
import { pickBar } from './ui/pick-bar.js';
import { pictureSwitch } from './ui/picture-switch.js';
import { shareButton } from './ui/share-button.js';
import { publishState } from './ui/state-attributes.js';
import { addPictureStyles, Theme } from './ui/theme.js';
import { topBar } from './ui/top-bar.js';

// Both come while the page is built.
const loading = init();
loading.catch(() => {}); // for whom it awaits
if (location.hash.length <= 1) samples[0].fetchAhead?.();

addPictureStyles();
const theme = new Theme();
const explorer = new Explorer();
const canvas = h('canvas', {
  tabindex: 0,
  'aria-label': 'The mesh in 3D. Arrow keys orbit, plus and minus zoom.',
});
const labels = h('div', { class: 'labels', 'aria-hidden': 'true' });
const stage = h('main', { class: 'stage' }, canvas, labels);
const help = helpDialog();
const openHelp = () => help.showModal();
/** How many links are being followed: what is opened then is what the address tells of. */
let following = 0;

async function start(): Promise<void> {
  const app = h('div', { id: 'app' }, stage);
  document.body.append(app);
  const view = new View(explorer, canvas, labels);
  theme.current.subscribe(() => view.applyTheme());
  const tab = new Signal<Tab>('circulate');
  const side = panel(explorer, tab, {
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
    failureNotice(explorer),
    ...cards,
    busyNotice(explorer),
    h('div', { class: 'toasts' }, leftNotice(explorer), share.outcome),
    dropTarget(explorer),
    help,
  );
  view.keepClearOf(side, cards);
  listenToKeys(explorer, view, tab, openHelp);
  listenToPointer(canvas, {
    itemAt: (x, y, reach) => view.pick(x, y, reach),
    hovers: (item) => {
      if (!sameItem(item, explorer.hovered.value)) explorer.hovered.value = item;
    },
    picks: (item) => explorer.pick(item),
    doubleClicked: () => view.focus(),
  });
  listenToPaste(explorer);
  publishState(explorer, view, stage);
  await loading;
  if (location.hash.length > 1) await followLink(view);
  await explorer.openSomething();
  forgetLinkWithMesh();
  window.addEventListener('beforeunload', (event) => {
    if (explorer.editor.anyUnsaved) event.preventDefault();
  });
  window.addEventListener('hashchange', () => void followLink(view));
}

/** The address tells of no mesh but the one on show: it is cleared when another one is chosen. */
function forgetLinkWithMesh(): void {
  let { value: shown } = explorer.document;
  explorer.document.subscribe((opened) => {
    if (opened === shown) return;
    shown = opened;
    if (following > 0 || location.hash === '') return;
    history.replaceState(null, '', location.pathname + location.search);
  });
}

/** Goes where the address leads; what is wrong with it is told in a sentence. */
async function followLink(view: View): Promise<void> {
  following += 1;
  try {
    await follow(location.hash.slice(1), explorer, view);
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error);
    await explorer.openSomething();
    explorer.failure.value = { title: 'The link could not be followed', message, lesson: null };
  } finally {
    following -= 1;
  }
}

start().catch((error: unknown) => {
  document.documentElement.dataset.state = 'error';
  explorer.failure.value = {
    title: 'The explorer could not start',
    lesson: null,
    message: error instanceof Error ? error.message : String(error),
  };
  if (!document.querySelector('.notice')) document.body.append(failureNotice(explorer));
});
