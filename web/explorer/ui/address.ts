import { failureOf, type MeshDocument } from '../app/documents.js';
import type { Explorer } from '../app/explorer.js';
import { loadPackage } from '../app/fetching.js';
import { follow, type Sight } from '../app/share.js';
import { brokenSamples } from '../samples/broken.js';
import { samples } from '../samples/index.js';

/** Whether the address tells of a state of the page. */
export function hasLink(): boolean {
  return location.hash.length > 1;
}

/** What a link chooses besides the mesh. */
type Choices = ReturnType<typeof choicesOf>;

function choicesOf({ walker, labels, pointers, pickMode, tab }: Explorer) {
  return {
    tab: tab.value,
    pickMode: pickMode.value,
    dialect: walker.dialect.value,
    direction: walker.direction.value,
    speed: walker.speed.value,
    labels: labels.value,
    pointers: pointers.value,
  };
}

/** Shows what the address tells of, now and whenever it changes. */
export class AddressFollower {
  readonly #explorer: Explorer;
  readonly #sight: Sight;
  /** How many links are being followed: what is opened then is what the address tells of. */
  #following = 0;
  #shown: MeshDocument | null = null;
  /** What was on show last while the address told of nothing. */
  #plain: MeshDocument | null = null;
  /** What was chosen before links were followed; null while the address tells of nothing. */
  #chosen: Choices | null = null;

  constructor(explorer: Explorer, sight: Sight) {
    this.#explorer = explorer;
    this.#sight = sight;
  }

  /** Opens what the page begins with. */
  async start(): Promise<void> {
    const explorer = this.#explorer;
    if (hasLink()) await this.#followLink();
    await explorer.openSomething();
    this.#shown = explorer.document.value;
    explorer.document.subscribe((opened) => this.#forgetLink(opened));
    window.addEventListener('hashchange', () => {
      if (hasLink()) void this.#followLink();
      else this.#goBack();
    });
  }

  /** The address tells of no mesh but the one on show: it is cleared when another one is chosen. */
  #forgetLink(opened: MeshDocument | null): void {
    if (opened !== this.#shown && this.#following === 0 && hasLink()) this.#clear();
    this.#shown = opened;
    if (!hasLink()) this.#plain = opened;
  }

  #clear(): void {
    history.replaceState(null, '', location.pathname + location.search);
    this.#chosen = null;
  }

  /** Goes where the address leads; what is wrong with it is told in a sentence. */
  async #followLink(): Promise<void> {
    const explorer = this.#explorer;
    this.#chosen ??= choicesOf(explorer);
    this.#following += 1;
    const before = explorer.document.value;
    let isThere = true;
    try {
      await loadPackage();
      isThere = await follow(location.hash.slice(1), explorer, this.#sight);
    } catch (error) {
      await explorer.openSomething();
      const told = failureOf(error, { name: 'The link' });
      explorer.failure.value = { ...told, title: 'The link could not be followed' };
    } finally {
      this.#following -= 1;
    }
    // Something else was opened before the link had led anywhere.
    if (!isThere && this.#following === 0 && explorer.document.value !== before) {
      this.#clear();
      this.#plain = explorer.document.value;
    }
  }

  /**
   * Shows again what was on show before a link was followed, in the names and with the labels of then: with its
   * edits, if it has any and undo leads to it; as it was opened, if it is a sample. Something else is gone: what is
   * on show stays.
   */
  #goBack(): void {
    const explorer = this.#explorer;
    const plain = this.#plain;
    explorer.cancel();
    explorer.failure.value = null;
    this.#chooseAgain();
    if (plain && plain === explorer.document.value) return;
    if (plain && plain === explorer.editor.previous) {
      explorer.editor.undo();
      return;
    }
    const id = plain ? plain.sample : samples[0].id;
    const sample = [...samples, ...brokenSamples].find((each) => each.id === id);
    if (sample) void explorer.open(sample);
  }

  #chooseAgain(): void {
    const explorer = this.#explorer;
    if (!this.#chosen) return;
    const { dialect, direction, speed, labels, pointers, pickMode, tab } = this.#chosen;
    this.#chosen = null;
    explorer.walker.setDialect(dialect);
    explorer.walker.setDirection(direction);
    explorer.walker.speed.value = speed;
    explorer.labels.value = labels;
    explorer.pointers.value = pointers;
    explorer.pickMode.value = pickMode;
    if (tab !== 'problems') explorer.tab.value = tab;
  }
}
