import { HalfedgeMesh } from 'halfedge';
import { fetching, NotFetched } from '../app/fetching.js';
import bunnyUrl from './bunny.off?url';
import * as generate from './generators.js';
import suzanneUrl from './suzanne.off?url';

/** A mesh that the page offers by name. */
export interface Sample {
  readonly id: string;
  readonly name: string;
  /** What it is good for seeing, in a few words. */
  readonly note: string;
  /** The vertex that is selected when the sample opens; null for one in plain sight. */
  readonly start: number | null;
  /** From which direction it is first seen (y is up); need not be a unit vector. */
  readonly view: readonly [number, number, number];
  load(): Promise<HalfedgeMesh>;
  /** Begins to fetch what `load` is going to read. */
  fetchAhead?(): void;
}

async function fetchText(url: string): Promise<string> {
  const response = await fetching('The sample', fetch(url));
  if (!response.ok) {
    throw new NotFetched(`The sample could not be fetched (HTTP ${response.status}).`);
  }
  return fetching('The sample', response.text());
}

/** A mesh in a file beside the page. */
function fetched(url: string): Required<Pick<Sample, 'load' | 'fetchAhead'>> {
  let ahead: Promise<string> | null = null;
  return {
    async load() {
      const text = ahead ?? fetchText(url);
      ahead = null; // if it fails, it is fetched again the next time
      return HalfedgeMesh.parse(await text, { format: 'off' }).mesh;
    },
    fetchAhead() {
      ahead = fetchText(url);
      ahead.catch(() => {}); // for whom it loads
    },
  };
}

/** The first one opens with the page. */
export const samples: readonly Sample[] = [
  {
    id: 'bunny',
    name: 'Bunny',
    note: 'closed, 5,648 triangles',
    start: 1224,
    view: [0.3, 0.22, 1],
    ...fetched(bunnyUrl),
  },
  {
    id: 'suzanne',
    name: 'Suzanne',
    note: 'three components, four boundary loops',
    start: null,
    view: [0.35, 0.15, 1],
    ...fetched(suzanneUrl),
  },
  {
    id: 'icosahedron',
    name: 'Icosahedron',
    note: '20 triangles, every valence 5',
    start: null,
    view: [0.15, 0.35, 1],
    load: async () => HalfedgeMesh.icosahedron(),
  },
  {
    id: 'icosphere',
    name: 'Icosphere',
    note: '320 triangles',
    start: null,
    view: [0.2, 0.3, 1],
    load: async () => HalfedgeMesh.icoSphere(2),
  },
  {
    id: 'cube',
    name: 'Cube',
    note: 'six quads',
    start: 7,
    view: [0.75, 0.6, 1],
    load: async () => HalfedgeMesh.cube(),
  },
  {
    id: 'torus',
    name: 'Torus',
    note: 'quads, genus 1',
    start: 100,
    view: [0.35, 0.5, 1],
    load: async () => HalfedgeMesh.torus(28, 14),
  },
  {
    id: 'football',
    name: 'Truncated icosahedron',
    note: 'pentagons and hexagons',
    start: null,
    view: [0.25, 0.3, 1],
    load: async () => generate.truncatedIcosahedron(),
  },
  {
    id: 'star',
    name: 'Star prism',
    note: 'concave ten-sided faces',
    start: 1,
    view: [0.35, 0.25, 1],
    load: async () => generate.starPrism(),
  },
  {
    id: 'grid',
    name: 'Open grid',
    note: '36 quads, one boundary loop',
    start: 3,
    view: [0.25, 0.9, 0.9],
    load: async () => generate.openGrid(6),
  },
  {
    id: 'annulus',
    name: 'Annulus',
    note: 'two boundary loops',
    start: 0,
    view: [0.1, 1.2, 0.9],
    load: async () => generate.annulus(14),
  },
  {
    id: 'pinched',
    name: 'Pinched vertex',
    note: 'three fans, joined by boundary halfedges',
    start: 0,
    view: [0.1, 1.2, 0.8],
    load: async () => generate.pinchedVertex(),
  },
];
