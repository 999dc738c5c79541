// The states of the explorer that are worth a picture: the link that leads there, and what is then done.
// `aim` flies to what is selected, before; `moves` is after how many milliseconds of a motion the picture is taken.

const tab = (name) => (page) => page.click(`[data-tab-button=${name}]`);
const keys =
  (...pressed) =>
  async (page) => {
    for (const key of pressed) await page.keyboard.press(key);
  };
const both =
  (...acts) =>
  async (page, settings) => {
    for (const act of acts) await act(page, settings);
  };
/** In a narrow window the inspector is a tab. */
const inspect = async (page, { narrow }) => {
  if (narrow) await tab('inspect')(page);
};
const walk = (names) => `sample=suzanne&select=v60&query=vertexVertices&at=3&names=${names}`;
const paste = (text) => (page) =>
  page.evaluate((pasted) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData('text/plain', pasted);
    document.body.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true }));
  }, text);
const pause = (milliseconds) => (page) => page.waitForTimeout(milliseconds);

const ATTRIBUTES = `ply
format ascii 1.0
comment a corner of a room
element vertex 4
property float x
property float y
property float z
property float nx
property float ny
property float nz
property uchar red
property uchar green
property uchar blue
property float quality
element face 2
property list uchar int vertex_indices
property int room
end_header
0 0 0 0 0 1 255 0 0 0.25
1 0 0 0 0 1 0 255 0 0.5
1 1 0.3 0.6 0 0.8 0 0 255 0.75
0 1 0 0 0 1 255 255 0 1
3 0 1 2 7
3 0 2 3 8
`;

export const states = {
  start: {},
  hover: {
    act: async (page, { narrow }) => {
      if (!narrow) await page.mouse.move(470, 400);
    },
  },
  vertex: { link: 'sample=suzanne&select=v60', act: both(inspect, keys('z')) },
  edge: { link: 'sample=icosahedron&select=e12', act: both(inspect, keys('z')) },
  halfedge: { link: 'sample=icosahedron&select=h12', act: both(inspect, keys('z')) },
  face: { link: 'sample=football&select=f5', act: both(inspect, keys('z')) },
  boundary: { link: 'sample=annulus&select=h136', act: inspect },
  attributes: { act: both(paste(ATTRIBUTES), pause(800), inspect) },
  nothing: { link: 'sample=torus&select=nothing', act: inspect },
  pointers: { link: 'sample=icosahedron&select=h12&pointers=on', act: keys('z') },
  'pointers-vertex': { link: 'sample=grid&select=v8&pointers=on', act: keys('z') },
  'pointers-face': { link: 'sample=grid&select=f8&pointers=on' },
  'pointers-boundary': { link: 'sample=annulus&select=h136&pointers=on', aim: true },
  'labels-all': { link: 'sample=grid&select=f8&labels=all:vehf' },
  'labels-closed': { link: 'sample=icosphere&select=v3&labels=all:vf' },
  'labels-selection': { link: 'sample=suzanne&select=v60&labels=selection:vhf', act: keys('z') },
  'names-menu': {
    link: 'sample=grid&select=f8&labels=all:vhf',
    act: (page) => page.click('.captions > button'),
  },
  walk: { link: 'sample=suzanne&select=v60&query=vertexVertices&at=4', act: keys('z') },
  'walk-done': { link: 'sample=football&select=v5&query=vertexFaces', act: keys('End', 'z') },
  'walk-boundary': {
    link: 'sample=annulus&select=h136&query=halfedgeLoop',
    act: keys('.', '.', '.', '.'),
  },
  'code-openmesh': { link: walk('openmesh'), act: keys('z') },
  'code-cgal': { link: walk('cgal'), act: keys('z') },
  'code-mcguire': { link: walk('mcguire'), act: keys('z') },
  records: { link: 'sample=cube&select=h3', aim: true, act: tab('records') },
  'records-vertices': { link: 'sample=bunny&select=v1224', act: tab('records') },
  'records-bunny': { link: 'sample=bunny&select=h16943', aim: true, act: tab('records') },
  'records-walk': { link: 'sample=cube&select=v3', act: both(tab('records'), keys('.', '.')) },
  'records-attributes': { act: both(paste(ATTRIBUTES), pause(800), tab('records')) },
  edit: { link: 'sample=icosahedron&select=e12', aim: true, act: tab('edit') },
  'moving-extrude': {
    link: 'sample=icosahedron&select=f3',
    aim: true,
    act: both(tab('edit'), keys('Shift+E')),
    moves: 230,
  },
  'moving-collapse': {
    link: 'sample=icosphere&select=h31',
    aim: true,
    act: both(tab('edit'), keys('Shift+C')),
    moves: 230,
  },
  'moving-flip': {
    link: 'sample=icosahedron&select=e12',
    aim: true,
    act: both(tab('edit'), keys('Shift+F')),
    moves: 230,
  },
  'edit-done': {
    link: 'sample=icosahedron&select=f3',
    aim: true,
    act: both(tab('edit'), keys('Shift+E')),
  },
  refusal: { link: 'sample=grid&select=e0', act: both(tab('edit'), keys('Shift+F')) },
  pending: { link: 'sample=football&select=h6', act: both(tab('edit'), keys('Shift+E')) },
  mesh: { link: 'sample=bunny&select=nothing', act: tab('mesh') },
  loops: { link: 'sample=annulus&select=nothing', act: tab('mesh') },
  warnings: { link: 'sample=pinched', act: tab('mesh') },
  menu: { link: 'sample=cube', act: (page) => page.click('.mesh-button') },
  'menu-broken': {
    link: 'sample=cube',
    act: async (page) => {
      await page.click('.mesh-button');
      await page.evaluate(() => document.querySelector('[data-broken=klein]').scrollIntoView());
    },
  },
  keys: { link: 'sample=cube', act: keys('?') },
  repaired: { link: 'sample=klein' },
  original: {
    link: 'sample=klein&picture=original',
    act: (page) => page.click('.entries button'),
  },
  scan: { link: 'sample=scan&picture=original' },
  'problem-lit': { link: 'sample=three-faces', act: (page) => page.click('.entries button') },
  'cut-short': { link: 'sample=cut-short' },
  failure: { link: 'sample=cube', act: both(paste('OFF\n3 1 0\n0 0 0\n1 0 zero\n'), pause(800)) },
  'bad-link': { link: 'sample=cow' },
  share: { link: 'sample=cube&select=h3', act: (page) => page.click('[data-share]') },
  empty: { link: 'sample=cube', act: both(paste('OFF\n0 0 0\n'), pause(800)) },
  drop: {
    link: 'sample=cube',
    act: (page) =>
      page.evaluate(() => {
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(new File([''], 'a.obj'));
        document.body.dispatchEvent(new DragEvent('dragenter', { dataTransfer, bubbles: true }));
      }),
  },
  loading: {
    link: 'sample=cube',
    act: (page) =>
      page.evaluate(() => {
        const busy = document.querySelector('.busy');
        busy.hidden = false;
        busy.querySelector('span').textContent = 'Reading dragon.ply …';
        busy.querySelector('progress').hidden = false;
        busy.querySelector('progress').value = 0.4;
      }),
  },
};
