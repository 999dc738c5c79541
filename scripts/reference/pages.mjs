// Which page of the reference shows which entries of the package, and what the parts of large classes are called there.
// Of an entry that several pages show, those without `names` show what the others don't. Where `namesSayIt`, members
// of classes need no docstring.

export const pages = [
  {
    file: 'mesh.md',
    title: 'The mesh',
    entries: ['.'],
    names: ['HalfedgeMesh'],
    about: 'The class `HalfedgeMesh`: links, circulators, measures, operations, files.',
  },
  {
    file: 'halfedge.md',
    title: 'Around the mesh',
    entries: ['.'],
    about:
      '`init`, errors, circulators, attributes, history, and all options and results. `halfedge/inline` exports the same as `halfedge`, with the WebAssembly module in it.',
  },
  {
    file: 'directed-edges.md',
    title: 'Directed Edges',
    entries: ['.'],
    names: [
      'DirectedEdgesMesh',
      'DirectedCirculator',
      'DirectedOrbit',
      'DirectedItems',
      'DirectedEdgesViews',
    ],
    about: 'The compact mesh of triangles, which is only read.',
  },
  {
    file: 'worker.md',
    title: 'halfedge/worker',
    entries: ['./worker'],
    about: 'Meshes that are read, repaired and built in a worker.',
  },
  {
    file: 'three.md',
    title: 'halfedge/three',
    entries: ['./three', './three/picking', './three/webgpu'],
    about: 'Geometries, helpers, lines and picking for three.js.',
  },
  {
    file: 'gltf.md',
    title: 'halfedge/gltf',
    entries: ['./gltf'],
    about: 'glTF and GLB, in and out.',
  },
  {
    file: 'figure.md',
    title: 'halfedge/figure',
    entries: ['./figure'],
    about:
      'The element `<halfedge-figure>`. `halfedge/figure/standalone` is the same in one file, with everything of `halfedge`.',
  },
  {
    file: 'exercise.md',
    title: 'halfedge/exercise',
    entries: ['./exercise', './exercise/judge'],
    about:
      'The element `<halfedge-exercise>`, and its judge. `halfedge/exercise/standalone` is the element in one file, with everything of `halfedge`.',
  },
  {
    file: 'dialects.md',
    title: 'halfedge/dialects',
    namesSayIt: true,
    entries: ['./dialects'],
    about: 'Programs written for OpenMesh, CGAL or McGuire’s structs, on our meshes.',
  },
  {
    file: 'teaching.md',
    title: 'halfedge/teaching',
    namesSayIt: true,
    entries: ['./teaching'],
    about: 'What the explorer knows of circulators, links and operations: names, steps, code.',
  },
  {
    file: 'scene.md',
    title: 'halfedge/scene',
    namesSayIt: true,
    entries: ['./scene'],
    about: 'What the explorer and the figures draw with.',
  },
];

/** Entries that export what another one does, or nothing. */
export const entriesWithoutPage = [
  './inline',
  './worker-thread',
  './three/picking-thread',
  './figure/standalone',
  './exercise/standalone',
];

/** The classes that a large class is made of, and what each part is about. */
export const parts = {
  Navigation: 'Counts, links and queries',
  BulkRings: 'All rings at once',
  Circulation: 'Circulators',
  Geometry: 'Normals, areas, lengths, angles',
  Construction: 'Construction',
  EulerOperations: 'Euler operations',
  Surgery: 'Surgery',
  Modelling: 'Modelling',
  Mending: 'Mending',
  Editing: 'History, attributes, generations',
  Neighbourhoods: 'Neighbourhoods and topology',
  Shapes: 'Shapes',
  DirectedEdgesNavigation: 'Counts, links and queries',
  DirectedEdgesGeometry: 'Normals, areas, lengths, angles',
  HalfedgeCirculator: 'What both circulators have',
  Handle: 'What all handles have',
  FigureAttributes: 'Attributes',
};
